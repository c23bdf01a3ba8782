#!/usr/bin/env bash
# plane.sh FOOTFALL OUT SECONDS: the lander stands so long on the rigid plane; the report of the run is then made within a minute.
set -u
footfall=$1 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$2" && mkdir -p "$2" && cd "$2" || exit 1
start=$(date +%s)
"$footfall" run "$here/../../inputs/rigid_plane" --set end_time="$3" --set flexible=false --quiet --out run >said.txt 2>&1 || { cat said.txt; exit 1; }
took=$(($(date +%s) - start))
start=$(date +%s%N)
timeout 120 "$footfall" report run >report.txt 2>&1 || { cat report.txt; exit 1; }
tenths=$((($(date +%s%N) - start) / 100000000))
rows=$(($(wc -l <run/history.csv) - 2))
echo "$3 s on the rigid plane: $rows rows, $(($(stat -c %s run/history.csv) / 1000000)) MB, run and pictures $took s, report $((tenths / 10)).$((tenths % 10)) s"
((tenths <= 600)) || { echo "the report took more than a minute"; exit 1; }
rm -rf run
exit 0
