#!/usr/bin/env bash
# Usage: scripts/test_in_cgal_tree.sh [--only REGEX] [--standard N] [CHECKOUT]
#
# Puts a copy of the package where it would be in CGAL's git tree, holds it to the rules that CGAL has for packages, and
# configures, builds and runs its examples and tests there as CGAL's test suite does. CHECKOUT is a clone of CGAL's
# repository, which is not changed; without it, the tree is made of the CGAL that CMake finds, for which CGAL_DIR may be
# set, with every header in the package that its $URL$ names. CXX and CXXFLAGS are heeded; N is the C++ standard, 17 by
# default. Without CHECKOUT, the examples take CGAL's meshes from CGAL_DATA_DIR, or where the build has unpacked them.
# With --only, just the programs whose names match REGEX are built and run, and the public headers are compiled together
# instead of one by one: about a minute, and not everything anew.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

usage="Usage: scripts/test_in_cgal_tree.sh [--only REGEX] [--standard N] [CHECKOUT]"
package=Spherical_parameterization
programs=
standard=17
while [ $# -gt 1 ] && [[ $1 == --* ]]; do
  case $1 in
  --only) programs=$2 ;;
  --standard) standard=$2 ;;
  *) fail "$usage" ;;
  esac
  shift 2
done
[ $# -eq 0 ] || { [ $# -eq 1 ] && [ -d "$1/Installation/package_info/Installation" ]; } || fail "$usage"
checkout=${1:+$(cd "$1" && pwd)}
directory=$build/cgal_tree
tree=$directory/cgal
cxx=${CXX-c++}

# Writes a script that sets these.
cgal_version='' cgal_headers='' cgal_modules='' cgal_config='' eigen_headers=''
find_cgal() {
  rm -rf "$directory/find_cgal" && mkdir -p "$directory/find_cgal" || return # another CGAL may be asked for each time
  cat >"$directory/find_cgal/CMakeLists.txt" <<'END'
cmake_minimum_required(VERSION 3.18...3.31)
project(find_cgal LANGUAGES CXX)
find_package(CGAL REQUIRED)
find_package(Eigen3 REQUIRED NO_MODULE)
list(GET CGAL_INCLUDE_DIRS 0 cgal_headers)
get_target_property(eigen_headers Eigen3::Eigen INTERFACE_INCLUDE_DIRECTORIES)
file(WRITE "${CMAKE_BINARY_DIR}/variables.sh" "cgal_version='${CGAL_VERSION}'\ncgal_headers='${cgal_headers}'\n"
  "cgal_modules='${CGAL_MODULES_DIR}'\ncgal_config='${CGAL_CONFIG_DIR}'\neigen_headers='${eigen_headers}'\n")
END
  cmake -S "$directory/find_cgal" -B "$directory/find_cgal/build" -DCMAKE_BUILD_TYPE=Release "$@"
}

# A tree of links to the packages of the checkout. CGAL finds packages from where its CMake files are, hence the copy.
link_checkout() {
  local folder
  for folder in "$checkout"/*/; do
    [ "$(basename "$folder")" = Installation ] || ln -s "${folder%/}" "$tree" || return
  done
  cp -R "$checkout/Installation" "$tree"
}

# The same from an installation, as far as examples and tests of a package need it. Two files do not say which package
# they are of; they go with their neighbours.
link_installation() {
  local folder
  # shellcheck disable=SC2016
  (cd "$cgal_headers" && grep -rom1 '\$URL: [^ ]*' CGAL && grep -rL '\$URL: ' CGAL) | perl -e '
    use File::Basename;
    use File::Path "make_path";
    my ($from, $to) = @ARGV;
    my %packages;
    for my $line (<STDIN>) {
      chomp $line;
      my ($file) = $line =~ /^([^:]*)/;
      my $folder = dirname($file);
      $packages{$folder} = $1 if $line =~ m{/(\w+)/include/CGAL/};
      my $target = "$to/$packages{$folder}/include";
      make_path("$target/$folder");
      symlink("$from/$file", "$target/$file") or die "$target/$file: $!\n";
    }' "$cgal_headers" "$tree" || return
  for folder in "$tree"/*/; do
    mkdir -p "$folder/package_info/$(basename "$folder")"
  done
  mkdir -p "$tree/Installation/"{cmake,lib/cmake/CGAL} &&
    cp -R "$cgal_modules" "$tree/Installation/cmake/modules" &&
    rm -f "$tree/Installation/cmake/modules"/CGALConfig*.cmake &&
    cp "$cgal_config"/CGALConfig*.cmake "$tree/Installation/lib/cmake/CGAL"
}

# What CGAL has its own means for stays here: the licence header, which it generates, and the tests of the build system.
copy_package() (
  cd "$root" || return
  { git ls-files --cached --others --exclude-standard 2>/dev/null || find . -type f -printf '%P\n'; } |
    grep -E "^(include/|(package_info|examples|test|benchmark|doc)/$package/)" |
    grep -vE "^(include/CGAL/license/|test/$package/(compile_errors|compile_flags|consumer|fuzz|sanitizers)/)" |
    while IFS= read -r file; do [ ! -f "$file" ] || echo "$file"; done |
    tar -cf - -T - | tar -xf - -C "$tree/$package"
)

make_tree() {
  local licences=$tree/Installation/include/CGAL/license
  rm -rf "$tree" && mkdir -p "$tree/$package" || return
  if [ -n "$checkout" ]; then link_checkout; else link_installation; fi || return
  copy_package &&
    cp "$root/include/CGAL/license/$package.h" "$licences" # instead of what CGAL generates from its list of packages
}

list_include_folders() {
  local folder
  for folder in "$tree"/*/; do
    [ ! -d "$folder/include" ] || [ ! -d "$folder/package_info" ] || echo "${folder%/}/include"
  done
}

# compile FILE [OPTION...]: what CGAL compiles headers with to see whether each includes all that it needs
compile() {
  # CXXFLAGS holds several words.
  # shellcheck disable=SC2086
  "$cxx" -std=c++"$standard" -fsyntax-only -DCGAL_EIGEN3_ENABLED -DCGAL_PROFILE ${CXXFLAGS-} "${include_flags[@]}" \
    -isystem "$eigen_headers" -x c++ "$@"
}

# Every public header compiles alone. Writes the packages whose headers they include.
check_headers() {
  local header
  mkdir -p "$directory/headers" && rm -f "$directory/headers"/*
  for header in "$tree/$package/include"/CGAL/{,"$package"/}*.h; do
    header=${header#"$tree/$package/include/"}
    if [ -n "$programs" ]; then
      echo "#include <$header>" >>"$directory/headers/all.cpp"
    else
      echo "#include <$header>" >"$directory/headers/${header//\//__}.cpp"
    fi
  done
  for header in "$directory/headers"/*.cpp; do
    compile "$header" -MD -MF "${header%.cpp}.d" || return
  done
  cat "$directory/headers"/*.d | tr -s '[:space:]' '\n' | grep '/include/CGAL/' | sort -u >"$directory/included.txt"
  if grep -vF "$tree/" "$directory/included.txt"; then
    echo "The headers above are not those of the tree."
    return 1
  fi
  sed "s#^$tree/\([^/]*\)/.*#\1#" "$directory/included.txt" | LC_ALL=C sort -u >"$directory/dependencies.txt"
}

# The packages that the headers need are those of CGAL 6; in the versions before, one of them was another one.
check_dependencies() {
  local difference=
  [[ $cgal_version != 5.* ]] || difference='s/^CGAL_Core$/Random_numbers/'
  sed "$difference" "$tree/$package/package_info/$package/dependencies" | LC_ALL=C sort |
    diff -u --label "package_info/$package/dependencies" --label "included" - "$directory/dependencies.txt"
}

# Every named parameter that is documented is one of CGAL's.
check_named_parameters() {
  {
    echo '#include <CGAL/Named_function_parameters.h>'
    echo 'int main() {'
    grep -rohE 'cgalParamNBegin\{\w+\}' "$tree/$package/"{include,doc} | sort -u |
      sed -E 's/.*\{(.*)\}/  CGAL::parameters::\1(0).\1(0);/'
    echo '}'
  } >"$directory/named_parameters.cpp"
  grep -q '::number_of_iterations' "$directory/named_parameters.cpp" &&
    compile "$directory/named_parameters.cpp" -DCGAL_NO_STATIC_ASSERTION_TESTS
}

list_programs() {
  find -L "$@" -maxdepth 1 -name '*.cpp' -printf '%f\n' 2>/dev/null
}

# All programs of CGAL are targets of one project.
check_names() {
  local folder other
  for folder in "$tree"/*/; do
    [ "$folder" = "$tree/$package/" ] || list_programs "$folder"{examples,test,demo}/*
  done >"$directory/programs.txt"
  other=$(list_programs "$tree/$package/"{examples,test}/* | grep -Fx -f "$directory/programs.txt")
  [ -z "$other" ] || { printf 'Another package has a program of this name: %s\n' "$other" && return 1; }
}

# configure SOURCE BINARY: as CGAL's test suite does, which refuses NDEBUG, so that every assertion is checked
configure() {
  local data=()
  [ -n "$checkout" ] || data=("-DCGAL_DATA_DIR=${CGAL_DATA_DIR-$build/data}")
  rm -rf "$2" # so that nothing is remembered of another CGAL
  CXXFLAGS="-Wall -Wextra ${CXXFLAGS-}" cmake -S "$1" -B "$2" -DCGAL_DIR="$tree/Installation/lib/cmake/CGAL" \
    -DCMAKE_{BUILD_TYPE=Release,CXX_FLAGS_RELEASE=-O1,CXX_STANDARD="$standard"} \
    -DCGAL_{ENABLE_TESTING,TEST_SUITE}=ON -DBUILD_TESTING=ON "${data[@]}"
}

# CGAL configures the examples and the tests of all packages in one project, ...
configure_together() {
  mkdir -p "$directory/programs"
  cat >"$directory/programs/CMakeLists.txt" <<END
cmake_minimum_required(VERSION 3.18...3.31)
project(programs)
enable_testing()
find_package(CGAL REQUIRED)
foreach(folder examples test)
  add_subdirectory("$tree/$package/\${folder}/$package" "\${folder}" EXCLUDE_FROM_ALL)
endforeach()
END
  configure "$directory/programs" "$directory/programs/build"
}

# ... and who works on a package configures each folder alone.
configure_alone() {
  local folder
  for folder in examples test benchmark; do
    configure "$tree/$package/$folder/$package" "$directory/$folder" || return
  done
}

# No program may be left out because something is not installed.
count_programs() {
  local present expected
  present=$(ctest --test-dir "$1" -N | grep -c ': compilation.of' || true)
  expected=$(list_programs "${@:2}" | wc -l)
  [ "$present" -eq "$expected" ] || fail "$1 compiles $present of $expected programs."
}

run_programs() {
  ctest --test-dir "$directory/programs/build" -j "$jobs" --timeout 1200 --no-tests=error -V \
    ${programs:+-R "of[ _]+($programs)\$"}
}

# CGAL 6.0 and 6.1 copy points that have no coordinates yet, as the default value of a property map; g++ says so of the
# line that asks for the map.
check_warnings() {
  ! grep -F "$tree/$package/" "$build/logs/${1// /_}.log" | grep "warning:" | grep -v -e -Wmaybe-uninitialized
}

run_stage "find CGAL" find_cgal ${checkout:+-DCGAL_DIR="$checkout/Installation/lib/cmake/CGAL"}
# shellcheck source=/dev/null
. "$directory/find_cgal/build/variables.sh"
run_stage "make a tree of CGAL $cgal_version" make_tree
mapfile -t include_flags < <(list_include_folders | sed 's/^/-I/')
run_stage "check the rules of CGAL" "$root/scripts/check_cgal_rules.sh" "$tree/$package"
run_stage "check the names of programs" check_names
run_stage "check the headers" check_headers
run_stage "check the dependencies" check_dependencies
run_stage "check the named parameters" check_named_parameters
run_stage "configure alone" configure_alone
count_programs "$directory/examples" "$tree/$package/examples/$package"
count_programs "$directory/test" "$tree/$package/test/$package"
run_stage "configure together" configure_together
count_programs "$directory/programs/build" "$tree/$package/"{examples,test}"/$package"
run_stage "build and run in the tree" run_programs
run_stage "look for warnings" check_warnings "build and run in the tree"
