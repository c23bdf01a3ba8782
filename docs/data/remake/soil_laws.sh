#!/usr/bin/env bash
# Remakes docs/data/soil_laws: published laws of soil, and the answers of the rigs on their default beds. Some hours on two cores; finished runs in
# runs/rigs (or $SOIL_RUNS) are kept.
#   docs/data/remake/soil_laws.sh [BUILD [PART...]]     BUILD: the build folder (default build). PART: these parts alone, of those listed below
set -euo pipefail
cd "$(dirname "$0")/../../.."
. docs/data/remake/parts.sh
footfall=${1:-build}/bin/footfall
out=${SOIL_RUNS:-runs/rigs}
jobs=${SOIL_JOBS:-0}   # runs at once; 0: footfall chooses
laws_of_soil=(rft rft_smooth rft_long rft_deep rft_wide rft_out rft_upright rft_few sphere sphere_scaling sphere_scaling_fine sphere_scaling_alike sphere_scaling_alike_fine sphere_scaling_whole sphere_scaling_heavy first_contact walls floor floor_fine floor_frozen floor_frozen_fine froude janssen janssen_drawn janssen_fine janssen_further footpad pad_drops pad_stiffness sphere_grains sphere_small_grains wheel_scaling wheel_stiffness)
rigs=(plate plate_checks cone cone_checks wheel wheel_checks shear shear_checks box box_checks repose repose_checks sphere_checks)
all=("${laws_of_soil[@]}" "${rigs[@]}")
few=(); ((jobs == 0)) || few=(--jobs "$jobs")
laws=docs/data/remake/soil_laws   # awk programs

# FOLDER RIG OPTIONS...: the table of a rig and the command that makes it.
rig() {
  local folder=$1 name=$2 option words=(); shift 2
  "$footfall" rig "$name" --out "$out/$folder" "${few[@]}" "$@" >&2
  for option in "$@"; do [[ $option == *['[" ']* ]] && words+=("'$option'") || words+=("$option"); done
  echo "\`footfall rig $name${words[*]:+ ${words[*]}}\`:"
  sed -e '/^## /d' -e '/^Made by/d' "$out/$folder/$name.md" | cat -s
}
sweep() { "$footfall" sweep "$1" --out "$2" "${few[@]}" >&2; echo "\`footfall sweep $1\`:"; echo; }

