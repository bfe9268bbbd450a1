# Sourced by the scripts of this folder.
# shellcheck shell=bash disable=SC2034

set -euo pipefail

root=$(cd "$(dirname "${BASH_SOURCE[0]}")/.." && pwd)
build=$root/build
jobs=$(nproc 2>/dev/null || echo 2)

fail() {
  printf '%s\n' "$@" >&2
  exit 1
}

# run_stage NAME COMMAND...: prints NAME in one line and keeps what COMMAND prints in build/logs; shows it on failure.
run_stage() {
  local name=$1 log=$build/logs/${1// /_}.log
  shift
  mkdir -p "$build/logs"
  printf '== %s\n' "$name"
  if ! "$@" >"$log" 2>&1 </dev/null; then
    tail -n 100 "$log" >&2
    fail "Failed: $name. The whole log: $log"
  fi
}
