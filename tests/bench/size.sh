#!/usr/bin/env bash
# What a step costs against the size of a mechanism: chains of rigid bodies, rigid landers with more and more legs, and ten flexible rods with more and more
# modes, along an axis of their frames and askew. Instructions of the whole program by valgrind, which do not depend on what else runs: the difference of two runs
# of fixed steps, so without the start.
# How many evaluations Newton needs for a step is a matter of the motion (a long chain falls otherwise than a short one), so the cost of one evaluation, with its
# share of all else, is told as well.
#   tests/bench/size.sh BUILD [OUT]      OUT (default runs/size) gets size.csv, size.md and size.png. Needs valgrind and gnuplot.
set -euo pipefail
export LC_ALL=C.UTF-8  # decimal points of awk
root=$(realpath "$(dirname "$0")/../..")
solver=$(realpath "$1")/bin/mbd_solver out=${2:-runs/size}
mkdir -p "$out"; out=$(realpath "$out")
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT

# chain BODIES MODES DIRECTION: a chain of rods, each 0.2 m with so many modes, that hangs in this direction from a ball joint and falls.
chain() {
  awk -v n="$1" -v modes="$2" -v direction="$3" 'function at(i) { return sprintf("[%g, %g, %g]", 0.2 * i * along[1], 0.2 * i * along[2], 0.2 * i * along[3]) }
  BEGIN {
    split(direction, along, " ")
    print "title = \"chain\"\nend_time = 1\ngravity = [0, 0, -9.81]\n[materials.steel]\ndensity = 7850\nyoung = 2.1e11\npoisson = 0.3"
    for (i = 1; i <= n; ++i) {
      printf "[[bodies]]\nname = \"rod_%d\"\nmaterial = \"steel\"\nshape = { kind = \"rod\", from = %s, to = %s, diameter = 0.02 }\n", i, at(i - 1), at(i)
      if (modes > 0) printf "flexible = { modes = %d, elements = 24 }\n", modes
    }
    for (i = 1; i <= n; ++i) {
      before = i == 1 ? "ground" : "rod_" (i - 1)
      printf "[[joints]]\nname = \"joint_%d\"\nkind = \"%s\"\nbodies = [\"%s\", \"rod_%d\"]\npoint = %s\n", i, i % 2 ? "spherical" : "revolute", before, i, at(i - 1)
      if (i % 2 == 0) print "axis = \"y\""
    }
    print "[solver]\nerror_control = false\nmax_step = 5e-4\n[output]\ninterval = 1\nplots = false\nvtk = false"
  }' > "$work/scene.toml"
}
# lander LEGS: inputs/rigid_plane with so many legs, a cabin and seven bodies each, which all touch the plane. Pads of 16 cm: 57 stand
# next to each other.
lander() {
  cat > "$work/scene.toml" <<END
base = "$root/inputs/rigid_plane"
total_mass = $((300 * $1))
flexible = false
[arrays.leg]
count = $1
step_deg = $(awk -v n="$1" 'BEGIN { print 360 / n }')
[[bodies]]
name = "footpad_{leg}"
shape = { kind = "disc", centre = [1.75, 0, 0], axis = [0, 0, 1], radius = 0.08, thickness = 0.008 }
[[struts]]
name = "leg_{leg}_primary"
mr = { controller = "lander.U1" }
[solver]
error_control = false
max_step = 5e-4
[output]
interval = 1
plots = false
vtk = false
END
}
instructions() {  # UNTIL: instructions and evaluations
  rm -rf "$work/run"
  valgrind --tool=callgrind --callgrind-out-file="$work/callgrind" "$solver" "$work/scene.toml" --quiet --keep-every 0 --until "$1" --out "$work/run" > "$work/log" 2>&1 || { cat "$work/log" >&2; exit 1; }
  echo "$(sed -n 's/^\(summary\|totals\): //p' "$work/callgrind" | head -n 1) $(sed -n 's/^ *"residuals": \([0-9]*\),$/\1/p' "$work/run/summary.json")"
}
# kind, size (what grows), of the scene that was written
measure() {
  local few many
  few=$(instructions 0.01) many=$(instructions 0.02)
  echo "$few $many" | awk -v kind="$1" -v size="$2" '{ printf "%s,%d,%.4g,%.4g,%.4g\n", kind, size, ($3 - $1) / 20, ($4 - $2) / 20, ($3 - $1) / ($4 - $2) }' | tee -a "$out/size.csv"
}

