#!/usr/bin/env bash
# campaign.sh FOOTFALL OUT: the table of drawn runs is the same from one and from two workers and after kills at any moment, of the campaign or of a
# worker; draws that the scene refuses are rows, figures without a number are counted; statements are checked before any run; a row is made again to
# the digit; no program of a landing loads OpenTURNS.
set -u
footfall=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$2" && mkdir -p "$2" && cd "$2" || exit 1
RANDOM=1
fail() { echo "campaign.sh: $*"; exit 1; }
cat >drawn.toml <<END
scene = "$here/../../inputs/tip_over/scene.toml"
settings = ["end_time=6"]
runs = 40
keep = 2
[[parameters]]
name = "gravity"
values = ["-1.62", "-9.81"]
settings = ["gravity=[0,0,{value}]"]
[[parameters]]
name = "v"
settings = ["initial.velocity=[{value},0,0]"]
distribution = "normal"
mean = 2.2
deviation = 0.3
[[figures]]
name = "turn [rad]"
columns = ["foot.angle"]
[[outcomes]]
name = "tipped"
when = "turn > pi / 4"
END
"$footfall" sweep drawn.toml --jobs 1 --out one >one.txt 2>&1 || { cat one.txt; fail "one worker"; }
"$footfall" sweep drawn.toml --jobs 2 --out two >two.txt 2>&1 || { cat two.txt; fail "two workers"; }
cmp one/runs.csv two/runs.csv || fail "two workers have another table than one"
(($(wc -l <one/runs.csv) == 81)) || fail "expected 80 rows and a head"
[[ ! -e one/work ]] || fail "the folders of the workers are left"
pages=$(grep -o 'href="kept/[^"]*"' one/report.html | cut -d '"' -f 2)
[[ $(wc -w <<<"$pages") -ge 2 ]] && (cd one && ls $pages >/dev/null) || fail "the report has no links to the pages of kept runs: $pages"
for k in 1 2 3 4 5 6; do
  "$footfall" sweep drawn.toml --jobs 2 --out killed >killed.txt 2>&1 &
  sleep 0.$((RANDOM % 9 + 1))
  kill -KILL $! 2>/dev/null
  wait $! 2>/dev/null
done
# A kill in the middle of a line.
[[ -f killed/rows.journal ]] && printf '7\t0\t0.12' >>killed/rows.journal
"$footfall" sweep drawn.toml --jobs 2 --out killed >killed.txt 2>&1 || { cat killed.txt; fail "after kills"; }
cmp one/runs.csv killed/runs.csv || fail "after kills the table is another"
# A worker that is killed leaves a row without result, which the same command repeats.
worker() { for p in /proc/[0-9]*; do [[ $(readlink "$p/fd/2") == "$PWD/lost/work/0.log" ]] && echo "${p#/proc/}"; done 2>/dev/null; }
"$footfall" sweep drawn.toml --jobs 1 --out lost >lost.txt 2>&1 &
for ((k = 0; k < 1000; ++k)); do
  (($(cat lost/rows.journal 2>/dev/null | wc -l) > 3)) && kill -KILL "$(worker)" 2>/dev/null && break
  sleep 0.01
