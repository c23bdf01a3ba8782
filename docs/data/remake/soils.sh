#!/usr/bin/env bash
# Remakes docs/data/soils: slopes, instruments and landings on spheres and on clumps. Two to three hours on two cores; finished runs in runs/soils (or
# $SOIL_RUNS) are kept.
#   docs/data/remake/soils.sh [BUILD [PART...]]     BUILD: the build folder (default build). PART: slopes, slopes_high, slopes_higher, instruments, landing, default
set -euo pipefail
cd "$(dirname "$0")/../../.."
. docs/data/remake/parts.sh
footfall=${1:-build}/bin/footfall
out=${SOIL_RUNS:-runs/soils}
# shellcheck disable=SC2034  # read by parts.sh
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
part_slopes() { slopes docs/data/soils/repose.toml; }
part_slopes_high() {
  local file=docs/data/soils/repose_high.toml
  slopes $file
  slope $file "clumps of three in a row" 'particles.box.clumps=["rod"]'
  slope $file "clumps of three in a triangle" 'particles.box.clumps=["triangle"]'
  slope $file "clumps of five" 'particles.box.clumps=["bipyramid"]'
  slope $file "clumps of six" 'particles.box.clumps=["octahedron"]'
}
part_slopes_higher() { slopes docs/data/soils/repose_higher.toml; }
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
}

part_default() {
  "$footfall" sweep inputs/sweeps/landing_on_soils.toml --out "$out/default" >&2
  grep "^[|]" "$out/default/cases.md"
}

make_parts docs/data/soils "${@:2}"
low=("$out"/repose_{clumps_of_four,clumps_of_two,spheres_without_rolling_friction,spheres_with_rolling_friction_0.2})
high=("${low[@]/repose_/repose_high_}" "$out"/repose_high_clumps_of_{three_in_a_row,three_in_a_triangle,five,six})
higher=("${low[@]/repose_/repose_higher_}")
instruments=("$out"/{plate,cone,wheel,shear}_{none,rolling,clumps})
count_cost docs/data/soils slopes "${low[@]}"
count_cost docs/data/soils slopes_high "${high[@]}"
count_cost docs/data/soils slopes_higher "${higher[@]}"
count_cost docs/data/soils instruments "${instruments[@]}"
count_cost docs/data/soils landing "$out/landing"
count_cost docs/data/soils default "$out/default"
count_cost docs/data/soils whole "${low[@]}" "${high[@]}" "${higher[@]}" "${instruments[@]}" "$out"/{landing,default}
