#pragma once
// Completes a scene that was read: copies of arrays, paths, points of joints, segments, masses, and the scripts of a bed.

#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene.h"

namespace footfall {

// Completes a scene that was read: copies of arrays, paths, points of joints, mass, centre and inertia of every body,
// and the scripts of a bed that is given by numbers.
// Errors become findings.
void resolve_scene(Scene& scene, Findings& findings);

// The surface of the ground: a level or tilted one becomes point and normal of plane and soil; a map is read.
void resolve_terrain(Scene& scene, Findings& findings);
// The surface of a terrain whose parts are checked.
std::shared_ptr<Terrain> terrain_of(const TerrainSpec& terrain);
// Of a field of rocks, whose sizes are checked.
double expected_rocks(const RockFieldSpec& field);
// Samples of a map from its file, counted from its origin. Throws InputError, naming file and line: not readable, another
// header, rows of other lengths, holes, values that are no numbers, too many samples.
std::shared_ptr<const HeightGrid> read_height_map(const TerrainMapSpec& map);

// True for a body that [initial] does not place or move (InitialGroupsSpec); not for "ground".
bool stands_still(const Scene& scene, const std::string& body);

// Mass centre in D of all bodies that [initial] moves [m]; total mass of all [kg].
Eigen::Vector3d mass_centre(const Scene& scene);
double total_mass(const Scene& scene);

}  // namespace footfall
