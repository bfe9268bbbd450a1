# Tests the comparison with other programs: what is said of good maps, of bad ones and of none, and all the numbers. The
# programs are commands of the shell, and so is the package, unless there is one.
#
# Usage: cmake -D BENCHMARK=comparison_benchmark -D FOLDER=folder_for_meshes [-D PACKAGE=1 [-D LIMITS=options]] -P
#   test_comparison_benchmark.cmake
cmake_minimum_required(VERSION 3.12...3.31)

file(REMOVE_RECURSE "${FOLDER}")

# An octahedron whose top and bottom vertices are at `top` and `bottom`, with the faces in the order that is given.
set(faces "3 0 2 4" "3 2 1 4" "3 1 3 4" "3 3 0 4" "3 2 0 5" "3 1 2 5" "3 3 1 5" "3 0 3 5")
function(write_octahedron path top bottom)
  string(REPLACE ";" "\n" lines "1 0 0;-1 0 0;0 1 0;0 -1 0;${top};${bottom};${ARGN}")
  file(WRITE "${FOLDER}/${path}.off" "OFF\n6 8 0\n${lines}\n")
endfunction()

write_octahedron(regular "0 0 1" "0 0 -1" ${faces})
write_octahedron(tall "0 0 2" "0 0 -2" ${faces})
write_octahedron(maps/tilted "0.6 0 0.8" "0 0 -1" ${faces})
write_octahedron(maps/folded "0.6 0 -0.8" "0 0 -1" ${faces})
write_octahedron(maps/near "0 0 1.00001" "0 0 -1" ${faces})
write_octahedron(maps/far "0 0 1.001" "0 0 -1" ${faces})
list(REVERSE faces)
write_octahedron(maps/reversed "0 0 1" "0 0 -1" ${faces})
list(REMOVE_AT faces 7)
write_octahedron(maps/other "0 0 1" "0 0 -1" ${faces} "3 0 4 2")
write_octahedron(maps/four_corners "0 0 1" "0 0 -1" ${faces} "4 0 2 4 1")
file(WRITE "${FOLDER}/maps/small.off" "OFF\n4 4 0\n1 1 1\n1 -1 -1\n-1 1 -1\n-1 -1 1\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n")
file(WRITE "${FOLDER}/no_mesh.off" "nothing\n")

# Takes the place of the package: maps every octahedron to the regular one, which `package_failure` can prevent.
file(WRITE "${FOLDER}/package.sh"
     "test \"$2\" = -o && test \"$4\" = --quiet || exit 3\necho \"run of $# arguments\" >> '${FOLDER}/runs'\n"
     "grep -q nothing \"$1\" && exit 1\ncp '${FOLDER}/regular.off' \"$3\"\n")

# Runs the benchmark on files with programs. `status` is the exit status to expect, `pattern` a regular expression for what
# is printed. More options may follow.
function(expect status pattern inputs programs)
  list(TRANSFORM inputs PREPEND "${FOLDER}/")
  set(options --csv)
  if(NOT "--package" IN_LIST ARGN AND NOT PACKAGE_ONLY)
    list(APPEND options --package "sh '${FOLDER}/package.sh'")
  endif()
  foreach(program IN LISTS programs)
    list(APPEND options --program "${program}")
  endforeach()
  execute_process(
    COMMAND "${BENCHMARK}" ${options} ${ARGN} ${inputs}
    RESULT_VARIABLE result
    OUTPUT_VARIABLE text
    ERROR_VARIABLE text)
  if(NOT result EQUAL status OR NOT text MATCHES "${pattern}")
    message(SEND_ERROR "${programs} on ${inputs}: exit status ${result} instead of ${status}, or no match of "
                       "'${pattern}' in\n${text}")
  endif()
endfunction()

set(maps "${FOLDER}/maps")
set(number "[0-9.]+")
set(times "${number},${number},${number}") # and the memory
set(no_ratios "-,-,-,-,-")
set(failed "-,-,-,-,-,${times},${no_ratios}")
set(perfect "certified,0,1.000,1.000,2.000,2.000,${times}")

