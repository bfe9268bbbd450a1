#!/usr/bin/env bash
# Usage: scripts/check_cgal_rules.sh FOLDER
#
# Checks FOLDER, a package in the layout of CGAL's git tree, against the rules that CGAL's continuous integration and
# its Developer manual have for the text of a package; not what compiles, nor what check_style.sh checks.
# Prints what is wrong; changes nothing. scripts/test_in_cgal_tree.sh makes such a folder of this package.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ -d "${1-}/include/CGAL" ] || fail "Usage: scripts/check_cgal_rules.sh FOLDER"
cd "$1"
package=$(basename "$PWD")
status=0
# A search that finds nothing is no failure, and report works in the shell that has the status.
set +e +o pipefail
shopt -s lastpipe

# report WHAT: says WHAT of every line of the standard input.
report() {
  local line
  while IFS= read -r line; do
    printf '%s: %s\n' "$line" "$1" >&2
    status=1
  done
}

# find_files PATTERN...: the files below the folders of the package whose names match one of the patterns.
find_files() {
  local names=()
  for pattern; do
    names+=(-o -name "$pattern")
  done
  find include package_info examples test benchmark doc -type f \( "${names[@]:1}" \) | sort
}

# grep_code REGEX FILE...: the lines that match REGEX in what neither a comment nor a string holds.
grep_code() {
  perl -e '
    my $regex = shift;
    for my $file (@ARGV) {
      open(my $lines, "<", $file) or die "$file: $!\n";
      local $/;
      my $text = <$lines>;
      my $literal = qr{\x27(?:[^\x27\\\n]|\\.)\x27|"(?:[^"\\\n]|\\.)*"};
      $text =~ s{$literal|//[^\n]*|/\*.*?\*/}{$& =~ tr/\n//cdr}gse;
      my $number = 0;
      for my $line (split(/\n/, $text)) {
        ++$number;
        print "$file:$number\n" if $line =~ /$regex/;
      }
    }' "$@"
}

mapfile -t headers < <(find include -name '*.h' | sort)
mapfile -t sources < <(find_files '*.h' '*.cpp' | grep -v '^doc/')
mapfile -t build_scripts < <(find test examples -mindepth 2 -maxdepth 2 -name CMakeLists.txt)

for file in package_info/"$package"/{copyright,dependencies,{description,license,long_description}.txt,maintainer} \
  doc/"$package"/{Doxyfile.in,PackageDescription.txt,"$package.txt",dependencies,examples.txt}; do
  [ -s "$file" ] || echo "$file"
done | report "the file is missing or empty"

dependencies=package_info/$package/dependencies
LC_ALL=C sort -cu "$dependencies" 2>/dev/null || echo "$dependencies" | report "the packages are not sorted"
grep -qx "$package" "$dependencies" || echo "$dependencies" | report "the package itself is missing"
grep -qxE 'L?GPL \(v3 or later\)' "package_info/$package/license.txt" ||
  echo "package_info/$package/license.txt" | report "this is neither 'GPL (v3 or later)' nor 'LGPL (v3 or later)'"

find . -type f -perm /111 ! -name '*.py' ! -name '*.sh' ! -name '*.pl' |
  report "only scripts with an extension may be executable"
find . ! -name '.' | grep '[^A-Za-z0-9_./+-]' | report "not every system takes such a file name"
printf '%s\n' "${headers[@]}" | sort -f | uniq -Di | report "another header differs in the case of letters only"
find . -type f | while IFS= read -r file; do
  # grep takes files without a zero byte for text
  ! LC_ALL=C grep -qI '' "$file" || iconv -f UTF-8 -t UTF-8 "$file" >/dev/null 2>&1 || echo "$file"
done | report "the text is not UTF-8"

# Each folder of programs is a project of its own, whose name CGAL's reports are sorted by, and leaves out no program.
for folder in test/*/ examples/*/; do
  [ -f "$folder/CMakeLists.txt" ] || echo "$folder" | report "there is no CMakeLists.txt"
done
for file in "${build_scripts[@]}"; do
  suffix=Tests
  [[ $file == test/* ]] || suffix=Examples
  grep -qE "^project\(${package}_$suffix *\)" "$file" || echo "$file" | report "the project is not ${package}_$suffix"
  [[ $(grep -vE '^ *(#|$)' "$file" | head -n 1) == cmake_minimum_required* ]] ||
    echo "$file" | report "the first instruction is not cmake_minimum_required"
  # the spelling by which CGAL's check knows that there is no list of programs to read
  grep -q 'GLOB cppfiles' "$file" || echo "$file" | report "the programs are not taken by 'file(GLOB cppfiles'"
done

grep -L 'SPDX-License-Identifier: L\?GPL-3.0-or-later' "${headers[@]}" | report "the licence is missing"
# the keywords that a release fills in
# shellcheck disable=SC2016
for keyword in '$URL$' '$Id$'; do
  grep -LF "// $keyword" "${headers[@]}" | report "the line '// $keyword' is missing"
done
for header in "${headers[@]}"; do
  [[ $header == include/CGAL/license/* ]] || grep -qx "#include <CGAL/license/$package.h>" "$header" ||
    echo "$header" | report "<CGAL/license/$package.h> is not included"
done

# Windows has macros of these names.
grep_code '(^|[^\w(])(\w+(<[\w: ]*>)?::)*(min|max) *\(' "${sources[@]}" |
  report "parentheses are missing around the name of min or max"
grep_code '\b(small|near|far|interface)\b' "${headers[@]}" | report "Windows has a macro of this name"
grep_code '^ *# *define +(?!CGAL_)' "${headers[@]}" | report "the name of the macro does not begin with CGAL_"
grep_code '\b(assert|abort|exit) *\(' "${headers[@]}" | report "headers neither abort nor exit"
grep_code '\b(std::(cout|cerr|clog)|printf)\b' "${headers[@]}" | report "headers print nothing"
grep_code '#include .*/internal/' examples/"$package"/*.cpp | report "an example uses what is internal"

for file in examples/"$package"/*.cpp; do
  grep -qF "\\example ${file#examples/}" "doc/$package/examples.txt" 2>/dev/null || echo "$file"
done | report "the example is missing in doc/$package/examples.txt"
grep -ohE '\\cgalExample\{[^}]*\}' doc/"$package"/*.txt | sed 's/.*{\(.*\)}/\1/' | sort -u | while IFS= read -r file; do
  [ -f "examples/$file" ] || echo "examples/$file"
done | report "the manual shows this file, which does not exist"

exit $status
