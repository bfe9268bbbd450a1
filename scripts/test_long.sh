#!/usr/bin/env bash
# Usage: scripts/test_long.sh
#
# What takes too long for scripts/test.sh, which is to be run first: 20,000 random triangulations instead of 500, other
# tests with as many more repetitions, each header on its own, compile flags, errors and times, the benchmarks, all tests
# under the sanitizer of addresses, every program in a CGAL tree, other platforms, the commands of the manual for
# cohorts, packages and the container on bare systems, and each fuzzer for ten minutes. Takes about two hours on two cores.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 0 ] || fail "Usage: scripts/test_long.sh"
[ -f "$build/CMakeCache.txt" ] || fail "Run scripts/test.sh first."
trap say_verdict EXIT
export SPHERICAL_PARAMETERIZATION_LONG_TESTS=1

"$root/scripts/setup.sh" --long-tests
run_stage "configure" cmake "$build" -DSPHERICAL_PARAMETERIZATION_QUICK_BUILD=OFF
run_stage "build everything with optimization" cmake --build "$build" -j "$jobs"
run_stage "long tests" ctest --test-dir "$build" --output-on-failure --no-tests=error -j "$jobs"
run_stage "compile times" "$root/scripts/measure_compile_time.py" --program --check
"$root/scripts/test_sanitizers.sh" --all
"$root/scripts/test_in_cgal_tree.sh"
"$root/scripts/test_platforms.sh"
"$root/scripts/test_cohorts.sh"
"$root/scripts/setup.sh" --packages
"$root/scripts/test_packages.sh"

# What a fuzzer finds that is new stays in build/fuzz/NAME, what makes it fail beside the log.
fuzz() {
  local name=$1 directory=$build/fuzz
  local dictionary=$root/test/Spherical_parameterization/fuzz/$name.dict
  mkdir -p "$directory/$name" "$directory/failures"
  "$directory/test/Spherical_parameterization/fuzz/fuzz_$name" "$directory/$name" \
    "$root/test/Spherical_parameterization/fuzz/corpus/$name" -artifact_prefix="$directory/failures/${name}_" \
    -max_total_time=600 -rss_limit_mb=2048 -malloc_limit_mb=1024 -timeout=20 \
    $([ ! -f "$dictionary" ] || echo "-dict=$dictionary")
}
run_stage "configure the fuzzers" cmake -S "$root" -B "$build/fuzz" -DCMAKE_CXX_COMPILER=clang++ \
  -DSPHERICAL_PARAMETERIZATION_BUILD_{PROGRAM,EXAMPLES,BENCHMARKS}=OFF -DSPHERICAL_PARAMETERIZATION_BUILD_FUZZERS=ON
for name in reading parameterize surfaces onto images surface_files; do
  run_stage "build the fuzzer of $name" cmake --build "$build/fuzz" --target "fuzz_$name"
  run_stage "fuzz $name" fuzz "$name"
done
