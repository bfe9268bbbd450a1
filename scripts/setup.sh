#!/usr/bin/env bash
# Usage: scripts/setup.sh [--tests|--long-tests|--packages]
#
# Makes sure that what the program needs is installed; with --tests, what the tests need as well, and with --long-tests, what
# scripts/test_long.sh does; with --packages, what builds Debian packages, a wheel and a container, and tries them. On Debian and
# Ubuntu, installs the packages that are missing. Elsewhere, says what to install. Does nothing where everything is in place.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[[ "$*" == @(|--tests|--long-tests|--packages) ]] || fail "Usage: scripts/setup.sh [--tests|--long-tests|--packages]"

packages=(g++ make cmake libcgal-dev libcgal-demo libcli11-dev libtbb-dev libeigen3-dev
  libpng-dev libopenexr-dev libexpat1-dev zlib1g-dev npm)
components=(CGAL TBB Eigen3)
wanted="a C++17 compiler, CMake 3.18, CGAL 5.5, CLI11, TBB, Eigen, libpng, OpenEXR 3, expat, zlib, Node.js 18 and npm"
if [ "${1-}" = --packages ]; then
  packages+=(dpkg-dev fakeroot debhelper dh-python help2man lintian pybuild-plugin-pyproject pybind11-dev python3-dev)
  packages+=(python3-numpy python3-nibabel python3-pip python3-setuptools python3-venv python3-wheel)
  packages+=(patchelf binutils mmdebstrap buildah)
  wanted+=", what builds Debian packages with Python, patchelf, mmdebstrap, buildah, and Python with its headers, numpy, nibabel, pip and pybind11"
elif [ $# -gt 0 ]; then
  packages+=(git locales libgtest-dev libbenchmark-dev clang libclang-rt-dev llvm clang-format-14 codespell)
  packages+=(python3-numpy python3-matplotlib python3-nibabel)
  packages+=(pybind11-dev python3-dev python3-pytest python3-pip python3-venv python3-setuptools python3-wheel)
  packages+=(g++-aarch64-linux-gnu g++-mingw-w64-x86-64-posix qemu-user-static wine64)
  packages+=(doxygen texlive-binaries libjs-mathjax fonts-mathjax python3-sphinx python3-numpydoc linkchecker chromium-headless-shell)
  components+=(GTest benchmark)
  wanted="a C++17 compiler, CMake 3.18, CGAL 5.5, CLI11, TBB, Eigen, libpng, OpenEXR 3, expat, zlib, Node.js 18, npm, GoogleTest, Google Benchmark, Clang"
  wanted+=" with its sanitizers, clang-format 14, codespell, Python with its headers, numpy, matplotlib, nibabel, pybind11, pytest and pip, doxygen 1.9.4, BibTeX, Sphinx, numpydoc, LinkChecker and Chromium; g++ for AArch64, MinGW-w64 with POSIX threads, QEMU and Wine"
fi
if [ "${1-}" = --long-tests ]; then
  packages+=(parallel slurm-wlm munge jq snakemake connectome-workbench)
  packages+=(g++-s390x-linux-gnu libz-mingw-w64-dev libc++-14-dev libc++abi-14-dev)
  wanted+=", GNU parallel, Slurm with MUNGE, jq, Snakemake, Connectome Workbench, g++ for s390x, zlib for MinGW-w64 and libc++"
fi

is_installed() {
  [ "$(dpkg-query -W -f='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]
}

# Prints the packages that are missing. Newer systems have no clang-format 14, Ubuntu has no package of Chromium, and other processors
# have no compilers for all platforms: the checks that need them say so. A Node.js from elsewhere brings npm along.
list_missing() {
  local package
  for package in "${packages[@]}"; do
    is_installed "$package" && continue
    [[ $package == @(clang-format-14|chromium-*|g++-*|wine64|libc++*|libz-mingw*) ]] && ! apt-cache show "$package" >/dev/null 2>&1 && continue
    [ "$package" = npm ] && command -v npm >/dev/null && continue
    echo "$package"
  done
}

install_missing() {
  local missing as_root=()
  mapfile -t missing < <(list_missing)
  [ ${#missing[@]} -gt 0 ] || return 0

  if [ "$(id -u)" -ne 0 ]; then
    command -v sudo >/dev/null ||
      fail "Packages are missing and there is no sudo. As root, run:" \
           "  apt-get update && apt-get install --no-install-recommends ${missing[*]}"
    echo "Installing packages needs root: sudo may ask for your password."
    sudo -v || fail "sudo refused."
    as_root=(sudo)
  fi
  run_stage "apt-get update" "${as_root[@]}" apt-get update
  # The lists may have been empty up to here.
  mapfile -t missing < <(list_missing)
  run_stage "apt-get install ${#missing[@]} packages" \
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive apt-get install -y --no-install-recommends "${missing[@]}"
}

# Container images often leave out the documentation of every package, which is where Debian keeps CGAL's meshes.
fetch_data_archive() (
  archive=usr/share/doc/libcgal-dev/data.tar.gz
  [ ! -e "/$archive" ] && [ ! -e "$build/libcgal-demo/$archive" ] || return 0
  mkdir -p "$build/libcgal-demo"
  cd "$build/libcgal-demo" || return
  apt-get download libcgal-demo || return
  dpkg-deb --fsys-tarfile libcgal-demo_*.deb | tar -x "./$archive" && rm libcgal-demo_*.deb
)

# A project of its own, so that the answer depends on nothing that an earlier configuration has stored.
find_everything() {
  local component
  rm -rf "$build/setup" && mkdir -p "$build/setup"
  {
    echo "cmake_minimum_required(VERSION 3.18...3.31)"
    echo "project(setup LANGUAGES CXX)"
    for component in "${components[@]}"; do
      echo "find_package($component REQUIRED)"
    done
    echo "if(CGAL_VERSION VERSION_LESS 5.5)"
    echo "  message(FATAL_ERROR \"CGAL 5.5 or newer is needed; this system has \${CGAL_VERSION}.\")"
    echo "endif()"
  } >"$build/setup/CMakeLists.txt"
  cmake -S "$build/setup" -B "$build/setup/build" -DCMAKE_BUILD_TYPE=Release
}

if command -v apt-get >/dev/null && command -v dpkg-query >/dev/null; then
  install_missing
  [ -n "${CGAL_DATA_DIR-}" ] || fetch_data_archive >/dev/null 2>&1 ||
    echo "CGAL's meshes are not to be had here: set CGAL_DATA_DIR to the folder data/ of a CGAL release."
else
  echo "This is neither Debian nor Ubuntu. Install yourself, if it is not there yet: $wanted, or newer."
  [ -n "${CGAL_DATA_DIR-}" ] || echo "For CGAL's meshes, set CGAL_DATA_DIR to the folder data/ of a CGAL release."
fi
run_stage "look for the dependencies" find_everything
