#!/usr/bin/env bash
# Usage: scripts/test_windows.sh
#
# Builds the program and tests for Windows, by MinGW-w64, runs them under Wine, and compares what the program writes with what that
# of this system does. Run scripts/test.sh first. Takes fifteen minutes on two cores.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 0 ] || fail "Usage: scripts/test_windows.sh"
[ -x "$build/program/spherical_parameterization" ] || fail "Run scripts/test.sh first."
trap say_verdict EXIT

"$root/scripts/setup.sh" --long-tests
windows=$build/windows
toolchain=(-DCMAKE_TOOLCHAIN_FILE="$root/cmake/toolchain_mingw.cmake" -DCMAKE_BUILD_TYPE=Release)
run_stage "configure GoogleTest for Windows" cmake -S /usr/src/googletest -B "$windows/googletest" "${toolchain[@]}" \
  -DBUILD_GMOCK=OFF -DCMAKE_INSTALL_PREFIX="$windows/root"
run_stage "build GoogleTest for Windows" cmake --build "$windows/googletest" --target install -j "$jobs"
run_stage "configure for Windows" cmake -S "$root" -B "$windows" "${toolchain[@]}" \
  -DSPHERICAL_PARAMETERIZATION_BUILD_{EXAMPLES,BENCHMARKS}=OFF -DSPHERICAL_PARAMETERIZATION_QUICK_BUILD=ON \
  -DCGAL_DATA_DIR="${CGAL_DATA_DIR-$build/data}"
run_stage "build for Windows" cmake --build "$windows" -j "$jobs" \
  --target spherical_parameterization hashes test_numbers test_certificate test_mesh test_hierarchy test_descent test_files

wine=$(PATH=$PATH:/usr/lib/wine type -P wine64 || type -P wine) || fail "Wine is not installed."
export WINEPREFIX=$windows/wine WINEDEBUG=-all LC_ALL=C.UTF-8 # for the names of files
run_stage "start Wine" "$wine" wineboot --init
run_stage "tests under Wine" ctest --test-dir "$windows" --output-on-failure --no-tests=error -j "$jobs" \
  -R '^(hashes|test_(numbers|certificate|mesh|hierarchy|descent|files))$'

# with_both ARGUMENT...: runs both programs, each in a folder of its own, and keeps what they print and return.
folder=$windows/comparison
count=0
with_both() {
  local system program status
  count=$((count + 1))
  for system in here windows; do
    program=("$build/program/spherical_parameterization")
    [ $system = here ] || program=("$wine" "$windows/program/spherical_parameterization.exe")
    status=0
    (cd "$folder/$system" && "${program[@]}" "$@" >"$count.out" 2>"$count.err") || status=$?
    printf '%s: %s\n' $status "$*" >>"$folder/$system/commands"
  done
}

# Times are different, and checksums of reports with them. The numbers of a page are those of other files.
without_times() {
  find "$folder" -type f \( -name '*.json' -o -name '*.html' -o -name '*.out' -o -name '*.err' \) -exec sed -i -E \
    -e '/^ *"seconds": \{/,/\}/d' -e '/^ *"(changed|(sphere_)?crc32|sphere_bytes)": /d' -e 's/"Seconds": "[^"]*"//' -e '/^ *Seconds /d' \
    -e 's/[0-9.]+ (s|seconds|meshes per minute)\b//g' -e '/^<script type="text\/plain"/d' {} +
}

compare_programs() {
  local system mesh
  rm -rf "$folder"
  for system in here windows; do
    mkdir -p "$folder/$system/Körper ab"
    (
      cd "$folder/$system"
      printf '%s\n' "OFF 6 8 0" "1.5 0 0" "-1 0 .25" "0 1 0" "0 -1.25e0 0" "0 0 2" "0 0.125 -1" "3 0 2 4" "3 2 1 4" \
        "3 1 3 4" "3 3 0 4" "3 2 0 5" "3 1 2 5" "3 3 1 5" "3 0 3 5" >"acht Flächen 八.off"
      sed 's/$/\r/' "acht Flächen 八.off" >"Körper ab/crlf.off"
      echo "OFF 1" >"Körper ab/defekt.off"
    )
  done
  for mesh in spot_2930 fandisk_606 cow_2904; do
    [ -f "$root/../shared/data/meshes/$mesh.off" ] || continue
    for system in here windows; do
      cp "$root/../shared/data/meshes/$mesh.off" "$folder/$system/Körper ab"
    done
  done
  with_both "acht Flächen 八.off" -o "Kugel ö.off" --json "Bericht ö.json" --page "Seite ö.html"
  with_both remesh "acht Flächen 八.off" octahedron=16 -o "fein ö.ply" --sphere "feine Kugel.obj" --json -
  with_both remesh "Körper ab/crlf.off" cube=9 -o "Würfel.obj"
  with_both match "fein ö.ply" "Würfel.obj" -o "lh.auf dem Würfel" --json "Paar.json"
  with_both check "acht Flächen 八.off" "Kugel ö.off"
  with_both check "kein Körper ö.off"
  with_both "acht Flächen 八.off" -o "kein Ordner ö/Kugel.off"
  with_both batch "Körper ab" --output-folder "Kugeln ö" --threads 1
  rm "$folder"/*/"Kugeln ö/crlf.off"
  with_both batch "Körper ab" --output-folder "Kugeln ö" --threads 1 --resume
  without_times
  diff -r "$folder/here" "$folder/windows"
}
run_stage "compare the programs" compare_programs
