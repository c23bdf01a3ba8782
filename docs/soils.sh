#!/usr/bin/env bash
# Remakes docs/soils.md and its picture: what rolling friction of spheres and corners of clumps do to a slope and to a landing. About ten
# minutes on two cores; runs that are done are kept.
#   docs/soils.sh [BUILD]     BUILD: the build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/.."
footfall=${1:-build}/bin/footfall
out=runs/soils
# NAME SETTING...: a row of the table of slopes, from three samples of the bed.
slope() {
  local name=$1 settings=(); shift
  for setting in "$@"; do settings+=(--set "$setting"); done
  "$footfall" rig repose --file docs/soils/repose.toml --samples 3 --out "$out/slope_${name// /_}" "${settings[@]}" >&2
  awk -F' [|] ' -v name="$name" '/^[|] (angle of repose|R\^2 of the slope)/ { split($0, c, /[ ]*[|][ ]*/); v[++n] = c[4]; i[n] = c[5] }
    END { print "| " name " | " v[1] " | " i[1] " | " v[2] " |" }' "$out/slope_${name// /_}/repose.md"
}
page=$(mktemp)
trap 'rm -f "$page"' EXIT
none='particles.box.material.rolling_model="none"'
{
  cat docs/soils/head.txt
  echo '| grains | angle of repose [deg] | 95 % interval: +- | R^2 of the slope |'
  echo '|---|---|---|---|'
  slope "spheres without rolling friction" "$none"
  slope "spheres with rolling friction 0.2"
  slope "clumps of two" 'particles.box.clumps=["pair"]'
  slope "clumps of four" 'particles.box.clumps=["tetrahedron"]'
  cat docs/soils/slopes.txt
  "$footfall" sweep inputs/sweeps/soils.toml --out "$out/landing" --jobs 2 >&2
  grep "^[|]" "$out/landing/cases.md"
  cat docs/soils/landing.txt
} > "$page"
cp "$page" docs/soils.md
cp "$out/landing/depth.png" docs/soils_depth.png
