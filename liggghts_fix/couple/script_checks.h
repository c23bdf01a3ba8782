#pragma once
// Properties of the grains in a LIGGGHTS script, apart from the coupling: values that mbd_solver compares with the scene,
// warnings for the user, and whether pair forces can overlap with the mechanism's step.

#include <string>

#include "coupler/messages.h"

namespace LAMMPS_NS {

class LAMMPS;
class Modify;

// --- Grains. All collective.

// Requires that radius and mass of every grain are positive, position and velocity finite. Throws InputError on all ranks,
// naming the grain: LIGGGHTS would silently compute no contact for a grain without a radius. where: beginning of the
// message.
void check_grains(LAMMPS* lmp, const std::string& where);
// A warning when the script or the command line has a variable `radius`, but no grain has that radius.
void warn_of_radius(LAMMPS* lmp, footfall::Start& script);
// A warning where only fix multisphere integrates, and spheres belong to no clump: they do not move.
void warn_of_spheres_at_rest(LAMMPS* lmp, footfall::Start& script);

// --- Fixes.

// Fills gravity and gravity_known of `script`. False, with a warning: gravity varies and is known only within a run.
bool read_gravity(Modify& modify, footfall::Start& script);
// Within a run: the sum of all fix gravity [m/s2].
Eigen::Vector3d gravity_now(Modify& modify);
// A warning where clumps (fix multisphere) are defined before a wall: in the set-up of a run LIGGGHTS gives clumps the
// forces of the fixes before them, so that the forces of the wall are missing in the first half step.
void warn_of_clumps(Modify& modify, footfall::Start& script);
// Warnings where LIGGGHTS' liquid bridges do not act on a wall as they should. With washino/capillary/viscous the wall's
// radius is 0 while a grain touches it, so that liquid acts only at a distance. easo/capillary/viscous uses the velocity
// of an atom instead of the wall's velocity at a distance (ScopedWallAsAtom).
void warn_of_liquid_on_walls(Modify& modify, footfall::Start& script);

// --- Overlap. A step of LIGGGHTS computes velocities and positions of the grains, neighbour lists, pair forces, then the
// forces of meshes and beams. The first three do not depend on the bodies: the grains can compute them while mbd_solver
// still computes the mechanism's motion, and wait for it only then.

// The reason that prevents this overlap, because the motion may affect it, or it may affect the pair forces: a fix
// that is unknown here (insertion, heat, ...), or a box that follows the grains. Empty: no reason, and results are
// equal to the bit. To be called after all fixes are defined.
std::string overlap_obstacle(LAMMPS* lmp);

}  // namespace LAMMPS_NS
