#!/usr/bin/env bash
# Usage: scripts/renew_hashes.sh [ROW...]
#
# Writes the hashes of today's results to the table that all platforms are held to, and the digest of the table to
# reproducibility.h; for a change that is meant to change results. With ROW..., these are added first, such as
# "cgal/bull.off default". Needs all meshes of the table, and scripts/test.sh before.

# shellcheck source-path=SCRIPTDIR source=common.sh
. "$(dirname "${BASH_SOURCE[0]}")/common.sh"

table=$root/test/Spherical_parameterization/reproducibility/hashes.txt
header=$root/include/CGAL/Spherical_parameterization/reproducibility.h
for row; do
  grep -q "^$row\( \|$\)" "$table" || echo "$row" >>"$table"
done
cmake --build "$build" -j "$jobs" --target hashes >/dev/null
version=$(ctest --test-dir "$build" --show-only=json-v1 | python3 -c '
import json, os, subprocess, sys
test = next(t for t in json.load(sys.stdin)["tests"] if t["name"] == "hashes")
environment = dict(p.split("=", 1) for q in test["properties"] if q["name"] == "ENVIRONMENT" for p in q["value"])
sys.exit(subprocess.run([*test["command"][:2], "--renew"], env={**os.environ, **environment}).returncode)' |
  tee /dev/stderr | sed -n 's/^results_version //p')
[ -n "$version" ] || fail "The table has not been renewed."
sed -i "s/\(results_version = \"\)[0-9a-f]*/\1$version/" "$header"
