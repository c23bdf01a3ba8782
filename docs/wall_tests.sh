#!/usr/bin/env bash
# Remakes docs/wall_tests.md: one sphere on a coupled plane against closed forms. Seconds.
#   docs/wall_tests.sh [BUILD]     BUILD: the build folder (default build)
set -euo pipefail
cd "$(dirname "$0")/.."
build=${1:-build}
rows=$(mktemp)
trap 'rm -f "$rows"' EXIT
FOOTFALL_WALL_TESTS=$rows "$build/bin/dem_wall_tests" >&2
{
  cat <<'TEXT'
# A sphere on a coupled plane

Made by `docs/wall_tests.sh`; the same tests run in `ctest -R WallTests`. The wall tests, numbers 2 to 6, of Chung and Ooi, *Benchmark tests for verifying discrete element modelling codes at
particle impact level*, Granular Matter 13, 643 (2011), with a plane that is the mesh of a coupled body at rest, of the same material as the sphere, window by window. Materials and speeds
are of their kind and stand in `tests/dem/wall_tests_test.cpp`.

- Peak, overlap and time of contact: Hertz. Restitution: the one that the script asks for (`limitForce on` takes the pull at the end of a contact away, and gives more: 0.32 for 0.2).
- Speed along the plane and spin: a sphere that slides all through the contact, by Coulomb's impulse with the normal impulse that is found, at the arm of one radius (LIGGGHTS takes half the overlap off it). With
  `limitForce on tangential_damping off`: by default LIGGGHTS' tangential damping exceeds Coulomb's limit until the sphere slides, by 9 % of the impulse at e = 0.5. Angles and speeds at which a sphere sticks
  for a part of the contact have no closed form and are left out.

| test | figure | closed form | found | difference [%] |
|---|---|---|---|---|
TEXT
  cat "$rows"
} > docs/wall_tests.md
