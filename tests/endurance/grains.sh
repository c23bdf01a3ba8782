#!/usr/bin/env bash
# grains.sh FOOTFALL OUT WINDOWS: so many windows through LIGGGHTS on two ranks; the memory of no program grows by more than a megabyte after the first tenth.
set -u
source "$(dirname "$0")/../cli/run_to_end.sh"
windows=$3 footfall=$1
rm -rf "$2" && mkdir -p "$2" && cd "$2" && out=$PWD || exit 1
export FOOTFALL_CACHE=$out/cache
scene_of_plate "$here/endless.in" "$here/endless_bed.in" >scene.toml
end=$(awk -v n="$windows" 'BEGIN { print n * 5e-4 }')
"$footfall" run scene.toml --ranks 2 --set end_time="$end" --set output.interval="$(awk -v e="$end" 'BEGIN { print e / 100 }')" --set output.plots=false --quiet --out run >said.txt 2>&1 &
run=$!
rows() { [[ -f run/history.csv ]] && (($(wc -l <run/history.csv) > $1)); }
memory() { for id in $(processes_of mbd_solver) $(processes_of liggghts_mbd); do awk '/VmRSS/ { printf "%d ", $2 }' "/proc/$id/status" 2>/dev/null; done; }
until rows 11; do kill -0 $run 2>/dev/null || die "the run ended early"; sleep 0.05; done
first=($(memory))
last=("${first[@]}")
while kill -0 $run 2>/dev/null; do
  now=($(memory))
  ((${#now[@]} == 3)) && last=("${now[@]}")
  sleep 0.2
done
wait $run || die "the run ended with $?"
grep -q '"status": "done"' run/summary.json || die "the run is not done"
echo "$windows windows through LIGGGHTS on two ranks: mbd_solver, rank 0, rank 1 have ${first[*]} kB after a tenth, ${last[*]} kB at the end"
for k in 0 1 2; do ((last[k] - first[k] <= 1024)) || die "memory grows"; done
rm -rf run
exit 0
