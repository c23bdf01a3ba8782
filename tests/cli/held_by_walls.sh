#!/usr/bin/env bash
# The shelf of tests/bad_input/through_static_mesh.in holds what [[contacts]] with walls = true say, on one rank and on two alike.
#   held_by_walls.sh FOOTFALL OUT
set -eu
footfall=$1 out=$2 here=$(cd "$(dirname "$0")" && pwd)
rm -rf "$out"
mkdir -p "$out"
for ranks in 1 2; do
  "$footfall" run "$here/held_by_walls.toml" --quiet --ranks $ranks --out "$out/$ranks" >"$out/$ranks.txt" 2>&1 || { cat "$out/$ranks.txt" >&2; exit 1; }
done
cmp "$out/1/history.csv" "$out/2/history.csv"
# It stands on z = 0.045 with half its thickness, 0.01; contacts of that stiffness give way by less than 1 mm.
awk -F, '/^time/ { for (i = 1; i <= NF; ++i) { if ($i == "plate.z") z = i; if ($i == "plate.contact.fz") f = i } next }
         z && NF > 1 { if ($z < 0.054) low = 1; if ($f > 0) pressed = 1; last = $z }
         END { print "ends at z = " last; exit low || !pressed || last > 0.06 }' "$out/1/history.csv"
