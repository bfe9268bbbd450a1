# cmake -DPROGRAMS=A;B;... -P compare_output.cmake
#
# Runs programs; fails if one of them fails, or prints something else than the first.

foreach(program IN LISTS PROGRAMS)
  execute_process(COMMAND "${program}" OUTPUT_VARIABLE output RESULT_VARIABLE status ERROR_VARIABLE messages)
  if(NOT status EQUAL 0)
    message(FATAL_ERROR "${program} fails (${status}):\n${messages}")
  endif()
  if(NOT DEFINED first_output)
    set(first_output "${output}")
  endif()
  if(NOT output STREQUAL first_output OR output STREQUAL "")
    message(FATAL_ERROR "${program} prints\n${output}where the first one prints\n${first_output}")
  endif()
  message(STATUS "${program}: ${output}")
endforeach()
