#!/usr/bin/env bash
# kills.sh FOOTFALL OUT COUNT [SEED [SECONDS]]: a coupled run is killed (SIGKILL) so many times (or until so long has passed), each time another process at another moment, drawn at random, and gone on with. Its
# history, surfaces and pictures must then be those of the run that nobody has disturbed, byte by byte. Prints a line for each kill and a table.
#   phases     bed, start (LIGGGHTS reads its script), handshake, window, checkpoint (a set is being written), shutdown
#   processes  footfall (the front door), mpirun, mbd_solver, rank0, rank1 of LIGGGHTS
# Who dies takes the others along: by a signal where its parent has died, and these may then write one more set. LIGGGHTS orders its grains anew at a set, which shows in
# the last bits; so the run goes on from that set (it must come to its end), and then once more from the newest of the sets that the undisturbed run makes.
set -u
source "$(dirname "$0")/run_to_end.sh"
footfall=$1 count=$3
RANDOM=${4:-1}
limit=${5:-1000000}
inputs=$(cd "$here/../../inputs" && pwd)
rm -rf "$2" && mkdir -p "$2" && cd "$2" && base=$PWD || exit 1
interval=0.01 end=0.07
scene=("$inputs/dropped_sphere" --ranks 2 --until $end --set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42
  --set particles.bed.variables.width=0.42 --set particles.bed.variables.depth=0.2 --set particles.bed.variables.settle=0.3
  --set output.checkpoint_interval=$interval --set output.vtk=true --set output.plots=false --quiet)
fail() { echo "kills.sh: $*"; tail -n 20 "$base/case/said.txt"; end_all; exit 1; }
# The sets of the undisturbed run: at the first window's end at or after each multiple of the interval; windows are of 0.3 ms.
regular=$(awk -v i=$interval -v e=$end 'BEGIN { for (k = 1; k * i < e - 1e-9; ++k) { w = k * i / 3e-4; n = int(w); printf " %d ", (w > n + 1e-6) ? n + 1 : n } }')

mkdir straight && cd straight && out=$PWD
FOOTFALL_CACHE=$base/cache "$footfall" run "${scene[@]}" --out run >said.txt 2>&1 || { cat said.txt; exit 1; }
begun=$(date +%s%N)
FOOTFALL_CACHE=$base/cache "$footfall" run "${scene[@]}" --out again >said.txt 2>&1 || { cat said.txt; exit 1; }
took=$((($(date +%s%N) - begun) / 1000000)) # [ms]
cd "$base" || exit 1
# What must be the same, in two folders.
same() {
  local file
  for file in "$base/straight/run/"{history.csv,motion/*,bodies*}; do cmp "$file" "$1/${file#"$base/straight/run/"}" || return 1; done
}
same "$base/straight/again" || { echo "kills.sh: two undisturbed runs differ"; exit 1; }

moment() { nap "$(printf '0.%03d' "$1")"; } # [ms]
ready() { # phase
  case $1 in
    bed) grep -qs '^run' cache/beds/*/liggghts.log ;;
    start) [[ -f run/liggghts.log ]] ;;
    handshake) grep -qs '^fix geo' run/liggghts.log ;;
    window) [[ -f run/history.csv && $(wc -l <run/history.csv) -gt 2 ]] ;;
    checkpoint) compgen -G 'run/checkpoint/*.part' >/dev/null ;;
    shutdown) [[ -f run/history.csv ]] && tail -n 1 run/history.csv | grep -q '^0.0[67]' && grep -q '^0.069[5-9]\|^0.07' run/history.csv ;;
  esac
}
victim() {
  case $1 in
    footfall) echo "$run" ;;
    mpirun) processes_of orterun; processes_of prterun ;;
    rank0) processes_of liggghts_mbd | sed -n 1p ;;
    rank1) processes_of liggghts_mbd | sed -n 2p ;;
    mbd_solver) processes_of mbd_solver ;;
  esac
}
sets() { ls run/checkpoint 2>/dev/null | grep -v part | sort -n; }

phases=(bed start handshake window window window checkpoint checkpoint shutdown)
declare -A of_phase of_process
killed=0 late=0 slowest=0 resumed=0 anew=0 extra=0
for ((i = 0; killed < count; ++i)); do
  ((SECONDS < limit)) || break
  ((i < 20 + 4 * count)) || fail "too many kills came too late: $late of $i"
  phase=${phases[RANDOM % ${#phases[@]}]}
  processes=(footfall mpirun mbd_solver rank0 rank1)
  [[ $phase == bed ]] && processes=(footfall mpirun rank0 rank1)
  process=${processes[RANDOM % ${#processes[@]}]}
  cd "$base" && rm -rf case && mkdir case && cd case && out=$PWD || exit 1
  export FOOTFALL_CACHE=$base/cache
  [[ $phase == bed ]] && FOOTFALL_CACHE=$out/cache
  "$footfall" run "${scene[@]}" --out run >said.txt 2>&1 &
  run=$!
  until ready "$phase"; do
    kill -0 "$run" 2>/dev/null || break
    nap 0.002
  done
  case $phase in
    bed) moment $((RANDOM % 300)) ;;
    start) moment $((RANDOM % 60)) ;;
    handshake | checkpoint | shutdown) moment $((RANDOM % 12)) ;;
    window) moment $((RANDOM % (took > 999 ? 999 : took))) ;;
  esac
  ids=$(victim "$process")
  if [[ -z $ids ]] || ! kill -KILL $ids 2>/dev/null; then
    late=$((late + 1))
    wait_for_end 60 || fail "a run that was not killed does not end"
    continue
  fi
  start=$(now)
  wait_for_end 60 || fail "$phase, $process: still there: $(processes_of "" | tr '\n' ' ')"
  tenths=$(((gone - start) / 100000))
  ((tenths > slowest)) && slowest=$tenths
  killed=$((killed + 1))
  of_phase[$phase]=$((${of_phase[$phase]:-0} + 1)) of_process[$process]=$((${of_process[$process]:-0} + 1))

  how="from the start"
  newest=$(sets | tail -n 1)
  if [[ -n $newest && $regular != *" $newest "* ]]; then
    extra=$((extra + 1))
    cp -r run more
    "$footfall" run --resume more --quiet >said.txt 2>&1 || fail "$phase, $process: does not go on from the set after window $newest, which the end has left"
    rm -rf "run/checkpoint/$newest" more
    newest=$(sets | tail -n 1)
  fi
  if [[ -n $newest ]]; then
    "$footfall" run --resume run --quiet >said.txt 2>&1 || fail "$phase, $process: the run resumed after window $newest ended with $?"
    how="after window $newest" resumed=$((resumed + 1))
  else
    # A front door that is killed has not noted what is its own, and --force then removes nothing.
    rm -rf run
    "$footfall" run "${scene[@]}" --out run >said.txt 2>&1 || fail "$phase, $process: the run made anew ended with $?"
    anew=$((anew + 1))
  fi
  same "$out/run" || fail "$phase, $process: another history than that of the undisturbed run"
  echo "$killed: $process in $phase: exit code $code after $((tenths / 10)).$((tenths % 10)) s, gone on with $how"
done
cd "$base" && rm -rf case
echo "kills $killed, resumed $resumed, made anew $anew, sets of an end in order $extra, slowest end $((slowest / 10)).$((slowest % 10)) s, too late $late"
for key in "${!of_phase[@]}"; do echo "phase $key ${of_phase[$key]}"; done | sort
for key in "${!of_process[@]}"; do echo "process $key ${of_process[$key]}"; done | sort
exit 0
