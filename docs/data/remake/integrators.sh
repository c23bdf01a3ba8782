#!/usr/bin/env bash
# Remakes docs/data/integrators.txt: error against run time of the mechanism alone. Minutes.
#   docs/data/remake/integrators.sh [RUNS]     RUNS: folder of the runs (default runs/accuracy)
set -euo pipefail
cd "$(dirname "$0")/../../.."
runs=${1:-runs/accuracy}
studies=(mechanisms lander_rigid lander_flexible)
status=0
for study in "${studies[@]}"; do ./footfall accuracy "inputs/accuracy/$study.toml" --out "$runs/$study" --table "$runs/$study.md" || status=$?; done
{
  echo '# The mechanism alone: error against run time (docs/data/remake/integrators.sh)'
  printf '\nErrors against the one-step method at rtol 1e-8 (slider-crank: 1e-10).\n'
  for study in "${studies[@]}"; do
    printf '\n'; sed '1s/^#/##/' "$runs/$study.md"
    printf '\n`./footfall accuracy inputs/accuracy/%s.toml`\n' "$study"
  done
} > docs/data/integrators.txt
# 1: a required check of a study failed; its section says which.
exit "$status"
