#!/usr/bin/env bash
# Remakes docs/landing_errors.md with its picture: errors of landings on samples of a bed. An hour; runs that are done are kept.
#   docs/landing_errors.sh [RUNS]     RUNS: folder of the runs (default runs/accuracy)
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-runs/accuracy}
for study in landing_bed bed_ensemble landing_physics; do
  ./footfall accuracy "inputs/accuracy/$study.toml" --resume --out "$runs/$study" --table "$runs/$study.md"
done
section() { printf '\n'; sed 's/^#/##/' "$runs/$1.md"; }
{
  cat docs/landing_errors.txt
  section landing_bed
  printf '\n![%s](landing_errors.png)\n' "Errors of the landing over windows and time step, and over run time"
  section bed_ensemble
  section landing_physics
} > docs/landing_errors.md
cp "$runs/landing_bed/landing_bed.png" docs/landing_errors.png
