# Runs DOXYGEN with DOXYFILE, shows what it has written to WARNINGS, and fails if that is anything.

# Doxygen calls BibTeX in the folder of its files, which BibTeX alone, without the rest of TeX, does not look into.
set(ENV{BIBINPUTS} ".:")
set(ENV{BSTINPUTS} ".:")
execute_process(COMMAND "${DOXYGEN}" "${DOXYFILE}" RESULT_VARIABLE status)
file(READ "${WARNINGS}" warnings)
if(NOT warnings STREQUAL "" OR NOT status EQUAL 0)
  message("${warnings}")
  message(FATAL_ERROR "Doxygen has found faults in the documentation, or failed (status ${status}).")
endif()
