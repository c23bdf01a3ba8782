#!/usr/bin/env bash
# Remakes docs/data/reliability.txt: signals, kills, full disks, damage, fuzzing, sanitizers, endurance.
#   docs/data/remake/reliability.sh [--short] [PART...]
#     PART     kills signals load stops disk damage keeping fuzz sanitizers endurance plane (default: all, in four rows in parallel). Each keeps its lines in
#              BUILD/reliability/PART.md. Lines of parts without such a file stay as they are; each names the commit that it tried.
#     PART     page: writes the data file and runs nothing
#     --short  a minute in all; the data file stays as it is
#   BUILD=FOLDER     default build, with all tests. The programs are copied first.
#   LOGS=1           takes the results of tests/fuzz/run.sh and tests/sanitize/run.sh as they are
#   PART_SECONDS     limit of kills and signals, twice that of load (default 900)
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
work=$build/reliability cli=tests/cli
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
    $cli/kills.sh "$footfall" "$work/kills_$k" "$(of 2 $((100 / jobs)))" "$((${SEED:-1} + k))" "$limit" >"$log.$k" 2>&1 &
  done
  for ((k = 1; k <= jobs; ++k)); do wait -n || failed; done
  cat "$log".* >"$log"
  ((code == 0)) || tail -n 5 "$log".* >&2
  local slow
  slow=$(sed -n 's/.*code [0-9]* after \([0-9.]*\) s, .*/\1/p' "$log" | sort -n | tail -n 1)
  echo "| a program is killed (SIGKILL) at a random moment; then \`footfall run --resume\`, or anew where nothing was kept yet | $(grep -c '^[0-9]*: ' "$log"): $(table_of phase "$log"); $(table_of process "$log") | history, surfaces and pictures are those of the undisturbed run to the byte; gone on with a checkpoint $(grep -c 'gone on with after' "$log"), anew $(grep -c 'gone on with from' "$log"); all gone after $slow s at most | $(verdict $code) | \`Kills.*\`, \`Resume.ToTheBit/*\` |"
}

# Of a log of signals.sh: how many, and how many of those that were to leave a checkpoint did.
signals_line() { # LOG CODE WHAT
  local log=$1 kept='^\(window\|exchange\|checkpoint\), .*code 3, sets'
  echo "| $3 | $(grep -c ', SIG\|^BAD' "$log"): $(sed -n 's/^\([a-z]*\), SIG.*/phase \1 1/p; s/^BAD \([a-z]*\),.*/phase \1 1/p' "$log" | table_of phase /dev/stdin); did not hold: $(grep -c '^BAD' "$log") | exit code 3, and the run goes on from a whole checkpoint: $(grep "$kept" "$log" | grep -vc 'sets no') of $(grep -c "$kept" "$log") in the three phases that can have one; nothing is left behind; all gone after $(slowest "$log") s at most | $(verdict "$2") | \`Signals.EndBothPrograms/*\` |"
}

