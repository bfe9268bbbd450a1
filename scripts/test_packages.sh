#!/usr/bin/env bash
# Usage: scripts/test_packages.sh [--tries-only]
#
# Builds the wheel, the Debian packages and the container, installs each in a bare root file system of this release of Debian, and
# does there what README.md begins with. Needs root, and what scripts/setup.sh --packages installs; with a cache of compiled
# packages in build/dist, --tries-only builds none.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

dist=$build/dist
work=$build/packages
mesh=$build/data/meshes/bunny00.off
[[ "$*" == @(|--tries-only) ]] || fail "Usage: scripts/test_packages.sh [--tries-only]"
[ "$(id -u)" -eq 0 ] || fail "Root file systems are made and entered as root only."
[ -f "$mesh" ] || fail "There is no $mesh: run scripts/test.sh before."
rm -rf "$work" && mkdir -p "$work" "$dist"

# make_root NAME PACKAGE...: a root file system with nothing but these, of the mirrors that this system has.
make_root() {
  local name=$1 suite sources
  shift
  # shellcheck source=/dev/null
  suite=$(. /etc/os-release && echo "$VERSION_CODENAME")
  sources=(/etc/apt/sources.list /etc/apt/sources.list.d/debian.sources)
  for file in "${sources[@]}"; do
    [ -s "$file" ] && break
  done
  mmdebstrap --variant=minbase ${1:+--include="$(IFS=, && echo "$*")"} "$suite" "$work/$name" "$file" || return
  [[ $name == *.tar ]] || { mkdir -p "$work/$name/try" && cp "$mesh" "$work/$name/try/bunny.off"; }
}

# in_root NAME COMMAND...: runs it in a root, with /proc, where the loader finds the folder of a program
in_root() {
  local name=$1
  shift
  env -i PATH=/usr/local/sbin:/usr/local/bin:/usr/sbin:/usr/bin:/sbin:/bin LC_ALL=C.UTF-8 HOME=/root \
    unshare --fork --pid --mount-proc="$work/$name/proc" chroot "$work/$name" "$@"
}

test_wheel() {
  cp "$dist"/spherical_parameterization-*.whl "$work/wheel/try" || return
  in_root wheel sh -ec '
    cd /try
    python3 -m venv --system-site-packages venv
    venv/bin/pip install --no-index --no-deps spherical_parameterization-*.whl
    venv/bin/python -c "
import numpy as np, spherical_parameterization as sp
vertices, faces = sp.read_mesh(\"bunny.off\")
sphere, report = sp.parameterize(vertices, faces)
assert sp.is_bijective(faces, sphere)
print(sp.__version__, len(vertices), sp.measure_distortion(vertices, faces, sphere).isometric)
"
    venv/bin/python -m spherical_parameterization bunny.off -o sphere.off
    venv/bin/spherical_parameterization check bunny.off sphere.off'
}

test_debian() {
  cp -r "$dist"/*.deb "$root/test/Spherical_parameterization/consumer" "$work/debian/try" || return
  in_root debian sh -ec '
    cd /try
    dpkg -i *.deb
    spherical_parameterization bunny.off -o sphere.off
    spherical_parameterization check bunny.off sphere.off
    test -s /usr/share/man/man1/spherical_parameterization.1.gz
    python3 -c "
import spherical_parameterization as sp
vertices, faces = sp.read_mesh(\"bunny.off\")
assert sp.is_bijective(faces, sp.parameterize(vertices, faces)[0])
"
    python3 -m spherical_parameterization --version
    spherical_parameterization_bids --version
    cmake -S consumer -B consumer/build -DCMAKE_BUILD_TYPE=Release
    cmake --build consumer/build --target consumer_of_library
    consumer/build/consumer_of_library'
}

# The image on a bare base: as another user, without a network, with inputs that are read only
test_container() {
  local container
  export STORAGE_DRIVER=vfs BUILDAH_ISOLATION=chroot PYTHONPATH=$build/python
  /usr/bin/python3 "$root/test/Spherical_parameterization/make_subjects.py" "$work/subjects" 24 &&
    container=$(buildah from scratch) &&
    buildah add --quiet "$container" "$work/base.tar" &&
    buildah commit --quiet --rm "$container" localhost/base &&
    buildah bud --network host --build-arg BASE=localhost/base -f "$root/packaging/container/Dockerfile" \
      -t localhost/spherical_parameterization "$dist" &&
    container=$(buildah from localhost/spherical_parameterization) &&
    mkdir -m 777 "$work/out" &&
    unshare --net buildah run --user 1234:1234 -v "$work/subjects:/study:ro" -v "$work/out:/out" "$container" -- \
      spherical_parameterization_bids /study/freesurfer /out participant --atlas fsaverage=/study/freesurfer/fsaverage &&
    buildah rm "$container" &&
    buildah images localhost/spherical_parameterization &&
    [ "$(find "$work/out" -name '*_desc-reg_sphere.surf.gii' -user 1234 | wc -l)" = 4 ]
}

# What the packages depend on, but for each other
dependencies() {
  for package; do
    dpkg-deb -f "$package" Depends
  done | tr ',' '\n' | sed 's/^ *//; s/[ (:|].*//' | grep -v spherical-parameterization | sort -u
}

if [ $# -eq 0 ]; then
  "$root/scripts/build_wheel.sh" "$dist"
  "$root/scripts/build_debian.sh" "$dist"
fi
run_stage "make a root with Python and numpy" make_root wheel python3-numpy python3-venv
run_stage "install and try the wheel" test_wheel
mapfile -t needed < <(dependencies "$dist"/*.deb)
run_stage "make a root for the packages" make_root debian cmake g++ make "${needed[@]}"
run_stage "install and try the packages" test_debian
run_stage "make a base for the container" make_root base.tar
run_stage "build and try the container" test_container
