#!/usr/bin/env bash
# Usage: scripts/test_cohorts.sh
#
# Runs the commands of the manual's page on cohorts as they are printed there: with the program alone, under GNU parallel, and
# as an array of Slurm, whose daemons run on this computer for as long. All three have to write the same bytes, and an array
# that was stopped has to be completed by the next one. The same for the page on pipelines: its array, and its workflow of
# Snakemake. Installs nothing; scripts/setup.sh --long-tests does.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 0 ] || fail "Usage: scripts/test_cohorts.sh"
page=$root/doc/Spherical_parameterization/Cohorts.txt
export PATH=$build/program:$PATH:/usr/sbin
for program in spherical_parameterization parallel munged slurmctld slurmd sbatch jq snakemake; do
  command -v $program >/dev/null || fail "There is no $program. Run scripts/setup.sh --long-tests and scripts/test.sh first."
done

folder=$(mktemp -d) # in a short path, as sockets have to be
export SLURM_CONF=$folder/slurm.conf
finish() {
  local file pid
  for file in "$folder"/*.daemon; do
    [ -f "$file" ] || continue
    pid=$(<"$file")
    kill "$pid" 2>/dev/null || continue
    tail --pid="$pid" -f /dev/null
  done
  rm -rf "$folder"
}
trap finish EXIT

# printed WORDS: the code on the page that has these words
printed() {
  awk -v words="$1" '/^\\code/ { code = "" }
                     /^\\endcode/ && index(code, words) { printf "%s", code; is_found = 1; exit }
                     !/^\\code/ { code = code $0 "\n" }
                     END { exit !is_found }' "$page"
}

# run_printed STATUS WORDS: runs that code, which has to exit with STATUS
run_printed() {
  local expected=$1 status=0 code
  code=$(printed "$2")
  bash -c "$code" || status=$?
  [ $status -eq "$expected" ] || fail "Exit status $status instead of $expected, of:" "$code"
}

# expect COMMAND...: COMMAND has to succeed
expect() {
  "$@" || fail "This does not hold: $*"
}

# The stages are subshells, which fail() ends.

# A folder of meshes, one of which has no map; begins to work in it.
make_meshes() {
  local name
  mkdir -p "$folder/$1/meshes"
  cd "$folder/$1"
  for name in cow cactus handle blobby cross; do
    cp "${CGAL_DATA_DIR-$build/data}/meshes/$name.off" "meshes/$name and more.off"
  done
  printf 'OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n' >meshes/border.off
}

# Compares with what the program alone has written.
expect_same_spheres() {
  local name
  expect diff <(ls spheres) <(ls "$folder/alone/spheres")
  for name in spheres/*.off; do
    expect cmp "$name" "$folder/alone/$name"
  done
}

run_alone() (
  make_meshes alone
  run_printed 1 "spherical_parameterization batch meshes --output-folder"
  expect [ "$(find spheres -name '*.off' | wc -l)" = 5 ]
)

run_parallel() (
  make_meshes parallel
  run_printed 1 "parallel -0"
  expect_same_spheres
  run_printed 0 "awk -F" >failed
  expect [ "$(wc -l <failed)" = 1 ]
  expect grep meshes/border.off failed
)

# start DAEMON...: until finish() ends it
start() {
  "$@" &
  echo $! >"$folder/$1.daemon"
}

# Starts a cluster of this computer alone, which is to have the cores and the memory that the script asks for.
start_slurm() (
  local host
  host=$(hostname -s)
  mkdir "$folder/state" "$folder/spool"
  cat >"$SLURM_CONF" <<END
ClusterName=cohorts
SlurmctldHost=$host(127.0.0.1)
SlurmctldPort=16817
SlurmdPort=16818
SlurmUser=$(id -un)
SlurmdUser=$(id -un)
AuthInfo=socket=$folder/munge.socket
StateSaveLocation=$folder/state
SlurmdSpoolDir=$folder/spool
SlurmctldPidFile=$folder/slurmctld.pid
SlurmdPidFile=$folder/slurmd.pid
ProctrackType=proctrack/linuxproc
TaskPlugin=task/none
JobAcctGatherType=jobacct_gather/none
SelectType=select/cons_tres
SelectTypeParameters=CR_Core_Memory
SlurmdParameters=config_overrides
NodeName=$host NodeAddr=127.0.0.1 CPUs=64 RealMemory=65536
PartitionName=all Nodes=ALL Default=YES
END
  (umask 077 && head -c 32 /dev/urandom >"$folder/munge.key")
  start munged --foreground --force --key-file="$folder/munge.key" --socket="$folder/munge.socket" \
    --pid-file="$folder/munged.pid" --seed-file="$folder/munge.seed" --log-file="$folder/munged.log"
  start slurmctld -D
  start slurmd -D
  wait_until 60 eval '[ "$(sinfo -h -o %t)" = idle ]'
)

# wait_until SECONDS COMMAND...
wait_until() {
  local end=$((SECONDS + $1))
  shift
  until "$@"; do
    [ $SECONDS -lt $end ] || fail "This does not come about: $*"
    sleep 0.2
  done
}
wait_for_jobs() {
  wait_until 300 eval '[ -z "$(squeue -h)" ]'
}

run_array() (
  make_meshes slurm
  printed "#SBATCH" >spheres.sbatch
  run_printed 0 "sbatch spheres.sbatch"
  wait_for_jobs
  expect_same_spheres
  expect grep -l "failed 1" spheres_*.log

  # A job that gets a signal to end, as before its time is up, leaves whole files; the next array maps what is missing.
  rm -r spheres spheres_*.log
  for k in {1..50}; do
    cp meshes/blobby*.off "meshes/$k.off"
  done
  find "$PWD/meshes" -name '*.off' | sort >meshes.txt
  local job
  job=$(sbatch --parsable --array=7 spheres.sbatch)
  wait_until 60 eval '[ -n "$(find spheres -name "*.json" 2>/dev/null)" ]'
  scancel --batch --signal=TERM "${job}_7"
  wait_for_jobs
  expect grep "interrupted" spheres_*_7.log
  (cd spheres && ls -l --time-style=full-iso) | tail -n +2 >before
  sbatch --array=3-5 spheres.sbatch
  wait_for_jobs
  (cd spheres && ls -l --time-style=full-iso) | tail -n +2 >after
  expect [ "$(grep -c -F -x -f before after)" = "$(wc -l <before)" ]
  expect [ "$(find spheres -name '*.off' | wc -l)" = 55 ]
)

collect_reports() (
  cd "$folder/slurm"
  run_printed 0 "cohort.csv"
  expect [ "$(wc -l <cohort.csv)" = 56 ]
  echo '{"input": "of another program"}' >spheres/other.json
  echo '{"distortion": {"D_iso": {"maximum": null, "average": null}}}' >spheres/infinite.json
  printed "import json" | python3 - >statistics
  expect grep "^55 maps" statistics
  expect [ "$(run_printed 0 "while read")" = "$PWD/meshes/border.off" ]
)

run_stage "map a cohort by the program alone" run_alone
run_stage "map a cohort by GNU parallel" run_parallel
run_stage "start Slurm" start_slurm
run_stage "map a cohort by a Slurm array" run_array
run_stage "collect the reports of a cohort" collect_reports

# Subjects of FreeSurfer, and the app as a command
page=$root/doc/Spherical_parameterization/Pipelines.txt
export PYTHONPATH=$build/python PATH=$folder/bin:$PATH
make_study() (
  mkdir "$folder/bin"
  printf '#!/bin/sh\nexec /usr/bin/python3 -m spherical_parameterization.bids "$@"\n' >"$folder/bin/spherical_parameterization_bids"
  chmod +x "$folder/bin/spherical_parameterization_bids"
  /usr/bin/python3 "$root/test/Spherical_parameterization/make_subjects.py" "$folder/subjects" 16
  for name in array workflow; do
    mkdir "$folder/$name"
    cp -r "$folder/subjects/freesurfer" "$folder/$name/study"
  done
)

run_array_of_subjects() (
  cd "$folder/array"
  printed "#SBATCH" >subjects.sbatch
  run_printed 0 "sbatch --array"
  wait_for_jobs
  expect [ "$(ls out/sub-*.html)" = "$(printf 'out/sub-01.html\nout/sub-02.html')" ]
  expect [ "$(find out -name '*_desc-reg_sphere.surf.gii' | wc -l)" = 4 ]
  run_printed 0 "sbatch --array"
  wait_for_jobs
  expect grep -q "skipped" slurm-*.out
)

run_workflow() (
  cd "$folder/workflow"
  printed "glob_wildcards" >Snakefile
  snakemake --cores 2
  # The same files as the array has written, but for the seconds that it took
  expect diff <(cd "$folder/array/out" && find . -type f | sort) <(cd out && find . -type f | sort)
  for file in $(cd out && find . -name '*.gii'); do
    expect cmp "out/$file" "$folder/array/out/$file"
  done
  expect grep -q "Nothing to be done" <(snakemake --cores 2 2>&1)
)

run_stage "make subjects" make_study
run_stage "map subjects by a Slurm array" run_array_of_subjects
run_stage "map subjects by Snakemake" run_workflow
