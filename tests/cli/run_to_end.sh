# Sourced by tests that end a run by force: a run whose processes are found by their working folder, and never by name alone.
#   start_run FOOTFALL OUT PHASE [OPTION...]   starts one in OUT and waits until it is in the phase; sets `run`
#   processes_of NAME                          process ids of a program of the run, in rising order; "" for all
#   wait_for_end SECONDS                       sets `code`; false when it is still there
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
set -m # a process in the background then ignores no signal
processes_of() {
  local folder
  for folder in /proc/[0-9]*; do
    [[ $(readlink "$folder/cwd") == "$out" ]] || continue
    case $(readlink "$folder/exe") in
      *"/$1") echo "${folder#/proc/}" ;;
      */footfall | */orterun | */prterun | */liggghts_mbd | */mbd_solver) [[ -z $1 ]] && echo "${folder#/proc/}" ;;
    esac
  done 2>/dev/null | sort -n
}
end_all() { local left; left=$(processes_of ""); [[ -z $left ]] || kill -KILL $left; }
die() { echo "$*"; tail -n 20 "$out/said.txt"; end_all; exit 1; }

in_phase() {
  case $1 in
    window) [[ -f run/history.csv && $(wc -l <run/history.csv) -gt 3 ]] ;;
    start) grep -qs '^run' run/liggghts.log && [[ -n $(processes_of mbd_solver) ]] ;;
    bed) grep -qs '^run' cache/beds/*/liggghts.log ;;
  esac
}
# The plate on grains that come from a bed, with these scripts.
scene_of_plate() {
  sed -e "s|^script = .*|script = \"$1\"|" "$here/../bad_input/plate_on_grains.scene"
  printf '[particles.bed]\nscript = "%s"\n' "$2"
}
# The script that never ends, in each phase; 2.5e9 substeps to the end, more than 32 bits count.
start_run() {
  local footfall=$1 phase=$3
  out=$2
  shift 3
  local more=("$@")
  rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
  export FOOTFALL_CACHE=$out/cache
  local script="$here/endless.in" bed="$here/endless_bed.in"
  if [[ $phase == start ]]; then
    script=$out/start.in
    sed -e "s|\${here}|$here|" -e '/couple.lammps/i run 1000000000' "$here/endless.in" >start.in
  elif [[ $phase == bed ]]; then
    bed=$out/bed.in
    sed -e "s|\${here}|$here|" -e '/write_restart/i run 1000000000' "$here/endless_bed.in" >bed.in
  fi
  scene_of_plate "$script" "$bed" >scene.toml
  "$footfall" run scene.toml --ranks 2 --set end_time=2.5e5 --set output.interval=0.03 --set output.plots=false --out run "${more[@]}" >said.txt 2>&1 &
  run=$!
  until in_phase "$phase"; do
    kill -0 "$run" 2>/dev/null || die "the run ended before it was in phase $phase"
    sleep 0.1
  done
}
wait_for_end() {
  local tenths
  for ((tenths = 10 * $1; tenths > 0; --tenths)); do
    if ! kill -0 "$run" 2>/dev/null; then
      wait "$run"
      code=$?
      until [[ -z $(processes_of "") ]]; do ((tenths-- > 0)) || return 1; sleep 0.1; done
      return 0
    fi
    sleep 0.1
  done
  return 1
}
