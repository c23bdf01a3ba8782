#!/usr/bin/env bash
# folders.sh FOOTFALL OUT: a run owns its folder. Another run into it is refused while it runs and afterwards; --force removes what the earlier run
# made and nothing of the user's; two runs that start together mix nowhere; a plain mbd_solver keeps to the same lock.
set -u
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
scene=$here/../../inputs/accuracy/scenes/slider_crank.toml
solver=$(dirname "$footfall")/mbd_solver
rm -rf "$out" && mkdir -p "$out" && cd "$out" || exit 1
die() { echo "folders.sh: $*"; cat ./*.txt; exit 1; }
run() { "$footfall" run "$scene" --quiet --until 0.02 "$@"; }
# refused MESSAGE COMMAND...: exit code 2, one line.
refused() {
  local message=$1 code=0; shift
  "$@" >said.txt 2>&1 || code=$?
  [[ $code == 2 ]] || die "ended with $code, expected 2: $*"
  grep -q -e "$message" said.txt || die "no line says: $message"
  (($(wc -l <said.txt) == 1)) || die "more than one message"
}

# The user's own things stay, in a folder with a run of ours too.
mkdir -p mine/plots mine/pictures mine/vtk mine/motion mine/compare
for name in notes plots/own pictures/own vtk/own motion/own compare/own; do echo mine >"mine/$name.txt"; done
run --out mine --set output.plots=true >first.txt 2>&1 || die "a folder with other files was refused"
[[ -s mine/history.csv && -s mine/plots/energy.png ]] || die "there are no results"
refused "holds an earlier run" run --out mine
echo old >mine/vtk/later.txt
before=$(stat -c %.9Y.%i mine/history.csv)
sleep 0.01
run --out mine --force >again.txt 2>&1 || die "--force failed"
[[ $(stat -c %.9Y.%i mine/history.csv) != "$before" ]] || die "--force kept the old history"
[[ ! -e mine/plots/energy.png ]] || die "--force left a picture of the old run"
for name in notes plots/own pictures/own vtk/own motion/own compare/own; do [[ $(<"mine/$name.txt") == mine ]] || die "$name.txt is gone"; done
[[ $(<mine/vtk/later.txt) == old ]] || die "a later file of the user is gone"
# Later commands add to what belongs to the run.
"$footfall" report mine >report.txt 2>&1 || die "report"
run --out mine --force >again.txt 2>&1 || die "--force after report"
[[ ! -e mine/report.html ]] || die "the page of the old run stayed"

# Where the run stands: --out . ; and files of the user with names of ours.
(mkdir here && cd here && echo mine >notes.txt && run --out . >../here.txt 2>&1 && [[ $(<notes.txt) == mine ]]) || die "--out ."
mkdir named && echo mine >named/history.csv
refused "no run is known to have made it" run --out named
refused "no run is known to have made it" run --out named --force
[[ $(<named/history.csv) == mine ]] || die "a file of the user was written over"

# A start that was stopped before the first row leaves no run to protect.
mkdir stopped && echo log >stopped/liggghts.log && printf 'liggghts.log\n' >stopped/.footfall.files
run --out stopped >again.txt 2>&1 || die "a start without results stands in the way"
[[ -s stopped/history.csv && ! -e stopped/liggghts.log ]] || die "what a start left stayed"

# While a run goes on, nobody else runs there: neither the front door nor the plain line.
"$footfall" run "$scene" --quiet --out busy --set end_time=1e5 >busy.log 2>&1 &
busy=$!
until [[ -s busy/history.csv ]]; do kill -0 $busy 2>/dev/null || die "the long run ended"; sleep 0.05; done
for more in "" --force; do refused "another run writes here" run --out busy $more; done
refused "another run writes here" "$solver" "$scene" --quiet --until 0.02 --out busy
kill -INT $busy; wait $busy
[[ $? == 3 ]] || die "the long run was disturbed"
refused "holds an earlier run" run --out busy
# Killed without a word: what it left is known all the same.
"$footfall" run "$scene" --quiet --out killed --set end_time=1e5 >killed.log 2>&1 &
killed=$!
until [[ -s killed/history.csv ]]; do kill -0 $killed 2>/dev/null || die "the long run ended"; sleep 0.05; done
kill -KILL $killed; wait $killed 2>/dev/null
run --out killed --force >again.txt 2>&1 || die "--force after a kill"
[[ $(tail -n 1 killed/history.csv | cut -d, -f1) == 0.02 ]] || die "the history is not that of the new run"
# All of it killed at once, with pictures half done; what the user put there before and since stays.
mkdir dead && echo mine >dead/before.txt
drawn=$here/../../inputs/rigid_plane
setsid "$footfall" run "$drawn" --quiet --out dead --set end_time=1e3 --set output.vtk_interval=0.01 >dead.log 2>&1 &
dead=$!
until [[ -s dead/bodies_0003.vtu ]]; do kill -0 $dead 2>/dev/null || die "the long run ended"; sleep 0.05; done
kill -KILL -- -$dead; wait $dead 2>/dev/null
sleep 0.1
echo mine >dead/since.txt
"$footfall" run "$drawn" --quiet --until 0.01 --out dead --force >again.txt 2>&1 || die "--force after a kill of all"
[[ $(<dead/before.txt) == mine && $(<dead/since.txt) == mine ]] || die "--force removed a file of the user"
[[ ! -e dead/bodies_0003.vtu ]] || die "a picture of the killed run stayed"

# The plain line notes what it makes.
"$solver" "$scene" --quiet --until 0.02 --out plain >plain.txt 2>&1 || die "the plain line"
refused "holds an earlier run" run --out plain
run --out plain --force >again.txt 2>&1 || die "--force after the plain line"

# Two that start together without --out take two folders.
for k in 1 2; do run >"together$k.txt" 2>&1 & done
wait
[[ $(ls runs | tr '\n' ' ') == "slider_crank slider_crank-2 " && -s runs/slider_crank/summary.json && -s runs/slider_crank-2/summary.json ]] ||
  die "expected two folders: $(ls runs)"
exit 0
