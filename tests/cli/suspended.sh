#!/usr/bin/env bash
# suspended.sh FOOTFALL OUT FIRST: all programs of a coupled run are stopped, as a batch system suspends a job, and go on later: FIRST (mpirun or
# the programs) first. mpirun hands its SIGCONT on to them, as it does when it ends a job; the run must go on all the same, and still end in order
# when somebody asks it to.
set -u
source "$(dirname "$0")/run_to_end.sh"
first=$3
# Windows of one substep: the plate lies on its grains for some 60 s of its own time.
start_run "$1" "$2" window --set coupling.timeout=2 --set particles.variables.every=1
mapfile -t programs < <(processes_of liggghts_mbd; processes_of mbd_solver)
mapfile -t launcher < <(processes_of orterun; processes_of prterun)
((${#launcher[@]} == 1 && ${#programs[@]} >= 2)) || die "expected one mpirun and its programs, found ${#launcher[@]} and ${#programs[@]}"
for pause in 1 3; do
  kill -STOP "${programs[@]}" "${launcher[@]}"
  nap $pause
  before=$(rows)
  if [[ $first == mpirun ]]; then kill -CONT "${launcher[@]}"; nap 0.1; kill -CONT "${programs[@]}"
  else kill -CONT "${programs[@]}"; nap 0.1; kill -CONT "${launcher[@]}"; fi
  for ((k = 0; k < 300 && $(rows) <= before; ++k)); do
    kill -0 "$run" 2>/dev/null || die "a run that was suspended has ended"
    nap 0.1
  done
  (($(rows) > before)) || die "after a stop of $pause s the run does not go on within 30 s"
done
nap 11 # what comes soon after a stop counts to it
kill -TERM "${launcher[@]}"
wait_for_end 40 || die "still there: $(processes_of "" | tr '\n' ' ')"
[[ $code == 3 ]] || die "asked to end: exit code $code, expected 3"
exit 0