part_rft() { rig rft rft --samples 1; }
# The smooth plate, and its stresses by depth. PART SAMPLES OPTIONS...
rft_by_depth() {
  local part=$1 samples=$2; shift 2
  rig "$part" rft --samples "$samples" --set particles.box.bodies.friction=0.27 "$@"
  echo
  echo "By depth, from the same runs (\`docs/data/remake/soil_laws/rft_depths.awk\`; alpha in N/cm^3, means over the six plates):"
  echo
  awk -v points="$out/$part/points.txt" -f $laws/rft_depths.awk "$out/$part"/runs/*/history.csv
}
part_rft_smooth() { rft_by_depth rft_smooth 1; }
part_rft_long() { rft_by_depth rft_long 1 --set 'particles.box.size=[0.62,0.2]' --set 'particles.box.centre=[0.1,0]'; }
part_rft_deep() { rft_by_depth rft_deep 3 --set 'particles.box.size=[0.62,0.2]' --set 'particles.box.centre=[0.1,0]' --set particles.box.depth=0.3; }
part_rft_wide() {
  rft_by_depth rft_wide 1 --set 'particles.box.size=[0.62,0.4]' --set 'particles.box.centre=[0.1,0]' --set particles.box.depth=0.3
  echo
  gnuplot -c $laws/rft_form.gp "$out/rft_wide/points.txt"
}
# Both ways: the plates of the deeper bed, and those that come out.
both_ways() { awk -f $laws/rft_depths.awk "$@" "$out"/rft_deep/runs/*__seed_$seed/history.csv "$out"/rft_out/runs/*__seed_$seed/history.csv; }
part_rft_out() {
  local seed
  part_rft_deep >/dev/null
  sweep inputs/laws/rft_out.toml "$out/rft_out"
  echo "With the plates that go in of the deeper bed, from one to three widths (\`docs/data/remake/soil_laws/rft_depths.awk\`):"
  echo
  echo '| sample of the bed | zeta | R^2 of all 48 pairs |'
  echo '|---|---|---|'
  for seed in 1 2 3; do both_ways | awk -v seed=$seed '/^[|] 1 to 3/ { print "| " seed " | " $6 " | " $8 " |" }'; done
  echo
  echo 'All samples together:'
  echo
  seed='*' both_ways -v points="$out/rft_out/points.txt"
  echo
  echo '| law | asked | found | met |'
  echo '|---|---|---|---|'
  seed='*' both_ways | awk '/^[|] 1 to 3/ { print "| plates that go in and come out: the printed coefficients and one scalar: R^2 at least 0.9 (Li, Zhang and Goldman, Science 339, 1408 (2013)) | 0.9 to 1 | " $8 " | " ($8 >= 0.9 ? "yes" : "no") " |" }'
  echo
  gnuplot -c $laws/rft_form.gp "$out/rft_out/points.txt"
}
part_rft_upright() {
  sweep inputs/laws/rft_upright.toml "$out/rft_upright"
  awk -f $laws/rft_upright.awk "$out"/rft_upright/runs/*/history.csv
}
# FOLDER FILE OPTIONS...: five pairs of angles, a row of the table.
five_pairs() {
  local folder=$out/rft_few/$1 name=${1//_/ } file=$2; shift 2
  "$footfall" rig rft --file "$file" --samples 1 --out "$folder" "${few[@]}" "$@" >&2
  awk -f $laws/rft_depths.awk "$folder"/runs/*/history.csv >"$folder/by_depth.txt"
  awk -v name="$name" -F '[ ]*[|][ ]*' '/^[|] 1 to 3/ { zeta = $3; r2 = $4 } /^[|] 1 to 2/ { upper = $4 } END { printf "| %s | %s | %s | %s |\n", name, zeta, r2, upper }' "$folder/by_depth.txt"
}
part_rft_few() {
  local file=inputs/laws/rft_few.toml
  echo "\`footfall rig rft --file inputs/laws/rft_few.toml --samples 1\`, with inputs/laws/rft_few_slow.toml, or with one of"
  echo "\`--set particles.box.radius=0.004\`, \`particles.box.packing=\"dense\"\`, \`particles.box.material.rolling_model=\"none\"\`, \`bodies.plate.shape.size=[0.05,0.05,0.003]\`:"
  echo
  echo '| five pairs | zeta | R^2, 1 to 3 widths | R^2, 1 to 2 widths |'
  echo '|---|---|---|---|'
  five_pairs as_before $file
  five_pairs a_third_of_the_speed inputs/laws/rft_few_slow.toml
  five_pairs dense_bed $file --set 'particles.box.packing="dense"'
  five_pairs no_rolling_friction $file --set 'particles.box.material.rolling_model="none"'
  five_pairs plate_of_half_the_thickness $file --set 'bodies.plate.shape.size=[0.05,0.05,0.003]'
  five_pairs grains_of_half_the_size $file --set particles.box.radius=0.004
}
part_sphere() { rig sphere sphere --samples 30; keep_picture "$out/sphere/sphere.png" docs/pictures/soil_sphere.png; }
# PART LABEL SAMPLES SPHERES OPTIONS...: spheres DIAMETER_DENSITY, and the exponents of both. In the options MM stands for the diameter in millimetres, RADII for a fifteenth and a twelfth of the diameter.
spheres() {
  local part=$1 label=$2 samples=$3 list=$4 sphere diameter density words options; shift 4
  for sphere in $list; do
    IFS=_ read -r diameter density <<<"$sphere"
    options=("${@//MM/$(printf %.0f "${diameter}e3")}")
    options=("${options[@]//RADII/$(awk "BEGIN { printf \"[%.6g,%.6g]\", $diameter / 15, $diameter / 12 }")}")
    "$footfall" rig sphere --out "$out/$part/$sphere" --samples "$samples" "${few[@]}" "${options[@]}" --set "bodies.ball.shape.radius=$(awk "BEGIN { print $diameter / 2 }")" --set "materials.ball.density=$density" >&2
  done
  words=$*
  echo "\`footfall rig sphere --samples $samples${words:+ $words} --set bodies.ball.shape.radius=RADIUS --set materials.ball.density=DENSITY\` (\`docs/data/remake/soil_laws/sphere_scaling.awk\`):"
  echo
  awk -v label="$label" -f $laws/student.awk -f $laws/sphere_scaling.awk "$out/$part"/*/sphere_samples.csv
}
part_sphere_scaling() { spheres sphere_scaling "" 3 "0.09_2800 0.12_2800 0.16_2800 0.12_1400 0.12_5600"; }
part_sphere_scaling_fine() { spheres sphere_scaling_fine "grains of half the size: " 2 "0.09_2800 0.16_2800" --set 'particles.box.radius=[0.004,0.005]' --set output.vtk=false; }
part_sphere_scaling_alike() { spheres sphere_scaling_alike "speeds and bed go with the sphere: " 5 "0.09_2800 0.12_2800 0.16_2800" --file inputs/laws/sphere_alike_MMmm.toml; }
part_sphere_scaling_alike_fine() { spheres sphere_scaling_alike_fine "the same, grains of 0.7 of the size: " 3 "0.09_2800 0.16_2800" --file inputs/laws/sphere_alike_MMmm.toml --set 'particles.box.radius=[0.0056,0.007]' --set output.vtk=false; }
part_sphere_scaling_whole() { spheres sphere_scaling_whole "the same, grains go with the sphere, too: " 5 "0.09_2800 0.16_2800" --file inputs/laws/sphere_alike_MMmm.toml --set particles.box.radius=RADII --set output.vtk=false; }
part_sphere_scaling_heavy() { spheres sphere_scaling_heavy "steel, wider and deeper bed: " 3 "0.09_7800 0.12_7800 0.16_7800" --set 'particles.box.size=[0.64,0.64]' --set particles.box.depth=0.4 --set end_time=0.4 --set output.vtk=false; }
# inputs/laws/NAME.toml: tables of its cases and of its statements.
stated() { sweep "inputs/laws/$1.toml" "$out/$1"; grep -h "^[|]" "$out/$1/cases.md"; echo; cat "$out/$1/statements.md"; }
part_walls() { stated walls; }
part_floor() { stated floor; }
part_floor_fine() { stated floor_fine; }
part_floor_frozen() {
  local packing bed
  stated floor_frozen
  echo
  echo "How far the grains fill the beds (\`docs/data/remake/soil_laws/filled.awk\`, means over the samples):"
  echo
  echo '| bed | 10 to 30 mm below the surface | 30 to 50 mm | 50 to 70 mm | 70 to 90 mm |'
  echo '|---|---|---|---|---|'
  for packing in loose dense; do
    for bed in 0.25 0.09 0.09_poured_higher; do
      sed -n 's/.*"grains": "\(.*bed\.restart\.grains\)".*/\1/p' "$out/floor_frozen/runs/packing_${packing}__bed_${bed}"__seed_*/summary.json | sort -u | xargs awk -f $laws/filled.awk |
        sed "s/^/| packing $packing, bed ${bed//_/ }/; s/$/ |/"
    done
  done
}
part_floor_frozen_fine() { stated floor_frozen_fine; }
part_froude() { sweep inputs/laws/froude.toml "$out/froude"; awk -f $laws/student.awk -f $laws/froude.awk "$out/froude/runs.csv"; }
# RIG: on its default bed, ten samples, and its picture.
default_bed() { rig "$1" "$1" --samples 10; }
checks() { rig "$1_checks" "$1" --samples 1 --checks; }
for name in plate cone wheel shear repose box; do eval "part_$name() { default_bed $name; }"; done
for name in plate cone wheel shear repose box sphere; do eval "part_${name}_checks() { checks $name; }"; done
# NAME RADIUS: columns of inputs/laws/NAME.toml, of grains of this radius [m], table and picture.
columns() {
  sweep "inputs/laws/$1.toml" "$out/$1"
  awk -v radius="$2" -v points="$out/$1/points.txt" -f $laws/student.awk -f $laws/janssen.awk "$out/$1/runs.csv"
  gnuplot <<PLOT
set terminal pngcairo size 900,600
set output "$out/$1/$1.png"
set xlabel "weight of the grains [N]"
set ylabel "weight on the floor [N]"
set key bottom right
Ws = $(<"$out/$1/points.txt.ws")
set xrange [0:40]
set yrange [0:25]
plot "$out/$1/points.txt" with points pt 7 title "columns", Ws * (1 - exp(-x / Ws)) lw 2 title "Janssen, mean W_s", x dt 2 lc "gray" title "no friction of walls"
PLOT
  [[ $1 != janssen_drawn ]] || keep_picture "$out/$1/$1.png" docs/pictures/soil_janssen_drawn.png
}
part_janssen() { columns janssen 0.005; }
part_janssen_drawn() { columns janssen_drawn 0.005; }
part_janssen_further() { columns janssen_further 0.005; }
part_janssen_fine() { columns janssen_fine 0.0025; }
part_footpad() {
  sweep inputs/laws/footpad.toml "$out/footpad"
  awk -f $laws/student.awk -f $laws/footpad.awk "$out"/footpad/runs/*/history.csv
}
# Tables and fits of inputs/laws/NAME.toml, without the line that says who made them.
fitted() {
  sweep "inputs/laws/$1.toml" "$out/$1"
  grep -h "^[|]" "$out/$1/cases.md"
  echo
  sed '/^Made by/d' "$out/$1/fits.md"
}
part_pad_drops() {
  fitted pad_drops
  echo
  awk -f $laws/pad_drops.awk "$out"/pad_drops/runs/*/history.csv
}
part_pad_stiffness() {
  fitted pad_stiffness
  echo
  awk -f $laws/pad_stiffness.awk "$out"/pad_stiffness/runs/*/history.csv
}
part_sphere_grains() {
  fitted sphere_grains
  echo
  awk -v "asks=radius_0.016/D=0.667/spheres of 5 and 7.5 grains: depth goes as D^(2/3), Uehara et al.;radius_0.008/D=0.667/spheres of 10 and 15 grains: depth goes as D^(2/3), Uehara et al." \
    -f $laws/exponents.awk "$out/sphere_grains/fits.csv"
}
part_sphere_small_grains() {
  fitted sphere_small_grains
  echo
  awk -v "asks=small_grains/D=0.667/spheres of 20 and 30 grains: depth goes as D^(2/3), Uehara et al." -f $laws/exponents.awk "$out/sphere_small_grains/fits.csv"
}
part_first_contact() {
  fitted first_contact
  echo
  awk -v "asks=first_contact/D=2/peak force of the first blow: the exponent of D is 2;first_contact/v+2*E=2/peak force of the first blow: the exponents of v and, twice, of E make 2" \
    -f $laws/exponents.awk "$out/first_contact/fits.csv"
  echo
  sweep inputs/laws/first_contact_others.toml "$out/first_contact_others"
  grep -h "^[|]" "$out/first_contact_others/cases.md"
  echo
  cat "$out/first_contact_others/statements.md"
  echo
  echo "At one depth, from the same runs (\`docs/data/remake/soil_laws/first_contact_depth.awk\`):"
  echo
  awk -f $laws/first_contact_depth.awk "$out/first_contact/fits.csv" "$out"/first_contact_others/runs/*/history.csv
}
wheels() { sweep "inputs/laws/$1.toml" "$out/$1"; awk -f $laws/student.awk -f $laws/wheel_scaling.awk "$out/$1"/runs/*/history.csv; }
part_wheel_scaling() { wheels wheel_scaling; }
part_wheel_stiffness() { wheels wheel_stiffness; }

make_parts docs/data/soil_laws "${@:2}"
# What the runs of the parts cost that were made now; of "whole" all parts together, each bed counted once.
now=("${@:2}")
((${#now[@]})) || now=("${all[@]}")
for part in "${now[@]}"; do
  runs=("$out/$part")
  [[ $part != first_contact ]] || runs+=("$out/first_contact_others")
  count_cost docs/data/soil_laws "$part" "${runs[@]}"
done
count_cost docs/data/soil_laws whole "${all[@]/#/$out/}" "$out/first_contact_others"
