# cmake -DPROGRAM=hybridfusion -DPAGE=options.md -P check_options_page.cmake
# Fails when the committed option reference differs from what the program prints.
execute_process(COMMAND ${PROGRAM} config --markdown OUTPUT_VARIABLE printed RESULT_VARIABLE failed)
file(READ ${PAGE} committed)
if(failed OR NOT committed MATCHES "^# Options\n")
  message(FATAL_ERROR "${PROGRAM} config failed, or ${PAGE} has no title")
endif()
string(FIND "${committed}" "| option |" start)
string(SUBSTRING "${committed}" ${start} -1 table)
if(NOT table STREQUAL printed)
  message(FATAL_ERROR "${PAGE} is not current: run scripts/options-page")
endif()