done
wait $!
(($? == 1)) && grep -q E0604 lost.txt && grep -q $'\t137\t' lost/rows.journal || { cat lost.txt; fail "a killed worker is not reported"; }
"$footfall" sweep drawn.toml --jobs 1 --out lost >lost.txt 2>&1 || { cat lost.txt; fail "the row of a killed worker is not repeated"; }
grep -q "ended from outside: 1$" lost.txt || { cat lost.txt; fail "the number of repeated rows is missing"; }
cmp one/runs.csv lost/runs.csv || fail "after a killed worker the table is another"
# Draws that the scene refuses are rows, also the first.
sed 's/"end_time=6"/"end_time=6", "bodies.body.mass={= row < 1 ? -1 : 1000}"/' drawn.toml >first.toml
"$footfall" sweep first.toml --jobs 2 --out first >first.txt 2>&1
(($? == 1)) && (($(wc -l <first/runs.csv) == 81 && $(grep -c ',2,.*E0105' first/runs.csv) == 2)) || { cat first.txt; fail "an invalid first draw ends the campaign"; }
"$footfall" sweep first.toml --list >first.txt 2>&1 || { cat first.txt; fail "an invalid first draw is not listed"; }
sed 's/deviation = 0.3/deviation = 0.2/; s/runs = 40/runs = 4/' drawn.toml >other.toml
"$footfall" sweep other.toml --jobs 2 --out killed >killed.txt 2>&1 || { cat killed.txt; fail "other inputs"; }
[[ -s killed/rows.before ]] && grep -q "of other inputs" killed.txt || { cat killed.txt; fail "rows of other inputs are lost without a word"; }
"$footfall" sweep drawn.toml --slurm --out array >/dev/null || fail "--slurm"
last=$(sed -n 's/^#SBATCH --array=0-//p' array/sweep.sbatch)
for ((k = 0; k <= last; ++k)); do "$footfall" sweep drawn.toml --out array --only $k >array.txt 2>&1 || { cat array.txt; fail "--only $k"; }; done
"$footfall" sweep drawn.toml --out array --merge >array.txt 2>&1 || { cat array.txt; fail "--merge"; }
cmp one/runs.csv array/runs.csv || fail "a job array has another table"
"$footfall" sweep drawn.toml --out one --row 17 >row.txt 2>&1 || { cat row.txt; fail "--row"; }
[[ -f one/kept/row_000017/history.csv ]] || fail "--row left no run"
"$footfall" accuracy drawn.toml --out no >no.txt 2>&1
(($? == 2)) && grep -q E0624 no.txt && [[ ! -e no ]] || { cat no.txt; fail "accuracy carries out drawn runs"; }
sed 's/x,0,0/0,0,0/; s/initial.velocity/initial.speed/' drawn.toml >bad.toml
"$footfall" sweep bad.toml --out bad >bad.txt 2>&1
(($? == 2)) && [[ ! -e bad ]] || { cat bad.txt; fail "a wrong setting is not refused before all runs"; }
# A statement that so few runs cannot show is found before any run; with enough runs the check says how often it may happen.
sed 's/when = "turn/at_most = 0.05\nwhen = "turn/' drawn.toml >few.toml
"$footfall" check few.toml >few.txt 2>&1
(($? == 1)) && grep -q "59 runs if it happens never.*E0626" few.txt || { cat few.txt; fail "a statement with too few runs is not refused"; }
sed 's/runs = 40/runs = 93/' few.toml >enough.toml
"$footfall" check enough.toml >few.txt 2>&1 || { cat few.txt; fail "check of a campaign"; }
grep -q "in 93 runs it may happen 1 times" few.txt || { cat few.txt; fail "check does not say how often it may happen"; }
grep -q "McNemar" one/drawn.md || fail "cases are not compared"
! grep -q '`' one/report.html || fail "report.html has backticks"
# Figures without a number are counted and end with exit code 1: force over sinkage, 0/0 of the balls that do not reach the ground.
cat >ball.toml <<END
end_time = 0.1
gravity = [0, 0, -9.81]
bodies = [{ name = "b", mass = 1, shape = { kind = "sphere", centre = [0, 0, 0], radius = 0.1 } }]
boundaries = [{ body = "b", surface = {} }]
ground = { kind = "plane", plane = { stiffness = 1e7, damping = 1, friction = 0.6 } }
initial = { clearance = 0 }
output = { interval = 0.01, vtk = false, plots = false }
END
cat >nan.toml <<END
scene = "ball.toml"
settings = ["initial.clearance={= a > 0 ? 0 : 1}"]
runs = 20
keep = 1
parameters = [{ name = "a", distribution = "normal", mean = 0, deviation = 1 }]
figures = [{ name = "ratio", key = "max_contact_force_N", over = "max_sinkage_m" }]
outcomes = [{ name = "stiff", when = "ratio > 1" }]
END
"$footfall" sweep nan.toml --jobs 2 --out nan >nan.txt 2>&1
(($? == 1)) && grep -q E0625 nan.txt && grep -q "| stiff | all | .* to 100 (.* to 100) |" nan/nan.md && grep -q "figure ratio has no number" nan/nan.md ||
  { cat nan.txt; fail "figures without a number are not counted"; }
for program in footfall footfall_studies mbd_solver liggghts_mbd; do
  ! ldd "$(dirname "$footfall")/$program" | grep -q libOT || fail "$program loads OpenTURNS"
done
echo "campaign.sh: done"
