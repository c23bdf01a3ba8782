#!/usr/bin/env bash
# endurance.sh FOOTFALL OUT CASE...: long runs.
#   grains WINDOWS                     through LIGGGHTS on two ranks: the memory of no program grows by more than a megabyte after the first tenth
#   checkpoints SECONDS SCENE ARGS...  what wall-clock checkpoints every so many seconds cost, as a share of the run's time: at most 0.5 % every 60 s
#   plane SECONDS                      the lander stands so long on the rigid plane; the report of the run is then written within a minute
set -u
export LC_ALL=C.UTF-8  # decimal points of awk
footfall=$(realpath -s "$1") inputs=$(cd "$(dirname "$0")/../../inputs" && pwd)
source "$(dirname "$0")/coupled_run.sh"
case=$3
rm -rf "$2" && mkdir -p "$2" || exit 1
out=$(realpath -s "$2")
[[ $case == checkpoints ]] || cd "$out" || exit 1 # its scene is named from where we are
shift 3
figure() { sed -n "s/^ *\"$1\": \([0-9.e+-]*\),*\$/\1/p" "$out/run/summary.json"; }

grains() {
  local end id k first last now
  export FOOTFALL_CACHE=$out/cache
  scene_of_plate "$here/plate/on_bed.in" "$here/plate/bed.in" >scene.toml
  end=$(awk -v n="$1" 'BEGIN { print n * 5e-4 }')
  "$footfall" run scene.toml --ranks 2 --set end_time="$end" --set output.interval="$(awk -v e="$end" 'BEGIN { print e / 100 }')" --set output.plots=false --quiet --out run >said.txt 2>&1 &
  run=$!
  memory() { for id in $(processes_of mbd_solver) $(processes_of liggghts_mbd); do awk '/VmRSS/ { printf "%d ", $2 }' "/proc/$id/status" 2>/dev/null; done; }
  until [[ -f run/history.csv ]] && (($(rows) > 11)); do kill -0 $run 2>/dev/null || die "the run ended early"; sleep 0.05; done
  first=($(memory))
  last=("${first[@]}")
  while kill -0 $run 2>/dev/null; do
    now=($(memory))
    ((${#now[@]} == 3)) && last=("${now[@]}")
    sleep 0.2
  done
  wait $run || die "the run ended with $?"
  echo "$1 windows through LIGGGHTS on two ranks: mbd_solver, rank 0, rank 1 have ${first[*]} kB after a tenth, ${last[*]} kB at the end"
  for k in 0 1 2; do ((last[k] - first[k] <= 1024)) || die "memory grows"; done
}

checkpoints() {
  local every=$1 sets=" " size=0 set
  shift
  "$footfall" run "$@" --keep-every "$every" --set output.plots=false --quiet --out "$out/run" >"$out/said.txt" 2>&1 &
  run=$!
  while kill -0 $run 2>/dev/null; do
    for set in "$out"/run/checkpoint/*; do
      [[ -e $set && $set != *.part && $sets != *" ${set##*/} "* ]] && sets+="${set##*/} " && size=$(du -sk "$set" | cut -f1)
    done
    sleep 0.5
  done
  wait $run || { cat "$out/said.txt"; exit 1; }
  (($(wc -w <<<"$sets") > 0)) || { echo "the run has ended before its first checkpoint"; exit 1; }
  awk -v saved="$(figure checkpoint_wall_s)" -v all="$(figure wall_s)" -v n="$(wc -w <<<"$sets")" -v size="$size" -v grains="$(figure particles)" -v every="$every" 'BEGIN {
    printf "%d grains, %.0f s, %d checkpoints of %.1f MB: %.2f s in all, %.2f %% of the run with one every %s s\n", grains, all, n, size / 1000, saved, 100 * saved / all, every
    exit 100 * saved / all > 0.5 }' || { echo "more than 0.5 %"; exit 1; }
}

plane() {
  local start tenths
  start=$(now)
  "$footfall" run "$inputs/rigid_plane" --set end_time="$1" --set flexible=false --quiet --out run >said.txt 2>&1 || { cat said.txt; exit 1; }
  echo "$1 s on the rigid plane: $(($(rows) - 2)) rows, run and pictures $((($(now) - start) / 1000000)) s"
  start=$(now)
  timeout 120 "$footfall" report run >report.txt 2>&1 || { cat report.txt; exit 1; }
  tenths=$((($(now) - start) / 100000))
  echo "report $((tenths / 10)).$((tenths % 10)) s"
  ((tenths <= 600)) || { echo "more than a minute"; exit 1; }
}
"$case" "$@"
