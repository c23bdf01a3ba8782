#!/usr/bin/env bash
# run.sh FOOTFALL OUT: a plate comes down on grains; stock LIGGGHTS replays its motion, and gives the same impulse and the same bed.
set -euo pipefail
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out"
"$footfall" run "$here/../../bad_input/plate_on_grains.scene" --set particles.script="\"$here/in.plate\"" --out "$out/a" --quiet
"$footfall" compare "$out/a" --quiet
cat "$out/a/compare/comparison.txt"
# The replay moves the plate along the chord of each window of five steps: impulse to half a per cent (measured: 0.03), grains to a tenth of their radius.
awk '$1 == "plate" && $2 > 1 && $8 < 0.5 { impulse = 1 } /^no grain is a tenth of its radius apart/ { bed = 1 } END { exit !(impulse && bed) }' \
  "$out/a/compare/comparison.txt"
for file in beds.csv forces.csv profile.csv in.stock plots/forces.png plots/crater.png; do [[ -s $out/a/compare/$file ]]; done
# Without stock LIGGGHTS its package is named, and the comparison that is there stays.
if PATH=/nowhere "$footfall" compare "$out/a" > "$out/no_stock.txt" 2>&1; then exit 1; else [[ $? == 2 ]]; fi
grep -q "liggghts: there is no such program; install the Debian package liggghts" "$out/no_stock.txt"
[[ -s $out/a/compare/comparison.txt ]]
# Two runs beside each other: with itself nothing differs.
"$footfall" compare "$out/a" "$out/a" --quiet
awk '$1 == "plate" && $8 == 0 { same = 1 } END { exit !same }' "$out/a/compare/comparison.txt"
# A folder without a run is told.
if "$footfall" compare "$out" > "$out/no_run.txt" 2>&1; then exit 1; else [[ $? == 2 ]]; fi
grep -q "holds no summary.json" "$out/no_run.txt"
