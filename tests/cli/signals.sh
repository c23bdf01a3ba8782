#!/usr/bin/env bash
# signals.sh FOOTFALL OUT PHASE PROCESS SIGNAL: one process of a run gets a signal; everything ends within ten seconds, with one exit code and one status
# for whoever got it, and nothing is left behind; a run in its windows leaves a whole checkpoint, from which it goes on. Prints the seconds
# that it took.
#   PHASE    bed, start (LIGGGHTS has not come to the coupling), handshake, window, exchange (a random moment of one), checkpoint (a set is being written), shutdown
#   PROCESS  footfall, mpirun, rank0, rank1, mbd_solver, all
#   SIGNAL   INT, TERM, HUP, QUIT, USR1, KILL; STOPPED: it is stopped, and then footfall gets INT; TWICE: TERM and HUP, one after the other
# signals.sh FOOTFALL OUT all [SECONDS]: every signal to every process in every phase, or as many as come in so many seconds.
# signals.sh FOOTFALL OUT many COUNT PROCESSES SIGNALS PHASES [SECONDS]: every signal to every process so many times, in phases that take turns (words in one argument each).
#   JOBS       of them at once (default 1); SEED, of the random moments
set -u
source "$(dirname "$0")/run_to_end.sh"
footfall=$1 phase=$3
several() { # lines PHASE PROCESS SIGNAL; prints what came of each, BAD where it did not hold
  local base=$1 until=$((SECONDS + $2))
  mkdir -p "$base" && base=$(cd "$base" && pwd) || exit 1
  [[ $footfall == /* ]] || footfall=$(cd "$(dirname "$footfall")" && pwd)/${footfall##*/}
  export BEDS=$base/beds
  local number=0 failed=0 line
  one() {
    ((SECONDS < until)) || exit 0
    local said
    if said=$("$here/signals.sh" "$footfall" "$base/$1" "$2" "$3" "$4" 2>&1); then
      echo "$said"
      rm -rf "${base:?}/$1"
    else
      echo "BAD $2, $3, $4 ($base/$1): $said"
      exit 1
    fi
  }
  while read -r line; do
    number=$((number + 1))
    one $number $line &
    while (($(jobs -pr | wc -l) >= ${JOBS:-1})); do wait -n || failed=1; done
  done
  while [[ -n $(jobs -pr) ]]; do wait -n || failed=1; done
  return $failed
}
if [[ $phase == all ]]; then
  for phase in start bed window; do
    for process in footfall mpirun rank0 rank1 mbd_solver all; do
      [[ $phase == bed && $process == mbd_solver ]] && continue
      for signal in INT TERM HUP QUIT USR1 KILL STOPPED; do
        [[ $signal == STOPPED && $process == @(footfall|all) ]] || echo "$phase $process $signal"
      done
    done
  done | several "$2" "${4:-1000000}"
  exit $?
elif [[ $phase == many ]]; then
  phases=($7) number=0
  for ((k = 0; k < $4; ++k)); do
    for process in $5; do
      for signal in $6; do
        phase=${phases[number++ % ${#phases[@]}]}
        [[ $phase == bed && $process == mbd_solver ]] && phase=window
        echo "$phase $process $signal"
      done
    done
    number=$((number + 1)) # so that each pair meets the next phase
  done | several "$2" "${8:-1000000}"
  exit $?
fi
process=$4 signal=$5
find_process() {
  case $process in
    footfall) ids=$run ;;
    mpirun) ids=$(processes_of orterun; processes_of prterun) ;;
    rank0) ids=$(processes_of liggghts_mbd | sed -n 1p) ;;
    rank1) ids=$(processes_of liggghts_mbd | sed -n 2p) ;;
    mbd_solver) ids=$(processes_of mbd_solver) ;;
    all) ids=$(processes_of "") ;;
  esac
  [[ -n $ids ]]
}
# In short phases the process may not be there yet, or no more.
for ((try = 0; try < 20; ++try)); do
  begin_run "$footfall" "$2" "$phase" --quiet --keep-every 0 && find_process && break
  [[ $phase == @(handshake|checkpoint|shutdown) ]] || die "$process was not found"
  end_all
  wait "$run" 2>/dev/null
done
[[ -n ${ids-} ]] || die "$process was not found"
start=$(now)
case $signal in
  STOPPED)
    kill -STOP $ids
    kill -INT "$run"
    ;;
  TWICE)
    kill -TERM $ids
    nap 0.3
    kill -HUP $ids 2>/dev/null
    ;;
  *) kill "-$signal" $ids ;;
esac
wait_for_end 60 || die "$phase, $process, $signal: still there: $(processes_of "" | tr '\n' ' ')"
tenths=$(((gone - start) / 100000))
expected=3 status=interrupted
[[ $signal == KILL ]] && expected=1 status=failed
[[ $signal == KILL && $process == @(footfall|all) ]] && expected=137 status=
[[ $phase == shutdown && $code == 0 ]] && expected=0 status=done
kept=no
compgen -G 'run/checkpoint/[0-9]*' >/dev/null && kept=$(ls run/checkpoint | grep -vc part)
echo "$phase, SIG$signal to $process: exit code $code, sets $kept, after $((tenths / 10)).$((tenths % 10)) s"

[[ $code == "$expected" ]] || die "exit code $code, expected $expected"
((tenths <= 100)) || die "it took more than ten seconds"
if [[ $phase != bed && -n $status ]]; then
  grep -q "\"status\": \"$status\"" run/summary.json || die "the summary does not say $status"
fi
[[ $expected == 137 ]] || ! compgen -G 'run/checkpoint/*.part' >/dev/null || die "half a checkpoint is left"
if [[ $phase == @(window|exchange|checkpoint) && $expected == 3 && $signal != STOPPED ]]; then
  compgen -G 'run/checkpoint/*' >/dev/null || die "there is no checkpoint"
  until=$(tail -n 1 run/history.csv | awk -F, '{print $1 + 0.04}')
  rows=$(rows)
  "$footfall" run --resume run --until "$until" --quiet >again.txt 2>&1 || die "it does not go on: $(cat again.txt)"
  (($(rows) > rows)) || die "no row has come to the history"
  grep -q '"status": "done"' run/summary.json || die "the resumed run is not done"
fi
compgen -G 'restart_forced*' >/dev/null && die "LIGGGHTS has left a restart file"
if [[ $phase == bed && $expected == 137 ]]; then
  # A front door that was killed cannot tidy up: the next one does.
  "$footfall" run scene.toml --ranks 2 --quiet --out again >>said.txt 2>&1 &
  run=$!
  sleep 2
  kill -TERM "$run"
  wait_for_end 20 || die "the second run did not end"
fi
[[ $phase == bed ]] && compgen -G 'cache/beds/*/' >/dev/null && die "the bed has left $(ls cache/beds)"
exit 0
