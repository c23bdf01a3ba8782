#!/usr/bin/env bash
# Remakes docs/soils.md and its picture: what rolling friction of spheres and corners of clumps do to a slope, to instruments and to a landing. Two hours
# on two cores, of which the default landing takes half; runs that are done are kept in runs/soils (or $SOIL_RUNS).
#   docs/soils.sh [BUILD [PART...]]     BUILD: the build folder (default build). PART: slopes, slopes_high, slopes_higher, instruments, landing, default; "page": no part, the page alone
# The tables of a part are kept in docs/soils/made/PART.txt, and the page is put together of them and of the texts in docs/soils.
set -euo pipefail
cd "$(dirname "$0")/.."
. docs/parts.sh
footfall=${1:-build}/bin/footfall
out=${SOIL_RUNS:-runs/soils}
all=(slopes slopes_high slopes_higher instruments landing default)
none='particles.box.material.rolling_model="none"'
clumps='particles.box.clumps=["tetrahedron"]'

# FOLDER RIG SAMPLES OPTIONS...: its table, NAME | UNIT | MEAN | INTERVAL | SAMPLES.
measured() {
  local folder=$1 rig=$2 samples=$3; shift 3
  "$footfall" rig "$rig" --samples "$samples" --out "$out/$folder" "$@" >&2
  sed -n '/^| answer /,/^$/ { /^| answer \|^|--/d; /^| /p; }' "$out/$folder/$rig.md"
}
# FILE NAME SETTING...: a row of the table of slopes, from ten samples of the bed.
slope() {
  local file=$1 name=$2 settings=(); shift 2
  for setting in "$@"; do settings+=(--set "$setting"); done
  measured "$(basename "$file" .toml)_${name// /_}" repose 10 --file "$file" "${settings[@]}" |
    awk -F '[ ]*[|][ ]*' -v name="$name" '$2 ~ /^(angle of repose|R\^2 of the slope)/ { v[++n] = $4; i[n] = $5 } END { print "| " name " | " v[1] " | " i[1] " | " v[2] " |" }'
}
slopes() {
  echo '| grains | angle of repose [deg] | 95 % interval: +- | R^2 of the slope |'
  echo '|---|---|---|---|'
  slope "$1" "spheres without rolling friction" "$none"
  slope "$1" "spheres with rolling friction 0.2"
  slope "$1" "clumps of two" 'particles.box.clumps=["pair"]'
  slope "$1" "clumps of four" "$clumps"
}
part_slopes() { slopes docs/soils/repose.toml; }
part_slopes_high() {
  local file=docs/soils/repose_high.toml
  slopes $file
  slope $file "clumps of three in a row" 'particles.box.clumps=["rod"]'
  slope $file "clumps of three in a triangle" 'particles.box.clumps=["triangle"]'
  slope $file "clumps of five" 'particles.box.clumps=["bipyramid"]'
  slope $file "clumps of six" 'particles.box.clumps=["octahedron"]'
}
part_slopes_higher() { slopes docs/soils/repose_higher.toml; }
part_instruments() {
  local rig work
  work=$(mktemp -d)
  echo '| instrument | answer | unit | spheres without rolling friction | spheres with rolling friction 0.2 | clumps of four |'
  echo '|---|---|---|---|---|---|'
  for rig in plate cone wheel shear; do
    measured "${rig}_none" $rig 3 --set "$none" >"$work/none"
    measured "${rig}_rolling" $rig 3 >"$work/rolling"
    measured "${rig}_clumps" $rig 3 --set "$clumps" >"$work/clumps"
    paste -d '|' "$work/none" "$work/rolling" "$work/clumps" |
      awk -F '[ ]*[|][ ]*' -v rig=$rig '{ printf "| %s | %s | %s | %s +- %s | %s +- %s | %s +- %s |\n", rig, $2, $3, $4, $5, $11, $12, $18, $19 }'
  done
  rm -rf "$work"
}
part_landing() {
  "$footfall" sweep inputs/sweeps/soils.toml --out "$out/landing" --jobs 2 >&2
  grep "^[|]" "$out/landing/cases.md"
  cp "$out/landing/depth.png" docs/soils_depth.png
}

part_default() {
  "$footfall" sweep inputs/sweeps/landing_on_soils.toml --out "$out/default" >&2
  grep "^[|]" "$out/default/cases.md"
  cp "$out/default/depth.png" docs/soils_default_depth.png
  cp "$out/default/force.png" docs/soils_default_force.png
}

made=docs/soils/made
make_parts docs/soils "${@:2}"
# RUNS OF A PART: slopes of one file begin with its name.
count_cost docs/soils slopes "$out"/repose_clumps_* "$out"/repose_spheres_*
count_cost docs/soils slopes_high "$out"/repose_high_*
count_cost docs/soils slopes_higher "$out"/repose_higher_*
count_cost docs/soils instruments "$out"/{plate,cone,wheel,shear}_{none,rolling,clumps}
count_cost docs/soils landing "$out/landing"
count_cost docs/soils default "$out/default"
count_whole docs/soils "$out"/repose{,_high,_higher}_{clumps_of_four,clumps_of_two,spheres_without_rolling_friction,spheres_with_rolling_friction_0.2} "$out"/repose_high_clumps_of_{three_in_a_row,three_in_a_triangle,five,six} \
  "$out"/{plate,cone,wheel,shear}_{none,rolling,clumps} "$out"/{landing,default}
page=$(mktemp)
trap 'rm -f "$page"' EXIT
{
  cat docs/soils/head.txt
  for part in "${all[@]}"; do
    [[ -f $made/$part.txt ]] || continue
    [[ ! -f docs/soils/${part}_before.txt ]] || cat "docs/soils/${part}_before.txt"
    cat "$made/$part.txt" "docs/soils/$part.txt"
  done
  echo
  cost_of_parts docs/soils
  echo
  cost_of_pages docs/soils
} >"$page"
cp "$page" docs/soils.md
