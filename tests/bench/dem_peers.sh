#!/usr/bin/env bash
# Processor and wall time of grains alone: liggghts_mbd, stock LIGGGHTS, LAMMPS and Yade on one packing, in turn, A B C D A B C D ...; medians over the rounds and
# their ratio to the best of the others.
#   tests/bench/dem_peers.sh BUILD [-n SIDE] [-s STEPS] [-r ROUNDS] [-p RANKS] [-o MODEL]
#     -n  spheres along a side of the periodic cube (default 34: 39 304 spheres)      -s  steps (default 2000)      -r  rounds (default 5)
#     -p  MPI ranks (default 1; Yade takes as many OpenMP threads)
#     -o  friction (Hertz with tangential history, the default), rolling (with rolling resistance, LIGGGHTS: cdt, as in all beds of footfall; LAMMPS: granular with rolling sds; Yade: Mindlin with moments)
# Needs what `./footfall run` installs, and of Debian's packages lammps and yade those that are to be compared; a missing one is left out and named.
# The packing is a compressed, jittered lattice with random velocities: five to six contacts a sphere, which break and form.
set -euo pipefail
export LC_ALL=C.UTF-8  # decimal points of awk
(($# >= 1)) || { sed -n '2,10p' "$0"; exit 2; }
build=$(realpath "$1"); shift
side=34 steps=2000 rounds=5 ranks=1 model=friction
while getopts n:s:r:p:o: option; do
  case $option in
    n) side=$OPTARG ;; s) steps=$OPTARG ;; r) rounds=$OPTARG ;; p) ranks=$OPTARG ;; o) model=$OPTARG ;; *) exit 2 ;;
  esac
done
[[ $model == friction || $model == rolling ]] || { echo "-o $model: expected friction or rolling" >&2; exit 2; }
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
((EUID)) || export OMPI_ALLOW_RUN_AS_ROOT=1 OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1
cd "$work"

# Radius 1 cm, spacing 1.997 radii: overlaps of 0.3 % of a radius and a jitter of the same size. Young's modulus 50 MPa, Poisson's ratio 0.3, density 2500 kg/m3.
awk -v n="$side" 'BEGIN {
  srand(7); d = 0.02; a = 0.9985 * d; L = n * a
  printf "Lattice of spheres\n\n%d atoms\n1 atom types\n0 %.9g xlo xhi\n0 %.9g ylo yhi\n0 %.9g zlo zhi\n\nAtoms\n\n", n^3, L, L, L
  for (i = 0; i < n; ++i) for (j = 0; j < n; ++j) for (k = 0; k < n; ++k) {
    j1 = 1.5e-5 * (2 * rand() - 1); j2 = 1.5e-5 * (2 * rand() - 1); j3 = 1.5e-5 * (2 * rand() - 1)
    printf "%d 1 %.9g 2500 %.9g %.9g %.9g\n", ++id, d, (i + 0.5) * a + j1, (j + 0.5) * a + j2, (k + 0.5) * a + j3
  }
  printf "\nVelocities\n\n"
  for (id = 1; id <= n^3; ++id) printf "%d %.9g %.9g %.9g 0 0 0\n", id, 0.1 * (rand() - 0.5), 0.1 * (rand() - 0.5), 0.1 * (rand() - 0.5)
}' >packing.data

