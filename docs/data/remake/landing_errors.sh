#!/usr/bin/env bash
# Remakes docs/data/landing_errors.txt: errors of landings on samples of a bed. An hour; finished runs are kept.
#   docs/data/remake/landing_errors.sh [RUNS]     RUNS: folder of the runs (default runs/accuracy)
set -euo pipefail
cd "$(dirname "$0")/../../.."
runs=${1:-runs/accuracy}
for study in landing_bed bed_ensemble landing_physics; do
  ./footfall accuracy "inputs/accuracy/$study.toml" --resume --out "$runs/$study" --table "$runs/$study.md"
done
{
  echo '# Errors of landings on samples of a bed (docs/data/remake/landing_errors.sh)'
  for study in landing_bed bed_ensemble landing_physics; do printf '\n'; sed 's/^#/##/' "$runs/$study.md"; done
} > docs/data/landing_errors.txt