echo "kind,size,instructions_per_step,evaluations_per_step,instructions_per_evaluation" > "$out/size.csv"
for n in 10 20 50 100 200 400; do chain "$n" 0 "1 0 0"; measure bodies "$n"; done
for n in 2 4 7 14 28 57; do lander "$n"; measure lander $((1 + 7 * n)); done
for m in 0 5 10 20 30 50; do chain 10 "$m" "1 0 0"; measure modes $((10 * m)); done
for m in 0 5 10 20 30 50; do chain 10 "$m" "0.6 0.48 0.64"; measure askew $((10 * m)); done

slope() {  # of kind $1 between sizes $2 and $3, on logarithmic scales: of a step, of an evaluation
  awk -F, -v kind="$1" -v a="$2" -v b="$3" '$1 == kind { step[$2] = $3; one[$2] = $5 }
    END { printf "%.2f (%.2f)", log(step[b] / step[a]) / log(b / a), log(one[b] / one[a]) / log(b / a) }' "$out/size.csv"
}
# The straight line through an evaluation's cost, a + b size, with the least relative squares: how far the costs are from it at most [%].
from_line() {
  awk -F, -v kind="$1" '$1 == kind { n++; x[n] = $2; y[n] = $5; w = 1 / ($5 * $5); s += w; sx += w * $2; sxx += w * $2 * $2; sy += w * $5; sxy += w * $2 * $5 }
    END { b = (s * sxy - sx * sy) / (s * sxx - sx * sx); a = (sy - b * sx) / s
          for (i = 1; i <= n; ++i) { d = y[i] / (a + b * x[i]) - 1; if (d < 0) d = -d; if (d > most) most = d } printf "%.0f", 100 * most }' "$out/size.csv"
}
{
  echo "| what grows | size | instructions of a step | evaluations of a step | instructions of an evaluation | for each of what grows |"
  echo "|---|---|---|---|---|---|"
  awk -F, 'BEGIN { name["bodies"] = "bodies of a chain"; name["lander"] = "bodies of a lander"; name["modes"] = "modes"; name["askew"] = "modes, rods askew" }
    NR > 1 { printf "| %s | %d | %.2e | %.1f | %.2e | %s |\n", name[$1], $2, $3, $4, $5, ($2 > 0 ? sprintf("%.2e", $5 / $2) : "-") }' "$out/size.csv"
  printf '\nSlopes on logarithmic scales, of a step and in brackets of an evaluation: %s from 10 to 100 bodies, %s from 100 to 400; of a lander %s from 15 to 99 and %s from 99 to 400; %s from 50 to 200 modes, %s from 200 to 500; askew %s and %s. ' \
    "$(slope bodies 10 100)" "$(slope bodies 100 400)" "$(slope lander 15 99)" "$(slope lander 99 400)" "$(slope modes 50 200)" "$(slope modes 200 500)" "$(slope askew 50 200)" "$(slope askew 200 500)"
  printf 'From the straight line with the least relative squares the cost of an evaluation is %s %% away at most with bodies of a chain, %s %% with bodies of a lander, %s %% with modes, %s %% with modes of rods askew.\n' \
    "$(from_line bodies)" "$(from_line lander)" "$(from_line modes)" "$(from_line askew)"
} > "$out/size.md"
gnuplot <<END
set terminal pngcairo size 900,600
set output "$out/size.png"
set logscale xy
set xlabel "bodies, or modes of ten bodies together"
set ylabel "instructions of an evaluation"
set format y "10^{%L}"
set grid
set key left top
set datafile separator ","
plot "< grep '^bodies' '$out/size.csv'" using 2:5 with linespoints lw 2 title "rigid bodies in a chain", \
     "< grep '^lander' '$out/size.csv'" using 2:5 with linespoints lw 2 title "rigid lander with 2 to 57 legs", \
     "< grep '^modes' '$out/size.csv' | grep -v ',0,'" using 2:5 with linespoints lw 2 title "modes of ten rods along x", \
     "< grep '^askew' '$out/size.csv' | grep -v ',0,'" using 2:5 with linespoints lw 2 title "modes of ten rods askew", \
     1e4*x dashtype 2 lc rgb "grey" title "linear"
END
cat "$out/size.md"
