#!/usr/bin/env bash
# A calibration of some 200 runs, killed five times, loses no finished run and ends as the undisturbed one, which goes run by run. Its ledger alone, in
# an empty folder and with scenes that stand elsewhere, says as much without a run; a line that is no entry is named.
#   calibrate_killed.sh FOOTFALL CALIBRATION OUT
set -eu
footfall=$1 calibration=$2 out=$3
inputs=$(dirname "$calibration")
rm -rf "$out"; mkdir -p "$out"
die() { echo "calibrate_killed.sh: $*" >&2; exit 1; }

# The shipped drop tests, shorter, with 112 sets of a random search, a local one and one by surfaces; and a target that no set can meet.
sed '/^\[\[stages\]\]/,$d' "$calibration" >"$out/many.toml"
sed -i "s|\"strut/|\"$inputs/strut/|; s|^step = .*|until = 0.05\nalone = 3|" "$out/many.toml"
printf '[[figures]]\nname = "peak"\nkey = "peak_acceleration_g"\n[[targets]]\nname = "out of reach"\nscene = "off"\nfigure = "peak"\nleast = 1e4\ntolerance = 1e4\n' >>"$out/many.toml"
printf '[[stages]]\nmethod = "crs2"\nevaluations = 60\n[[stages]]\nmethod = "bobyqa"\nevaluations = 40\nprecision = 1e-9\n[[stages]]\nmethod = "surrogate"\nevaluations = 12\n' >>"$out/many.toml"

"$footfall" calibrate "$out/many.toml" --out "$out/whole" --jobs 1 >"$out/whole.txt" 2>&1 || { cat "$out/whole.txt"; die "the undisturbed one failed"; }
grep -q '^| out of reach | at least 10000 | .* | 3 | ' "$out/whole/many.md" || { cat "$out/whole/many.md"; die "the target out of reach was not sought alone"; }
runs=$(find "$out/whole/runs" -name '*.done.json' | wc -l)
((runs >= 200)) || die "$runs runs, expected at least 200"

records() { find "$out/parts/runs" -name '*.done.json' -printf '%f %i %T@\n' 2>/dev/null | sort; }
for ((kill = 1; kill <= 5; ++kill)); do
  "$footfall" calibrate "$out/many.toml" --out "$out/parts" --jobs 2 >"$out/part_$kill.txt" 2>&1 &
  calibrate=$!
  until (($(records | wc -l) >= 35 * kill)); do
    kill -0 "$calibrate" 2>/dev/null || { cat "$out/part_$kill.txt"; die "it ended before kill $kill"; }
    sleep 0.05
  done
  kill -KILL "$calibrate"
  wait "$calibrate" 2>/dev/null || true
  sleep 0.3                            # its runs end with it
  records >"$out/records_$kill.txt"
done
# What is known by now is told without a run, and nothing is written.
find "$out/parts" -type f -printf '%p %T@\n' | sort >"$out/files_before.txt"
"$footfall" calibrate "$out/many.toml" --out "$out/parts" --so-far >"$out/so_far.txt" 2>&1 || { cat "$out/so_far.txt"; die "--so-far failed"; }
grep -q '^Of [1-9][0-9]* sets the one of least misfit' "$out/so_far.txt" || { cat "$out/so_far.txt"; die "--so-far knows no sets"; }
find "$out/parts" -type f -printf '%p %T@\n' | sort | cmp - "$out/files_before.txt" || die "--so-far has written"
code=0
"$footfall" calibrate "$out/many.toml" --out "$out/none" --so-far >"$out/none.txt" 2>&1 || code=$?
((code == 2)) && [[ ! -e $out/none ]] || die "--so-far of a missing folder ended with $code: $(cat "$out/none.txt")"
"$footfall" calibrate "$out/many.toml" --out "$out/parts" --jobs 2 >"$out/rest.txt" 2>&1 || { cat "$out/rest.txt"; die "the rest failed"; }
"$footfall" calibrate "$out/many.toml" --out "$out/parts" --so-far | grep -q 'has ended' || die "--so-far does not say that it has ended"
records >"$out/records.txt"
for ((kill = 1; kill <= 5; ++kill)); do
  lost=$(comm -23 "$out/records_$kill.txt" "$out/records.txt")
  [[ -z $lost ]] || die "runs that were finished at kill $kill were done again: $lost"
done
for file in way.csv best.txt most_met.txt parameters.csv targets.csv; do
  cmp "$out/whole/$file" "$out/parts/$file" || die "$file differs from that of the undisturbed one"
done

mkdir "$out/moved"
cp "$out/whole/numbers.jsonl" "$out/moved/"
cp -r "$inputs/strut" "$out/elsewhere"
sed "s|\"$inputs/strut/|\"$out/elsewhere/|" "$out/many.toml" >"$out/moved.toml"
"$footfall" calibrate "$out/moved.toml" --out "$out/moved" --jobs 2 >"$out/moved.txt" 2>&1 || { cat "$out/moved.txt"; die "the one from the ledger failed"; }
grep -q '^0 runs done, ' "$out/moved.txt" || die "runs of the ledger were done again: $(tail -n 1 "$out/moved.txt")"
cmp "$out/whole/way.csv" "$out/moved/way.csv" || die "way.csv from the ledger differs"
sed -i '2s/.*/{"scene": 7}/' "$out/moved/numbers.jsonl"
code=0
"$footfall" calibrate "$out/moved.toml" --out "$out/moved" >"$out/damaged.txt" 2>&1 || code=$?
((code == 2)) && grep -q 'numbers.jsonl:2: is no entry' "$out/damaged.txt" || die "a damaged ledger ended with $code: $(cat "$out/damaged.txt")"
echo "$runs runs; killed at $(for ((k = 1; k <= 5; ++k)); do wc -l <"$out/records_$k.txt"; done | paste -sd' ') of them; no finished run was done again"
