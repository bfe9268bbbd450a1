#!/usr/bin/env bash
# Usage: scripts/test.sh
#
# Installs what is missing, checks the style of the sources, builds everything with warnings as errors and runs the
# tests but those that scripts/test_long.sh has, compares some results with those on other platforms, checks that the package
# fits into CGAL's tree, builds and checks the manual, and runs tests under the sanitizer of threads. May be run again.
# Takes twenty minutes on two cores.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 0 ] || fail "Usage: scripts/test.sh"
trap say_verdict EXIT

"$root/scripts/setup.sh" --tests
run_stage "configure" cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DSPHERICAL_PARAMETERIZATION_BUILD_{TESTS,EXAMPLES,BENCHMARKS}=ON -DSPHERICAL_PARAMETERIZATION_WARNINGS_AS_ERRORS=ON \
  -DSPHERICAL_PARAMETERIZATION_QUICK_BUILD=ON

# in_background NAME COMMAND...: what a single process does, along with what follows; what it prints waits.
in_background() {
  local name=$1
  shift
  "$@" >"$build/logs/$name.out" 2>&1 &
  background+=("$! $name")
}
finish_background() {
  local entry pid name status=0
  for entry in "${background[@]}"; do
    read -r pid name <<<"$entry"
    wait "$pid" || status=$?
    cat "$build/logs/$name.out"
  done
  background=()
  [ $status -eq 0 ] || exit $status
}
background=()

in_background style run_stage "check the style" "$root/scripts/check_style.sh"
run_stage "build everything" cmake --build "$build" -j "$jobs"
finish_background
"$root/scripts/test_platforms.sh" --short
run_stage "test" ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$jobs"
run_stage "compare the quoted outputs" python3 "$root/scripts/check_outputs.py"
in_background manual "$root/scripts/check_documentation.sh"
in_background tree "$root/scripts/test_in_cgal_tree.sh" --only simple_spherical_parameterization
"$root/scripts/test_sanitizers.sh" thread
finish_background
