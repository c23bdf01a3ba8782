#!/usr/bin/env bash
# What is known is found: drop tests of a strut with hidden numbers and noise, and the intervals of its calibration.
#   calibrate_strut.sh FOOTFALL CALIBRATION OUT REPETITIONS LEAST [FIRST]    LEAST: so many intervals, of all parameters together, hold what was hidden;
#   FIRST: number of the first repetition, which its random numbers follow from
# Of ten intervals of 95 % fewer than nine hold in one of twelve series by chance alone, so the four parameters are counted together: of forty,
# fewer than 36 hold in one of twenty.
set -eu
footfall=$1 calibration=$2 out=$3 repetitions=$4 least=$5 first=${6-1}
inputs=$(dirname "$calibration")
rm -rf "$out"; mkdir -p "$out/strut"
die() { echo "calibrate_strut.sh: $*" >&2; exit 1; }

# The shipped calibration, without its search of the whole ranges: the intervals are what is tested.
sed '/^method = "direct"/,/^evaluations/d' "$calibration" | awk '/^\[\[stages\]\]/ && stages++ {next} {print}' >"$out/strut.toml"
sed -i "s|^scene = \"strut/scene.toml\"|scene = \"$inputs/strut/scene.toml\"|" "$out/strut.toml"
grep -c '^\[\[stages\]\]' "$out/strut.toml" | grep -qx 1 || die "expected one stage"

# measure VOLTAGE FILE SEED: a run with the hidden numbers; force at 24 strokes up to 0.9 of the largest, with noise of 60 N.
measure() {
  "$footfall" run "$inputs/strut" --quiet --force --out "$out/hidden" --set output.plots=false --set struts.leg.mr.voltage="$1" \
    --set struts.leg.mr.viscous="$viscous" --set struts.leg.mr.yield_force="$yield_force" \
    --set struts.leg.gas.pressure="$pressure" --set struts.leg.gas.exponent="$exponent" >"$out/hidden.txt" 2>&1 || die "the hidden run failed"
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
    }' "$out/hidden/history.csv" >"$2"
}

declare -A held
for ((k = first; k < first + repetitions; ++k)); do
  # Anywhere in the inner part of the ranges.
  read -r viscous yield_force pressure exponent < <(awk -v seed="$((2023 + k))" 'BEGIN { srand(seed); rand()
    print 1500 * 3.5 ^ rand(), 5500 * 2.2 ^ rand(), 7e5 * 2 ^ rand(), 1.1 + 0.35 * rand() }')
  measure 0 "$out/strut/force_off.csv" "$((100 + k))"
  measure 0.3 "$out/strut/force_on.csv" "$((200 + k))"
  "$footfall" calibrate "$out/strut.toml" --out "$out/found" --jobs 2 >"$out/said.txt" 2>&1 || { cat "$out/said.txt"; die "repetition $k failed"; }
  for name in viscous yield_force pressure exponent; do
    # | name | range | scale | start | best | LEAST to MOST | ...
    awk -F' *\\| *' -v name="$name" -v hidden="${!name}" -v k="$k" '$2 == name && NF > 8 && $7 ~ / to / { split($7, ends, " to ")
      print k, name, "hidden", hidden, "found", $6, "interval", $7
      exit !(hidden >= ends[1] && hidden <= ends[2]) }' "$out/found/strut.md" && held[$name]=$((${held[$name]:-0} + 1))
  done
  rm -rf "$out/found"
done
all=0
for name in viscous yield_force pressure exponent; do
  echo "$name: ${held[$name]:-0} of $repetitions intervals hold it"
  all=$((all + ${held[$name]:-0}))
done
((all >= least)) || die "$all of $((4 * repetitions)) intervals hold what was hidden, expected at least $least"
