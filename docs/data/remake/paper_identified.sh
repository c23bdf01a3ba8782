#!/usr/bin/env bash
# Writes the scenes of inputs/paper_identified from the set of parameters that inputs/calibrations/paper.toml finds.
#   docs/data/remake/paper_identified.sh [SET]     SET: best.txt or most_met.txt of `./footfall calibrate inputs/calibrations/paper.toml`; unless given, that in runs/calibrations/paper
set -euo pipefail
cd "$(dirname "$0")/../../.."
set=${1:-runs/calibrations/paper/best.txt}
folder=inputs/paper_identified

# NAME [FACTOR]: the parameter times the factor, to the digits of the calibration, so that the beds are the same ones.
value() {
  awk -v name="$1" -v factor="${2:-1}" '$1 == "#" && $2 == name { printf "%.10g", $4 * factor; found = 1 } END { exit !found }' "$set" ||
    { echo "paper_identified.sh: $set has no parameter $1" >&2; exit 1; }
}
scene() {  # NAME BASE TITLE: its text follows on stdin
  {
    printf '# Calibrated to the results of [Lin25], not published in it: docs/paper.md. Made by docs/data/remake/paper_identified.sh; published numbers are in the base.\n'
    printf '#   ./footfall run %s/%s.toml\n\nbase = "%s"\ntitle = "%s, identified"\n\n' "$folder" "$1" "$2" "$3"
    cat
  } >"$folder/$1.toml"
  echo "$folder/$1.toml"
}
auxiliary() {  # FORCE1 LENGTH1 FORCE2 LENGTH2: crush stages of both auxiliary struts
  for side in left right; do
    printf '[[struts]]\nname = "leg_{leg}_%s"\nhoneycomb = { stages = [{ force = %s, length = %s }, { force = %s, length = %s }] }\n' "$side" "$@"
  done
}

mkdir -p "$folder"
scene scene legs.toml "MR landing" <<TEXT
$(auxiliary "$(value aux_force 3000)" "$(value aux_length 0.10)" "$(value aux_force 6000)" "$(value aux_length 0.08)")
[[struts]]
name = "leg_{leg}_primary"
gas = { piston_diameter = $(value piston) }

[[bodies]]
name = "footpad_{leg}"
shape = { radius = $(value pad_radius) }

[[controllers]]
name = "lander"
touchdown_acceleration = $(value soft_until)

[particles]
variables = { width = $(value bed_width), grain_poisson = $(value pad_poisson) }
bed = { variables = { width = $(value bed_width), depth = $(value bed_depth), pour_friction = $(value pour_friction) } }
TEXT
scene two_two scene.toml "MR landing, 2-2" <<TEXT
[initial]
pitch_deg = $(value tilt_22)
TEXT
scene one_two_one scene.toml "MR landing, 1-2-1" <<TEXT
[initial]
roll_deg = $(value tilt_121)
pitch_deg = $(value tilt_121)
TEXT
pads() {
  cat <<TEXT
[[bodies]]
name = "footpad_{leg}"
shape = { radius = $(value drop_pad) }

[particles]
variables = { grain_poisson = $(value pad_poisson) }
bed = { variables = { pour_friction = $(value pour_friction) } }
TEXT
}
scene validation_drop legs_drop.toml "Validation drop" <<TEXT
$(auxiliary "$(value drop_aux 15e3)" 0.10 "$(value drop_aux 30e3)" 0.08)
[[struts]]
name = "leg_{leg}_primary"
honeycomb = { stages = [{ force = $(value drop_primary 35e3), length = 0.20 }, { force = $(value drop_primary 70e3), length = 0.15 }] }

$(pads)
TEXT
scene validation_drop_rigid legs_drop_rigid.toml "Validation drop, rigid lander" <<TEXT
$(pads)
TEXT
