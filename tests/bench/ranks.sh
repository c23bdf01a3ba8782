#!/usr/bin/env bash
# ranks.sh BUILD: loads of four pads that slide across a carpet of grains on 1 to 16 ranks of LIGGGHTS, on grids that cut the pads and with ranks without grains: the loads of one
# rank, to round-off. Sixteen ranks take half a minute on two cores.
set -u
"$1/bin/coupled_tests" --gtest_filter='*PadsOn*' --gtest_also_run_disabled_tests --gtest_brief=0 | sed -n 's/^largest/  largest/p; s/.*OneRank\/\([0-9x]*\) (.*/\1/p; /FAILED/p'
exit "${PIPESTATUS[0]}"
