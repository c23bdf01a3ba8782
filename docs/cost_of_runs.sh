#!/usr/bin/env bash
# cost_of_runs.sh FOLDER...: seconds of a core that the runs below the folders took, and LIGGGHTS' loops of the beds that they began on (each bed once, by the clock). Folders that are not there count nothing.
set -euo pipefail
folders=()
for folder in "$@"; do [[ ! -d $folder ]] || folders+=("$folder"); done
((${#folders[@]})) || { echo 0; exit; }
{
  find "${folders[@]}" -name '*.done.json' -exec grep -h '"cpu_s"' {} + | sed 's/.*: *//; s/[^0-9.e+-]*$//' || true
  find "${folders[@]}" -name summary.json -exec sed -n 's/.*"grains": "\(.*\)\/bed\.restart\.grains".*/\1/p' {} + | sort -u |
    while read -r bed; do [[ ! -f $bed/liggghts.log ]] || sed -n 's/^Loop time of \([0-9.e+-]*\) .*/\1/p' "$bed/liggghts.log"; done
} | awk '{ s += $1 } END { printf "%.0f\n", s }'