# Maps: the distortions, at whatever radius, and the ratios. The last map is that of the first program.
expect(0 "\"regular\",\"package, 1 thread\",6,${perfect},1.000,1.000,1.000,1.000,1.000\n" regular.off "")
expect(0 "\"regular\",\"package\",6,${perfect},${number},1.000,1.000,1.000,1.000\n" regular.off "")
expect(0 "\"tilted\",6,certified,0,1.533,1.225,2.309,2.108,${times},${number},1.533,1.225,1.155,1.054\n" regular.off
       "tilted=cp '${maps}/tilted.off' {output} # {input}")
expect(0 "\"tilted\",6,certified,0,1.885,1.500,3.000,2.466,${times},${number},1.432,1.140,1.299,1.068\n" tall.off
       "tilted=cp '${maps}/tilted.off' {output} # {input}")
expect(0 "\"reversed\",6,${perfect}," regular.off "reversed=cp '${maps}/reversed.off' {output} # {input}")
expect(0 "\"near\",6,certified,0,1.000," regular.off "near=cp '${maps}/near.off' {output} # {input}")
expect(0 "\"a, b\",6,${perfect}," regular.off "a, b=cp {input} {output}")

# Formats: the copy is a map only if both files are in the format, for the faces of the one are read from the other.
foreach(format obj ply ts)
  expect(0 "\"copy\",6,${perfect}," regular.off "copy=cp {input.${format}} {output.${format}}")
  expect(0 "\"copy\",-,no map,.*copy: .*off: " regular.off "copy=cp {input.${format}} {output}")
endforeach()
expect(0 "\"obj\",6,${perfect}," regular.off "obj=grep -q '^v' {input.obj} && cp {input.obj} {output.obj}")

# What is no one-to-one map.
expect(0 "\"folded\",6,folds,[1-4],${number},${number},${number},${number},${times},${no_ratios}\n.*of 8 faces are folded"
       regular.off "folded=cp '${maps}/folded.off' {output} # {input}")
expect(0 "\"far\",6,no map,0,.*,${no_ratios}\n.*far: the images are on no sphere" regular.off
       "far=cp '${maps}/far.off' {output} # {input}")
expect(0 "\"other\",-,no map,${failed}\n.*other: the map has other faces than the mesh" regular.off
       "other=cp '${maps}/other.off' {output} # {input}")
expect(0 "\"four\",-,no map,${failed}\n.*other faces" regular.off "four=cp '${maps}/four_corners.off' {output} # {input}")
expect(0 "\"small\",-,no map,${failed}\n.*small: the map has other numbers of vertices" regular.off
       "small=cp '${maps}/small.off' {output} # {input}")
expect(0 "\"text\",-,no map,${failed}\n" regular.off "text=echo nonsense > {output} # {input}")

# Failures are lines; what comes after them is run all the same. They are not run again.
set(copy "copy=cp {input} {output}")
expect(0 "\"segv\",-,broke down,${failed}\n.*\"copy\",6,${perfect}" regular.off "segv=kill -SEGV $$ # {input} {output};${copy}")
expect(0 "\"endless\",-,timed out,${failed}\n.*\"copy\",6,${perfect}.*endless: did not end within 1 s" regular.off
       "endless=sleep 1000 # {input} {output};${copy}" --time-limit 1)
expect(0 "\"rude\",-,refused,${failed}\n.*\"copy\",6,${perfect}.*rude: bad luck" regular.off
       "rude=echo bad luck >&2 && exit 1 # {input} {output};${copy}")
expect(0 "\"lazy\",-,no map,${failed}\n.*lazy: succeeded, but wrote no map" regular.off "lazy=true {input} {output}")
expect(0 "\"absent\",-,not run,${failed}\n.*absent: the command cannot be run" regular.off "absent=./no_such {input} {output}")
expect(0 "\"fat\",-,refused," regular.off "fat=head -c 300000000 /dev/zero | tail -n 1 > /dev/null # {input} {output}"
       --memory-limit 100)

