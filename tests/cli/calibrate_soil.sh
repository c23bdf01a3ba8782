#!/usr/bin/env bash
# What is known is found, with grains: slopes and plates on beds with hidden friction and rolling friction, and the intervals of the calibration, which runs on other beds.
#   calibrate_soil.sh FOOTFALL CALIBRATION OUT REPETITIONS LEAST [FIRST]    LEAST: so many intervals, of both parameters together, hold what was hidden;
#   FIRST: number of the first repetition, which its hidden numbers and beds follow from
# Runs in OUT are kept and used again by the next repetition; begin with an empty OUT where that is not wanted.
set -eu
footfall=$1 calibration=$2 out=$3 repetitions=$4 least=$5 first=${6-1}
mkdir -p "$out"
die() { echo "calibrate_soil.sh: $*" >&2; exit 1; }
# The shipped calibration, with scenes by their whole paths.
sed "s|^scene = \"\.\./|scene = \"$(cd "$(dirname "$calibration")/.." && pwd)/|" "$calibration" >"$out/whole.toml"
blocks() { awk -v kind="[[$1]]" -v as="[[$2]]" '$0 == kind { print as; on = 1; next } /^\[/ { on = 0 } on' "$out/whole.toml"; }

# A sweep over the calibration's scenes with hidden numbers, on beds that no search has seen.
measure() {
  {
    sed '/^\[/Q' "$out/whole.toml" | grep -E '^(title|scene) = '
    sed '/^\[/Q' "$out/whole.toml" | sed -n 's/^settings = \[//p' |
      sed "s|^|settings = [\"particles.box.material.friction=$friction\", \"particles.box.material.rolling_friction=$rolling\", |"
    printf '[[parameters]]\nname = "scene"\n'
    blocks scenes parameters.choices
    printf '[[parameters]]\nname = "seed"\nensemble = true\nsettings = ["particles.box.seed={value}"]\nvalues = [%s]\n' "$1"
    blocks figures figures
  } >"$out/hidden.toml"
  "$footfall" sweep "$out/hidden.toml" --out "$out/hidden" --jobs 2 >"$out/said.txt" 2>&1 || { cat "$out/said.txt"; die "the hidden runs failed"; }
}

declare -A held
for ((k = first; k < first + repetitions; ++k)); do
  # Anywhere in the inner part of the ranges; the beds of a repetition are its own.
  read -r friction rolling < <(awk -v k="$k" 'BEGIN { srand(4096 + k); rand(); printf "%.4f %.4f\n", 0.17 * 2.8 ^ rand(), 0.04 * 5 ^ rand() }')
  measure "$(seq -s, "$((1000 + 10 * k))" "$((1005 + 10 * k))")"
  # Means over the beds instead of the calibration's own targets.
  awk -F, 'FNR == NR && FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
      FNR == NR { ++n[$column["scene"]]; for (i = 1; i <= NF; ++i) sum[$column["scene"], i] += $i; next }
      /^\[\[targets\]\]/ { in_target = 1 } /^(figure|scene) = / && in_target { split($0, part, "\""); name[substr($0, 1, 1)] = part[2] }
      /^value = / && in_target { $0 = sprintf("value = %.5f", sum[name["s"], column[name["f"]]] / n[name["s"]]) }
      { print }' "$out/hidden/runs.csv" "$out/whole.toml" >"$out/soil.toml"
  "$footfall" calibrate "$out/soil.toml" --out "$out/found" --jobs 2 >"$out/said.txt" 2>&1 || { cat "$out/said.txt"; die "repetition $k failed"; }
  for name in friction rolling; do
    # | name | range | scale | start | best | LEAST to MOST | ...
    awk -F' *\\| *' -v name="$name" -v hidden="${!name}" -v k="$k" '$2 == name && NF > 8 && $7 ~ / to / { split($7, ends, " to ")
      print k, name, "hidden", hidden, "found", $6, "interval", $7, "determined:", $8
      exit !(hidden >= ends[1] && hidden <= ends[2]) }' "$out/found/soil.md" && held[$name]=$((${held[$name]:-0} + 1))
  done
done
all=0
for name in friction rolling; do
  echo "$name: ${held[$name]:-0} of $repetitions intervals hold it"
  all=$((all + ${held[$name]:-0}))
done
((all >= least)) || die "$all of $((2 * repetitions)) intervals hold what was hidden, expected at least $least"
