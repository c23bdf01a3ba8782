#!/usr/bin/env bash
# Remakes docs/reliability.md: what was done to runs, and what came of it.
#   docs/reliability.sh [--short] [PART...]
#     PART     kills signals stops disk damage fuzz sanitizers endurance (default: all). Each keeps its lines in BUILD/reliability/PART.md; the page is put together
#              of those that are there, so that parts may be made one by one.
#     PART     page: puts the page together and does nothing else
#     --short  a minute in all, and the page stays as it is
#   BUILD=FOLDER (default build), FUZZ_SECONDS (300 for each target), PART_SECONDS: kills and signals are tried for so long at most; the page says how many were.
# The long form takes some hours on two cores.
set -uo pipefail
cd "$(dirname "$0")/.."
root=$PWD build=$(cd "${BUILD:-build}" && pwd)
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
short=false
[[ ${1-} == --short ]] && { short=true; shift; }
parts=("$@")
((${#parts[@]})) || parts=(kills signals stops disk damage fuzz sanitizers endurance)
footfall=$build/bin/footfall cli=tests/cli
work=$build/reliability
$short && work=$build/reliability_short
mkdir -p "$work"
failed=0 limit=${PART_SECONDS:-1000000}
of() { $short && echo "$1" || echo "$2"; } # SHORT LONG
quiet() { "$@" >"$work/log" 2>&1 || { failed=1; echo "FAILED: $*" >&2; tail -n 20 "$work/log" >&2; return 1; }; }
verdict() { (($1 == 0)) && echo "held" || echo "**did not hold**"; }

kills() {
  local log=$work/kills.log code=0
  $cli/kills.sh "$footfall" "$work/kills" "$(of 2 100)" "${SEED:-1}" "$limit" >"$log" 2>&1 || { code=1; failed=1; tail -n 5 "$log" >&2; }
  local total
  total=$(grep '^kills ' "$log")
  echo "| a program is killed (SIGKILL) at a random moment; then \`footfall run --resume\`, or anew where nothing was kept yet | $(grep -c '^[0-9]*: ' "$log"): $(sed -n 's/^phase //p' "$log" | paste -sd, | sed 's/,/, /g'); $(sed -n 's/^process //p' "$log" | paste -sd, | sed 's/,/, /g') | history, surfaces and pictures are those of the undisturbed run to the byte; ${total#kills *, } | $(verdict $code) | \`Kills.*\`, \`Resume.ToTheBit/*\` |"
}

signals() {
  local log=$work/signals.log code=0 process signal k
  : >"$log"
  for ((k = 0; k < $(of 1 10); ++k)); do
    for process in $(of rank1 "footfall mpirun rank0 rank1 mbd_solver"); do
      for signal in $(of TERM "TERM INT HUP QUIT USR1"); do
        ((SECONDS < limit)) || break 3
        $cli/signals.sh "$footfall" "$work/signals" window "$process" "$signal" >>"$log" 2>&1 || { code=1; failed=1; echo "BAD $process $signal" >>"$log"; }
      done
    done
  done
  echo "| a signal (TERM, INT, HUP, QUIT, USR1) to one process of a run in its windows (footfall, mpirun, rank 0, rank 1, mbd_solver) | $(grep -c '^window, SIG' "$log") | exit code 3, a whole checkpoint from which the run goes on, nothing left; all gone after $(slowest "$log") s at most | $(verdict $code) | \`Signals.EndBothPrograms/*\` |"
  $short && return
  code=0
  $cli/signals.sh "$footfall" "$work/signals" all "$limit" >"$log" 2>&1 || { code=1; failed=1; }
  echo "| every signal, and SIGKILL, to every process in every phase (bed, start, window) | $(grep -c ', SIG' "$log") | exit code 3 (1 for SIGKILL), nothing left; all gone after $(slowest "$log") s at most | $(verdict $code) | \`Signals.EndBothPrograms/*\` |"
}
slowest() { sed -n 's/.*after \([0-9.]*\) s$/\1/p' "$1" | sort -n | tail -n 1; }

stops() {
  local log=$work/stops.log code=0 case
  : >"$log"
  for case in $(of window/mbd_solver "window/liggghts_mbd window/mbd_solver window/orterun start/liggghts_mbd"); do
    $cli/stopped_partner.sh "$footfall" "$work/stops" "${case#*/}" "${case%/*}" >>"$log" 2>&1 || { code=1; failed=1; }
  done
  echo "| one program is stopped (SIGSTOP), \`coupling.timeout\` = 2 s: $(sed -n 's/^\(.*\) stopped: .*/\1/p' "$log" | paste -sd';' | sed 's/;/; /g') | $(grep -c ended "$log") | exit code 1, a message names the silent program; all gone after $(slowest "$log") s at most | $(verdict $code) | \`Failure.AStoppedPartnerEndsTheRun/*\` |"
}

disk() {
  local log=$work/disk.log code=0 case
  : >"$log"
  $cli/full_disk.sh "$footfall" "$work/disk" >>"$log" 2>&1 || { code=1; failed=1; }
  for case in $(of restart "motion pictures restart memory"); do
    $cli/full_disk_grains.sh "$footfall" "$work/disk_$case" $case >>"$log" 2>&1 || { code=1; failed=1; }
  done
  echo "| a file may not grow any more: history, summary, pictures, checkpoint of a mechanism; motion, pictures, both sides' parts of a checkpoint with grains; a folder that is gone | $(of "" 9) | exit code 1 at once, with the file's name; what is there is whole; no half set passes for a checkpoint | $(verdict $code) | \`cli.full_disk\`, \`Failure.AFileThatMayNotGrowEndsTheRun/*\` |"
  $short && return
  code=0
  $cli/full_tmpfs.sh "$footfall" "$work/tmpfs" >"$log" 2>&1 || code=$?
  if ((code == 77)); then
    echo "| a disk that is full (a small tmpfs) | 0 | not tried: no right to mount one | | |"
  else
    ((code == 0)) || failed=1
    echo "| a disk that is full (a small tmpfs), with grains, at $(grep -c '^full' "$log") sizes between an empty folder and a whole run | $(grep -c '^full' "$log") | exit code 1 with the file's name, or done where the room is enough; what is there is whole | $(verdict $code) | |"
  fi
}

damage() {
  local log=$work/damage.log code=0
  $cli/damaged_checkpoint.sh "$footfall" "$work/damaged_checkpoint" >"$log" 2>&1 || { code=1; failed=1; }
  echo "| files of a checkpoint, and the history it belongs to, cut, changed, empty, missing | $(sed -n 's/ damaged checkpoints.*//p' "$log") | the set before is taken, to the byte; where none is whole exit code 2 and their names | $(verdict $code) | \`cli.damaged_checkpoint\` |"
  $short && return
  code=0
  $cli/damaged_runs.sh "$footfall" "$work/damaged_runs" >"$log" 2>&1 || { code=1; failed=1; }
  echo "| summaries cut or strange, read by report, pictures, compare, sweep | 18 | exit code 2; a sweep does the run again | $(verdict $code) | \`cli.damaged_runs\` |"
  code=0
  $cli/damaged_bed.sh "$footfall" "$work/damaged_bed" inputs/dropped_sphere >"$log" 2>&1 || { code=1; failed=1; }
  echo "| beds empty, cut, changed, missing, without seal; a cut restart file of a script | 6 | made again with a warning; exit code 2 for the script's own | $(verdict $code) | \`Bed.ThatIsDamagedIsToldAndMadeAgain\` |"
  code=0
  ctest --test-dir "$build" -L bad_input >"$log" 2>&1 || { code=1; failed=1; }
  echo "| wrong scenes, scripts, meshes, experiments; kept findings of fuzzing | $(sed -n 's/.*tests passed.* out of //p' "$log") tests | one clear message, exit code 2, within 10 s | $(verdict $code) | label \`bad_input\` |"
}

fuzz() {
  local log=$work/fuzz.log code=0 seconds=${FUZZ_SECONDS:-300}
  if $short; then
    ctest --test-dir "$build" -R '^fuzz\.' >"$log" 2>&1 || failed=1
    return
  fi
  nice tests/fuzz/run.sh "$seconds" >"$log" 2>&1 || { code=1; failed=1; }
  echo "| every reader is fed with rubbish (libFuzzer, address and undefined sanitizers), $seconds s for each of $(grep -c ': .*Done [0-9]* runs' "$log") targets | $(sed -n 's/.*Done \([0-9]*\) runs.*/\1/p' "$log" | awk '{ n += $1 } END { printf "%.2g million inputs", n / 1e6 }') | refused in the reader's own words, or read; no crash, no hang above 10 s | $(verdict $code) | \`fuzz.*\` (the kept inputs) |"
}

sanitizers() {
  $short && return
  local log=$work/sanitizers.log code=0
  nice tests/sanitize/run.sh >"$log" 2>&1 || { code=1; failed=1; }
  echo "| tests with address and undefined sanitizers (g++), unit tests under valgrind (memcheck) | $(sed -n 's/^\([a-z_]*\), address.*out of \([0-9]*\).*/\2 \1/p' "$log" | paste -sd, | sed 's/,/, /g'); $(sed -n 's/^valgrind, \([a-z_]*\):.*/\1/p' "$log" | paste -sd, | sed 's/,/, /g') | no finding. Neither program has threads of its own | $(verdict $code) | |"
}

endurance() {
  local log=$work/endurance.log code=0
  "$build/bin/endurance_loopback" "$(of 10000 1000000)" >"$log" 2>&1 || { code=1; failed=1; }
  echo "| many windows in one process | $(head -n 1 "$log" | sed 's/ windows.*//') windows | $(tail -n 1 "$log" | sed 's/.*windows: //') | $(verdict $code) | \`Endurance.MemoryStays/loopback\` |"
  code=0
  tests/endurance/grains.sh "$footfall" "$work/endurance" "$(of 2000 100000)" >"$log" 2>&1 || { code=1; failed=1; }
  echo "| many windows through LIGGGHTS, two ranks | $(tail -n 1 "$log" | sed 's/ windows.*//') windows | $(tail -n 1 "$log" | sed 's/.*: //') | $(verdict $code) | \`Endurance.MemoryStays/grains\` |"
  $short && return
  code=0
  tests/endurance/plane.sh "$footfall" "$work/plane" "${PLANE_SECONDS:-1000}" >"$log" 2>&1 || { code=1; failed=1; }
  echo "| the lander stands on the rigid plane | $(tail -n 1 "$log" | sed 's/ on the.*//') | $(tail -n 1 "$log" | sed 's/.*plane: //') | $(verdict $code) | |"
}

for part in "${parts[@]}"; do
  [[ $part == page ]] && continue
  echo "reliability: $part" >&2
  $part >"$work/$part.new" && mv "$work/$part.new" "$work/$part.md"
done
$short && exit $failed
cd "$root" || exit 1
{
  cat <<'TEXT'
# What was done to runs, and what came of it

Made by `docs/reliability.sh`. The last column names the tests that do a part of the same in every run of the checks (`ctest -R NAME`).
The killed run is a ball that drops onto some 400 grains on two ranks, with checkpoints; signals, stops and full disks meet a plate on grains that would go on for days.

| what was done | tried | what has to come of it, and figures | | tests |
|---|---|---|---|---|
TEXT
  for part in kills signals stops disk damage fuzz sanitizers endurance; do
    cat "$work/$part.md" 2>/dev/null || echo "| $part | not tried yet | | | |"
  done
  cat <<'TEXT'

- "All gone" is counted from the kill or signal until the last process of the run has ended. A program that is asked to end and cannot, because another one is stopped, ends 5 s after the signal.
- A set of files that is not whole never counts as a checkpoint: it grows under another name and is renamed when checksums of all its files are on the disk ([resume.md](resume.md)).
- Killed is not powered off: what a disk has confirmed and then loses is not tried here.
TEXT
} > docs/reliability.md
exit $failed
