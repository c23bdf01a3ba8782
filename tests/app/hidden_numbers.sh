#!/usr/bin/env bash
# hidden_numbers.sh FOOTFALL OUT strut|soil REPETITIONS LEAST [FIRST]: runs with hidden parameters, drawn at random in the inner part of their ranges, are calibrated against:
# at least LEAST of the intervals, of all parameters and repetitions together, hold what was hidden. FIRST: number of the first repetition, which its random numbers follow from.
#   strut   inputs/calibrations/strut.toml: drop tests with noise of 60 N. Of ten intervals of 95 % fewer than nine hold in one of twelve series by chance alone; of forty
#           fewer than 36 in one of twenty
#   soil    inputs/calibrations/soil.toml: slopes and plates on beds that the calibration does not use. Runs in OUT are used again by the next repetition
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
footfall=$1 kind=$3 repetitions=$4 least=$5 first=${6-1}
inputs=$(cd "$(dirname "$0")/../../inputs/calibrations" && pwd)
mkdir -p "$2" && cd "$2"
die() { echo "hidden_numbers.sh: $*" >&2; exit 1; }
declare -A held
# uniform SEED FORMULA...: numbers of an awk formula each
draw() { awk -v seed="$1" "BEGIN { srand(seed); rand(); printf \"$2\n\", $3 }"; }
count_held() { # PAGE K NAME...: parameters of these names (shell variables hold what was hidden)
  local page=$1 k=$2 name; shift 2
  for name; do # | name | range | scale | start | best | LEAST to MOST | ...
    awk -F' *\\| *' -v name="$name" -v hidden="${!name}" -v k="$k" '$2 == name && NF > 8 && $7 ~ / to / { split($7, ends, " to ")
      print k, name, "hidden", hidden, "found", $6, "interval", $7
      exit !(hidden >= ends[1] && hidden <= ends[2]) }' "$page" && held[$name]=$((${held[$name]:-0} + 1))
  done
  return 0
}
calibrate() { "$footfall" calibrate "$1" --out found --jobs 2 >said.txt 2>&1 || { cat said.txt; die "repetition $k failed"; }; }

strut() { # K
  local k=$1
  read -r viscous yield_force pressure exponent < <(draw "$((2023 + k))" "%.10g %.10g %.10g %.10g" "1500 * 3.5 ^ rand(), 5500 * 2.2 ^ rand(), 7e5 * 2 ^ rand(), 1.1 + 0.35 * rand()")
  measure() { # VOLTAGE FILE SEED: force at 24 strokes up to 0.9 of the largest, with noise
    "$footfall" run "$inputs/strut" --quiet --force --out hidden --set output.plots=false --set struts.leg.mr.voltage="$1" --set struts.leg.mr.viscous="$viscous" \
      --set struts.leg.mr.yield_force="$yield_force" --set struts.leg.gas.pressure="$pressure" --set struts.leg.gas.exponent="$exponent" >said.txt 2>&1 || die "the hidden run failed"
    awk -F, -v seed="$3" '
      function noise() { return sqrt(-2 * log(1 - rand())) * cos(6.283185307179586 * rand()) }
      /^#/ { next }
      !column { for (i = 1; i <= NF; ++i) { if ($i == "leg.stroke") x = i; if ($i == "leg.force") column = i }; next }
      { stroke[++n] = $x; force[n] = $column; if ($x > top) top = $x }
      END {
        srand(seed)
        for (k = 1; k <= 24; ++k) {
          at = 0.9 * top * k / 24
          for (m = 2; stroke[m] < at; ++m) {}
          y = force[m - 1] + (force[m] - force[m - 1]) * (at - stroke[m - 1]) / (stroke[m] - stroke[m - 1])
          printf "%.6f, %.2f\n", at, y + 60 * noise()
        }
      }' hidden/history.csv >"$2"
  }
  # The shipped calibration without its search of the whole ranges: the intervals are what is tested.
  mkdir -p strut
  sed '/^method = "direct"/,/^evaluations/d' "$inputs/strut.toml" | awk '/^\[\[stages\]\]/ && stages++ {next} {print}' |
    sed "s|^scene = \"strut/scene.toml\"|scene = \"$inputs/strut/scene.toml\"|" >strut.toml
  measure 0 strut/force_off.csv "$((100 + k))"
  measure 0.3 strut/force_on.csv "$((200 + k))"
  calibrate strut.toml
  count_held found/strut.md "$k" viscous yield_force pressure exponent
  rm -rf found
}

soil() { # K
  local k=$1
  read -r friction rolling < <(draw "$((4096 + k))" "%.4f %.4f" "0.17 * 2.8 ^ rand(), 0.04 * 5 ^ rand()")
  sed "s|^scene = \"\.\./|scene = \"$(dirname "$inputs")/|" "$inputs/soil.toml" >whole.toml
  blocks() { awk -v kind="[[$1]]" -v as="[[$2]]" '$0 == kind { print as; on = 1; next } /^\[/ { on = 0 } on' whole.toml; }
  {
    sed '/^\[/Q' whole.toml | grep -E '^(title|scene) = '
    sed '/^\[/Q' whole.toml | sed -n 's/^settings = \[//p' |
      sed "s|^|settings = [\"particles.box.material.friction=$friction\", \"particles.box.material.rolling_friction=$rolling\", |"
    printf '[[parameters]]\nname = "scene"\n'
    blocks scenes parameters.choices
    printf '[[parameters]]\nname = "seed"\nensemble = true\nsettings = ["particles.box.seed={value}"]\nvalues = [%s]\n' "$(seq -s, "$((1000 + 10 * k))" "$((1005 + 10 * k))")"
    blocks figures figures
  } >hidden.toml
  "$footfall" sweep hidden.toml --out hidden --jobs 2 >said.txt 2>&1 || { cat said.txt; die "the hidden runs failed"; }
  # Means over the beds instead of the calibration's own targets.
  awk -F, 'FNR == NR && FNR == 1 { for (i = 1; i <= NF; ++i) column[$i] = i; next }
      FNR == NR { ++n[$column["scene"]]; for (i = 1; i <= NF; ++i) sum[$column["scene"], i] += $i; next }
      /^\[\[targets\]\]/ { in_target = 1 } /^(figure|scene) = / && in_target { split($0, part, "\""); name[substr($0, 1, 1)] = part[2] }
      /^value = / && in_target { $0 = sprintf("value = %.5f", sum[name["s"], column[name["f"]]] / n[name["s"]]) }
      { print }' hidden/runs.csv whole.toml >soil.toml
  calibrate soil.toml
  count_held found/soil.md "$k" friction rolling
}

for ((n = first; n < first + repetitions; ++n)); do $kind $n; done
all=0
for name in "${!held[@]}"; do
  echo "$name: ${held[$name]} of $repetitions intervals hold it"
  all=$((all + ${held[$name]}))
done
((all >= least)) || die "$all intervals hold what was hidden, expected at least $least"
