#!/usr/bin/env bash
# Remakes docs/integrators.md with its pictures: error against run time of the mechanism alone. Minutes.
#   docs/integrators.sh [RUNS]     RUNS: folder of the runs (default runs/accuracy)
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-runs/accuracy}
studies=(mechanisms lander_rigid lander_flexible)
status=0
for study in "${studies[@]}"; do ./footfall accuracy "inputs/accuracy/$study.toml" --out "$runs/$study" --table "$runs/$study.md" || status=$?; done
{
  cat <<'TEXT'
# The mechanism alone: error against run time

Made by `docs/integrators.sh`; each section by `footfall accuracy inputs/accuracy/FILE`. Errors are against the one-step method with a tolerance of 1e-8 (1e-10 for the slider-crank). So the last digits of IDA
may be errors of the reference as well.

On the lander the one-step method reaches the same error several times faster than IDA with rigid bodies, and about ten times faster with flexible ones. Impacts and a sampled controller make a multistep
method start again and again. So the one-step method is the default. Projection is the default too: Baumgarte's terms cost as much and leave a drift (see its column). Fixed steps are there for orders and for
comparison: over all those of the slider-crank the order is below two, between the shortest it is two.
TEXT
  for study in "${studies[@]}"; do
    printf '\n'; sed '1s/^#/##/' "$runs/$study.md"
    cp "$runs/$study/$study.png" "docs/integrators_$study.png"
    printf '\n`./footfall accuracy inputs/accuracy/%s.toml`\n\n![%s](integrators_%s.png)\n' "$study" "$study" "$study"
  done
} > docs/integrators.md
# 1: an expectation of a study did not come out; its section says which.
exit "$status"
