#pragma once
// Completes a scene that was read: copies of arrays, paths, points of joints, segments, masses, and the scripts of a bed.

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Replaces every entry (body, joint, strut, spring, force, drive, gear, boundary, contact, initial velocity) in which
// "{leg}" occurs by `count` copies: "{leg}" becomes 1, 2, ...; points, directions and orientations turn about the array's
// axis through the origin of D. In lists of names elsewhere a name with "{leg}" becomes all of its names. Braces that name
// no array are findings.
void apply_arrays(Scene& scene, Findings& findings);

// Completes a scene that was read: copies of arrays, paths, points of joints, mass, centre and inertia of every body,
// and the scripts of a bed that is given by numbers.
// Errors become findings.
void resolve_scene(Scene& scene, Findings& findings);

// A body with flexible.segments = N becomes N bodies "NAME_1" ... "NAME_N" with fixed joints between them; joints, struts,
// springs and forces on it act on the segment at their point.
void resolve_segments(Scene& scene, Findings& findings);

// The surface of the ground: a level or tilted one becomes point and normal of plane and soil; a map is read.
void resolve_terrain(Scene& scene, Findings& findings);
// The surface of a terrain whose parts are checked.
std::shared_ptr<Terrain> terrain_of(const TerrainSpec& terrain);
// Of a field of rocks, whose sizes are checked.
double expected_rocks(const RockFieldSpec& field);

// Mass, mass centre and inertia of every body: from numbers, or from shape and material; "remainder" last.
void resolve_masses(Scene& scene, Findings& findings);

// True for a body that [initial] does not place or move (InitialGroupsSpec); not for "ground".
bool stands_still(const Scene& scene, const std::string& body);

// Mass centre in D of all bodies that [initial] moves [m]; total mass of all [kg].
Eigen::Vector3d mass_centre(const Scene& scene);
double total_mass(const Scene& scene);

}  // namespace footfall