# The time of processes that outlive the one that the shell waits for counts, and of those that it has waited for.
set(work "head -c 1000000000 /dev/zero > /dev/null")
expect(0 "\"parent\",6,${perfect},.*\"child\",6,certified,0,1.000,1.000,2.000,2.000,(0.0[1-9]|0.[1-9]|[1-9])" regular.off
       "parent=cp {input} {output};child=sh -c '${work}' && cp {input} {output}")
expect(0 "\"orphan\",-,timed out,-,-,-,-,-,(0.0[1-9]|0.[1-9]|[1-9])" regular.off
       "orphan=yes > /dev/null & sleep 1000 # {input} {output}" --time-limit 1)

# How often everything is run: twice for the package, with and without --threads 1.
file(REMOVE "${FOLDER}/runs")
expect(0 "" regular.off "once=echo once >> '${FOLDER}/runs' && exit 1 # {input} {output}" --repeat 4)
file(READ "${FOLDER}/runs" runs)
foreach(line "run of 4 arguments:4" "run of 6 arguments:4" "once:1")
  string(REPLACE ":" ";" line "${line}")
  list(GET line 0 text)
  list(GET line 1 expected)
  string(REGEX MATCHALL "${text}" matches "${runs}")
  list(LENGTH matches count)
  if(NOT count EQUAL expected)
    message(SEND_ERROR "'${text}' is found ${count} times instead of ${expected} in\n${runs}")
  endif()
endforeach()

# Geometric means, over what is mapped by both, and a mesh that none can map.
set(means "geometric means\",meshes,certified,folded,failed,in common,.*")
expect(0 "${means}\"tilted\",2,2,0,0,2,${number},1.482,1.182,1.225,1.061\n" "regular.off;tall.off"
       "tilted=cp '${maps}/tilted.off' {output} # {input}")
expect(0 "${means}\"picky\",2,1,1,0,1,${number},1.432,1.140,1.299,1.068\n" "regular.off;tall.off"
       "picky=grep -q '0 0 2' {input} && cp '${maps}/tilted.off' {output} || cp '${maps}/folded.off' {output}")
expect(1 "\"no_mesh\",\"package\",-,refused,.*${means}\"package\",2,1,0,1,1,.*\"copy\",2,1,0,1,1,${number},1.000"
       "no_mesh.off;regular.off" "${copy}")
expect(1 "\"no_mesh\",\"copy\",-,not run,.*no_mesh.off: copy: .*no_mesh.off: " no_mesh.off "copy=cp {input.obj} {output.obj}")
expect(1 "\"package\",1,0,0,1,0,${no_ratios}\n.*\"tilted\",1,1,0,0,0,${no_ratios}" tall.off
       "tilted=cp '${maps}/tilted.off' {output} # {input}" --package false)

# What is no way to call it.
expect(1 "{output} has to be in the command" regular.off "copy=cp {input} .")
expect(1 "two formats of its input" regular.off "copy=cat {input} {input.ply} > {output}")
expect(1 "the format .stl is none of" regular.off "copy=cp {input} {output.stl}")
expect(1 "NAME=COMMAND" regular.off "cp {input} {output}")
expect(1 "Two programs have the name copy" regular.off "${copy};${copy}")
expect(1 "no such file" missing.off "${copy}")
expect(1 "--repeat must" regular.off "${copy}" --repeat 0)
expect(1 "A limit is" regular.off "${copy}" --time-limit=-1)

# The package's own program, if there is one.
if(PACKAGE)
  set(PACKAGE_ONLY ON)
  expect(0 "\"package\",2,2,0,0,2,${number},1.000,1.000,1.000,1.000\n.*\"copy\",2,1,0,1,1," "regular.off;tall.off" "${copy}"
         ${LIMITS})
endif()
