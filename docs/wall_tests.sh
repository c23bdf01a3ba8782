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

Made by `docs/wall_tests.sh`; the same tests run in `ctest -R WallTests`. These are the wall tests, numbers 2 to 6, of Chung and Ooi, *Benchmark tests for verifying discrete element modelling codes at particle
impact level*, Granular Matter 13, 643 (2011). The plane is the mesh of a coupled body at rest, 1000 times stiffer than the sphere.

The paper itself was not at hand. Materials, sizes and speeds are those that other codes give for these tests: 2 to 4 as in Yade (yade-dev/trunk, its scripts Test2.py to Test4.py; Kratos has the same), 5 as in
Kratos (`basic_benchmarks/benchmark5DEM.mdpa`) and PySPH, 6 as in Kratos (`benchmark6DEM.mdpa`). Test 6 on nylon is left out: no source for its constants was found.

| test | sphere | Young's modulus [GPa] | Poisson's ratio | density [kg/m3] | radius [m] | speed [m/s] | friction | restitution |
|---|---|---|---|---|---|---|---|---|
| 2 | aluminium alloy; magnesium alloy | 70; 40 | 0.30; 0.35 | 2699; 1800 | 0.1 | 0.2 down | 0 | 1 |
| 3 | aluminium oxide; cast iron | 380; 100 | 0.23; 0.25 | 4000; 7000 | 0.0025 | 3.9 down | 0 | 0.2 to 1 |
| 4 | aluminium oxide; aluminium alloy | 380; 70 | 0.23; 0.33 | 4000; 2700 | 0.0025 | 3.9 at an angle | 0.092 | 0.98 |
| 5 | steel; polyethylene | 208; 1 | 0.30; 0.40 | 7850; 1400 | 0.00001 | 5 down, to 70 along | 0.3 | 1 |
| 6 | aluminium alloy | 70 | 0.33 | 2700 | 0.1 | 0.2 down, spinning | 0.4 | 0.5 |

- Peak force, overlap and time of contact are Hertz's. The restitution is that of the script. (`limitForce on` takes away the pull at the end of a contact, and gives more: 0.32 for 0.2.)
- Speed along the plane and spin are those of a sphere that slides all through the contact: Coulomb's impulse, with the normal impulse that is found. Its arm is one radius less half the overlap, as LIGGGHTS takes
  it; that matters on polyethylene alone (1.1 %).
- These runs have `limitForce on tangential_damping off`: by default LIGGGHTS' tangential damping exceeds Coulomb's limit until the sphere slides, by 9 % of the impulse at e = 0.5.
- Angles and speeds at which a sphere sticks for a part of the contact have no closed form and are left out.

| test | figure | closed form | found | difference [%] |
|---|---|---|---|---|
TEXT
  cat "$rows"
} > docs/wall_tests.md
