#!/usr/bin/env bash
# Remakes docs/data/coupling_lattice.txt and its picture: every scheme on fixed grains, and the cost of one percent. Five minutes; finished runs are kept.
#   docs/data/remake/coupling_lattice.sh [RUNS]     RUNS: folder of the runs (default runs/accuracy)
set -euo pipefail
cd "$(dirname "$0")/../../.."
. docs/data/remake/parts.sh
runs=${1:-runs/accuracy}/coupling_lattice
./footfall accuracy inputs/accuracy/coupling_lattice.toml --resume --out "$runs" --table docs/data/coupling_lattice.txt
{
  printf '\n## What one percent costs\n\nWhere each curve crosses an error of one percent, straight between its points on logarithmic scales; in brackets the ratio to the first curve.\n'
  for measure in motion impulse energy; do
    printf '\nMade by `tests/bench/time_at_error.sh RUNS/coupling_lattice.csv 0.01 %s`:\n\n```\n' "$measure"
    tests/bench/time_at_error.sh "$runs/coupling_lattice.csv" 0.01 "$measure"
    printf '```\n'
  done
} >> docs/data/coupling_lattice.txt
keep_picture "$runs/coupling_lattice.png" docs/explanation/coupling_lattice.png 820
