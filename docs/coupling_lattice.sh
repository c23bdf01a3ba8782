#!/usr/bin/env bash
# Remakes docs/coupling_lattice.md with its picture: every scheme on fixed grains, and what one percent costs each. Five minutes on a quiet machine; runs that are done are kept.
#   docs/coupling_lattice.sh [RUNS]     RUNS: folder of the runs (default runs/accuracy)
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-runs/accuracy}/coupling_lattice
./footfall accuracy inputs/accuracy/coupling_lattice.toml --resume --out "$runs" --table docs/coupling_lattice.md
{
  printf '\n## What one percent costs\n\nWhere each curve crosses an error of one percent, straight between its points on logarithmic scales; in brackets the ratio to the first curve.\n'
  for measure in motion impulse energy; do
    printf '\nMade by `tests/bench/time_at_error.sh RUNS/coupling_lattice.csv 0.01 %s`:\n\n```\n' "$measure"
    tests/bench/time_at_error.sh "$runs/coupling_lattice.csv" 0.01 "$measure"
    printf '```\n'
  done
} >> docs/coupling_lattice.md
cp "$runs/coupling_lattice.png" docs/coupling_lattice.png
