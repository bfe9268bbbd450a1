#!/usr/bin/env bash
# Usage: scripts/check_style.sh
#
# Checks the layout of all C++ files (clang-format 14, whose output differs from that of other versions), the first
# lines and the include guard of every header, that results depend on neither the compiler nor the standard library, and the
# words, the spelling (codespell) and the blanks of every text file. Prints what is wrong; changes nothing.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

cd "$root"
status=0
report() {
  printf '%s\n' "$@" >&2
  status=1
}

# Without git, such as in an unpacked release, everything but the build counts.
list_files() {
  git ls-files --cached --others --exclude-standard 2>/dev/null ||
    find . -path ./build -prune -o -type f -printf '%P\n'
}
# The inputs of the fuzzers are what they are.
mapfile -t files < <(list_files | grep -v '/fuzz/\(corpus\|regressions\)/' | sort | while read -r file; do [ ! -f "$file" ] || echo "$file"; done)
sources=()
headers=()
for file in "${files[@]}"; do
  [[ $file != *.h && $file != *.cpp ]] || sources+=("$file")
  [[ $file != include/*.h ]] || headers+=("$file")
done
[ ${#headers[@]} -gt 0 ] || fail "No header found in $root."

formatter=$(command -v clang-format-14 || command -v clang-format || true)
if [ -n "$formatter" ] && [[ $("$formatter" --version) == *"version 14."* ]]; then
  for file in "${sources[@]}"; do
    "$formatter" --dry-run --Werror "$file" 2>/dev/null || report "$file: the layout; '${formatter##*/} -i' repairs it"
  done
elif [ -n "${CI-}" ]; then
  report "clang-format 14 is not installed."
else
  echo "clang-format 14 is not installed: the layout remains unchecked."
fi

computes='\b(double|float|FT|Vector_3d?)\b|\b[0-9]+\.'
for header in "${headers[@]}"; do
  [[ $header != */numbers/@(begin|end)_arithmetic.h ]] || continue # included several times
  if sed 's,//.*,,; /^#include/d' "$header" | grep -qE "$computes" && grep -q '^namespace CGAL' "$header"; then
    between=$(sed -n '\,numbers/begin_arithmetic.h>$,,\,numbers/end_arithmetic.h>$,p' "$header")
    [ "$(grep -c '^namespace CGAL' "$header")" -eq "$(grep -c '^namespace CGAL' <<<"$between")" ] &&
      [ "$(grep -c '^#include <\(CGAL\|[a-z]\)' <<<"$between")" -eq 2 ] ||
      report "$header: it computes, and is not between internal/numbers/begin_arithmetic.h and end_arithmetic.h"
  fi
  boilerplate=$(head -n 8 "$header")
  [[ $boilerplate == "// Copyright (c) "*"// This file is part of the Spherical_parameterization package for CGAL"* ]] ||
    report "$header: the copyright is missing"
  [[ $boilerplate == *"// SPDX-License-Identifier: GPL-3.0-or-later"* ]] ||
    report "$header: the licence is missing"
  guard=${header#include/}
  guard=${guard^^}
  guard=${guard//[\/.]/_}
  [ "$(grep -m 1 '^#ifndef' "$header")" = "#ifndef $guard" ] || report "$header: the include guard is not $guard"
  [ "$(tail -n 1 "$header")" = "#endif // $guard" ] || report "$header: the last line is not '#endif // $guard'"
done

# These differ between machines, or are compiled as the user's code is; square roots and std::fmod are the same.
inexact='std::(fma|inner_product|a?(cos|sin|tan)h?|atan2|exp2?|expm1|log|log2|log10|log1p|pow|cbrt|hypot|erfc?|[lt]gamma|polar|arg|norm)\b'
mapfile -t computing < <(printf '%s\n' "${sources[@]}" | grep -E '^(include|program|src|python)/')
if grep -nE "^([^/]|/[^/])*$inexact" "${computing[@]}"; then
  report "The lines above call what is not the same on every machine: see internal/numbers/elementary_functions.h."
fi

# One word for one thing: to report or to state; sulcus and gyrus; hole patch; small components; double precision; integer; instead of.
words='tells?|told|furrows?|fillers?|crumbs?|numbers of (32|64) bits|whole numbers?|in the place of'
mapfile -t texts < <(printf '%s\n' "${files[@]}" | grep -vE '^scripts/check_style.sh|^LICENSE|bibliography|package-lock|\.(tag|jpg|png|off)$')
if grep -nwIiE "$words" "${texts[@]}"; then
  report "The lines above have words that have a better one: see scripts/check_style.sh."
fi
if command -v codespell >/dev/null; then
  codespell --quiet-level 3 --ignore-words-list summar,lod,parm,fo,ordner "${texts[@]}" || report "The lines above have misspelled words."
elif [ -n "${CI-}" ]; then
  report "codespell is not installed."
else
  echo "codespell is not installed: the spelling remains unchecked."
fi

# -I leaves out binary files; rules of make begin with a tab.
if printf '%s\0' "${files[@]}" | grep -zv '/rules$' | xargs -0 grep -nIP '\t|[ \r]$' /dev/null; then
  report "The lines above have a tab, or a blank at the end."
fi
for file in "${files[@]}"; do
  if [ -s "$file" ] && grep -qI '' "$file" && [ -n "$(tail -c 1 "$file")" ]; then
    report "$file: the last line has no end"
  fi
done

exit $status
