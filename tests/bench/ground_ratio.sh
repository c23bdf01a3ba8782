#!/usr/bin/env bash
# Processor time of the public lander for 4 s on rigid uneven ground, relative to the plane: medians of runs in turn. Maps of 1000 x 1000 samples, 2 cm apart.
#   tests/bench/ground_ratio.sh BUILD [ROUNDS]      ROUNDS: 5
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
(( $# >= 1 )) || { sed -n '2,3p' "$0"; exit 2; }
solver=$(realpath "$1")/bin/mbd_solver rounds=${2:-5}
root=$(realpath "$(dirname "$0")/../..")
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
map() {  # NAME, height over x and y
  awk "BEGIN { n = 1000; print \"ncols \" n \"\nnrows \" n \"\nxllcorner 0\nyllcorner 0\ncellsize 0.02\"
    for (j = 0; j < n; ++j) for (i = 0; i < n; ++i) { x = 0.02 * i; y = 0.02 * j; printf \"%.6f%s\", $2, i < n - 1 ? \" \" : \"\n\" } }" > "$work/$1.asc"
}
map flat 0
map hills '0.3 * sin(1.3 * x) * sin(1.1 * y)'
map waves '0.0004 * (sin(6 * x + 2 * y) + sin(14 * y - 5 * x) + sin(20 * x + 18 * y) + sin(33 * x - 25 * y) + sin(60 * y + 10 * x))'
declare -A ground=([plane]="" [flat]="map={file='$work/flat.asc'}" [hills]="map={file='$work/hills.asc'}" [waves]="map={file='$work/waves.asc'}"
  [roughness]="roughness={height=0.001,shortest=0.1,longest=2}")
seconds_of() {
  local TIMEFORMAT='%U %S'
  { time "$@" > "$work/out" 2>&1; } 2> "$work/time" || { cat "$work/out" >&2; exit 1; }
  awk '{ print $1 + $2 }' "$work/time"
}
for round in $(seq "$rounds"); do
  for name in plane flat hills waves roughness; do
    words=(--set end_time=4 --set ground.kind=plane --out "$work/run" --quiet)
    [ -z "${ground[$name]}" ] || words+=(--set "ground.terrain.${ground[$name]}")
    rm -rf "$work/run"
    seconds_of "$solver" "$root/inputs/public_lander" "${words[@]}" >> "$work/$name"
  done
done
median() { sort -g "$work/$1" | awk '{ v[NR] = $1 } END { print (v[int((NR + 1) / 2)] + v[int((NR + 2) / 2)]) / 2 }'; }
plane=$(median plane)
for name in plane flat hills waves roughness; do
  awk -v n="$name" -v t="$(median "$name")" -v p="$plane" 'BEGIN { printf "%-10s %.2f s  %.2f\n", n, t, t / p }'
done
