#!/usr/bin/env bash
# Usage: scripts/build_debian.sh [OUTPUT]
#
# Builds Debian packages of the program, the library and the Python module for this system, checks them with lintian, and writes
# them to OUTPUT, by default build/dist. Needs what scripts/setup.sh --packages installs.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

output=$(realpath -m "${1-$build/dist}")
work=$build/debian
python=/usr/bin/python3
rm -rf "$work" && mkdir -p "$work" "$output"
version=$(sed -n 's/^ *VERSION \([0-9.]*\)$/\1/p' "$root/CMakeLists.txt")
# Of the commit, so that the same sources give the same packages
time=$(git -C "$root" log -1 --format=%ct 2>/dev/null || date +%s)

unpack_sources() (
  sources=$work/spherical-parameterization-$version
  cd "$root" &&
    "$python" -c 'import sys; from setuptools import build_meta; build_meta.build_sdist(sys.argv[1])' "$work" &&
    mkdir "$sources" &&
    tar xf "$work"/*.tar.gz -C "$sources" --strip-components=1 &&
    cp -r packaging/debian "$sources" &&
    cat >"$sources/debian/changelog" <<EOF
spherical-parameterization ($version) unstable; urgency=medium

  * See CHANGES.md.

 -- $(sed -n 's/^Maintainer: //p' packaging/debian/control)  $(date -u -R -d "@$time")
EOF
)

build_packages() (
  cd "$work/spherical-parameterization-$version"
  export PATH=/usr/sbin:/usr/bin:/sbin:/bin # packages are built with Debian's Python alone
  export DEB_BUILD_OPTIONS="parallel=$jobs noautodbgsym"
  dpkg-buildpackage --build=binary --unsigned-changes --unsigned-buildinfo
)

check_packages() (
  cd "$work"
  lintian --fail-on error,warning --info ./*.changes
)

run_stage "make the sources of the packages" unpack_sources
run_stage "build the packages" build_packages
run_stage "check them with lintian" check_packages
cp "$work"/*.deb "$output"
ls -l "$output"/*.deb
