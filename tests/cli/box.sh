#!/usr/bin/env bash
# box.sh FOOTFALL OUT: a bed by numbers, [particles.box]: what it holds, and that it is the same run as its scripts taken over, and as a script that
# somebody writes by hand: history and energies of the grains byte by byte.
set -u
footfall=$1 out=$2 reference=$(cd "$(dirname "$0")/../../inputs/reference" && pwd)
die() { echo "box.sh: $*"; exit 1; }
rm -rf "$out" && mkdir -p "$out" && cd "$out" || die "cannot make $out"
mechanism='end_time = 0.03
[[bodies]]
name = "plate"
mass = 0.5
shape = { kind = "cylinder", centre = [0, 0, 0.01], radius = 0.04, length = 0.01 }
[[bodies]]
name = "tine"
mass = 0.1
shape = { kind = "capsule", from = [0.05, -0.03, 0.01], to = [0.05, 0.03, 0.01], diameter = 0.01 }
[[boundaries]]
body = "plate"
surface = { element_size = 0.02 }
[[boundaries]]
body = "tine"
beams = { radius = 0.005, points = [[0.05, -0.03, 0.01], [0.05, 0.03, 0.01]] }
[ground]
kind = "particles"
[initial]
velocity = [0, 0, -1]
[output]
plots = false'
cat >box.toml <<TOML
$mechanism
[particles]
ranks = 1
[particles.box]
size = [0.2, 0.16]
depth = 0.05
radius = [0.007, 0.009]
every = 3
TOML
run() { "$footfall" run "$1.toml" --quiet --out "$1" >"$1.txt" 2>&1 || { cat "$1.txt"; die "the run of $1.toml failed"; }; }
run box

# What is in the bed: check tells it, and the dump of the bed agrees.
"$footfall" check box.toml >check.txt || die "the scene is refused"
cat check.txt
grep -q "floor at z = -0.05 m, surface at z = 0; about" check.txt || die "check does not tell floor and surface"
bed=$(tail -n 1 check.txt | tr -d ' ')
[[ -s $bed/bed.restart.grains ]] || die "check does not tell where the bed is"
# Surface: nothing stands above it by more than a quarter radius, and most of it is less than a radius and a half below. Solid fraction: a loose bed
# of spheres has 0.54 to 0.60, less beside walls, which are near everywhere in this one.
awk -v depth=0.05 -v lx=0.2 -v ly=0.16 '
  /^ITEM/ { atoms = /ATOMS/; next }
  atoms && NF == 4 {
    n++; z = $3; r = $4; if (z + r > top) top = z + r; if (z - r < -depth) low = z - r + depth
    small += r < 0.008
    cell = int(($1 + lx / 2) / 0.02) "," int(($2 + ly / 2) / 0.02); if (!(cell in high) || z + r > high[cell]) high[cell] = z + r
    a = -0.75 * depth - z; b = -0.25 * depth - z; if (a < -r) a = -r; if (b > r) b = r
    if (b > a) volume += 3.14159265 * (r * r * (b - a) - (b ^ 3 - a ^ 3) / 3)
    mass_small += r < 0.008 ? r ^ 3 : 0; mass += r ^ 3
  }
  END {
    fraction = volume / (lx * ly * 0.5 * depth)
    for (c in high) { sum += high[c]; cells++ }
    printf "%d grains, fraction %.3f, top %.4f, mean surface %.4f, share of small ones %.2f\n", n, fraction, top, sum / cells, mass_small / mass
    if (top > 0.002 || low < -0.001) { print "the bed reaches too high or too low"; exit 1 }
    if (sum / cells < -0.012) { print "its surface lies too low"; exit 1 }
    if (fraction < 0.48 || fraction > 0.62) { print "it is not packed as poured spheres are"; exit 1 }
    if (mass_small / mass < 0.4 || mass_small / mass > 0.6) { print "the two radii do not share the mass"; exit 1 }
  }' "$bed/bed.restart.grains" || die "the bed is not what was asked for"
