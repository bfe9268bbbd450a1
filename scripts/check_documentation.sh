#!/usr/bin/env bash
# Usage: scripts/check_documentation.sh
#
# Builds the manual in build/doc/html, which fails on any warning of doxygen's, and checks that everything public is
# documented and that no link within the manual is broken. Links to other sites are not followed, but listed in
# build/doc/external_links.txt. Installs nothing; scripts/setup.sh --tests does.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

[ $# -eq 0 ] || fail "Usage: scripts/check_documentation.sh"

# Called by root, LinkChecker becomes a user who may not be allowed to read the build; so it gets a copy.
check_links() (
  site=$(mktemp -d)
  trap 'rm -rf "$site"' EXIT
  cp -r "$build/doc/html/." "$site"
  chmod -R a+rX "$site"
  status=0
  linkchecker --config "$root/doc/standalone/linkchecker.ini" --no-status --verbose --output csv "$site/index.html" \
    >"$build/doc/links.csv" || status=$?
  # The fields: 1 the link, 2 the page, 5 a warning, 7 whether it is valid, 8 the address
  awk -F ';' '$1 ~ /^https?:/ { print $8 }' "$build/doc/links.csv" | sort -u >"$build/doc/external_links.txt"
  if [ $status -ne 0 ]; then
    awk -F ';' '$7 == "False" || $5 != "" && $5 != "warningstring" { print $2 ": " $1 ": broken. " $5 }' \
      "$build/doc/links.csv" | sed "s|file://$site/||g"
  fi
  return $status
)

# What a benchmark is to write between a line that begins a part of a page and one that ends it.
check_measured_parts() {
  awk '/<!-- begin /{ line = FNR }
       /<!-- end / && FNR == line + 1 { print FILENAME ": nothing has been measured here:" $0; is_wrong = 1 }
       END { exit is_wrong }' "$root"/doc/*/*.txt
}

run_stage "check that all that is to be measured is there" check_measured_parts
[ -f "$build/CMakeCache.txt" ] || run_stage "configure" cmake -S "$root" -B "$build"
run_stage "build the manual" cmake --build "$build" --target doc
run_stage "check that everything is documented" python3 "$root/scripts/check_documentation.py" "$build/doc/xml"
run_stage "check the links of the manual" check_links
