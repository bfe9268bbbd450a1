#!/usr/bin/env bash
# Usage: scripts/test_sanitizers.sh [--all] [address] [thread]
#
# Builds tests with Clang, with warnings as errors and all assertions and expensive checks, and runs them under its
# sanitizers: those of addresses and undefined behaviour, and that of threads, or only the one that is named. Which tests,
# says the CMakeLists.txt of the tests; with --all, the sanitizer of addresses judges all of them, and the program.
# Installs nothing; scripts/setup.sh --tests does.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

program=OFF
tests_of_address=address
if [ "${1-}" = --all ]; then
  program=ON
  tests_of_address=unit
  shift
fi
[ $# -gt 0 ] || set -- address thread
for sanitizer; do
  [[ $sanitizer = address || $sanitizer = thread ]] ||
    fail "Usage: scripts/test_sanitizers.sh [--all] [address] [thread]"
done

for sanitizer; do
  directory=$build/sanitizer_$sanitizer
  tests=$sanitizer
  [ "$sanitizer" = thread ] || tests=$tests_of_address
  run_stage "configure for the $sanitizer sanitizer" cmake -S "$root" -B "$directory" -DCMAKE_CXX_COMPILER=clang++ \
    -DSPHERICAL_PARAMETERIZATION_BUILD_TESTS=ON -DSPHERICAL_PARAMETERIZATION_BUILD_PROGRAM=$program -DSPHERICAL_PARAMETERIZATION_BUILD_EXAMPLES=OFF \
    -DSPHERICAL_PARAMETERIZATION_BUILD_BENCHMARKS=OFF \
    -DSPHERICAL_PARAMETERIZATION_WARNINGS_AS_ERRORS=ON -DSPHERICAL_PARAMETERIZATION_SANITIZER="$sanitizer" \
    -DCMAKE_CXX_FLAGS="-fsanitize-ignorelist='$root/test/Spherical_parameterization/sanitizers/undefined.txt'"
  run_stage "build for the $sanitizer sanitizer" \
    cmake --build "$directory" -j "$jobs" --target "Spherical_parameterization_${tests}_tests"
  run_stage "test with the $sanitizer sanitizer" \
    ctest --test-dir "$directory" --output-on-failure --no-tests=error -j "$jobs" -L "$tests"
done
