#!/usr/bin/env bash
# damping_mass pair, on beams and with the mass that mbd_solver sends: restitution is the script's, and less with `grain`.
#   pair_mass.sh FOOTFALL OUT
set -eu
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out"
mkdir -p "$out"
# restitution WORD: relative speed after the impact over that before it.
restitution() {
  "$footfall" run "$here/pair_mass.toml" --quiet --set "particles.variables.word=$1" --out "$out/$1" >"$out/$1.txt" 2>&1 || { cat "$out/$1.txt" >&2; exit 1; }
  awk -F, -v grain="$(tail -n 1 "$out/$1"/grain.2600)" '/^time/ { for (i = 1; i <= NF; ++i) if ($i == "beam.vz") at = i } END { split(grain, g, " "); print ($at - g[2]) / 0.2 }' \
    "$out/$1/history.csv"
}
pair=$(restitution pair) grain=$(restitution grain)
echo "restitution: pair $pair, grain $grain; the script says 0.4"
# Windows of one step: 5e-3, as in tests/dem/pair_mass_test.cpp. The same mass again: 0.26 (docs/reference/fixes/README.md).
awk -v p="$pair" -v g="$grain" 'BEGIN { exit !(p > 0.395 && p < 0.405 && g > 0.25 && g < 0.27) }'