grains=$(awk '/^ITEM/ { atoms = /ATOMS/; next } atoms && NF == 4 { n++ } END { print n }' "$bed/bed.restart.grains")
grep -q "the bed is made: $grains grains" check.txt || die "check tells another number of grains than $grains"

# Taken over: the kept scripts in the place of the box.
for file in in.bed in.grains material.lammps walls.lammps energy.lammps particles.toml; do
  [[ -s box/script/$file ]] || die "box/script/$file is missing"
done
cp -r box/script . && { echo "$mechanism"; cat script/particles.toml; } >taken.toml
run taken

# By hand: no variable but ${bed} and ${out}, no loop, no include.
dt=$(sed -n 's/^dt = "\(.*\)"/\1/p' script/particles.toml | head -n 1)
cat >hand.in <<LIGGGHTS
atom_modify map array
newton off
communicate single vel yes
units si
hard_particles yes
processors * * 1
read_restart \${bed}
neighbor 0.0024 bin
neigh_modify delay 0
fix young    all property/global youngsModulus peratomtype 1e7 2e11
fix poisson  all property/global poissonsRatio peratomtype 0.3 0.3
fix restitution all property/global coefficientRestitution peratomtypepair 2 0.3 0.3 0.3 0.3
fix friction all property/global coefficientFriction peratomtypepair 2 0.5 0.5 0.5 0.5
fix rolling  all property/global coefficientRollingFriction peratomtypepair 2 0.2 0.2 0.2 0.2
pair_style gran model hertz tangential history rolling_friction cdt
pair_coeff * *
fix floor all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 zplane -0.05
fix wall_x1 all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 xplane -0.1
fix wall_x2 all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 xplane 0.1
fix wall_y1 all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 yplane -0.08
fix wall_y2 all wall/gran model hertz tangential history rolling_friction cdt primitive type 1 yplane 0.08
timestep $dt
fix gravity all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere
fix geo all couple/mbd/geometry body plate
fix plate all mesh/surface fix geo type 2
fix touch all wall/gran model hertz tangential history rolling_friction cdt mesh n_meshes 1 meshes plate
fix beam all wall/gran/beam model hertz tangential history rolling_friction cdt type 2 body tine
fix mbd all couple/mbd every 3 mesh plate plate
run 1000000000
LIGGGHTS
{
  echo "$mechanism"
  sed -n '/^\[particles.bed\]/,$p' script/particles.toml >bed.toml
  printf '[particles]\nscript = "hand.in"\nranks = 1\nsurface_height = 0\n'
  cat bed.toml
} >hand.toml
run hand
rows=$(wc -l <box/history.csv)
((rows > 20)) || die "the history has hardly a row"
awk -F, 'NR > 1 && $0 ~ /nan/ { exit 1 }' box/history.csv || die "a number is none"
for other in taken hand; do
  cmp box/history.csv "$other/history.csv" || die "the run of $other.toml is another one"
done
cmp box/grains_energy.txt taken/grains_energy.txt || die "the grains of taken.toml have another energy"

# A mesh of the script, taken over as it stands there: LIGGGHTS compares it with the scene's, triangle by triangle.
cp "$reference/rock.stl" . || die "rock.stl is missing"
sed 's|^fix geo .*||; s|^fix plate .*|fix plate all mesh/surface file rock.stl type 2 scale 0.0005 rotate axis 1 1 0 angle 40 move 0 0 0.02|' hand.in >mesh.in
{
  echo "$mechanism" | sed 's|surface = .*|surface = { from_script = "plate" }|; s|end_time = .*|end_time = 0.003|'
  printf '[particles]\nscript = "mesh.in"\nranks = 1\nsurface_height = 0\n'
  cat bed.toml
} >mesh.toml
run mesh
exit 0
