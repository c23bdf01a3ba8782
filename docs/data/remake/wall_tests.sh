#!/usr/bin/env bash
# Remakes docs/data/wall_tests.txt: one sphere on a coupled plane against closed forms. Seconds.
#   docs/data/remake/wall_tests.sh [BUILD]     BUILD: the build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/../../.."
build=${1:-build}
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
FOOTFALL_WALL_TESTS=$rows "$build/bin/coupled_tests" --gtest_filter='WallTests.*' >&2
{
  printf '# A sphere on a coupled plane, tests 2 to 6 of Chung and Ooi, Granular Matter 13, 643 (2011) (docs/data/remake/wall_tests.sh)\n\n'
  printf '| test | figure | closed form | found | difference [%%] |\n|---|---|---|---|---|\n'
  cat "$rows"
} > docs/data/wall_tests.txt
