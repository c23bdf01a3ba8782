#pragma once
// Copies of entries: [arrays.leg] and names with "{leg}".

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Replaces every entry (body, joint, strut, spring, boundary, initial velocity) in which "{leg}" occurs by `count`
// copies:
// "{leg}" becomes 1, 2, ..., points, directions and orientations turn about the array's axis through the origin of D.
// In lists of names elsewhere "{leg}" becomes all of its names. Braces of no array are findings.
void apply_arrays(Scene& scene, Findings& findings);

}  // namespace footfall
