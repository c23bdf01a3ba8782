#!/usr/bin/env bash
# Beds of a sweep are made side by side, one for each that differs, once; a bed that cannot be made stops the sweep with LIGGGHTS' own message.
#   sweep_beds.sh FOOTFALL SCENE       SCENE: inputs/dropped_sphere
set -eu
footfall=$1 scene=$2
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
die() { echo "sweep_beds.sh: $*" >&2; cat "$work"/*.txt >&2; exit 1; }
export FOOTFALL_CACHE=$work/cache

# sweep SEEDS: some hundred grains, two windows for each seed of the bed.
sweep() {
  cat > "$work/beds.toml" <<TOML
title = "Beds"
scene = "$scene/scene.toml"
settings = ["particles.ranks=1", "particles.bed.variables.width=0.42", "particles.variables.width=0.42", "bodies.ball.shape.radius=0.07",
  "particles.bed.variables.depth=0.1", "particles.bed.variables.settle=0.1", "particles.bed.variables.rest=0.01"]
[[parameters]]
name = "seed"
settings = ["particles.bed.variables.seed={value}"]
values = [$1]
[[parameters]]
name = "window"
settings = ["particles.variables.every={value}"]
values = [2, 3]
[[figures]]
name = "peak acceleration [g]"
key = "peak_acceleration_g"
TOML
  "$footfall" sweep "$work/beds.toml" --out "$work/sweep" --jobs 2 --list
}
sweep "15485863, 32452843" > "$work/first.txt" 2>&1 || die "the beds were not made"
grep -q "2 beds to make, 2 at once" "$work/first.txt" || die "expected two beds"
(( $(find "$FOOTFALL_CACHE/beds" -name bed.restart | wc -l) == 2 )) || die "expected two beds in the cache"
sweep "15485863, 32452843" > "$work/again.txt" 2>&1 || die "the second call failed"
! grep -q "beds to make" "$work/again.txt" || die "beds were made again"

code=0; sweep "15485863, 4" > "$work/wrong.txt" 2>&1 || code=$?
[[ $code == 2 ]] || die "a wrong seed ended with $code, expected 2"
grep -q "ERROR.*random seed" "$work/wrong.txt" || die "LIGGGHTS' message is missing"
