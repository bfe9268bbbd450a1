#!/usr/bin/env bash
# Usage: scripts/test_platforms.sh [--short]
#
# Compares results with the table of hashes where other compilers, flags, processors and systems could give others: by g++ and Clang
# with all kinds of flags, without AVX-512 and AVX2, on AArch64 and on Windows; and runs the tests of the core there, and those of files on a
# big-endian machine as well. QEMU and Wine run what is for other machines. Run scripts/test.sh first. Takes half an hour on two cores.
#
# With --short: five meshes on AArch64 and on Windows. Takes a minute.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[[ "$*" == @(|--short) ]] || fail "Usage: scripts/test_platforms.sh [--short]"
tests=$root/test/Spherical_parameterization
folder=$build/platforms
mkdir -p "$folder/include"
for name in CGAL boost; do # those beside them are of this system
  ln -sfn "/usr/include/$name" "$folder/include/$name"
done
export SPHERICAL_PARAMETERIZATION_DATA_DIR=${SPHERICAL_PARAMETERIZATION_DATA_DIR-$root/../shared/data}
[ -n "${CGAL_DATA_DIR-}" ] || export CGAL_DATA_DIR=$build/data
wine=$(PATH=$PATH:/usr/lib/wine type -P wine64 || type -P wine || true)
export WINEPREFIX=$folder/wine WINEDEBUG=-all

libraries=()
# compile_hashes NAME SOURCES COMPILER...: the headers alone, by the compiler with these flags; SOURCES is spheres, or that and
# operations.
compile_hashes() {
  local name=$1 sources=$2 source macro=()
  shift 2
  [[ $sources == *operations* ]] || macro=(-DHASHES_OF_SPHERES_ONLY)
  for source in main $sources; do
    echo "#include \"$tests/reproducibility/$source.cpp\""
  done >"$folder/$name.cpp"
  "$@" -std=c++17 "${macro[@]}" -I"$root/include" -I"$tests/include" "$folder/$name.cpp" -o "$folder/$name" "${libraries[@]}"
}
cross=(-O1 -w -static -DCGAL_DISABLE_GMP -I"$folder/include")

# compare_hashes ROWS COMMAND...: ROWS are words of rows, or the largest number of vertices.
compare_hashes() {
  local rows
  read -ra rows <<<"$1"
  shift
  "$@" "$tests/reproducibility/hashes.txt" "${rows[@]}"
}

if [ "${1-}" = --short ]; then
  missing=$([ -n "$wine" ] || echo Wine)
  for program in aarch64-linux-gnu-g++ x86_64-w64-mingw32-g++-posix qemu-aarch64-static; do
    command -v $program >/dev/null || missing+=" $program"
  done
  if [ -n "$missing" ]; then
    [ -z "${CI-}" ] || fail "Not installed: $missing"
    echo "Not installed: $missing. Results are not compared with those on other platforms."
    exit
  fi
  on_aarch64() {
    compile_hashes aarch64_short spheres aarch64-linux-gnu-g++ "${cross[@]}"
    compare_hashes "--generated default" qemu-aarch64-static "$folder/aarch64_short"
  }
  on_windows() {
    compile_hashes windows.exe spheres x86_64-w64-mingw32-g++-posix "${cross[@]}"
    compare_hashes "--generated default" "$wine" "$folder/windows.exe"
  }
  run_stage "five meshes on Windows" on_windows &
  run_stage "five meshes on AArch64" on_aarch64
  wait $!
  exit
fi

trap say_verdict EXIT
"$root/scripts/setup.sh" --long-tests
libraries=(-lmpfr -lgmp)

# with_flags NAME SOURCES ROWS COMPILER...
with_flags() {
  local name=$1 sources=$2 rows=$3
  shift 3
  compile_hashes "$name" "$sources" "$@" -w -I/usr/include/eigen3 -DCGAL_EIGEN3_ENABLED
  compare_hashes "$rows" "$folder/$name"
}
run_stage "g++ -O0" with_flags gcc_O0 spheres "--largest 3000" g++ -O0 &
run_stage "g++ -O3 -march=native" with_flags gcc_native "spheres operations" "--largest 100000" g++ -O3 -march=native
wait $!
run_stage "g++ in the standard language" with_flags gcc_standard "spheres operations" "--largest 10000" \
  g++ -O2 -pedantic-errors -DCGAL_SPHERICAL_PARAMETERIZATION_STANDARD_CXX &
run_stage "clang++ -march=native with libc++" with_flags clang_native "spheres operations" "--largest 100000" \
  clang++ -O2 -march=native -stdlib=libc++
wait $!
run_stage "g++ -O2" with_flags gcc_O2 spheres "--largest 100000" g++ -O2
for processor in Haswell Nehalem; do # without AVX-512, and without AVX2
  run_stage "g++ -O2 on $processor" compare_hashes "--largest 1000" qemu-x86_64-static -cpu $processor "$folder/gcc_O2"
done

# on PLATFORM TARGET...: builds by a toolchain of the folder cmake/, and runs the tests of these names.
on() {
  local platform=$1 other=$build/$1
  shift
  local toolchain=(-DCMAKE_TOOLCHAIN_FILE="$root/cmake/toolchain_$platform.cmake" -DCMAKE_BUILD_TYPE=Release)
  cmake -S /usr/src/googletest -B "$other/googletest" "${toolchain[@]}" -DBUILD_GMOCK=OFF -DCMAKE_INSTALL_PREFIX="$other/root"
  cmake --build "$other/googletest" --target install -j "$jobs"
  CXXFLAGS=-DCGAL_SPHERICAL_PARAMETERIZATION_TEST_IS_SLOW cmake -S "$root" -B "$other" "${toolchain[@]}" \
    -DSPHERICAL_PARAMETERIZATION_BUILD_{EXAMPLES,BENCHMARKS,PROGRAM}=OFF -DSPHERICAL_PARAMETERIZATION_QUICK_BUILD=ON \
    -DCGAL_DATA_DIR="$CGAL_DATA_DIR"
  cmake --build "$other" --target "$@" -j "$jobs"
  ctest --test-dir "$other" --output-on-failure --no-tests=error -j "$jobs" -R "^($(IFS='|' && echo "$*"))\$"
}
run_stage "tests on AArch64" on aarch64 test_numbers test_certificate test_mesh test_hierarchy test_descent test_files
hashes_on_aarch64() {
  libraries=()
  compile_hashes aarch64 "spheres operations" aarch64-linux-gnu-g++ "${cross[@]}" -O2 -I/usr/include/eigen3 -DCGAL_EIGEN3_ENABLED
  compare_hashes "--largest 3000" qemu-aarch64-static "$folder/aarch64"
}
run_stage "hashes on AArch64" hashes_on_aarch64
run_stage "tests of files on a big-endian machine" on s390x test_files
"$root/scripts/test_windows.sh"
