#!/usr/bin/env bash
# audit_scenes.sh FOOTFALL SOURCE OUT short|whole: footfall run --audit on every scene of inputs/ and examples/ that touches grains, short and on beds that are
# poured in seconds, scenes of the examples as their own tests do. Scenes that differ in numbers alone (sweeps, validation) stand on these.
set -u
footfall=$1 source=$2 out=$3 part=$4
failed=0
rm -rf "$out/runs"
mkdir -p "$out"
audited=()
# audit SCENE [OPTION...]
audit() {
  local scene=$1 name=${#audited[@]}_${1//\//_}
  shift
  audited+=("$scene")
  "$footfall" run "$source/$scene" --audit --out "$out/runs/$name" "$@" >"$out/$name.txt" 2>&1
  local code=$?
  if ((code != 0)) || ! grep -qE '^grains: linear momentum .* holds$' "$out/$name.txt"; then
    echo "$scene: exit code $code"; cat "$out/$name.txt"; failed=1
  else
    echo "$scene: $(tail -n 1 "$out/$name.txt")"
  fi
}
small_box=(--set particles.box.size=[3.2,3.2] --set particles.box.depth=0.2 --set particles.box.radius=0.05 --set particles.box.zones.0.size=[0.4,0.4] --set particles.box.zones.0.depth=0.06
  --set particles.box.pour.settle_time=0.05)
small_bed=(--set particles.bed.variables.depth=0.1 --set particles.bed.variables.settle=0.2)
audit inputs/accuracy/scenes/loose.toml --windows 100
audit inputs/accuracy/scenes/loose.toml --windows 100 --scheme tangent --ranks 2
audit inputs/accuracy/scenes/flexible_pad.toml --windows 60
[[ $part == whole ]] || exit $failed
audit inputs/accuracy/scenes/two_mass.toml --windows 100
audit inputs/accuracy/scenes/lattice.toml --windows 100
audit inputs/accuracy/scenes/linear.toml --windows 100
audit inputs/accuracy/scenes/bed.toml --until 0.01 "${small_bed[@]}"
audit inputs/dropped_sphere --until 0.05 --set bodies.ball.shape.radius=0.07 --set particles.variables.width=0.42 \
  --set particles.bed.variables.width=0.42 --set particles.bed.variables.depth=0.2 --set particles.bed.variables.settle=0.5
audit inputs/landing_mr --until 0.008 "${small_box[@]}"
audit inputs/landing_script --until 0.008 "${small_bed[@]}" --set particles.variables.width=0.5 --set particles.bed.variables.width=0.5 \
  --set particles.bed.variables.fine=0.5 --set particles.bed.variables.fine_depth=0.1
audit inputs/landing_clumps --until 0.008 "${small_box[@]}"
audit examples/flexible_rake --until 0.08 --set particles.bed.variables.settle=0.2 --set particles.bed.variables.depth=0.03
audit examples/01_pendulum --until 0.5
audit examples/02_wheel --until 0.05
audit examples/03_scoop --until 0.4
audit examples/04_arm --until 0.7             # its plate touches at 0.5 s
audit examples/05_auger --until 0.06
audit inputs/landing_soils --until 0.03
audit examples/06_gripper --until 0.3
audit examples/07_rover --until 0.0532          # ends within a window
audit examples/08_touchdown --until 0.2503
box() { echo "--set particles.box.size=$1 --set particles.box.depth=$2"; }
audit inputs/rigs/scenes/plate.toml --until 0.06 $(box [0.24,0.24] 0.06)
audit inputs/rigs/scenes/cone.toml --until 0.12 $(box [0.16,0.16] 0.1) --set bodies.cone.shape.scale=0.03
audit inputs/rigs/scenes/wheel.toml --until 0.04 $(box [0.54,0.14] 0.05)
audit inputs/rigs/scenes/shear.toml --until 0.05 $(box [0.24,0.24] 0.05)
# The gate stands: grains lean on it.
audit inputs/rigs/scenes/repose.toml --until 0.1 --set 'joints.draw.motion.x.polynomial=[0,0]' $(box [0.32,0.08] 0.06) --set 'particles.box.pit=[0,0.16]' --set particles.box.pit_depth=0.04 \
  --set 'bodies.gate.shape.size=[0.01,0.078,0.08]'
audit inputs/rigs/scenes/sphere.toml --until 0.04 $(box [0.24,0.24] 0.12) --set bodies.ball.shape.radius=0.04
audit inputs/rigs/scenes/rft.toml --until 0.1 $(box [0.42,0.1] 0.12)
audit inputs/ground_fits/pad.toml --until 0.02 $(box [0.8,0.8] 0.2) --set particles.box.zones.0.depth=0.1
audit inputs/starters/penetrator --until 0.05
audit inputs/starters/seesaw --until 0.8
audit inputs/starters/blade --until 0.3
audit inputs/public_lander --until 0.03 --set particles.box.radius=0.07
# Coarser grains; the tray has the depth of the bed.
audit inputs/rigs/scenes/box.toml --until 0.01 --set particles.box.radius=0.01
audit inputs/laws/scenes/janssen.toml --until 0.01 --set particles.bed.variables.fill=0.05
audit inputs/laws/scenes/driven_wheel.toml --until 0.04 --set 'particles.box.size=[1.2,0.2]' --set particles.box.depth=0.04
audit inputs/laws/scenes/pad.toml --until 0.02 $(box [0.3,0.3] 0.08)
audit inputs/laws/scenes/moved_pad.toml --until 0.02 $(box [0.3,0.3] 0.08)
# All grains free: grains that stand still take momentum, as walls do, and are not counted.
audit inputs/laws/scenes/frozen_floor.toml --until 0.01 --set particles.variables.frozen=-1 --set particles.variables.depth=0.06 --set particles.bed.variables.depth=0.06 \
  --set particles.variables.length=0.2 --set particles.bed.variables.length=0.2 --set particles.variables.width=0.2 --set particles.bed.variables.width=0.2

# Every scene with grains is there; the reference scene names every key and is run by its own test.
while IFS= read -r file; do
  scene=${file#"$source/"}
  scene=${scene%/scene.toml}
  [[ " ${audited[*]} inputs/reference " == *" $scene "* ]] || { echo "$scene: touches grains and is not audited"; failed=1; }
done < <(grep -rlE '^(ground = \{ )?kind = "particles"' "$source/inputs" "$source/examples" --include=*.toml)
exit $failed
