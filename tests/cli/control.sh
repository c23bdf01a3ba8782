#!/usr/bin/env bash
# The fuzzy controller beats every constant voltage, and skyhook, on the stated cost of inputs/sweeps/control_plane.toml.
#   control.sh FOOTFALL FILE
set -eu
work=$(mktemp -d); trap 'rm -rf "$work"' EXIT
"$1" sweep "$2" --out "$work/sweep" | tee "$work/said"
grep -q "within the limits: control fuzzy$" "$work/said"
