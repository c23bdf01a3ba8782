#pragma once
// Copies of entries: [arrays.leg] and names with "{leg}".

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Replaces every entry (body, joint, strut, spring, force, drive, gear, boundary, contact, initial velocity) in which
// "{leg}" occurs by `count` copies: "{leg}" becomes 1, 2, ...; points, directions and orientations turn about the array's
// axis through the origin of D. In lists of names elsewhere a name with "{leg}" becomes all of its names. Braces that name
// no array are findings.
void apply_arrays(Scene& scene, Findings& findings);

}  // namespace footfall
