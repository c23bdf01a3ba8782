#!/usr/bin/env bash
# Remakes docs/data/reliability.txt: signals, kills, full disks, damage, fuzzing, sanitizers, endurance.
#   docs/data/remake/reliability.sh [--short] [PART...]
#     PART     kills signals load stops disk damage keeping fuzz sanitizers endurance plane (default: all, in four rows in parallel). Each keeps its lines in
#              BUILD/reliability/PART.md. Lines of parts without such a file stay as they are; each names the commit that it tried.
#     PART     page: writes the data file and runs nothing
#     --short  a minute in all; the data file stays as it is
#   BUILD=FOLDER     default build, with all tests. The programs are copied first.
#   LOGS=1           takes the results of tests/fuzz/run.sh and tests/bench/sanitize/run.sh as they are
#   PART_SECONDS     limit of kills (default 900)
#   FUZZ_SECONDS     for each target (default 300); KEEP_SCENE, KEEP_ARGS: the run whose checkpoints are timed; PLANE_SECONDS
# The long form takes some 40 minutes on two cores that are shared, and hours with PART_SECONDS=100000 FUZZ_SECONDS=3600.
set -uo pipefail
cd "$(dirname "$0")/../../.." || exit 1
root=$PWD build=$(cd "${BUILD:-build}" && pwd)
export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
short=false as_row=false
[[ ${1-} == --short ]] && { short=true; shift; }
[[ ${1-} == --row ]] && { as_row=true; shift; } # of a whole run
parts=("$@")
all=(kills signals load stops disk damage keeping fuzz sanitizers endurance plane)
work=$build/reliability app=tests/app
version="$(git rev-parse --short HEAD 2>/dev/null || echo "no commit") ($(date +%F))"
$short && work=$build/reliability_short
mkdir -p "$work"
if [[ ${parts[*]} != page ]] && ! $as_row; then
  ((${#parts[@]})) || rm -f "$work"/*.md "$work"/*.failed
  rm -rf "${work:?}/bin" && cp -r "$build/bin" "$work/bin"
fi
footfall=$work/bin/footfall limit=${PART_SECONDS:-900}
of() { $short && echo "$1" || echo "$2"; } # SHORT LONG
verdict() { (($1 == 0)) && echo "held" || echo "**did not hold**"; }
failed() { touch "$work/$part.failed"; code=1; } # in a part
slowest() { sed -n 's/.*after \([0-9.]*\) s$/\1/p' "$1" | sort -n | tail -n 1; }
table_of() { sed -n "s/^$1 //p" "$2" | awk '{ n[$1] += $2 } END { for (k in n) print k, n[k] }' | sort | paste -sd, | sed 's/,/, /g'; }

kills() {
  local log=$work/kills.log code=0 jobs k
  jobs=${KILL_JOBS:-1}
  rm -f "$log".*
  for ((k = 1; k <= jobs; ++k)); do
    $app/kills.sh "$footfall" "$work/kills_$k" "$(of 2 $((100 / jobs)))" "$((${SEED:-1} + k))" "$limit" >"$log.$k" 2>&1 &
  done
  for ((k = 1; k <= jobs; ++k)); do wait -n || failed; done
  cat "$log".* >"$log"
  ((code == 0)) || tail -n 5 "$log".* >&2
  echo "| a program is killed (SIGKILL) at a random moment; then \`footfall run --resume\`, or anew where nothing was kept yet | $(grep -c '^[0-9]*: ' "$log"): $(sed -n 's/^[0-9]*: .* in \([a-z]*\): .*/phase \1 1/p' "$log" | table_of phase /dev/stdin); $(sed -n 's/^[0-9]*: \([a-z0-9_]*\) in .*/process \1 1/p' "$log" | table_of process /dev/stdin) | history, surfaces and pictures are those of the undisturbed run to the byte; resumed from a checkpoint $(grep -c 'resumed after' "$log"), anew $(grep -c 'resumed from the start' "$log") | $(verdict $code) | \`app.Kills\`, \`app.Resume\` |"
}

# Of a log of `by_force.sh signals`: how many, and how many of those that were to leave a checkpoint did.
signals_line() { # LOG CODE WHAT
  local log=$1 kept='^\(window\|exchange\|checkpoint\), .*code 3, checkpoints'
  echo "| $3 | $(grep -c ', SIG' "$log"): $(sed -n 's/^\(FAILED \)\{0,1\}\([a-z]*\), .*/phase \2 1/p' "$log" | table_of phase /dev/stdin); did not hold: $(grep -c '^FAILED' "$log") | exit code 3, and the run goes on from a whole checkpoint: $(grep "$kept" "$log" | grep -vc 'checkpoints 0') of $(grep -c "$kept" "$log") in the three phases that can have one; nothing is left behind; all gone after $(slowest "$log") s at most | $(verdict "$2") | \`app.Signal/*\` |"
}

signals() {
  local log=$work/signals.log code=0 names="TERM INT HUP QUIT USR1"
  if $short; then
    $app/by_force.sh "$footfall" "$work/signals" signal window rank1 TERM >"$log" 2>&1 || failed
    $app/by_force.sh "$footfall" "$work/signals" signal window footfall TWICE >>"$log" 2>&1 || failed
    return
  fi
  JOBS=${JOBS:-2} $app/by_force.sh "$footfall" "$work/signals" signals 10 "footfall mpirun rank0 rank1 mbd_solver" "$names" "window bed checkpoint start exchange handshake shutdown" >"$log" 2>&1 || failed
  grep '^FAILED' "$log" >&2
  signals_line "$log" $code "a signal (TERM, INT, HUP, QUIT, USR1) to one process (footfall, mpirun, rank 0, rank 1, mbd_solver), ten times each pair, the phases in turn"
  code=0
  JOBS=${JOBS:-2} $app/by_force.sh "$footfall" "$work/signals" signals 2 "footfall mpirun rank0 rank1 mbd_solver" "KILL TWICE" "window checkpoint" >"$log" 2>&1 || failed
  grep '^FAILED' "$log" >&2
  echo "| SIGKILL, and two signals one after the other, to each process | $(grep -c ', SIG' "$log"); did not hold: $(grep -c '^FAILED' "$log") | exit code 1 and 3; nothing is left behind; all gone after $(slowest "$log") s at most | $(verdict $code) | \`app.Signal/*\` |"
}

# On a machine where ten programs want each core: what is missing to that is started.
load() {
  $short && return
  local log=$work/load.log code=0 idle=() k before after others
  read -r before _ </proc/loadavg
  for ((k = ${before%.*}; k < 10 * $(nproc); ++k)); do
    bash -c 'while :; do :; done' &
    idle+=($!)
  done
  JOBS=1 $app/by_force.sh "$footfall" "$work/load" signals 10 footfall "TERM INT HUP QUIT USR1" "window checkpoint exchange" >"$log" 2>&1 || failed
  ((${#idle[@]} == 0)) || { kill "${idle[@]}"; wait "${idle[@]}" 2>/dev/null; }
  read -r after _ </proc/loadavg
  grep '^FAILED' "$log" >&2
  signals_line "$log" $code "the same to the front door of a run on a machine on which ten programs want each core (load $before by others at the start, ${#idle[@]} of our own added, $after at the end)"
}

stops() {
  local log=$work/stops.log code=0 case
  : >"$log"
  for case in $(of window/mbd_solver "window/liggghts_mbd window/mbd_solver window/orterun start/liggghts_mbd"); do
    $app/by_force.sh "$footfall" "$work/stops" stopped "${case#*/}" "${case%/*}" >>"$log" 2>&1 || failed
  done
  echo "| one program is stopped (SIGSTOP), \`coupling.timeout\` = 2 s: $(sed -n 's/^\(.*\) stopped: .*/\1/p' "$log" | paste -sd';' | sed 's/;/; /g') | $(grep -c ended "$log") | exit code 1, a message names the silent program; all gone after $(slowest "$log") s at most, the 2 s included | $(verdict $code) | \`app.Stopped/*\` |"
}

disk() {
  local log=$work/disk.log code=0 case bad=""
  : >"$log"
  "$build/bin/app_tests" --gtest_filter='Disks.*' >>"$log" 2>&1 || { failed; bad="mechanism"; }
  for case in $(of restart "motion pictures restart state"); do
    $app/by_force.sh "$footfall" "$work/disk_$case" full $case >>"$log" 2>&1 || { failed; bad+=" $case"; }
  done
  echo "| a file may not grow any more: history, summary, pictures, checkpoint of a mechanism; motion, pictures, both sides' parts of a checkpoint with grains; a folder that is gone | 9 | exit code 1 at once, with the file's name; what is there is whole; no half set passes for a checkpoint | $(verdict $code)${bad:+: $bad} | \`app.Disks\`, \`app.Full/*\` |"
  $short && return
  code=0
  $app/by_force.sh "$footfall" "$work/tmpfs" disks >"$log" 2>&1 || code=$?
  if ((code == 77)); then
    echo "| a disk that is full (a small tmpfs) | 0 | not tried: no right to mount one | | |"
  else
    ((code == 0)) || failed
    echo "| a disk that is full (a small tmpfs), with grains: history, motion, pictures, both sides' checkpoints; sizes between an empty folder and a whole run | $(grep -c '^disk of' "$log") | exit code 1 with the file's name, or done where the room is enough; what is there is whole, and goes on once there is room | $(verdict $code) | |"
  fi
}

passed() { sed -n 's/.*PASSED.* \([0-9]* tests*\)\..*/\1/p' "$1"; }

damage() {
  local log=$work/damage.log code=0
  "$build/bin/app_tests" --gtest_filter='*DamagedCheckpoint*' >"$log" 2>&1 || failed
  echo "| files of a checkpoint, and the history it belongs to, cut, changed, empty, missing | $(passed "$log") | the set before is taken, to the byte; where none is whole exit code 2 and their names | $(verdict $code) | \`Folders.WithADamagedCheckpoint*\` |"
  $short && return
  code=0
  "$build/bin/app_tests" --gtest_filter='Folders.OfDamagedRuns*' >"$log" 2>&1 || failed
  echo "| summaries cut or strange, read by report, pictures, compare, sweep | $(passed "$log") | exit code 2; a sweep does the run again | $(verdict $code) | \`Folders.OfDamagedRuns*\` |"
  code=0
  "$build/bin/app_tests" --gtest_filter='Folders.OfBedsThatAreDamaged*' >"$log" 2>&1 || failed
  echo "| beds empty, cut, changed, missing, without seal; a cut restart file of a script | $(passed "$log") | made again with a warning; exit code 2 for the script's own | $(verdict $code) | \`Folders.OfBedsThatAreDamaged*\` |"
  code=0
  "$build/bin/app_check" --gtest_filter='Check/*:Quick/*:Run/*' >"$log" 2>&1 || failed
  echo "| wrong scenes, scripts, meshes, experiments; kept findings of fuzzing | $(passed "$log") | one clear message, exit code 2, within 10 s | $(verdict $code) | \`app.BadInput*\` |"
}

keeping() {
  $short && return
  local log=$work/keeping.log code=0
  $app/endurance.sh "$footfall" "$work/keeping" checkpoints "${KEEP_EVERY:-60}" ${KEEP_SCENE:-inputs/landing_mr} ${KEEP_ARGS:---until 1.0} >"$log" 2>&1 || failed
  echo "| a run (${KEEP_SCENE:-inputs/landing_mr} ${KEEP_ARGS:---until 1.0}) is kept by the clock | 1 | at most 0.5 % of its time: $(tail -n 1 "$log") | $(verdict $code) | \`app.WallClockCheckpoints/*\` |"
}

fuzz() {
  local log=$work/fuzz.log code=0 seconds=${FUZZ_SECONDS:-300}
  if $short; then
    ctest --test-dir "$build" -R '^fuzz\.' >"$log" 2>&1 || failed
    return
  fi
  [[ -n ${LOGS-} ]] || LEDGER=docs/data/fuzzed.txt JOBS=${FUZZ_JOBS:-2} nice tests/fuzz/run.sh "$seconds" >"$log" 2>&1 || true
  [[ -e docs/data/fuzzed.txt ]] || { echo "| every reader is fed with rubbish | 0 | not tried | | |"; return; }
  awk '{ last[$2] = $5 } END { for (k in last) if (last[k] > 0) exit 1 }' docs/data/fuzzed.txt || failed
  made_at=$(awk '{ print $6 " (" $7 ")" }' docs/data/fuzzed.txt | sort -k 2,2 -k 1,1 | uniq | paste -sd, | sed 's/,/, /g')
  echo "| every kind of input as rubbish (libFuzzer, address and undefined sanitizers) | $(
    awk '{ n[$1] += $3; s[$1] += $4 } END { for (k in n) print k, n[k], "in", s[k], "s" }' docs/data/fuzzed.txt | sort | paste -sd, | sed 's/,/, /g'); of processor time, added up in docs/data/fuzzed.txt | refused in the reader's own words, or read; no crash, no hang above 10 s$(
    awk '{ last[$2] = $5 } $5 > 0 { at[$2] = $6 } END { for (k in at) print "; " k ": a finding at " at[k] (last[k] ? "" : ", mended") }' docs/data/fuzzed.txt | sort | paste -sd '') | $(verdict $code) | \`fuzz.*\` (the kept inputs, and some thousand damaged ones); a minute each before a change lands |"
}

sanitizers() {
  $short && return
  local log=$work/sanitizers.log code=0
  [[ -n ${LOGS-} ]] || BUILD=$work nice tests/bench/sanitize/run.sh >"$log" 2>&1 || code=1
  local lines=(build-sanitize/*.line) line name said
  [[ -e ${lines[0]} ]] || { echo "| tests under sanitizers | 0 | not tried | | |"; return; }
  made_at=$(sed -n 's/.*; at //p' "${lines[@]}" | grep -o '[0-9a-f]\{7\} ([-0-9]*)' | sort -u | paste -sd, | sed 's/,/, /g')
  # NAME, WHAT (BY WHAT): FIGURES; at COMMIT
  for name in $(basename -s .line "${lines[@]}"); do
    line=$(cat "build-sanitize/$name.line") said=${line#*: } code=0
    grep -q '[1-9][0-9]* failed\|[1-9][0-9]* findings\|[1-9][0-9]* reports\|[1-9][0-9]* places\|failed:' <<<"$said" && failed
    line=${line%%:*}
    echo "| ${line#*, }: $name | $said | no finding; what is left out has its reason in \`tests/bench/sanitize/left_out.txt\` | $(verdict $code) | \`tests/bench/sanitize/run.sh $name\` |"
  done
}

endurance() {
  local log=$work/endurance.log code=0
  $app/endurance.sh "$footfall" "$work/endurance" grains "$(of 2000 100000)" >"$log" 2>&1 || failed
  echo "| many windows through LIGGGHTS, two ranks | $(tail -n 1 "$log" | sed 's/ windows.*//') windows | $(tail -n 1 "$log" | sed 's/.*: //') | $(verdict $code) | \`app.Endurance/*\` |"
}

plane() {
  $short && return
  local log=$work/plane.log code=0
  $app/endurance.sh "$footfall" "$work/plane" plane "${PLANE_SECONDS:-1000}" >"$log" 2>&1 || failed
  echo "| the lander stands on the rigid plane | $(sed -n 's/ on the rigid plane.*//p' "$log") | $(sed -n 's/.*plane: //p; s/^report/, report/p' "$log" | paste -sd '') | $(verdict $code) | |"
}

row() { # PART...
  local part
  for part in "$@"; do
    [[ $part == page ]] && continue
    rm -f "$work/$part.failed"
    echo "reliability: $part, $(date +%T)" >&2
    made_at=$version
    $part >"$work/$part.new" && sed "s/|\$/| $part: ${made_at//\//\\\/} |/" "$work/$part.new" >"$work/$part.md"
    rm -f "$work/$part.new"
  done
}
if ((${#parts[@]})) || $short; then
  ((${#parts[@]})) || parts=("${all[@]}")
  row "${parts[@]}"
else
  # Each row as a session, to which Linux gives a share of its own; so that a part of many programs does not starve the others.
  rows=("kills keeping" "load signals stops disk damage" "fuzz" "endurance plane sanitizers") leaders=()
  for parts_of_row in "${rows[@]}"; do
    setsid docs/data/remake/reliability.sh --row $parts_of_row &
    leaders+=($!)
  done
  trap 'kill -- "${leaders[@]/#/-}"' INT TERM HUP
  wait
fi
$as_row && exit 0
ended=0
compgen -G "$work/*.failed" >/dev/null && ended=1
$short && exit $ended
cd "$root" || exit 1
page=docs/data/reliability.txt
{
  cat <<'TEXT'
# Signals, kills, full disks, damage, fuzzing, sanitizers, endurance (docs/data/remake/reliability.sh)

| what was done | tried | what has to come of it, and figures | | tests | part: commit |
|---|---|---|---|---|---|
TEXT
  for part in "${all[@]}"; do
    cat "$work/$part.md" 2>/dev/null || grep "| $part: [^|]* |\$" "$page" || echo "| $part | not tried yet | | | | $part: |"
  done
} >"$work/page.new" && mv "$work/page.new" "$page"
exit $ended
