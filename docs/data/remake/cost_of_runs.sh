#!/usr/bin/env bash
# cost_of_runs.sh FOLDER...: seconds of a core that the runs below the folders took, and the beds that they began on, each bed once (of a bed that an older footfall has made the time of
# LIGGGHTS' loops by the clock). Folders that are not there count nothing.
set -euo pipefail
folders=()
for folder in "$@"; do [[ ! -d $folder ]] || folders+=("$folder"); done
((${#folders[@]})) || { echo 0; exit; }
seconds() { grep -h '"cpu_s"' "$@" | sed 's/.*"cpu_s": *//; s/[^0-9.e+-].*$//'; }
{
  find "${folders[@]}" -name '*.done.json' -print0 | while IFS= read -r -d '' run; do seconds "$run" || true; done
  find "${folders[@]}" -name summary.json -exec sed -n 's/.*"grains": "\(.*\)\/bed\.restart\.grains".*/\1/p' {} + | sort -u |
    while read -r bed; do
      if [[ -f $bed/bed_cost.json ]]; then seconds "$bed/bed_cost.json"
      elif [[ -f $bed/liggghts.log ]]; then sed -n 's/^Loop time of \([0-9.e+-]*\) .*/\1/p' "$bed/liggghts.log"; fi
    done
} | awk '{ s += $1 } END { printf "%.0f\n", s }'
