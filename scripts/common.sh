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

# run_stage NAME COMMAND...: prints NAME and how many seconds COMMAND has taken in one line and keeps what it prints in
# build/logs; shows its end on failure, and last of all the lines of what has failed.
run_stage() {
  local name=$1 log=$build/logs/${1// /_}.log start=$SECONDS status=0
  shift
  mkdir -p "$build/logs"
  "$@" >"$log" 2>&1 </dev/null || status=$?
  printf '== %s: %d s\n' "$name" $((SECONDS - start))
  if [ $status -ne 0 ]; then
    tail -n 100 "$log" >&2
    echo "== What has failed:" >&2
    grep -a -A 6 -E ': Failure$|error:|^E  |Sanitizer:' "$log" | cut -c -400 | tail -n 40 >&2 || true
    fail "Failed: $name. The whole log: $log"
  fi
}

# The end of a long log is what is read first.
say_verdict() {
  local status=$?
  if [ $status -eq 0 ]; then
    echo "== All checks passed, in $SECONDS s"
  else
    echo "== A CHECK FAILED, with exit status $status after $SECONDS s; see above for which"
  fi
}
