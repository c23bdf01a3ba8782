#!/usr/bin/env bash
# Remakes docs/data/mechanisms_checked.txt: mechanisms with known answers, and 300 random ones, over tolerances. Some minutes.
#   docs/data/remake/mechanisms_checked.sh [BUILD]     BUILD: build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/../../.."
build=${1:-build}
cmake --build "$build" --target mechanisms_checked
parts=$(mktemp -d)
trap 'rm -rf "$parts"' EXIT
program=$build/bin/mechanisms_checked
last=$(($("$program" --sections) - 1))
status=0
seq 0 "$last" | xargs -P "$(nproc)" -I{} sh -c "\"$program\" --section {} > \"$parts/{}\"" || status=1
{
  for k in $(seq 0 "$last"); do grep -v '^@' "$parts/$k"; done
  "$program" --table
  for k in $(seq 0 "$last"); do sed -n 's/^@//p' "$parts/$k"; done
} > docs/data/mechanisms_checked.txt
if [ "$status" -ne 0 ]; then echo "an error is larger than what the tests hold it to" >&2; fi
exit "$status"
