#!/usr/bin/env bash
# Remakes docs/data/calibration/foretold: numbers fitted to one half of the statements of docs/paper.md foretell the other half. `first` is fitted to Table 2 and Figure 12,
# `second` to Figures 13 to 15; targets of the other half have no weight.
#   docs/data/remake/foretold.sh [RUNS [HALF...]]     RUNS: folder of the runs (default runs/foretold). HALF: soil_first soil_second (minutes each), grains_first grains_second (ten minutes each on two cores, without beds)
set -euo pipefail
cd "$(dirname "$0")/../../.."
. docs/data/remake/parts.sh
runs=${1:-runs/foretold}
data=docs/data/calibration/foretold
footfall=${FOOTFALL:-./footfall}
all=(soil_first soil_second grains_first grains_second)

# HALF: the calibration with these targets alone; its page without pictures. Runs of the other half on the same ground are used again.
half() {
  local ground=${1%_*} half=${1#*_} file other
  file=paper_on_$ground
  other=$ground\_$([[ $half == first ]] && echo second || echo first)
  mkdir -p "$runs/$1"
  [[ -f $runs/$1/numbers.jsonl || ! -f $runs/$other/numbers.jsonl ]] || cp "$runs/$other/numbers.jsonl" "$runs/$1/numbers.jsonl"
  awk -v half="$half" -v inputs="$PWD/inputs" '
    function flush(  no_weight, k) {
      no_weight = half == "first" ? text ~ /source = "Figure 1[345]/ : text ~ /source = "(Table 2|Figure 12)/
      if (target && no_weight) { gsub(/weight = [0-9.]+\n/, "", text); sub(/\n*$/, "\nweight = 0\n", text) }
      printf "%s", text
      text = ""
    }
    /^\[/ { flush(); target = /^\[\[targets/ }
    { gsub(/"\.\.\//, "\"" inputs "/"); if (/^alone = /) $0 = "alone = 0"; if (/^title = /) sub(/"$/, ", " half " half\""); text = text $0 "\n" }
    END { flush() }' "inputs/calibrations/$file.toml" >"$runs/$1.toml"
  "$footfall" calibrate "$runs/$1.toml" --out "$runs/$1" >&2
  sed -E -e '/^!\[/d' -e "s#\`./footfall calibrate [^\`]*\`#\`docs/data/remake/foretold.sh RUNS $1\`#" "$runs/$1/$1.md"
}
for name in "${all[@]}"; do eval "part_$name() { half $name; }"; done
parts=("${@:2}")
((${#parts[@]})) || parts=(soil_first soil_second)
make_parts $data "${parts[@]}"
