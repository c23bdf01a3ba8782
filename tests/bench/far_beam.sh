#!/usr/bin/env bash
# What beams away from the grains cost: processor time (user + system) of liggghts_mbd on a moving bed under a coupled plate, with and without
# BEAMS beams of 20 segments that come down beside the plate and stay clear of the grains. Runs in turns, A B A B ...; ratio pair by pair, then the
# median and the ratio of the shortest times, which what else runs on the machine disturbs least.
#   tests/bench/far_beam.sh BUILD [PAIRS] [BEAMS] [STEPS] [STEPS per window]        needs the target beam_partner
set -euo pipefail
build=$(cd "$1" && pwd) pairs=${2:-9} beams=${3:-1} steps=${4:-4000} every=${5:-10}
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
cd "$work"
model="model hertz tangential history rolling_friction cdt"
pair_of() { echo "fix m_$1 all property/global $1 peratomtypepair 2 $2 $2 $2 $2"; }

{ cat <<END
atom_style granular
atom_modify map array
boundary f f f
newton off
communicate single vel yes
units si
region box block -0.26 0.26 -0.26 0.26 0 0.8 units box
create_box 2 box
neighbor 0.01 bin
neigh_modify delay 0
fix m_young all property/global youngsModulus peratomtype 35e6 35e6
fix m_poisson all property/global poissonsRatio peratomtype 0.25 0.25
$(pair_of coefficientRestitution 0.3)
$(pair_of coefficientFriction 0.44)
$(pair_of coefficientRollingFriction 0.05)
timestep 2e-5
pair_style gran $model
pair_coeff * *
lattice sc 0.0299
region heap block -0.25 0.25 -0.25 0.25 0.014 0.51 units box
create_atoms 1 region heap
set group all diameter 0.03 density 2600
velocity all set 0.1 0.05 0
fix floor all wall/gran $model primitive type 1 zplane 0
fix g all gravity 9.81 vector 0 0 -1
fix integrate all nve/sphere
thermo 1000
fix geo all couple/mbd/geometry body plate
fix plate all mesh/surface fix geo type 2
fix plates all wall/gran $model mesh n_meshes 1 meshes plate
END
} > in.bed
coupling="fix mbd all couple/mbd every $every mesh plate plate"
{ cat in.bed; echo "$coupling"; echo "run $steps"; } > in.without
{ cat in.bed
  printf 'fix w all wall/gran/beam %s type 2' "$model"; for b in $(seq "$beams"); do printf ' body tine%d' "$b"; done; echo
  echo "$coupling"; echo "run $steps"; } > in.with
awk -v beams="$beams" -v end="$(awk -v n="$steps" 'BEGIN { printf "%.10g", n * 2e-5 }')" 'BEGIN { print "end", end
    print "body plate\nnode -0.01 -0.01 0.79\nnode 0.01 -0.01 0.79\nnode 0 0.01 0.79\ntriangle 0 1 2\nvelocity 0 0 -1"
  for (b = 1; b <= beams; ++b) { print "body tine" b
    for (i = 0; i <= 20; ++i) print "node", -0.25 + 0.025 * i, 0.02 * (b % 12) - 0.1, 0.75
    for (i = 0; i < 20; ++i) print "segment", i, i + 1, 0.01, 0
    print "velocity 0 0 -1\nspin 0 0 1" } }' > motion.txt

# Processor time of LIGGGHTS alone: the shell around it counts its children.
cat > timed.sh <<'END'
"$@" > /dev/null; code=$?
times > children
awk -F'[ms ]+' 'NR == 2 { print 60 * $1 + $2 + 60 * $3 + $4 }' children > cpu
exit $code
END
mpi="mpirun --allow-run-as-root --oversubscribe --bind-to none"
cpu_of() { rm -f cpu; "$@" > out 2>&1 || { cat out >&2; exit 1; }; cat cpu; }
for pair in $(seq "$pairs"); do
  for case in with without; do
    cpu_of $mpi -np 1 bash timed.sh "$build/bin/liggghts_mbd" -in in.$case : -np 1 "$build/bin/beam_partner" motion.txt loads.csv > $case
  done
  awk -v a="$(cat with)" -v b="$(cat without)" 'BEGIN { printf "with %.3f s  without %.3f s  ratio %.4f\n", a, b, a / b }' | tee -a pairs.txt
done
awk -v beams="$beams" '{ a[NR] = $8; if (NR == 1 || $2 < with) with = $2; if (NR == 1 || $5 < without) without = $5 }
  END { n = asort_(a, NR); printf "%d beam%s away from the grains: median %+.2f %%, shortest times %+.2f %%\n", beams, (beams > 1 ? "s" : ""), 100 * (a[int((n + 1) / 2)] - 1), 100 * (with / without - 1) }
  function asort_(a, n,   i, j, t) { for (i = 2; i <= n; ++i) for (j = i; j > 1 && a[j] < a[j - 1]; --j) { t = a[j]; a[j] = a[j - 1]; a[j - 1] = t } return n }' pairs.txt
