#!/usr/bin/env bash
# landing_without.sh PROGRAM...: none of them loads a library that only the import of robots needs.
set -u
failed=0
for program; do
  ldd "$program" | grep -E 'urdfdom|sdformat|mujoco|ignition|console_bridge|tinyxml' && { echo "$program loads a library of the import"; failed=1; }
done
exit $failed
