#pragma once
// Does a body stand inside the simulation box? LIGGGHTS loses triangles that leave it, and grains are only inside.

#include <Eigen/Core>
#include <string>

namespace LAMMPS_NS {

class Domain;

// Is x [m] outside of a side of the box that does not follow the grains, by more than `margin` [m]? Periodic directions
// have no outside; what lies on a side is inside, whatever the round-off of a mesh file.
bool is_outside(const Domain& domain, const Eigen::Vector3d& x, double margin);

// "leaves the simulation box: node at ..., box from ... to ...", with the body's size and the unit that it looks like,
// for the first node outside; empty when all are inside. x: nodes [m].
std::string outside_box(const Domain& domain, const Eigen::Matrix3Xd& x);

}  // namespace LAMMPS_NS
