#!/usr/bin/env bash
# Remakes docs/data/paper and the pictures of docs/paper.md: the studies of [Lin25]. Hours on two cores; finished runs are kept.
#   docs/data/remake/paper.sh [RUNS]             RUNS: folder of the runs (default runs/paper)
#   docs/data/remake/paper.sh RUNS identified    only the calibrated set, inputs/paper_identified
#   docs/data/remake/paper.sh RUNS assumed       only the legs with which that set was calibrated, inputs/paper_identified/legs.toml
#   docs/data/remake/paper.sh RUNS merge         only the tables and pictures of runs that are there
set -euo pipefail
cd "$(dirname "$0")/../../.."
. docs/data/remake/parts.sh
runs=${1:-runs/paper} what=${2-}
data=docs/data/paper pictures=docs/pictures/paper
sweeps=(paper_on_soil paper_on_small_bed validation_drop_coarse validation_drop validation_sensitivity ground attitudes friction velocity control_fast explanations bed bed_grains)
identified=(validation_drop ground attitudes friction velocity)   # run once more with the scenes of inputs/paper_identified

# SWEEP: the same sweep with the legs of legs.toml; prints its file.
assumed_sweep() {
  local file=$runs/assumed/$1.toml scenes=$PWD/inputs/paper_identified
  mkdir -p "$runs/assumed"
  sed -e "s#\"\.\./landing_script/scene.toml\"#\"$scenes/legs.toml\"#; s#\"\.\./validation_drop/scene.toml\"#\"$scenes/legs_drop.toml\"#" \
    -e "s#\"\.\./validation_drop/rigid.toml\"#\"$scenes/legs_drop_rigid.toml\"#" "inputs/sweeps/$1.toml" >"$file"
  echo "$file"
}
# SWEEP: the same sweep with the calibrated scenes; prints its file.
identified_sweep() {
  local file=$runs/identified/$1.toml scenes=$PWD/inputs/paper_identified
  mkdir -p "$runs/identified"
  sed -e "s#\"\.\./landing_script/scene.toml\"#\"$scenes/scene.toml\"#; s#\"\.\./validation_drop/scene.toml\"#\"$scenes/validation_drop.toml\"#" \
    -e "s#\"\.\./validation_drop/rigid.toml\"#\"$scenes/validation_drop_rigid.toml\"#" \
    -e "s#^settings = \[\"initial.pitch_deg=4\"\]#scene = \"$scenes/two_two.toml\"#" \
    -e "s#^settings = \[\"initial.roll_deg=4\", \"initial.pitch_deg=4\"\]#scene = \"$scenes/one_two_one.toml\"#" "inputs/sweeps/$1.toml" >"$file"
  echo "$file"
}
# FILE OUT: a sweep that need not be complete.
sweep() {
  if [[ $what == merge ]]; then
    [[ ! -d $2/runs ]] || ./footfall sweep "$1" --out "$2" --merge >/dev/null || true
  else
    ./footfall sweep "$1" --out "$2" || echo "paper.sh: $1 is not complete" >&2
  fi
}
# SCENE OUT: a landing with drawings of the grains.
landing() {
  [[ $what != merge ]] || return 0
  ./footfall run "$1" --force --out "$2" --set output.vtk=true --set output.vtk_interval=0.05
  ./footfall view "$2" --pictures --times 0.25 --width 1000
}
# FOLDER TO: the tables of a sweep as one text.
tables() {
  [[ -f $1/cases.md ]] || return 0
  mkdir -p "$(dirname "$2")"
  { cat "$1/cases.md"; [[ ! -f $1/statements.md ]] || { echo; cat "$1/statements.md"; }; } >"$2"
}
# FILE NAME WIDTH: a picture of each set.
pair() {
  keep_picture "$runs/$1" "$pictures/$2.png" "${3:-640}"
  keep_picture "$runs/identified/$1" "$pictures/$2_identified.png" "${3:-640}"
  keep_picture "$runs/assumed/$1" "$pictures/$2_assumed.png" "${3:-640}"
}

if [[ $what == assumed || $what == merge ]]; then
  landing inputs/paper_identified/legs.toml "$runs/assumed/landing"
  for name in "${sweeps[@]:3}"; do
    sweep "$(assumed_sweep "$name")" "$runs/assumed/$name"
    tables "$runs/assumed/$name" "$data/assumed/$name.txt"
  done
  [[ $what == merge ]] || exit 0
fi
if [[ $what != identified ]]; then
  landing inputs/landing_script "$runs/landing"
  for name in "${sweeps[@]}"; do sweep "inputs/sweeps/$name.toml" "$runs/$name"; done
fi
[[ ! -f $runs/landing/grains_0.vtp ]] || python3 docs/data/remake/moving_grains.py "$runs/landing" >"$data/figure10.txt"
landing inputs/paper_identified "$runs/identified/landing"
for name in "${identified[@]}"; do sweep "$(identified_sweep "$name")" "$runs/identified/$name"; done

for name in "${sweeps[@]}"; do tables "$runs/$name" "$data/$name.txt"; done
for name in "${identified[@]}"; do tables "$runs/identified/$name" "$data/identified/$name.txt"; done
pair validation_drop/force.png table2_force
pair validation_drop/depth.png table2_depth
pair landing/pictures/grains_0.2500s.png figure10_grains_0.2500s 720
pair landing/plots/overview.png figure11 900
pair landing/plots/ledger.png ledger
pair ground/acceleration.png figure12a
pair attitudes/acceleration.png figure13a
pair friction/acceleration.png figure14a
pair velocity/acceleration.png figure15a
