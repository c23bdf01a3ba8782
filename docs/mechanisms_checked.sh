#!/usr/bin/env bash
# Remakes docs/mechanisms_checked.md: mechanisms with known answers, and 200 random ones, over tolerances. Some minutes.
#   docs/mechanisms_checked.sh [BUILD]     BUILD: build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build}
cmake --build "$build" --target mechanisms_checked
page=$(mktemp)
trap 'rm -f "$page"' EXIT
status=0
"$build/bin/mechanisms_checked" > "$page" || status=$?
cp "$page" docs/mechanisms_checked.md
chmod 644 docs/mechanisms_checked.md
if [ "$status" -ne 0 ]; then echo "an error is larger than what the tests hold it to" >&2; fi
exit "$status"
