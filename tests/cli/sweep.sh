#!/usr/bin/env bash
# A sweep that is interrupted, or killed, goes on with what is left and gives the tables of an uninterrupted one.
#   sweep.sh FOOTFALL FILE
set -eu
footfall=$1 file=$2
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "sweep.sh: $*" >&2; cat "$work"/*.txt >&2; exit 1; }

"$footfall" sweep "$file" --out "$work/whole" > "$work/whole.txt" 2>&1 || die "the whole sweep ended with $?"
grep -q "8 runs to do, 0 done before" "$work/whole.txt" || die "expected 8 runs"

# stop_after RUNS SIGNAL: starts the sweep and ends it when so many runs are done; its exit code.
stop_after() {
  "$footfall" sweep "$file" --out "$work/parts" --jobs 2 > "$work/part.txt" 2>&1 &
  local sweep=$! code=0
  for _ in $(seq 600); do
    (( $(find "$work/parts" -name '*.done.json' 2>/dev/null | wc -l) >= $1 )) && break
    sleep 0.05
  done
  kill "-$2" "$sweep"
  wait "$sweep" || code=$?
  return "$code"
}
code=0; stop_after 2 INT || code=$?
[[ $code == 3 ]] || die "an interrupted sweep ended with $code, expected 3"
code=0; stop_after 4 KILL || code=$?
[[ $code == 137 ]] || die "a killed sweep ended with $code"
"$footfall" sweep "$file" --out "$work/parts" > "$work/rest.txt" 2>&1 || die "the rest ended with $?"
grep -qE "[1-4] runs to do, [4-7] done before" "$work/rest.txt" || die "finished runs were done again"
for table in runs.csv cases.csv; do cmp "$work/whole/$table" "$work/parts/$table" || die "$table differs"; done

# What was expected, and whether it came out; what others have printed.
grep -q '^a faster fall hits harder.*,yes$' "$work/whole/statements.csv" || die "a true statement did not come out"
grep -q '^the slowest fall hits hardest.*,no$' "$work/whole/statements.csv" || die "a false statement came out"
grep -q 'no: it does not' "$work/whole/statements.md" || die "the reason is missing"
grep -q '^| somebody | 2.5 |' "$work/whole/cases.md" || die "the printed row is missing"

# A column or a number that no run has is told after the first run, and what is done is kept.
for wrong in 's/"cabin.z"/"cabin.q"/; columns' 's/"peak_acceleration_g"/"peak_acceleration"/; figures' ; do
  sed -e "${wrong%;*}" -e "s#\"../../inputs#\"$(dirname "$(realpath "$file")")/../../inputs#" "$file" > "$work/wrong.toml"
  rm -rf "$work/typo"
  code=0; "$footfall" sweep "$work/wrong.toml" --out "$work/typo" --jobs 1 > "$work/typo.txt" 2>&1 || code=$?
  [[ $code == 2 ]] || die "a figure that no run has ended with $code, expected 2"
  grep -q "${wrong#*; }.* has no .*Did you mean" "$work/typo.txt" || die "the figure is not named: $wrong"
  [[ $(find "$work/typo" -name '*.done.json' | wc -l) == 1 ]] || die "the sweep went on with a figure that no run has"
done
sed -e "s#\"../../inputs#\"$(dirname "$(realpath "$file")")/../../inputs#" "$file" > "$work/wrong.toml"
"$footfall" sweep "$work/wrong.toml" --out "$work/typo" > "$work/typo.txt" 2>&1 || die "the mended sweep ended with $?"
grep -q "7 runs to do, 1 done before" "$work/typo.txt" || die "the mended sweep did its first run again"

# As a job array: every element alone, then the tables.
"$footfall" sweep "$file" --out "$work/array" --slurm > "$work/slurm.txt" || die "--slurm"
grep -q -- "--array=0-7" "$work/array/sweep.sbatch" || die "the job array has the wrong size"
for element in $(seq 0 7); do "$footfall" sweep "$file" --out "$work/array" --only "$element" > "$work/only.txt" || die "--only $element"; done
"$footfall" sweep "$file" --out "$work/array" --merge > "$work/merge.txt" || die "--merge"
for table in runs.csv cases.csv; do cmp "$work/whole/$table" "$work/array/$table" || die "$table of the job array differs"; done

# On one page.
"$footfall" report "$work/whole" > "$work/report.txt" || die "report"
grep -q "speed_4__friction_0.5" "$work/whole/report.html" || die "the page lacks a run"
