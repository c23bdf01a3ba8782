#!/usr/bin/env bash
# keeping.sh FOOTFALL OUT SECONDS SCENE ARGS...: what it costs that a run is kept by the clock every so many seconds (60, unless asked otherwise), as a share of its time:
# the time in checkpoints, of the program's own clock, over that of the run. At most 0.5 %.
set -u
footfall=$1 every=$3
rm -rf "$2" && mkdir -p "$2" || exit 1
out=$(cd "$2" && pwd)
shift 3
"$footfall" run "$@" --keep-every "$every" --set output.plots=false --quiet --out "$out/run" >"$out/said.txt" 2>&1 &
run=$!
sets=" "
while kill -0 $run 2>/dev/null; do
  for set in "$out"/run/checkpoint/*; do
    [[ -e $set && $set != *.part && $sets != *" ${set##*/} "* ]] && sets+="${set##*/} " && size=$(du -sk "$set" | cut -f1)
  done
  sleep 0.5
done
wait $run || { cat "$out/said.txt"; exit 1; }
count=$(wc -w <<<"$sets")
((count > 0)) || { echo "the run has ended before it was kept"; exit 1; }
figure() { sed -n "s/^ *\"$1\": \([0-9.e+-]*\),*\$/\1/p" "$out/run/summary.json"; }
awk -v kept="$(figure checkpoint_wall_s)" -v all="$(figure wall_s)" -v n="$count" -v size="$size" -v grains="$(figure particles)" -v every="$every" 'BEGIN {
  printf "%d grains, %.0f s, %d sets of %.1f MB: %.2f s in all, %.2f %% of the run kept every %s s\n", grains, all, n, size / 1000, kept, 100 * kept / all, every
  exit 100 * kept / all > 0.5 }' || { echo "more than 0.5 %"; exit 1; }
rm -rf "$out"
exit 0
