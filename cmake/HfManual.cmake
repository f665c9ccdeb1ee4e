# Manual pages (help2man, where it is installed) and shell completion, both made by asking the built program for its
# commands, so that neither can lag behind it.
find_program(HF_HELP2MAN help2man)
set(manual_dir ${CMAKE_BINARY_DIR}/manual)
add_custom_command(OUTPUT ${manual_dir}/stamp
  COMMAND ${CMAKE_COMMAND} -DPROGRAM=$<TARGET_FILE:hybridfusion_cli> -DHELP2MAN=${HF_HELP2MAN} -DDIR=${manual_dir}
          -DVERSION=${PROJECT_VERSION} -P ${PROJECT_SOURCE_DIR}/cmake/make_manual.cmake
  DEPENDS hybridfusion_cli ${PROJECT_SOURCE_DIR}/cmake/make_manual.cmake VERBATIM
  COMMENT "Manual pages and shell completion")
add_custom_target(hf_manual ALL DEPENDS ${manual_dir}/stamp)
install(DIRECTORY ${manual_dir}/man1 DESTINATION ${CMAKE_INSTALL_MANDIR} COMPONENT runtime)
install(FILES ${manual_dir}/completion.bash RENAME hybridfusion
        DESTINATION ${CMAKE_INSTALL_DATADIR}/bash-completion/completions COMPONENT runtime)
install(FILES ${manual_dir}/completion.zsh RENAME _hybridfusion
        DESTINATION ${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions COMPONENT runtime)
