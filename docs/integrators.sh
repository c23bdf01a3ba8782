#!/usr/bin/env bash
# Remakes docs/integrators.md with its pictures: error against run time of the mechanism alone. Minutes.
#   docs/integrators.sh [RUNS]     RUNS: folder of the runs (default runs/accuracy)
set -euo pipefail
cd "$(dirname "$0")/.."
runs=${1:-runs/accuracy}
studies=(mechanisms lander_rigid lander_flexible)
for study in "${studies[@]}"; do ./footfall accuracy "inputs/accuracy/$study.toml" --out "$runs/$study" --table "$runs/$study.md"; done
{
  cat <<'TEXT'
# The mechanism alone: error against run time

Made by `docs/integrators.sh`; each section by `footfall accuracy inputs/accuracy/FILE`. Errors are against the one-step method with a tolerance of 1e-8 (1e-10 for
the slider-crank), so the last digits of IDA are as much its own as the reference's. On the lander the one-step method reaches the same error several times faster than
IDA with rigid bodies and about twenty times faster with flexible ones: impacts and a sampled controller make a multistep method start again and again. That is why it
is the default, with projection: Baumgarte's terms cost as much and leave the drift of its column. Fixed steps are for orders and for comparison.
TEXT
  for study in "${studies[@]}"; do
    printf '\n'; sed '1s/^#/##/' "$runs/$study.md"
    cp "$runs/$study/$study.png" "docs/integrators_$study.png"
    printf '\n`./footfall accuracy inputs/accuracy/%s.toml`\n\n![%s](integrators_%s.png)\n' "$study" "$study" "$study"
  done
} > docs/integrators.md
