#!/usr/bin/env bash
# watch.sh FOOTFALL OUT: a run is followed to its end, with a page; its exit code is that of the run; output into a file has a line per per
# cent, no time left before anybody knows it, and nothing of LIGGGHTS.
set -euo pipefail
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out" && mkdir -p "$out" && cd "$out"
die() { echo "watch.sh: $*"; exit 1; }
"$footfall" run "$here/../../examples/01_pendulum" --until 0.4 --out run > said 2>&1 &
run=$!
for ((i = 0; i < 600; ++i)); do [[ -f run/history.csv ]] && break; sleep 0.1; done
"$footfall" watch run --once > once || die "a run that goes on is no failure"
grep -qE 't = 0\.[0-9]{4} of 0.4 s \([0-9]+ %\)|before the first row' once || { cat once; die "does not say where the run is"; }
"$footfall" watch run --page --interval 0.2 > watched || die "the run is done, and watch ended with $?"
wait $run
grep -q '(100 %).*done' watched || { cat watched; die "does not follow to the end"; }
grep -q '<img' run/watch.html && ! grep -q 'http-equiv="refresh"' run/watch.html || die "the last page has no plots, or goes on refreshing itself"
[[ $(ls -d "${TMPDIR:-/tmp}"/footfall_watch_* 2>/dev/null | wc -l) == 0 ]] || die "leaves files behind"

grep -q '(100 %)' said || { cat said; die "the run does not say that it has come to its end"; }
if grep -n ' 0 s left' said; then die "knows the time left too early"; fi
if grep -nE '^version|^LIGGGHTS' said; then die "LIGGGHTS speaks past its screen"; fi
[[ $(grep -cE '^t = ' said) -le 101 ]] || die "more than a line per per cent"

"$footfall" watch run > /dev/null || die "a run that is done is no failure"
sed -i 's/"status": "done"/"status": "failed"/' run/summary.json
code=0; "$footfall" watch run > /dev/null || code=$?
[[ $code == 1 ]] || die "a failed run ends with $code"
mkdir empty
code=0; "$footfall" watch empty > refused 2>&1 || code=$?
[[ $code == 2 ]] && grep -q 'neither a run' refused || die "a folder without run is not refused"

# A script that settles its grains first says how far it is.
mkdir settling
cat > settling/in.plate <<SCRIPT
variable here index .
variable out index .
include $here/../bad_input/box.lammps
thermo 50000
run 12000000
include $here/../bad_input/couple.lammps
run 1000000
SCRIPT
"$footfall" run "$here/../bad_input/plate_on_grains.scene" --set particles.script="\"$out/settling/in.plate\"" --until 0.01 --out settling/run > settling/said 2>&1
grep -qE '^before the coupling: step [0-9]+ of 12000000' settling/said || { cat settling/said; die "a settling script says nothing"; }
