# Tests that all kernels run, on the map that is given or made, and that what is no map of the mesh is refused.
#
# Usage: cmake -D BENCHMARK=kernel_benchmark -D FOLDER=folder_for_meshes [-D TBB=1] -P test_kernel_benchmark.cmake
cmake_minimum_required(VERSION 3.12...3.31)

file(REMOVE_RECURSE "${FOLDER}")

# An octahedron whose top vertex is at `top`.
function(write_octahedron path top)
  string(REPLACE ";" "\n" lines
         "1 0 0;-1 0 0;0 1 0;0 -1 0;${top};0 0 -1;3 0 2 4;3 2 1 4;3 1 3 4;3 3 0 4;3 2 0 5;3 1 2 5;3 3 1 5;3 0 3 5")
  file(WRITE "${FOLDER}/${path}.off" "OFF\n6 8 0\n${lines}\n")
endfunction()

write_octahedron(mesh "0.3 0.2 2")
write_octahedron(map "0.6 0 0.8")
write_octahedron(folded "0.6 0 -0.8")
file(WRITE "${FOLDER}/small.off" "OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n")
file(WRITE "${FOLDER}/open.off" "OFF\n4 3 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n")

# Runs the benchmark. `status` is the exit status to expect; each of `patterns` is a regular expression for what is printed.
function(expect status patterns)
  execute_process(
    COMMAND "${BENCHMARK}" --benchmark_min_time=0.001 ${ARGN}
    WORKING_DIRECTORY "${FOLDER}"
    RESULT_VARIABLE result
    OUTPUT_VARIABLE text
    ERROR_VARIABLE text)
  if(NOT result EQUAL status)
    message(SEND_ERROR "${ARGN}: exit status ${result} instead of ${status}:\n${text}")
  endif()
  foreach(pattern IN LISTS patterns)
    if(NOT text MATCHES "${pattern}")
      message(SEND_ERROR "${ARGN}: no match of '${pattern}' in\n${text}")
    endif()
  endforeach()
endfunction()

# Some work is done by each.
set(kernels certificate coarsening coloring descent_setup embedding focus insertion measurement reading removal_cost
            star_derivatives star_load star_update star_value sweep)
if(TBB)
  foreach(kernel certificate coarsening descent_setup embedding measurement sweep)
    list(APPEND kernels "${kernel}_2_threads/process_time/real_time")
  endforeach()
endif()
set(lines "${kernels}")
list(TRANSFORM lines PREPEND "\n")
list(TRANSFORM lines APPEND " +[0-9.]+ us [^\n]* items_per_second=[0-9]*[.]?[0-9]*[1-9]")
expect(0 "${lines}" mesh.off)
expect(0 "${lines}" --map=map.off mesh.off)

# A map is written where there is none, and read where there is one.
expect(0 "star_value" --benchmark_filter=star_value --map=new.off mesh.off)
file(READ "${FOLDER}/new.off" first)
if(NOT first MATCHES "OFF[ \r\n]+6 8")
  message(SEND_ERROR "This is no map:\n${first}")
endif()
expect(0 "star_value" --benchmark_filter=star_value --map=new.off mesh.off)
file(READ "${FOLDER}/new.off" second)
if(NOT first STREQUAL second)
  message(SEND_ERROR "The map was written again.")
endif()
expect(1 "mesh.off: .*not one-to-one" --map=folded.off mesh.off)
expect(1 "mesh.off: the map is not that of the mesh" --map=small.off mesh.off)
expect(1 "cannot be written" --map=no_folder/map.off mesh.off)

# What is no mesh for it, and no way to call it.
expect(1 "open.off: The mesh has a border" open.off)
expect(1 "missing.off: cannot be read" missing.off)
expect(1 "Usage" mesh.off map.off)
expect(1 "Usage" --no-such-option mesh.off)
expect(0 "Usage;benchmark_filter" --help)
