#!/usr/bin/env bash
# What `footfall check --time` foretells, and what the run then takes: a Markdown table. Wall times: leave the machine alone, or believe the ratio no better
# than the load is even. Beds are made first.
#   tests/bench/run_time.sh BUILD [SCENE...]       default: five scenes of inputs and examples
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
(( $# )) || { sed -n '2,4p' "$0"; exit 2; }
footfall=$(realpath "$1")/bin/footfall; shift
root=$(cd "$(dirname "$0")/../.." && pwd)
scenes=("$@")
(( $# )) || scenes=(inputs/landing_mr inputs/rigid_plane examples/02_wheel examples/04_arm examples/01_pendulum)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cd "$root"
echo "| scene | foretold [s] | bounds [s] | took [s] | foretold / took |"
echo "|---|---|---|---|---|"
for scene in "${scenes[@]}"; do
  "$footfall" run "$scene" --until 1e-4 --quiet --force --set output.plots=false --out "$work/bed" >/dev/null 2>&1 || true
  "$footfall" check "$scene" --time >"$work/said"
  begun=$(date +%s.%N)
  "$footfall" run "$scene" --quiet --force --set output.plots=false --out "$work/run" >/dev/null 2>&1
  took=$(echo "$(date +%s.%N) $begun" | awk '{ print $1 - $2 }')
  # "about 2.5 min (2.4 min to 2.6 min)" in seconds.
  sed -n 's/^Run time: //p' "$work/said" | tr -d '();,' | awk -v scene="$scene" -v took="$took" '
    function seconds(value, unit) { return value * (unit == "min" ? 60 : unit == "h" ? 3600 : 1) }
    /^about/ { f = seconds($2, $3); a = seconds($4, $5); b = seconds($7, $8) }
    !/^about/ { f = a = b = seconds($1, $2) }
    END { printf "| %s | %.3g | %.3g to %.3g | %.3g | %.2f |\n", scene, f, a, b, took, f / took }'
done
