#!/usr/bin/env bash
# rare.sh FOOTFALL OUT: a rare event by subset simulation ([rare]): its interval has the exact probability; after kills at any moment, and with another
# number of workers, the same command gives the same runs and the same page; what cannot go with it is refused before any run.
set -u
footfall=$1
here=$(cd "$(dirname "${BASH_SOURCE[0]}")" && pwd)
rm -rf "$2" && mkdir -p "$2" && cd "$2" || exit 1
RANDOM=1
fail() { echo "rare.sh: $*"; exit 1; }
# It tips over beyond 2.218 m/s, 2.9 deviations above the mean: 1.9e-3.
cat >tips.toml <<END
title = "A body that tips over rarely"
scene = "$here/../../inputs/tip_over/scene.toml"
settings = ["end_time=3", "output.vtk=false"]
runs = 500
seed = 1
[rare]
figure = "turn [rad]"
above = 0.7853981633974483
[[parameters]]
name = "v"
settings = ["initial.velocity=[{value},0,0]"]
distribution = "normal"
mean = 2.0
deviation = 0.075
[[figures]]
name = "turn [rad]"
columns = ["foot.angle"]
END
"$footfall" check tips.toml >check.txt 2>&1 || { cat check.txt; fail "check"; }
mkdir whole killed
(cd whole && "$footfall" sweep ../tips.toml --jobs 2 --out rare >said.txt 2>&1) || { cat whole/said.txt; fail "the search"; }
rows=$(($(wc -l <whole/rare/runs.csv) - 1))
((rows > 200 && rows <= 500)) || fail "$rows runs"
grep -o "is [0-9.e-]*, between [0-9.e-]* and [0-9.e-]* with 95 % confidence" whole/rare/tips.md | awk '
  { low = $4 + 0; high = $6 + 0; exit !(low < 1.9e-3 && 1.9e-3 < high && high < 100 * low) } END { if (NR != 1) exit 1 }' ||
  { cat whole/rare/tips.md; fail "the interval lacks the exact probability, 1.9e-3"; }
kills=0
for k in 1 2 3 4 5; do
  (cd killed && exec "$footfall" sweep ../tips.toml --jobs 1 --out rare >said.txt 2>&1) &
  before=$(cat killed/rare/rows.journal 2>/dev/null | wc -l)
  for ((i = 0; i < 3000; ++i)); do
    (($(cat killed/rare/rows.journal 2>/dev/null | wc -l) > before + 10 + RANDOM % 60)) && break
    sleep 0.01
  done
  kill -KILL $! 2>/dev/null && kills=$((kills + 1))
  wait $! 2>/dev/null
done
((kills >= 3)) || fail "the search was killed only $kills times"
[[ ! -e killed/rare/tips.md ]] || fail "a search that was killed has a page"
(cd killed && "$footfall" sweep ../tips.toml --jobs 2 --out rare >said.txt 2>&1) || { cat killed/said.txt; fail "after kills"; }
for file in runs.csv tips.md; do cmp whole/rare/$file killed/rare/$file || fail "after $kills kills $file is another"; done
for option in "--only 0" --list --slurm "--row 3"; do
  "$footfall" sweep tips.toml $option --out no >no.txt 2>&1
  (($? == 2)) && grep -q "has \[rare\]" no.txt && [[ ! -e no ]] || { cat no.txt; fail "$option is not refused"; }
done
sed 's/^runs = 500/runs = 100/' tips.toml >few.toml
"$footfall" sweep few.toml --out no >no.txt 2>&1
(($? == 2)) && grep -q "at least 500 with \[rare\]" no.txt && [[ ! -e no ]] || { cat no.txt; fail "100 runs are not refused"; }
echo "rare.sh: done, $rows runs, $kills kills"
