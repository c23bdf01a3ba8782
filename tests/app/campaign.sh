#!/usr/bin/env bash
# campaign.sh FOOTFALL OUT: the table of drawn runs is the same from one and from two workers and after kills at any moment, of the campaign or of a
# worker; draws that the scene refuses are rows; a row is made again to the digit; no program of a landing loads OpenTURNS.
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
for program in footfall footfall_studies mbd_solver liggghts_mbd; do
  ! ldd "$(dirname "$footfall")/$program" | grep -q libOT || fail "$program loads OpenTURNS"
done
echo "campaign.sh: done"
