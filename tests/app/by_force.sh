#!/usr/bin/env bash
# by_force.sh FOOTFALL OUT CASE...: a coupled run that is ended, stopped or starved from outside. Everything ends within ten seconds, with the exit code of what
# happened and a summary that agrees, and nothing is left running; the last checkpoint is complete.
#   signal PHASE PROCESS SIGNAL  PHASE: coupled_run.sh; PROCESS: footfall, mpirun, rank0, rank1, mbd_solver, all; SIGNAL: INT, TERM, HUP, QUIT, USR1, KILL; STOPPED: the
#                                process is stopped, then footfall gets INT; TWICE: TERM and HUP, one after the other. The run is then resumed.
#   signals COUNT PROCESSES SIGNALS PHASES   every signal to every process so many times, in phases that take turns (words in one argument each). JOBS at once (default 1)
#   stopped PROGRAM PHASE        one program is stopped (SIGSTOP): after coupling.timeout the other reports it
#   suspended FIRST              all programs are stopped and resumed, as a batch system suspends a job, mpirun or the programs first. mpirun then hands its SIGCONT on
#                                to them, as it does when it ends a job: the run continues, and still ends in order when asked to
#   full motion|pictures|restart|state   a file may not grow, or finds the disk full
#   disks                        runs into disks of 16 kB to 1 MB (a tmpfs; exit code 77 where none can be mounted)
#   no_room                      limits that leave MPI no room for its files: a full folder, files, their size (likewise)
#   launcher                     mpirun crashes when both programs have ended, which is no failure; or before them, which is one
set -u
export LC_ALL=C.UTF-8  # decimal points of awk
self=$(realpath -s "$0") footfall=$(realpath -s "$1")
source "$(dirname "$self")/coupled_run.sh"
out=$2 what=$3
shift 3
seconds() { echo "$((($1 - start) / 100000 / 10)).$((($1 - start) / 100000 % 10)) s"; }
ends_with() { # CODE: within a minute
  wait_for_end 60 || die "$what: still there: $(processes_of "" | tr '\n' ' ')"
  [[ $code == "$1" ]] || die "$what: exit code $code, expected $1"
}
summary_says() { grep -q "\"status\": \"$1\"" run/summary.json || die "$what: the summary does not say $1"; }

signal() { # PHASE PROCESS SIGNAL
  local phase=$1 process=$2 signal=$3 ids= try expected=3 status=interrupted until before
  what="$phase, SIG$signal to $process"
  find_process() {
    case $process in
      footfall) ids=$run ;;
      mpirun) ids=$(launcher) ;;
      rank0) ids=$(processes_of liggghts_mbd | sed -n 1p) ;;
      rank1) ids=$(processes_of liggghts_mbd | sed -n 2p) ;;
      mbd_solver) ids=$(processes_of mbd_solver) ;;
      all) ids=$(processes_of "") ;;
    esac
    [[ -n $ids ]]
  }
  for ((try = 0; try < 20; ++try)); do # in short phases the process may not be there yet, or no more
    begin_run "$footfall" "$out" "$phase" --quiet --keep-every 0 && find_process && break
    [[ $phase == @(handshake|checkpoint|shutdown) ]] || die "$process was not found"
    end_all
    wait "$run" 2>/dev/null
  done
  [[ -n $ids ]] || die "$process was not found"
  start=$(now)
  case $signal in
    STOPPED) kill -STOP $ids && kill -INT "$run" ;;
    TWICE) kill -TERM $ids && nap 0.3 && kill -HUP $ids 2>/dev/null ;;
    *) kill "-$signal" $ids ;;
  esac
  wait_for_end 60 || die "$what: still there: $(processes_of "" | tr '\n' ' ')"
  [[ $signal == KILL ]] && expected=1 status=failed
  [[ $signal == KILL && $process == @(footfall|all) ]] && expected=137 status=
  [[ $phase == shutdown && $code == 0 ]] && expected=0 status=done
  echo "$what: exit code $code, checkpoints $(checkpoints | wc -l), after $(seconds "$gone")"
  [[ $code == "$expected" ]] || die "exit code $code, expected $expected"
  ((gone - start <= 10000000)) || die "it took more than ten seconds"
  [[ $phase == bed || -z $status ]] || summary_says "$status"
  [[ $expected == 137 ]] || ! compgen -G 'run/checkpoint/*.part' >/dev/null || die "half a checkpoint is left"
  if [[ $phase == @(window|exchange|checkpoint) && $expected == 3 && $signal != STOPPED ]]; then
    [[ -n $(checkpoints) ]] || die "there is no checkpoint"
    until=$(tail -n 1 run/history.csv | awk -F, '{print $1 + 0.04}')
    before=$(rows)
    "$footfall" run --resume run --until "$until" --quiet >again.txt 2>&1 || die "it cannot be resumed: $(cat again.txt)"
    (($(rows) > before)) || die "the history has no new row"
    summary_says done
  fi
  compgen -G 'restart_forced*' >/dev/null && die "LIGGGHTS has left a restart file"
  if [[ $phase == bed && $expected == 137 ]]; then # what a killed footfall has left the next one removes
    "$footfall" run scene.toml --ranks 2 --quiet --out again >>said.txt 2>&1 &
    run=$!
    sleep 2
    kill -TERM "$run"
    wait_for_end 20 || die "the second run did not end"
  fi
  [[ $phase == bed ]] && compgen -G 'cache/beds/*/' >/dev/null && die "the bed has left $(ls cache/beds)"
  return 0
}

