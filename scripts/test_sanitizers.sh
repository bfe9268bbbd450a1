#!/usr/bin/env bash
# Usage: scripts/test_sanitizers.sh [address] [thread]
#
# Builds tests with Clang, with warnings as errors and all assertions and expensive checks, and runs them under its
# sanitizers: those of addresses and undefined behaviour, and that of threads, or only the one that is named. Which tests,
# says the CMakeLists.txt of the tests. Installs nothing; scripts/setup.sh --tests does.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -gt 0 ] || set -- address thread
for sanitizer; do
  [[ $sanitizer = address || $sanitizer = thread ]] || fail "Usage: scripts/test_sanitizers.sh [address] [thread]"
done

for sanitizer; do
  directory=$build/sanitizer_$sanitizer
  run_stage "configure for the $sanitizer sanitizer" cmake -S "$root" -B "$directory" -DCMAKE_CXX_COMPILER=clang++ \
    -DSPHERICAL_PARAMETERIZATION_BUILD_{TESTS,EXAMPLES}=ON -DSPHERICAL_PARAMETERIZATION_BUILD_BENCHMARKS=OFF \
    -DSPHERICAL_PARAMETERIZATION_WARNINGS_AS_ERRORS=ON -DSPHERICAL_PARAMETERIZATION_SANITIZER="$sanitizer" \
    -DCMAKE_CXX_FLAGS="-fsanitize-ignorelist='$root/test/Spherical_parameterization/sanitizers/undefined.txt'"
  run_stage "build for the $sanitizer sanitizer" \
    cmake --build "$directory" -j "$jobs" --target "Spherical_parameterization_${sanitizer}_tests"
  echo "== test with the $sanitizer sanitizer"
  ctest --test-dir "$directory" --output-on-failure --no-tests=error -j 2 -L "$sanitizer"
done
