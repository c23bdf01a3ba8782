#!/usr/bin/env bash
# inputs/regolith/in.bed on stock LIGGGHTS: four patches or one bed, small grains under the pads and large ones elsewhere, about as many as it says.
#   regolith_bed.sh LIGGGHTS SOURCE
set -eu
export LC_ALL=C.UTF-8  # decimal points of awk
liggghts=$1 source=$2
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cd "$work"
die() { echo "regolith_bed.sh: $*" >&2; cat log >&2; exit 1; }
# pour NAME VALUE...: the poured grains, before they have fallen far.
pour() { "$liggghts" -in "$source/inputs/regolith/in.bed" -var here "$source/inputs/regolith" -var bed bed.restart -var centre 0.35 -var settle 0.001 -log log "$@" > out 2>&1 || die "LIGGGHTS ended with $?"; }
# count CONDITION: of grains, over x y z r and u, the larger of their distances |x| - centre and |y| - centre from the middle of their patch.
count() { awk "function a(v) { return v < 0 ? -v : v } NF == 7 && \$1 + 0 == \$1 { x = \$1; y = \$2; z = \$3; r = \$4; dx = a(a(x) - 0.35); dy = a(a(y) - 0.35); u = dx > dy ? dx : dy; if ($1) ++n } END { print n + 0 }" bed.restart.grains; }
# Poured grains must fit in whole, so small beds take up to a fifth less than asked.
about() { local n; n=$(count "$2"); (( n <= $3 && 5 * n >= 4 * $3 )) || die "$1: $n grains, expected about $3"; }
expect() { [[ $(count "$2") == "$3" ]] || die "$1: $(count "$2") grains, expected $3"; }

# One kind of grain in four patches of 0.6 x 0.6 x 0.1 m: 4 round(0.61 V / (4/3 pi r^3)).
pour -var width 0.6 -var depth 0.1
about "patches" 1 2620
expect "outside the patches" "u > 0.3" 0

# Two kinds: grains of 2 cm within 0.3 m, none of 4 cm there.
pour -var width 0.6 -var depth 0.2 -var fine 0.3 -var fine_depth 0.1 -var coarse 0.04
about "2 cm" "r == 0.02" 656
expect "2 cm outside their part" "r == 0.02 && u > 0.15" 0
about "4 cm" "r == 0.04" 573
expect "4 cm inside that part" "r == 0.04 && u < 0.15 && z > 0.2179" 0

# One bed where the patches meet: also between them.
pour -var width 0.8 -var depth 0.2 -var fine 0.3 -var fine_depth 0.1 -var coarse 0.04
about "2 cm" "r == 0.02" 656
[[ $(count "u > 0.4") == 0 && $(count "x * x < 0.0016") -gt 10 ]] || die "four patches of 0.8 m around 0.35 m are not one bed"

# Clumps of five spheres: as many as there would be spheres, each of the mass of the sphere in its place.
pour -var width 0.6 -var depth 0.1 -var clumps 1 -var clump bipyramid
clumps=$(awk 'NF == 8 && $1 + 0 == $1 { ++n[$5] } END { for (k in n) { if (n[k] != 5) exit 1; ++all }; print all }' bed.restart.grains) || die "a clump has not 5 spheres"
((clumps <= 2620 && 5 * clumps >= 4 * 2620)) || die "$clumps clumps, expected about 2620"
grep -qE '^INFO: Particle insertion pour_fine: inserted '"$clumps"' particle templates' out || die "not $clumps clumps were poured"