signals() { # COUNT PROCESSES SIGNALS PHASES
  local base number=0 failed=0 phases=($4) k process signal phase
  mkdir -p "$out" && base=$(cd "$out" && pwd) || exit 1
  export BEDS=$base/beds
  one() {
    local said
    if said=$("$self" "$footfall" "$base/$1" signal "$2" "$3" "$4" 2>&1); then
      echo "$said"
      rm -rf "${base:?}/$1"
    else
      echo "FAILED $2, $3, $4 ($base/$1): $said"
      exit 1
    fi
  }
  for ((k = 0; k < $1; ++k)); do
    for process in $2; do
      for signal in $3; do
        phase=${phases[number++ % ${#phases[@]}]}
        [[ $phase == bed && $process == mbd_solver ]] && phase=window
        one $number "$phase" "$process" "$signal" &
        while (($(jobs -pr | wc -l) >= ${JOBS:-1})); do wait -n || failed=1; done
      done
    done
    number=$((number + 1)) # each pair meets the next phase
  done
  while [[ -n $(jobs -pr) ]]; do wait -n || failed=1; done
  return $failed
}

stopped() { # PROGRAM PHASE
  what="$2, $1 stopped"
  start_run "$footfall" "$out" "$2" --set coupling.timeout=2
  local id
  id=$(processes_of "$1" | head -n 1)
  [[ -n $id ]] || die "$1 was not found"
  kill -STOP "$id"
  start=$(now)
  ends_with 1
  summary_says failed
  echo "$what: ended after $(seconds "$gone")"
}

suspended() { # FIRST
  # Windows of one step: the plate lies on its grains for some 60 s of the machine's time.
  start_run "$footfall" "$out" window --set coupling.timeout=2 --set particles.variables.every=1
  local programs mpirun pause before k
  mapfile -t programs < <(processes_of liggghts_mbd; processes_of mbd_solver)
  mapfile -t mpirun < <(launcher)
  ((${#mpirun[@]} == 1 && ${#programs[@]} >= 2)) || die "expected one mpirun and its programs, found ${#mpirun[@]} and ${#programs[@]}"
  for pause in 1 3; do
    kill -STOP "${programs[@]}" "${mpirun[@]}"
    nap $pause
    before=$(rows)
    if [[ $1 == mpirun ]]; then kill -CONT "${mpirun[@]}"; nap 0.1; kill -CONT "${programs[@]}"
    else kill -CONT "${programs[@]}"; nap 0.1; kill -CONT "${mpirun[@]}"; fi
    for ((k = 0; k < 300 && $(rows) <= before; ++k)); do
      kill -0 "$run" 2>/dev/null || die "a run that was suspended has ended"
      nap 0.1
    done
    (($(rows) > before)) || die "after a stop of $pause s the run does not go on within 30 s"
  done
  nap 11 # what comes soon after a stop counts to it
  kill -TERM "${mpirun[@]}"
  ends_with 3
}

full() { # CASE: before the limit only the rows, pictures and checkpoints of the case are written
  local options=() program=mbd_solver limit name id before set
  case $1 in
    motion) limit=20000 name=motion/plate.csv ;;
    pictures) options=(--set output.vtk=true --set output.vtk_interval=0.2) limit=unlimited name=bodies_ ;;
    state) options=(--set output.checkpoint_interval=0.5) limit=2000 name='run.txt\|plate.csv' ;;
    restart) options=(--set output.checkpoint_interval=0.5) program=liggghts_mbd limit=1000 name=grains.restart ;;
  esac
  what="full, $1"
  start_run "$footfall" "$out" window --set end_time=1e4 --keep-every 0 "${options[@]}"
  # Pictures alone: the file of the motion grows in each window, so that a limit for all files would meet it first.
  [[ $1 != pictures ]] || for id in {0000..0999}; do ln -s /dev/full "run/bodies_$id.vtu.part"; done
  for id in $(processes_of $program); do prlimit --pid "$id" --fsize=$limit || die "prlimit is missing"; done
  sleep 0.3
  before=" $(ls run/checkpoint 2>/dev/null | tr '\n' ' ')"
  ends_with 1
  grep -q "\($name\)" said.txt || die "$what: the message does not name the file"
  for set in run/checkpoint/*; do
    [[ $set == *.part || ! -e $set || $before == *" ${set##*/} "* ]] || die "$what: half a set passes for a checkpoint: $set"
  done
}

disks() {
  local size cells
  rm -rf "$out" && mkdir -p "$out/disk" && cd "$out" && out=$PWD || exit 1
  export FOOTFALL_CACHE=$out/cache
  scene_of_plate "$here/plate/on_bed.in" "$here/plate/bed.in" >scene.toml
  trap 'cd /; umount "$out/disk" 2>/dev/null' EXIT
  for size in 16 32 48 64 96 128 192 256 384 512 1024; do
    what="disk of $size kB"
    mount -t tmpfs -o size=${size}k tmpfs disk 2>/dev/null || exit 77
    "$footfall" run scene.toml --ranks 2 --set end_time=1.0 --set output.interval=0.01 --set output.vtk=true --set output.vtk_interval=0.05 --set output.checkpoint_interval=0.11 \
      --set output.plots=false --quiet --out disk/run >said.txt 2>&1 &
    run=$!
    wait_for_end 60 || die "$what: still there"
    # Before the first row it is a wrong folder.
    [[ $code == [01] || ($code == 2 && $(cat disk/run/history.csv 2>/dev/null | wc -l) -le 2) ]] || die "$what: exit code $code"
    if [[ -s disk/run/history.csv ]] && (($(wc -l <disk/run/history.csv) > 2)); then
      cells=$(sed -n 2p disk/run/history.csv | tr -cd , | wc -c)
      [[ -z $(tail -c 1 disk/run/history.csv) && $(tail -n 1 disk/run/history.csv | tr -cd , | wc -c) == "$cells" ]] || die "$what: the history ends in half a row"
    fi
    if ((code != 0)) && ls disk/run/checkpoint 2>/dev/null | grep -qv part; then
      mount -o remount,size=64m disk
      "$footfall" run --resume disk/run --quiet >again.txt 2>&1 || die "$what: with room again it cannot be resumed: $(cat again.txt)"
    fi
    echo "$what: exit code $code"
    umount disk
  done
}

# Limits that leave mpirun no room for its own files: said before it starts, and nothing is made.
no_room() {
  rm -rf "$out" && mkdir -p "$out/disk" && cd "$out" && out=$PWD || exit 1
  trap 'cd /; umount "$out/disk" 2>/dev/null' EXIT
  refused() { # WHAT WORD: a run in the environment of this shell
    "$footfall" run "$here/plate" --quiet --out run >said.txt 2>&1 &
    run=$!
    wait_for_end 10 || die "$1: still there"
    [[ $code == 2 ]] || die "$1: exit code $code, expected 2"
    grep -q "$2.*E0575" said.txt || die "$1: no message names $2: $(cat said.txt)"
    [[ ! -e run ]] || die "$1: there is a folder of the run"
  }
  (ulimit -n 24 && refused "ulimit -n" "ulimit -n") && (ulimit -f 64 && refused "ulimit -f" "ulimit -f") || exit 1
  for size in 200k 300k 1000k 8000k; do
    mount -t tmpfs -o size=$size tmpfs disk 2>/dev/null || exit 77
    (TMPDIR=$PWD/disk && export TMPDIR && refused "$size" "$PWD/disk has .* kB left") || exit 1
    umount disk
  done
  mount -t tmpfs -o size=64k tmpfs disk || exit 77
  (export OMPI_MCA_btl_vader_backing_directory=$PWD/disk && refused "shared memory" "shared memory $PWD/disk has .* kB left") || exit 1
  umount disk
  mount -t tmpfs -o size=64m,nr_inodes=12 tmpfs disk || exit 77
  (TMPDIR=$PWD/disk && export TMPDIR && refused inodes inodes)
}

launcher_crash() {
  rm -rf "$out" && mkdir -p "$out/bin" && cd "$out" && out=$PWD || exit 1
  local mpirun
  mpirun=$(command -v mpirun)
  scene_of_plate "$here/plate/on_bed.in" "$here/plate/bed.in" >scene.toml
  run_with() { # what the launcher of the two programs does; other launches are mpirun's own
    printf '#!/bin/sh\ncase "$*" in *mbd_solver*) %s ;; *) exec %s "$@" ;; esac\n' "$1" "$mpirun" >bin/mpirun && chmod +x bin/mpirun
    PATH=$PWD/bin:$PATH FOOTFALL_CACHE=$PWD/cache "$footfall" run scene.toml --out run --until 0.02 --force --quiet >said.txt 2>&1
    code=$?
  }
  run_with "$mpirun \"\$@\"; kill -SEGV \$\$"
  ((code == 0)) || die "whole run: exit code $code, expected 0"
  summary_says done
  grep -q 'mpirun' said.txt || die "no warning names mpirun"
  run_with 'kill -SEGV $$'
  ((code == 1)) || die "no run: exit code $code, expected 1"
  summary_says failed
}
[[ $what != launcher ]] || what=launcher_crash
"$what" "$@"
