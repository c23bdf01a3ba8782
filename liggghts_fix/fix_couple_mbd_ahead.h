#pragma once
// Grains that go ahead of the mechanism. A step of LIGGGHTS: velocities and places of the grains, neighbour lists,
// forces of grains on each other, then those of meshes and beams. The first three know nothing of the bodies: the grains
// do them while the mechanism still moves on under the load of the last window, and only then wait for its motion.

#include <string>

namespace LAMMPS_NS {

class LAMMPS;

// What keeps the grains of this run from going ahead, as the motion may make a difference to it, or it to the forces of
// grains on each other: a fix that is not known here (insertion, heat, ...), or a box that follows what is in it.
// Empty: nothing does, and what comes out is the same to the bit. To be asked when all fixes are there.
std::string why_grains_wait(LAMMPS* lmp);

}  // namespace LAMMPS_NS
