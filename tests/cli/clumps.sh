#!/usr/bin/env bash
# clumps.sh FOOTFALL OUT: a bed of cohesive clumps by numbers: what check tells of it, a run, its ledger, the audit, and stock LIGGGHTS' replay.
set -u
footfall=$1 out=$2 scene=$(cd "$(dirname "$0")" && pwd)/clumps.toml
die() { echo "clumps.sh: $*"; exit 1; }
rm -rf "$out" && mkdir -p "$out" && cd "$out" || die "cannot make $out"
"$footfall" run "$scene" --quiet --out a >run.txt 2>&1 || { cat run.txt; die "the run failed"; }

# check: clumps and spheres, as the dump of the bed has them.
"$footfall" check "$scene" >check.txt || die "the scene is refused"
cat check.txt
grep -q "clumps: pair (2 spheres of radius 0.00638 m), tetrahedron (4 spheres" check.txt || die "check does not tell the shapes"
grep -q "rolling friction: none" check.txt || die "check does not tell that clumps have no rolling friction"
bed=$(tail -n 1 check.txt | tr -d ' ')
read -r clumps spheres wrong < <(awk '/^ITEM/ { atoms = /^ITEM: ATOMS/; next } atoms { n++; size[$5]++; small[$5] = $4 < 0.006 }
  END { for (c in size) { k++; if (size[c] != (small[c] ? 4 : 2)) wrong++ } print k, n, wrong + 0 }' "$bed/bed.restart.grains")
((wrong == 0)) || die "$wrong clumps have lost a sphere"
grep -q "the bed is made: $clumps clumps of $spheres spheres" check.txt || die "check tells another number than $clumps clumps of $spheres spheres"
# The bed reaches its surface, and is packed as grains with corners are.
awk -v f="$(sed -n 's/.*solid fraction \([0-9.]*\).*/\1/p' check.txt)" -v top="$(sed -n 's/.*reaches z = \([-0-9.e]*\) m.*/\1/p' check.txt)" \
  'BEGIN { exit !(f > 0.42 && f < 0.66 && top > -0.006 && top < 0.001) }' || die "the bed is not what was asked for"

# The ledger: clumps are bodies. What the mechanism gave is what grains have, or have lost; they have spun, and none of them counts twice.
awk '!/^#/ { n++; if ($4 > spin) spin = $4; if ($3 > most) most = $3 } END { exit !(n > 5 && spin > 1e-5 && most > 1e-3 && most < 0.3) }' \
  a/grains_energy.txt || die "the energies of the clumps are not those of bodies"
awk -F, '$1 == "time" { for (i = 1; i <= NF; ++i) c[$i] = i } $1 + 0 == $1 { e = $c["closing_error"]; d = $c["grains.dissipated"] }
  END { exit !(e * e < 1e-10 && d > 0) }' a/ledger.csv || die "the ledger does not close"

# In every window the clumps lose what bodies, walls and gravity get.
"$footfall" audit "$scene" --out audit --until 0.03 >audit.txt 2>&1 || { cat audit.txt; die "the audit does not hold"; }
grep -E "^(grains: (linear|angular)|walls of bodies: linear)" audit.txt
(($(grep -cE "^(grains: (linear|angular) momentum|walls of bodies: linear impulse) .* holds$" audit.txt) == 3)) || die "the audit did not check it"

# Pictures, and the replay by stock LIGGGHTS.
ls a/grains_*.vtk >/dev/null || die "there are no pictures"
"$footfall" compare a --quiet >compare.txt 2>&1 || { cat compare.txt; die "stock LIGGGHTS does not replay it"; }
[[ -s a/compare/beds.csv ]] || die "the replay left no beds"
exit 0
