# Tests that the robustness benchmark tells good maps, refusals and all that is wrong from each other, with commands of
# the shell as the programs that it judges.
#
# Usage: cmake -D BENCHMARK=robustness_benchmark -D FOLDER=folder_for_meshes [-D PACKAGE=1 [-D LIMITS=options]] -P
#   test_robustness_benchmark.cmake
cmake_minimum_required(VERSION 3.12...3.31)

file(REMOVE_RECURSE "${FOLDER}")

function(write_off path number_of_vertices number_of_faces)
  string(REPLACE ";" "\n" lines "${ARGN}")
  file(WRITE "${FOLDER}/${path}.off" "OFF\n${number_of_vertices} ${number_of_faces} 0\n${lines}\n")
endfunction()

# Runs the benchmark on files or folders with a command as the program. `status` is the exit status to expect, `pattern`
# a regular expression for what is printed. More options may follow.
function(expect status pattern inputs command)
  list(TRANSFORM inputs PREPEND "${FOLDER}/")
  if(command)
    set(program --program "${command}")
  endif()
  execute_process(
    COMMAND "${BENCHMARK}" ${program} ${ARGN} ${inputs}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE text
    ERROR_VARIABLE text)
  if(NOT result EQUAL status OR NOT text MATCHES "${pattern}")
    message(SEND_ERROR "${command} on ${inputs}: exit status ${result} instead of ${status}, or no match of "
                       "'${pattern}' in\n${text}")
  endif()
endfunction()

# An octahedron whose top vertex is at `top`.
function(write_octahedron path top)
  write_off(
    ${path} 6 8 "1 0 0" "-1 0 0" "0 1 0" "0 -1 0" "${top}" "0 0 -1" "3 0 2 4" "3 2 1 4" "3 1 3 4" "3 3 0 4" "3 2 0 5"
    "3 1 2 5" "3 3 1 5" "3 0 3 5")
endfunction()

write_octahedron(good/hard_sphere "0 0 1")
write_octahedron(folded "0.6 0 -0.8")
write_octahedron(flat "0.6 0.8 0") # four faces lie in the plane of the equator
write_octahedron(high "0 0 2")
write_octahedron(nowhere "0 0 inf")
write_off(
  open 6 7 "1 0 0" "-1 0 0" "0 1 0" "0 -1 0" "0 0 1" "0 0 -1" "3 0 2 4" "3 2 1 4" "3 1 3 4" "3 3 0 4" "3 2 0 5"
  "3 1 2 5" "3 3 1 5")
# All faces are positive, but the star of either pole is a pentagram.
write_off(
  double 7 10 "1 0 0" "-0.80901699437494745 0.58778525229247314 0" "0.30901699437494745 -0.95105651629515353 0"
  "0.30901699437494745 0.95105651629515353 0" "-0.80901699437494745 -0.58778525229247314 0" "0 0 1" "0 0 -1" "3 0 1 5"
  "3 1 2 5" "3 2 3 5" "3 3 4 5" "3 4 0 5" "3 1 0 6" "3 2 1 6" "3 3 2 6" "3 4 3 6" "3 0 4 6")
write_off(mixed/invalid_text 0 0 "nothing")
configure_file("${FOLDER}/good/hard_sphere.off" "${FOLDER}/mixed/hard_sphere.off" COPYONLY)
configure_file("${FOLDER}/good/hard_sphere.off" "${FOLDER}/mixed/it's a sphere.off" COPYONLY)
configure_file("${FOLDER}/folded.off" "${FOLDER}/mixed/folded.off" COPYONLY)

# What is printed for a single mesh: 1 file, and how many of it are certified, refused and wrong.
set(certified "all +\\| +1 \\| +1 \\| +0 \\| +0 \\|")
set(refused "all +\\| +1 \\| +0 \\| +1 \\| +0 \\|")
set(wrong "all +\\| +1 \\| +0 \\| +0 \\| +1 \\|")

# Maps, by programs that give back what they get.
set(copy "cp {input} {output}")
expect(0 "${certified}.* 1.000 \\| +1.000 " good "${copy}")
expect(0 "hard_sphere.off +\\| certified \\| +6 " good "${copy}" --list)
expect(0 "\"all\",1,1,0,0," good "${copy}" --csv)
expect(1 "${wrong}.*wrong: .*folded.off: [1-4] of 8 faces are folded" folded.off "${copy}")
expect(1 "${wrong}.*4 of 8 faces are folded over or have no area" flat.off "${copy}")
expect(1 "${wrong}.*cover the sphere 2 times" double.off "${copy}")
expect(1 "${wrong}.*on no sphere" high.off "${copy}")
expect(1 "${wrong}.*no closed surface" open.off "${copy}")
expect(1 "${wrong}.*(cannot be read|vertex 4 has no finite image)" nowhere.off "${copy}") # as CGAL reads infinity
expect(1 "${wrong}.*other numbers of vertices" good "cp '${FOLDER}/double.off' {output} # {input}")
expect(1 "${wrong}.*the map cannot be read" good "echo nonsense > {output} # {input}")

# Programs without a map.
expect(0 "${refused}.*refused: [^\n]*good/hard_sphere.off: bad luck" good "echo {input}: bad luck >&2 && exit 1 # {output}")
expect(0 "${refused}.*refused: [^\n]*good/hard_sphere.off: without a word" good "exit 3 # {input} {output}")
expect(1 "${wrong}.*wrote no map" good "true {input} {output}")
expect(1 "${wrong}.*broke down" good "kill -SEGV $$ # {input} {output}")
expect(1 "${wrong}.*broke down" good "sh -c 'kill -SEGV $$' {input} {output}")
expect(1 "${wrong}.*cannot be run" good "./no_such_program {input} {output}")
expect(1 "${wrong}.*did not end within 1 seconds" good "sleep 1000 # {input} {output}" --time-limit 1)
expect(1 "${wrong}.*wrote no map" good "head -c 300000000 /dev/zero | tail -n 1 > /dev/null # {input} {output}")
expect(0 "${refused}" good "head -c 300000000 /dev/zero | tail -n 1 > /dev/null # {input} {output}" --memory-limit 100)

# Several at once.
set(row " +\\| +")
string(
  CONCAT rows
  "mixed/\\*${row}2${row}1${row}0${row}1 .*"
  "mixed/hard_\\*${row}1${row}1${row}0${row}0 .*"
  "mixed/invalid_\\*${row}1${row}0${row}1${row}0 .*"
  "all${row}4${row}2${row}1${row}1 ")
expect(1 "${rows}" mixed "! grep -q nothing {input} && ${copy}")

# The second run writes nothing, and must not get what the first one wrote.
set(once "${FOLDER}/once")
expect(1 "all${row}2${row}1${row}0${row}1 .*wrote no map" "good;good"
       "test ! -e '${once}' && touch '${once}' && ${copy} || true")

# What is no way to call it.
expect(1 "{output}" good "cp {input} .")
expect(1 "no such file" missing.off "${copy}")
expect(1 "A limit is" good "${copy}" --time-limit=-1)

# The package's own program, if there is one: all of these are valid meshes, but two.
if(PACKAGE)
  expect(0 "all${row}10${row}8${row}2${row}0 .*refused: [^\n]*nowhere.off: vertex 4 .*refused: [^\n]*invalid_text.off: "
         "folded.off;flat.off;double.off;high.off;nowhere.off;good;mixed" "" ${LIMITS})
endif()
