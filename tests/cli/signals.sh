#!/usr/bin/env bash
# signals.sh FOOTFALL OUT PHASE PROCESS SIGNAL: one process of a run gets a signal; everything ends soon, with one exit code and one status
# for whoever got it, and nothing is left behind; a run in its windows leaves a whole checkpoint, from which it goes on. Prints the seconds
# that it took.
#   PHASE    bed, start (LIGGGHTS has not come to the coupling), window
#   PROCESS  footfall, mpirun, rank0, rank1, mbd_solver, all
#   SIGNAL   INT, TERM, HUP, QUIT, USR1, KILL; STOPPED: it is stopped, and then footfall gets INT
# signals.sh FOOTFALL OUT all [SECONDS]: every signal to every process in every phase, some minutes, or as many as come in so many seconds.
set -u
source "$(dirname "$0")/run_to_end.sh"
footfall=$1 phase=$3
if [[ $phase == all ]]; then
  failed=0
  for phase in start bed window; do
    for process in footfall mpirun rank0 rank1 mbd_solver all; do
      [[ $phase == bed && $process == mbd_solver ]] && continue
      for signal in INT TERM HUP QUIT USR1 KILL STOPPED; do
        [[ $signal == STOPPED && $process == @(footfall|all) ]] && continue
        ((SECONDS < ${4:-1000000})) || continue
        "$0" "$footfall" "$2" "$phase" "$process" "$signal" || failed=1
      done
    done
  done
  exit $failed
fi
process=$4 signal=$5
start_run "$footfall" "$2" "$phase" --quiet --keep-every 0
case $process in
  footfall) ids=$run ;;
  mpirun) ids=$(processes_of orterun; processes_of prterun) ;;
  rank0) ids=$(processes_of liggghts_mbd | sed -n 1p) ;;
  rank1) ids=$(processes_of liggghts_mbd | sed -n 2p) ;;
  mbd_solver) ids=$(processes_of mbd_solver) ;;
  all) ids=$(processes_of "") ;;
esac
[[ -n $ids ]] || die "$process was not found"
start=$(date +%s%N)
if [[ $signal == STOPPED ]]; then
  kill -STOP $ids
  kill -INT "$run"
else
  kill "-$signal" $ids
fi
wait_for_end 40 || die "$phase, $process, $signal: still there: $(processes_of "" | tr '\n' ' ')"
tenths=$((($(date +%s%N) - start) / 100000000))
echo "$phase, SIG$signal to $process: exit code $code after $((tenths / 10)).$((tenths % 10)) s"

expected=3 status=interrupted
[[ $signal == KILL ]] && expected=1 status=failed
[[ $signal == KILL && $process == @(footfall|all) ]] && expected=137 status=
[[ $code == "$expected" ]] || die "exit code $code, expected $expected"
if [[ $phase != bed && -n $status ]]; then
  grep -q "\"status\": \"$status\"" run/summary.json || die "the summary does not say $status"
fi
if [[ $phase == window && $expected == 3 && $signal != STOPPED ]]; then
  compgen -G 'run/checkpoint/*.part' >/dev/null && die "half a checkpoint is left"
  mapfile -t sets < <(ls run/checkpoint)
  ((${#sets[@]} == 1)) || die "expected one checkpoint, found: ${sets[*]}"
  rows=$(wc -l <run/history.csv)
  until=$(tail -n 1 run/history.csv | awk -F, '{print $1 + 0.1}')
  "$footfall" run --resume run --until "$until" --quiet >again.txt 2>&1 || die "it does not go on: $(cat again.txt)"
  (($(wc -l <run/history.csv) > rows)) || die "no row has come to the history"
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
