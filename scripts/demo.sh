#!/usr/bin/env bash
# Usage: scripts/demo.sh [MESH]
#
# Installs what is missing, builds the program in Release mode, and maps MESH to the sphere: by default the armadillo
# that comes with CGAL. Ends with the distortion of the map and the files that show it, a page for a browser first. May be
# run again.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -le 1 ] || fail "Usage: scripts/demo.sh [MESH]"
mesh=${1-${CGAL_DATA_DIR-$build/data}/meshes/armadillo.off}

"$root/scripts/setup.sh"
run_stage "configure" cmake -S "$root" -B "$build" -DCMAKE_BUILD_TYPE=Release
run_stage "build the program" cmake --build "$build" -j "$jobs" --target spherical_parameterization
[ -r "$mesh" ] || fail "Cannot read $mesh. Give a closed triangle mesh of genus 0: scripts/demo.sh MESH"

name=$(basename "${mesh%.*}")
result=$build/demo/$name
mkdir -p "$build/demo"
page=()
[ ! -e "$build/page/page.stamp" ] || page=(--page "$result.html") # npm may have been out of reach
echo "== map $name to the sphere"
"$build/program/spherical_parameterization" \
  map "$mesh" -o "${result}_map.off" --colored "$result" "${page[@]}"

echo
[ ${#page[@]} -eq 0 ] || echo "Both side by side, for a browser:        $result.html"
echo "The mesh, colored by distortion:         ${result}_surface.ply"
echo "Its image on the sphere, colored alike: ${result}_sphere.ply"
echo "The image alone, in full precision:      ${result}_map.off"
