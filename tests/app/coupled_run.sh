# Sourced by scripts that end runs by force: the plate of tests/app/plate on its bed; processes are found by their working folder, never by
# name alone.
#   start_run FOOTFALL OUT PHASE [OPTION...]   starts it in OUT and waits until it is in the phase; sets `run`. BEDS: folder of the bed cache
#   begin_run FOOTFALL OUT PHASE [OPTION...]   the same; false when it has ended before
#   processes_of NAME                          process ids of a program of the run, in rising order; "" for all
#   wait_for_end SECONDS                       sets `code`, and `gone`: when the last process ended [us]; false when it is still there
# Phases: bed, start (LIGGGHTS reads its script), handshake, window, exchange (a random moment of one), checkpoint (being written), shutdown
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
set -m # a process in the background then ignores no signal
exec {never}<> <(:)
nap() { read -rt "$1" -u "$never"; } # without a process, which a busy machine starts late
now() { echo "${EPOCHREALTIME/[.,]/}"; } # [us]
processes_of() {
  local folders
  mapfile -t folders < <(find /proc/[0-9]*/cwd -maxdepth 0 -lname "$(cd "$out" && pwd -P)" -printf '%h/exe\n' 2>/dev/null)
  ((${#folders[@]})) || return 0
  find "${folders[@]}" -maxdepth 0 -printf '%h %l\n' 2>/dev/null | while read -r folder program; do
    case $program in
      *"/$1" | *"/$1 (deleted)") echo "${folder#/proc/}" ;;
      */footfall | */orterun | */prterun | */prte | */liggghts_mbd | */mbd_solver) [[ -z $1 ]] && echo "${folder#/proc/}" ;;
    esac
  done | sort -n
}
launcher() { processes_of orterun; processes_of prterun; processes_of prte; }
end_all() { local left; left=$(processes_of ""); [[ -z $left ]] || kill -KILL $left; }
die() { echo "$*"; tail -n 20 "$out/said.txt"; end_all; exit 1; }
rows() { local lines=(); mapfile -t lines 2>/dev/null <run/history.csv; echo ${#lines[@]}; } # with the two lines of names
checkpoints() { ls run/checkpoint 2>/dev/null | grep -v part | sort -n; }
in_phase() {
  case $1 in
    bed) grep -qs '^run' "$FOOTFALL_CACHE"/beds/*/liggghts.log ;;
    start) grep -qs '^run' run/liggghts.log && [[ -n $(processes_of mbd_solver) ]] ;;
    handshake) grep -qs '^fix geo' run/liggghts.log ;;
    window | exchange) [[ -f run/history.csv ]] && (($(rows) > 3)) ;;
    checkpoint) compgen -G 'run/checkpoint/*.part' >/dev/null ;;
    shutdown) grep -qs '^0.0[45]' run/history.csv ;;
  esac
}
scene_of_plate() { # SCRIPT BED
  printf 'base = "%s/plate/scene.toml"\n[particles]\nscript = "%s"\nbed = { script = "%s" }\n' "$here" "$1" "$2"
}
start_run() { begin_run "$@" || die "the run ended before it was in phase $3"; }
begin_run() {
  local footfall=$1 phase=$3
  out=$2
  shift 3
  local more=("$@") end=2.5e5 # 2.5e9 steps, more than 32 bits count
  rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
  out=$PWD
  export FOOTFALL_CACHE=${BEDS:-$out/cache}
  [[ $phase == bed ]] && FOOTFALL_CACHE=$out/cache
  local script=$here/plate/on_bed.in bed=$here/plate/bed.in
  case $phase in
    bed)
      bed=$out/bed.in
      sed -e "s|\${here}|$here/plate|" -e '/write_restart/i run 1000000000' "$here/plate/bed.in" >bed.in
      ;;
    start)
      script=$out/start.in
      sed -e "s|\${here}|$here/plate|" -e '/couple.lammps/i thermo_modify flush yes\nrun 1000000000' "$here/plate/on_bed.in" >start.in
      ;;
    checkpoint)
      more+=(--set output.checkpoint_interval=0.01)
      end=900
      ;;
    shutdown) end=0.05 ;;
  esac
  scene_of_plate "$script" "$bed" >scene.toml
  # Whoever started us may ignore signals (nohup).
  env --default-signal "$footfall" run scene.toml --ranks 2 --set end_time=$end --set output.interval=0.03 --set output.plots=false --out run "${more[@]}" >said.txt 2>&1 &
  run=$!
  local pause=0.05
  [[ $phase == @(handshake|checkpoint|shutdown) ]] && pause=0.002
  until in_phase "$phase"; do
    kill -0 "$run" 2>/dev/null || return 1
    nap $pause
  done
  case $phase in
    exchange) nap "0.$((100 + RANDOM % 400))" ;;
    handshake | shutdown) nap "0.0$((10 + RANDOM % 90))" ;;
  esac
  return 0
}
wait_for_end() {
  local last=$(($(now) + $1 * 1000000))
  while kill -0 "$run" 2>/dev/null; do
    (($(now) < last)) || return 1
    nap 0.02
  done
  wait "$run"
  code=$?
  gone=$(now)
  while [[ -n $(processes_of "") ]]; do
    (($(now) < last)) || return 1
    nap 0.02
    gone=$(now)
  done
  return 0
}
