#!/usr/bin/env bash
# kills.sh FOOTFALL OUT COUNT [SEED [SECONDS]]: a coupled run is killed (SIGKILL) so many times, or until so long has passed, each time another process at another moment,
# drawn at random, and resumed. History, surfaces and pictures must then equal the undisturbed run's, byte by byte. Prints a line for each kill.
# A program whose parent has died ends by a signal, and may then write one more checkpoint. At a checkpoint LIGGGHTS sorts its grains anew, which shows in the last bits:
# such a run must come to its end, and is resumed once more from the newest checkpoint that the undisturbed run makes as well.
set -u
export LC_ALL=C.UTF-8  # decimal points of awk
source "$(dirname "$0")/coupled_run.sh"
footfall=$1 count=$3
RANDOM=${4:-1}
limit=${5:-1000000}
rm -rf "$2" && mkdir -p "$2" && cd "$2" && base=$PWD || exit 1
interval=0.01 end=0.07
scene=("$here/../../inputs/dropped_sphere" --ranks 2 --until $end --set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42
  --set particles.bed.variables.width=0.42 --set particles.bed.variables.depth=0.2 --set particles.bed.variables.settle=0.3
  --set output.checkpoint_interval=$interval --set output.vtk=true --set output.plots=false --quiet)
fail() { echo "kills.sh: $*"; tail -n 20 "$base/case/said.txt"; end_all; exit 1; }
# Checkpoints of the undisturbed run: at the first end of a window (of 0.3 ms) at or after each multiple of the interval.
regular=$(awk -v i=$interval -v e=$end 'BEGIN { for (k = 1; k * i < e - 1e-9; ++k) { w = k * i / 3e-4; n = int(w); printf " %d ", (w > n + 1e-6) ? n + 1 : n } }')

mkdir straight && cd straight && out=$PWD
for name in run again; do
  begun=$(now)
  FOOTFALL_CACHE=$base/cache "$footfall" run "${scene[@]}" --out $name >said.txt 2>&1 || { cat said.txt; exit 1; }
  took=$((($(now) - begun) / 1000)) # [ms]
done
cd "$base" || exit 1
same() {
  local file
  for file in "$base/straight/run/"{history.csv,motion/*,bodies*}; do cmp "$file" "$1/${file#"$base/straight/run/"}" || return 1; done
}
same "$base/straight/again" || { echo "kills.sh: two undisturbed runs differ"; exit 1; }

ready() { # PHASE
  case $1 in
    window) [[ -f run/history.csv ]] && (($(rows) > 2)) ;;
    start) [[ -f run/liggghts.log ]] ;;
    shutdown) [[ -f run/history.csv ]] && grep -q '^0.069[5-9]\|^0.07' run/history.csv ;;
    *) in_phase "$1" ;;
  esac
}
victim() { # PROCESS
  case $1 in
    footfall) echo "$run" ;;
    mpirun) launcher ;;
    rank0) processes_of liggghts_mbd | sed -n 1p ;;
    rank1) processes_of liggghts_mbd | sed -n 2p ;;
    mbd_solver) processes_of mbd_solver ;;
  esac
}
phases=(bed start handshake window window window checkpoint checkpoint shutdown)
declare -A longest=([bed]=300 [start]=60 [handshake]=12 [checkpoint]=12 [shutdown]=12 [window]=$((took > 999 ? 999 : took))) # delay of the kill [ms]
killed=0 late=0
for ((i = 0; killed < count; ++i)); do
  ((SECONDS < limit)) || break
  ((i < 20 + 4 * count)) || fail "too many kills came too late: $late of $i"
  phase=${phases[RANDOM % ${#phases[@]}]}
  processes=(footfall mpirun rank0 rank1 mbd_solver)
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
  nap "$(printf '0.%03d' $((RANDOM % ${longest[$phase]})))"
  ids=$(victim "$process")
  if [[ -z $ids ]] || ! kill -KILL $ids 2>/dev/null; then
    late=$((late + 1))
    wait_for_end 60 || fail "a run that was not killed does not end"
    continue
  fi
  wait_for_end 60 || fail "$phase, $process: still there: $(processes_of "" | tr '\n' ' ')"
  killed=$((killed + 1)) how="from the start"
  newest=$(checkpoints | tail -n 1)
  if [[ -n $newest && $regular != *" $newest "* ]]; then
    cp -r run more
    "$footfall" run --resume more --quiet >said.txt 2>&1 || fail "$phase, $process: cannot be resumed from the checkpoint after window $newest, which the end has left"
    rm -rf "run/checkpoint/$newest" more
    newest=$(checkpoints | tail -n 1)
  fi
  if [[ -n $newest ]]; then
    "$footfall" run --resume run --quiet >said.txt 2>&1 || fail "$phase, $process: the run resumed after window $newest ended with $?"
    how="after window $newest"
  else
    rm -rf run
    "$footfall" run "${scene[@]}" --out run >said.txt 2>&1 || fail "$phase, $process: the run made anew ended with $?"
  fi
  same "$out/run" || fail "$phase, $process: another history than the undisturbed run's"
  echo "$killed: $process in $phase: exit code $code, resumed $how"
done
cd "$base" && rm -rf case
echo "kills $killed, too late $late"
