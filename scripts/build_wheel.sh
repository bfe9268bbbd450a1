#!/usr/bin/env bash
# Usage: scripts/build_wheel.sh [OUTPUT]
#
# Builds the source distribution of the Python module and, from that, a wheel for the Python of this system that needs nothing
# but numpy: the libraries that it is linked with are inside. Both are written to OUTPUT, by default build/dist.
# Needs what scripts/setup.sh --packages installs.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

output=$(realpath -m "${1-$build/dist}")
work=$build/wheel
python=/usr/bin/python3 # another one on the path may lack setuptools
[ -x "$python" ] || python=python3
rm -rf "$work" && mkdir -p "$work" "$output"

build_sources() (
  cd "$root"
  "$python" -c 'import sys; from setuptools import build_meta; build_meta.build_sdist(sys.argv[1])' "$work"
)

build_wheel() (
  cd "$work"
  "$python" -m pip wheel --no-deps --no-build-isolation --no-index --wheel-dir "$work/plain" "$work"/*.tar.gz
)

run_stage "build the source distribution" build_sources
run_stage "build the wheel from it" build_wheel
run_stage "put libraries into the wheel" "$python" "$root/scripts/repair_wheel.py" "$work"/plain/*.whl "$work/repaired"
cp "$work"/*.tar.gz "$work"/repaired/*.whl "$output"
ls -l "$output"/spherical_parameterization-*
