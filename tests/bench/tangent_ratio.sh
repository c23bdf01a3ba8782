#!/usr/bin/env bash
# Run time of scheme `tangent` beside `css-trapezoid` with the same windows on the lattice of fixed grains: A B A B ..., minimum and median of each,
# for the whole program and for mechanism and exchange alone. The mechanism integrates with a tolerance that still hides behind the coupling's error; the
# scene's own, 1e-8, makes it take seven steps in a window of 40 substeps.
#   tests/bench/tangent_ratio.sh BUILD [REPEATS] [SUBSTEPS per window]
set -eu
build=$1 repeats=${2:-7} every=${3:-20}
root=$(cd "$(dirname "$0")/../.." && pwd)
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
(( EUID )) || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
for k in $(seq "$repeats"); do
  for scheme in css-trapezoid tangent; do
    "$build/bin/footfall" run "$root/inputs/accuracy/scenes/lattice.toml" --quiet --out "$work/run" --set output.plots=false --set output.interval=1e-3 --set solver.rtol=1e-6 --set solver.atol=1e-8 \
      --set coupling.scheme=$scheme --set particles.variables.every="$every" > "$work/out" 2>&1 || { cat "$work/out" >&2; exit 1; }
    sed -n 's/^ *"\(wall_s\|dem_wall_s\|mbd_wall_s\|exchange_wall_s\)": *\([0-9.e-]*\),*/\1 \2/p' "$work/run/summary.json" |
      awk -v s=$scheme '{ t[$1] = $2 } END { print s, t["wall_s"], t["dem_wall_s"], t["mbd_wall_s"], t["exchange_wall_s"] }' >> "$work/times"
  done
done
column_of() { awk -v s="$1" -v c="$2" '$1 == s { print c == "own" ? $4 + $5 : $2 }' "$work/times" | sort -g; }
for what in whole own; do
  for scheme in css-trapezoid tangent; do
    column_of $scheme $what | awk -v s=$scheme '{ t[NR] = $1 } END { print s, t[1], t[int((NR + 1) / 2)] }'
  done | awk -v w=$what '{ m[$1] = $2; d[$1] = $3 } END {
    a = "css-trapezoid"; b = "tangent"
    printf "%-20s minimum %.4f s and %.4f s, ratio %.3f; median %.4f s and %.4f s, ratio %.3f\n", w == "own" ? "mechanism, exchange" : "whole run", m[a], m[b], m[b] / m[a], d[a], d[b], d[b] / d[a] }'
done
