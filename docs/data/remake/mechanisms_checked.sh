#!/usr/bin/env bash
# Prints the errors of the mechanisms of docs/data/mechanisms_checked.txt by both integrators at rtol 1e-6, and those of random mechanisms. Some minutes.
#   docs/data/remake/mechanisms_checked.sh [BUILD]     BUILD: build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/../../.."
build=${1:-build}
cmake --build "$build" --target validation_tests
"$build/bin/validation_tests" --gtest_filter='*CheckedMechanism*:RandomMechanisms.*' --gtest_brief=1