common="units si
boundary p p p
newton off
processors * * 1
read_data packing.data
neighbor 0.002 bin
neigh_modify delay 0
timestep 1e-5"
motion="fix move all nve/sphere
thermo 1000000
run $steps"
rolling='' && [[ $model == friction ]] || rolling=' rolling_friction cdt'
cat >in.liggghts <<END
atom_style granular
atom_modify map array
communicate single vel yes
$common
fix m1 all property/global youngsModulus peratomtype 5e7
fix m2 all property/global poissonsRatio peratomtype 0.3
fix m3 all property/global coefficientRestitution peratomtypepair 1 0.5
fix m4 all property/global coefficientFriction peratomtypepair 1 0.5
fix m5 all property/global coefficientRollingFriction peratomtypepair 1 0.1
pair_style gran model hertz tangential history$rolling
pair_coeff * *
$motion
END
# Kn = 4/3 E*, Kt = 8 G* of the same material; damping for a restitution of 0.5.
pair="pair_style gran/hertz/history 3.66e7 4.52e7 2.0e5 1.0e5 0.5 1
pair_coeff * *"
[[ $model == friction ]] || pair="pair_style granular
pair_coeff * * hertz/material 5e7 0.44 0.3 tangential mindlin NULL 1.0 0.5 rolling sds 1e3 1e-2 0.1 damping tsuji"
cat >in.lammps <<END
atom_style sphere
comm_modify vel yes
$common
$pair
$motion
END
cat >in_yade.py <<END
from yade import utils
import random
random.seed(12345)
rolling = "$model" == "rolling"
lines = open("packing.data").read().split("Atoms")[1].split("Velocities")[0].split("\n")
O.periodic = True
size = $side * 0.9985 * 0.02
O.cell.setBox(size, size, size)
O.materials.append(FrictMat(young=5e7, poisson=0.3, density=2500, frictionAngle=0.4636))
for line in lines:
    w = line.split()
    if len(w) == 7:
        O.bodies.append(utils.sphere([float(x) for x in w[4:7]], 0.5 * float(w[2])))
for b in O.bodies:
    b.state.vel = [random.uniform(-0.05, 0.05) for _ in range(3)]
contact = Ip2_FrictMat_FrictMat_MindlinPhys(en=0.5, krot=0.1 if rolling else 0.0, eta=0.1)
O.engines = [ForceResetter(), InsertionSortCollider([Bo1_Sphere_Aabb()], verletDist=0.001),
             InteractionLoop([Ig2_Sphere_Sphere_ScGeom()], [contact], [Law2_ScGeom_MindlinPhys_Mindlin(includeMoment=rolling)]),
             NewtonIntegrator(damping=0)]
O.dt = 1e-5
O.run($steps, True)
import os
os._exit(0)
END

mpi="mpirun --oversubscribe --bind-to none -np $ranks"
declare -A command=(
  [liggghts_mbd]="$mpi $build/bin/liggghts_mbd -in in.liggghts -log none" [liggghts]="$mpi liggghts -in in.liggghts -log none"
  [lammps]="$mpi lmp -in in.lammps -log none" [yade]="yade -n -x -j$ranks in_yade.py")
names=(liggghts_mbd)
for name in liggghts:liggghts lammps:lmp yade:yade; do
  if command -v "${name#*:}" >/dev/null; then names+=("${name%:*}"); else echo "left out, not installed: ${name%:*}"; fi
done
for round in $(seq "$rounds"); do
  for name in "${names[@]}"; do
    TIMEFORMAT='%R %U %S'
    { time ${command[$name]} >"$name.out" 2>&1 </dev/null; } 2>time || { tail -n 20 "$name.out" >&2; echo "$name failed" >&2; exit 1; }
    awk -v name="$name" '{ print name, $1, $2 + $3 }' time >>times
  done
done
echo "$((side ** 3)) spheres, $steps steps, $model, $ranks ranks, $rounds rounds; median and range [s]"
python3 - "${names[@]}" <<'END'
import statistics, sys
rows = [line.split() for line in open("times")]
took = {n: [(float(w), float(p)) for m, w, p in rows if m == n] for n in sys.argv[1:]}
for n, times in took.items():
    print(f"{n:14}", *(f"{what} {statistics.median(t):.2f} ({min(t):.2f} to {max(t):.2f})" for what, t in zip(("wall", "processor"), zip(*times))))
others = [n for n in took if n != "liggghts_mbd"]
for i, what in enumerate(("wall", "processor")):
    ratios = [ours[i] / min(took[o][k][i] for o in others) for k, ours in enumerate(took["liggghts_mbd"])]
    print(f"{what} time over the best of the others: {statistics.median(ratios):.2f} ({min(ratios):.2f} to {max(ratios):.2f})")
END
