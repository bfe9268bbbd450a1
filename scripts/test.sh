#!/usr/bin/env bash
# Usage: scripts/test.sh
#
# Installs what is missing, checks the style of the sources, builds everything with warnings as errors and runs all
# tests, checks that the package fits into CGAL's tree, then runs tests of the library and the program under the
# sanitizers of Clang, and meanwhile builds and checks the manual. May be run again.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 0 ] || fail "Usage: scripts/test.sh"

# The end of a long log is what is read first.
say_verdict() {
  local status=$?
  if [ $status -eq 0 ]; then
    echo "== All checks passed"
  else
    echo "== A CHECK FAILED, with exit status $status; see above for which"
  fi
}
trap say_verdict EXIT

"$root/scripts/setup.sh" --tests
run_stage "check the style" "$root/scripts/check_style.sh"
run_stage "configure" cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release \
  -DSPHERICAL_PARAMETERIZATION_BUILD_{TESTS,EXAMPLES,BENCHMARKS}=ON -DSPHERICAL_PARAMETERIZATION_WARNINGS_AS_ERRORS=ON \
  -DSPHERICAL_PARAMETERIZATION_QUICK_EXAMPLES=ON
run_stage "build everything" cmake --build "$build" -j "$jobs"
echo "== test"
ctest --test-dir "$build" --output-on-failure --no-tests=error -j 2
"$root/scripts/test_in_cgal_tree.sh" --only test_error_codes

# Of the manual, one process does nearly all. The sanitizers, which build elsewhere, need not wait for it; what it prints
# waits for them, so as not to be lost among their tests.
"$root/scripts/check_documentation.sh" >"$build/logs/manual.log" 2>&1 &
status=0
"$root/scripts/test_sanitizers.sh" || status=$?
wait $! || status=$?
cat "$build/logs/manual.log"
exit $status
