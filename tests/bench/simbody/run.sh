#!/usr/bin/env bash
# The same rigid lander in footfall and in Simbody 3.7: agreement of strokes and height, and error against processor time of both in one picture.
#   tests/bench/simbody/run.sh BUILD [OUT [REPEATS]]      needs libsimbody-dev, python3, valgrind and gnuplot; footfall itself needs none of them
# OUT (default runs/simbody) gets simbody.csv, simbody.md and simbody.png, and simbody_sampled.csv and .md with voltages that change every millisecond. Runs of both take turns; the shortest time of REPEATS (default 5) counts.
set -euo pipefail
here=$(cd "$(dirname "$0")" && pwd) solver=$(realpath "$1")/bin/mbd_solver
out=${2:-runs/simbody} repeats=${3:-5}
mkdir -p "$out"; out=$(realpath "$out")
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
g++ -w -O2 -std=c++17 -I/usr/include/simbody "$here/lander.cpp" -o "$work/lander" -lSimTKsimbody -lSimTKmath -lSimTKcommon
python3 "$here/compare.py" "$solver" "$work/lander" "$here" "$work" "$out" "$repeats"
gnuplot <<END
set terminal pngcairo size 900,600
set output "$out/simbody.png"
set logscale xy
set xlabel "processor time of one second [s]"
set ylabel "error of height and strokes [-]"
set format y "10^{%L}"
set grid
set datafile separator ","
plot "< grep '^footfall' '$out/simbody.csv'" using 4:3 with linespoints lw 2 title "footfall, one\\\\_step", \
     "< grep '^cpodes' '$out/simbody.csv'" using 4:3 with linespoints lw 2 title "Simbody, CPodes"
END
cat "$out"/simbody{,_instructions,_sampled}.md
