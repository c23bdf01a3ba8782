#!/usr/bin/env bash
# One idea per file: no source that people write has more than 300 lines. web/dist is bundled from web/src.
set -u
cd "$(dirname "$0")/../.."
find coupler liggghts_fix mbd_solver \( -name dist -o -name node_modules \) -prune -o \
  -type f -regextype egrep -regex '.*\.(cpp|h|in|js|mjs|css|sh)' -print0 | xargs -0 awk -v most=300 '
  function tell() {
    if (lines > most) {
      printf "%s: %d lines, expected at most %d; give what is an idea of its own a file of its own\n", file, lines, most
      failed = 1
    }
  }
  FNR == 1 { tell(); file = FILENAME; seen++ }
  { lines = FNR }
  END {
    tell()
    if (seen < 700) { printf "only %d sources were found: this check is blind\n", seen; failed = 1 }
    exit failed
  }'
