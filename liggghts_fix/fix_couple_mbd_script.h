#pragma once
// What a LIGGGHTS script says about its grains beside the coupling, for the partner to hold against the scene.

#include "coupler/messages.h"

namespace LAMMPS_NS {

class LAMMPS;
class Modify;

// Fills gravity and gravity_known of `script`. False, with a warning: gravity varies, and is known within a run alone.
bool read_gravity(Modify& modify, footfall::Start& script);
// Within a run: the sum of all fix gravity [m/s2].
Eigen::Vector3d gravity_now(Modify& modify);
// A warning where clumps (fix multisphere) stand before a wall: when a run is set up LIGGGHTS hands them the forces that
// stand when their turn comes, and the first half step lacks those of the wall.
void warn_of_clumps(Modify& modify, footfall::Start& script);
// A warning where spheres belong to no clump and fix multisphere alone integrates: they stand still. For all ranks at once.
void warn_of_still_spheres(LAMMPS* lmp, footfall::Start& script);
// Warnings where liquid bridges of LIGGGHTS do not reach a wall as they should: with washino/capillary/viscous the radius of a
// wall is 0 while a grain touches it, so that liquid pulls at a distance alone; easo/capillary/viscous takes an atom's velocity for
// that of a wall at a distance (wall_as_atom.h).
void warn_of_liquid_on_walls(Modify& modify, footfall::Start& script);

}  // namespace LAMMPS_NS
