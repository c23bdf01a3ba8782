#!/usr/bin/env bash
# box_kinds.sh FOOTFALL OUT: beds of every kind of [particles.box] settle and carry a plate: dense and loose, periodic and tilted, cohesive, each rolling
# model, on the moon. The dense one is denser; every one has come to rest; a plate that is let down carries its weight in the mean.
set -u
footfall=$1 out=$2
die() { echo "box_kinds.sh: $*"; exit 1; }
rm -rf "$out" && mkdir -p "$out" && cd "$out" || die "cannot make $out"
cat >box.toml <<'TOML'
end_time = 0.02
[[bodies]]
name = "plate"
mass = 0.5
shape = { kind = "cylinder", centre = [0, 0, 0.01], radius = 0.04, length = 0.01 }
[[boundaries]]
body = "plate"
surface = { element_size = 0.02 }
[ground]
kind = "particles"
[initial]
clearance = 0.001
[particles]
ranks = 1
[particles.box]
size = [0.2, 0.16]
depth = 0.05
radius = 0.008
[output]
plots = false
TOML
kind() {  # NAME SETTING...
  local name=$1 settings=(); shift
  for setting in "$@"; do settings+=(--set "$setting"); done
  "$footfall" run box.toml --quiet --out "$name" "${settings[@]}" >"$name.txt" 2>&1 || { cat "$name.txt"; die "$name failed"; }
  "$footfall" check box.toml "${settings[@]}" >>"$name.txt" || die "$name is refused"
  # 1e-5 J are 300 grains of 6 g at 3 mm/s.
  local bed energy; bed=$(tail -n 1 "$name.txt" | tr -d ' ')
  energy=$(awk 'NF == 4 && $1 + 0 == $1 { e = $3 } END { print e }' "$bed/liggghts.log")
  awk -v e="$energy" 'BEGIN { exit !(e < 1e-4) }' || die "the bed of $name still moves: $energy J"
  fraction=$(sed -n 's/.*solid fraction \([0-9.]*\).*/\1/p' "$name.txt")
  echo "$name: solid fraction $fraction, kinetic energy $energy J"
}
kind loose
loose=$fraction
kind dense 'particles.box.packing="dense"'
awk -v a="$loose" -v b="$fraction" 'BEGIN { exit !(b > a + 0.02) }' || die "dense is not denser than loose: $fraction, $loose"
kind periodic particles.box.periodic=true 'gravity=[0.8,0,-9.7]' 'particles.box.material.rolling_model="epsd2"'
kind cohesive particles.box.material.cohesion=1e4 'particles.box.material.rolling_model="none"' particles.box.bodies.cohesion=0
kind moon 'gravity=[0,0,-1.62]' 'particles.box.centre=[0.02,-0.02]' 'particles.box.radius=[0.007,0.01]' 'particles.box.shares=[0.7,0.3]' particles.box.frames=0.01
ls moon/grains_*.vtk moon/meshes_*.vtk >/dev/null || die "there are no dumps"
exit 0