signals() {
  local log=$work/signals.log code=0 names="TERM INT HUP QUIT USR1"
  if $short; then
    $cli/signals.sh "$footfall" "$work/signals" window rank1 TERM >"$log" 2>&1 || failed
    $cli/signals.sh "$footfall" "$work/signals" window footfall TWICE >>"$log" 2>&1 || failed
    return
  fi
  JOBS=${JOBS:-2} $cli/signals.sh "$footfall" "$work/signals" many 10 "footfall mpirun rank0 rank1 mbd_solver" "$names" "window bed checkpoint start exchange handshake shutdown" "$limit" >"$log" 2>&1 || failed
  grep '^BAD' "$log" >&2
  signals_line "$log" $code "a signal (TERM, INT, HUP, QUIT, USR1) to one process (footfall, mpirun, rank 0, rank 1, mbd_solver), ten times each pair, the phases in turn"
  code=0
  JOBS=${JOBS:-2} $cli/signals.sh "$footfall" "$work/signals" many 2 "footfall mpirun rank0 rank1 mbd_solver" "KILL TWICE" "window checkpoint" "$limit" >"$log" 2>&1 || failed
  grep '^BAD' "$log" >&2
  echo "| SIGKILL, and two signals one after the other, to each process | $(grep -c ', SIG' "$log"); did not hold: $(grep -c '^BAD' "$log") | exit code 1 and 3; nothing is left behind; all gone after $(slowest "$log") s at most | $(verdict $code) | \`Signals.EndBothPrograms/*\` |"
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
  JOBS=1 $cli/signals.sh "$footfall" "$work/load" many 10 footfall "TERM INT HUP QUIT USR1" "window checkpoint exchange" "$((limit / 2))" >"$log" 2>&1 || failed
  ((${#idle[@]} == 0)) || { kill "${idle[@]}"; wait "${idle[@]}" 2>/dev/null; }
  read -r after _ </proc/loadavg
  grep '^BAD' "$log" >&2
  signals_line "$log" $code "the same to the front door of a run on a machine on which ten programs want each core (load $before by others at the start, ${#idle[@]} of our own added, $after at the end)"
}

stops() {
  local log=$work/stops.log code=0 case
  : >"$log"
  for case in $(of window/mbd_solver "window/liggghts_mbd window/mbd_solver window/orterun start/liggghts_mbd"); do
    $cli/stopped_partner.sh "$footfall" "$work/stops" "${case#*/}" "${case%/*}" >>"$log" 2>&1 || failed
  done
  echo "| one program is stopped (SIGSTOP), \`coupling.timeout\` = 2 s: $(sed -n 's/^\(.*\) stopped: .*/\1/p' "$log" | paste -sd';' | sed 's/;/; /g') | $(grep -c ended "$log") | exit code 1, a message names the silent program; all gone after $(slowest "$log") s at most, the 2 s included | $(verdict $code) | \`Failure.AStoppedPartnerEndsTheRun/*\` |"
}

disk() {
  local log=$work/disk.log code=0 case bad=""
  : >"$log"
  $cli/full_disk.sh "$footfall" "$work/disk" >>"$log" 2>&1 || { failed; bad="mechanism"; }
  for case in $(of restart "motion pictures restart memory"); do
    $cli/full_disk_grains.sh "$footfall" "$work/disk_$case" $case >>"$log" 2>&1 || { failed; bad+=" $case"; }
  done
  echo "| a file may not grow any more: history, summary, pictures, checkpoint of a mechanism; motion, pictures, both sides' parts of a checkpoint with grains; a folder that is gone | 9 | exit code 1 at once, with the file's name; what is there is whole; no half set passes for a checkpoint | $(verdict $code)${bad:+: $bad} | \`cli.full_disk\`, \`Failure.AFileThatMayNotGrowEndsTheRun/*\` |"
  $short && return
  code=0
  $cli/full_tmpfs.sh "$footfall" "$work/tmpfs" >"$log" 2>&1 || code=$?
  if ((code == 77)); then
    echo "| a disk that is full (a small tmpfs) | 0 | not tried: no right to mount one | | |"
  else
    ((code == 0)) || failed
    echo "| a disk that is full (a small tmpfs), with grains: history, motion, pictures, both sides' checkpoints; sizes between an empty folder and a whole run | $(grep -c '^full' "$log") | exit code 1 with the file's name, or done where the room is enough; what is there is whole, and goes on once there is room | $(verdict $code) | |"
  fi
}

damage() {
  local log=$work/damage.log code=0
  $cli/damaged_checkpoint.sh "$footfall" "$work/damaged_checkpoint" >"$log" 2>&1 || failed
  echo "| files of a checkpoint, and the history it belongs to, cut, changed, empty, missing | $(sed -n 's/ damaged checkpoints.*//p' "$log") | the set before is taken, to the byte; where none is whole exit code 2 and their names | $(verdict $code) | \`cli.damaged_checkpoint\` |"
  $short && return
  code=0
  $cli/damaged_runs.sh "$footfall" "$work/damaged_runs" >"$log" 2>&1 || failed
  echo "| summaries cut or strange, read by report, pictures, compare, sweep | 18 | exit code 2; a sweep does the run again | $(verdict $code) | \`cli.damaged_runs\` |"
  code=0
  $cli/damaged_bed.sh "$footfall" "$work/damaged_bed" "$root/inputs/dropped_sphere" >"$log" 2>&1 || failed
  echo "| beds empty, cut, changed, missing, without seal; a cut restart file of a script | 6 | made again with a warning; exit code 2 for the script's own | $(verdict $code) | \`Bed.ThatIsDamagedIsToldAndMadeAgain\` |"
  code=0
  ctest --test-dir "$build" -L bad_input >"$log" 2>&1 || failed
  echo "| wrong scenes, scripts, meshes, experiments; kept findings of fuzzing | $(sed -n 's/.*tests passed.* out of //p' "$log") tests | one clear message, exit code 2, within 10 s | $(verdict $code) | label \`bad_input\` |"
}

keeping() {
  $short && return
  local log=$work/keeping.log code=0
  tests/endurance/keeping.sh "$footfall" "$work/keeping" "${KEEP_EVERY:-60}" ${KEEP_SCENE:-inputs/landing_mr} ${KEEP_ARGS:---until 1.0} >"$log" 2>&1 || failed
  echo "| a run (${KEEP_SCENE:-inputs/landing_mr} ${KEEP_ARGS:---until 1.0}) is kept by the clock | 1 | at most 0.5 % of its time: $(tail -n 1 "$log") | $(verdict $code) | \`Resume.KeptByTheClock/*\` |"
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
  [[ -n ${LOGS-} ]] || BUILD=$work nice tests/sanitize/run.sh >"$log" 2>&1 || code=1
  local lines=(build-sanitize/*.line) line name said
  [[ -e ${lines[0]} ]] || { echo "| tests under sanitizers | 0 | not tried | | |"; return; }
  made_at=$(sed -n 's/.*; at //p' "${lines[@]}" | grep -o '[0-9a-f]\{7\} ([-0-9]*)' | sort -u | paste -sd, | sed 's/,/, /g')
  # NAME, WHAT (BY WHAT): FIGURES; at COMMIT
  for name in $(basename -s .line "${lines[@]}"); do
    line=$(cat "build-sanitize/$name.line") said=${line#*: } code=0
    grep -q '[1-9][0-9]* failed\|[1-9][0-9]* findings\|[1-9][0-9]* reports\|[1-9][0-9]* places\|failed:' <<<"$said" && failed
    line=${line%%:*}
    echo "| ${line#*, }: $name | $said | no finding; what is left out has its reason in \`tests/sanitize/left_out.txt\` | $(verdict $code) | \`tests/sanitize/run.sh $name\` |"
  done
}

endurance() {
  local log=$work/endurance.log code=0
  "$work/bin/endurance_loopback" "$(of 10000 1000000)" >"$log" 2>&1 || failed
  echo "| many windows in one process | $(head -n 1 "$log" | sed 's/ windows.*//') windows | $(tail -n 1 "$log" | sed 's/.*windows: //') | $(verdict $code) | \`Endurance.MemoryStays/loopback\` |"
  code=0
  tests/endurance/grains.sh "$footfall" "$work/endurance" "$(of 2000 100000)" >"$log" 2>&1 || failed
  echo "| many windows through LIGGGHTS, two ranks | $(tail -n 1 "$log" | sed 's/ windows.*//') windows | $(tail -n 1 "$log" | sed 's/.*: //') | $(verdict $code) | \`Endurance.MemoryStays/grains\` |"
}

plane() {
  $short && return
  local log=$work/plane.log code=0
  tests/endurance/plane.sh "$footfall" "$work/plane" "${PLANE_SECONDS:-1000}" >"$log" 2>&1 || failed
  echo "| the lander stands on the rigid plane | $(tail -n 1 "$log" | sed 's/ on the.*//') | $(tail -n 1 "$log" | sed 's/.*plane: //') | $(verdict $code) | |"
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
