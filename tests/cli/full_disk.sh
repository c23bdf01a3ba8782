#!/usr/bin/env bash
# full_disk.sh FOOTFALL OUT: a file that may not grow, and a folder that is gone, end a run at once with exit code 1 and the file's name; what is there
# is whole.
set -u
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
scene=$here/../../inputs/accuracy/scenes/slider_crank.toml
solver=$(dirname "$footfall")/mbd_solver
rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
die() { echo "full_disk.sh: $*"; cat ./*.txt; exit 1; }

code=0
(ulimit -f 48; exec "$solver" "$scene" --quiet --out full --set end_time=1e3 --set output.interval=1e-3) >full.txt 2>&1 || code=$?
[[ $code == 1 ]] || die "ended with $code, expected 1"
grep -q 'full/history.csv: cannot be written: File too large' full.txt || die "the message does not name file and reason"
(($(wc -l <full.txt) == 1)) || die "more than one message"
cells=$(sed -n 2p full/history.csv | tr -cd , | wc -c)
[[ -z $(tail -c 1 full/history.csv) && $(tail -n 1 full/history.csv | tr -cd , | wc -c) == "$cells" ]] || die "the history ends in half a row"
(($(wc -l <full/history.csv) > 10)) || die "there are hardly any rows"
grep -q '"status": "failed"' full/summary.json || die "the summary does not say failed"

code=0
(ulimit -f 4; exec "$solver" "$scene" --quiet --out small --until 0.01 --set output.interval=1e-2) >small.txt 2>&1 || code=$?
[[ $code == 1 ]] || die "a summary that cannot be written ended with $code, expected 1"
grep -q 'small/summary.json: cannot be written: File too large' small.txt || die "the message does not name the summary"
[[ ! -e small/summary.json && ! -e small/summary.json.part ]] || die "half a summary is left"

# A checkpoint and pictures, whose files are larger than the few rows of these runs.
code=0
(ulimit -f 4; exec "$solver" "$scene" --quiet --out kept --until 0.1 --set output.interval=0.05 --set output.checkpoint_interval=0.04) >kept.txt 2>&1 || code=$?
[[ $code == 1 ]] || die "a checkpoint that cannot be written ended with $code, expected 1"
grep -q 'kept/checkpoint/[0-9]*.part/start.json: cannot be written: File too large' kept.txt || die "the message does not name the file of the checkpoint"
(($(wc -l <kept.txt) == 1)) || die "more than one message"
compgen -G 'kept/checkpoint/*[0-9]' >/dev/null && die "half a set passes for a checkpoint"
code=0
(ulimit -f 16; exec "$solver" "$here/../../inputs/rigid_plane" --quiet --out drawn --until 0.002 --set flexible=false --set output.vtk=true) >drawn.txt 2>&1 || code=$?
[[ $code == 1 ]] || die "pictures that cannot be written ended with $code, expected 1"
grep -q 'drawn/bodies[^ ]*: cannot be written: File too large' drawn.txt || die "the message does not name the picture"

"$solver" "$scene" --quiet --out gone --set end_time=1e5 >gone.txt 2>&1 &
run=$!
until [[ -s gone/history.csv ]] && (($(wc -l <gone/history.csv) > 4)); do kill -0 $run 2>/dev/null || die "the long run ended"; sleep 0.05; done
rm -rf gone
wait $run
[[ $? == 1 ]] || die "a run without its folder did not end with 1"
grep -q 'gone/history.csv: cannot be written: No such file' gone.txt || die "the message does not name the file that is gone"
exit 0
