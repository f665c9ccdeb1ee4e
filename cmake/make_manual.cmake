# cmake -DPROGRAM=hybridfusion -DHELP2MAN=help2man -DDIR=out -DVERSION=0.1.0 -P make_manual.cmake
# Writes out/completion.bash, out/completion.zsh and, with help2man, out/man1/hybridfusion*.1.gz: one page for the
# program and one for each command.
cmake_minimum_required(VERSION 3.25)
file(REMOVE_RECURSE ${DIR})
file(MAKE_DIRECTORY ${DIR}/man1)
foreach(shell bash zsh commands)
  execute_process(COMMAND ${PROGRAM} completion ${shell} OUTPUT_FILE ${DIR}/completion.${shell} COMMAND_ERROR_IS_FATAL ANY)
endforeach()
file(STRINGS ${DIR}/completion.commands commands)

# help2man reads the first line of --help as a sentence of the description; the page's one-line name is that too.
function(write_page page help_option)
  execute_process(COMMAND ${PROGRAM} ${help_option} --help OUTPUT_VARIABLE help COMMAND_ERROR_IS_FATAL ANY)
  string(REGEX REPLACE "[.:;(]? *[\n].*|[.:;(] .*" "" title "${help}")
  # help2man splits no option, so that the program and its command travel in a script of one line.
  file(WRITE ${DIR}/hybridfusion "#!/bin/sh\nexec '${PROGRAM}' ${help_option} \"$@\"\n")
  file(CHMOD ${DIR}/hybridfusion PERMISSIONS OWNER_READ OWNER_WRITE OWNER_EXECUTE)
  execute_process(
    COMMAND ${HELP2MAN} --no-info --section=1 --name=${title} --source=HybridFusion --version-string=${VERSION}
            --manual=HybridFusion ${DIR}/hybridfusion
    OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  string(REPLACE " " "-" upper "${page}")
  string(TOUPPER "${upper}" upper)
  string(REGEX REPLACE "\n\\.TH [A-Z]+ " "\n.TH ${upper} " text "${text}")
  string(REGEX REPLACE "\nhybridfusion \\\\- " "\n${page} \\\\- " text "${text}")
  file(WRITE ${DIR}/man1/${page}.1 "${text}")
endfunction()

if(HELP2MAN)
  write_page(hybridfusion "")
  foreach(command IN LISTS commands)
    write_page(hybridfusion-${command} ${command})
  endforeach()
  file(REMOVE ${DIR}/hybridfusion)
  file(GLOB pages ${DIR}/man1/*.1)
  execute_process(COMMAND gzip -9n ${pages} COMMAND_ERROR_IS_FATAL ANY)
else()
  message(STATUS "help2man is not installed: no manual pages")
endif()
file(TOUCH ${DIR}/stamp)
