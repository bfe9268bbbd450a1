# Builds the reference of the Python module in OUTPUT, by Sphinx and numpydoc for the interpreter PYTHON. It uses the Sphinx project
# SOURCE, the Python files MODULE and the compiled part CORE, all copied to WORK. If CORE or Sphinx is missing, OUTPUT gets a page
# that says so, so that links to it remain valid.

file(REMOVE_RECURSE "${OUTPUT}" "${WORK}")
set(missing)
if(NOT EXISTS "${CORE}")
  list(APPEND missing "the target spherical_parameterization_python is not built")
endif()
execute_process(COMMAND "${PYTHON}" -c "import numpydoc, sphinx" RESULT_VARIABLE status OUTPUT_QUIET ERROR_QUIET)
if(NOT status EQUAL 0)
  list(APPEND missing "Sphinx or numpydoc is not found")
endif()
if(missing)
  list(JOIN missing ", and " missing)
  set(notice "This manual is without the reference of the Python module: ${missing}.")
  message("NOTICE: ${notice}")
  file(WRITE "${OUTPUT}/index.html" "<!DOCTYPE html>\n<title>Python reference</title>\n<p>${notice}</p>\n")
  return()
endif()

file(COPY "${SOURCE}" "${MODULE}" DESTINATION "${WORK}")
get_filename_component(source "${SOURCE}" NAME)
get_filename_component(module "${MODULE}" NAME)
file(COPY "${CORE}" DESTINATION "${WORK}/${module}")
set(ENV{PYTHONPATH} "${WORK}")
execute_process(COMMAND "${PYTHON}" -m sphinx -q -W --keep-going -d "${WORK}/doctrees" "${WORK}/${source}" "${OUTPUT}"
                RESULT_VARIABLE status)
if(NOT status EQUAL 0)
  message(FATAL_ERROR "Sphinx has found faults in the docstrings, or failed (status ${status}).")
endif()
