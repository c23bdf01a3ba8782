#pragma once
// The surface of a mesh of another finite-element code.

#include <Eigen/Dense>
#include <vector>

#include "mbd_solver/fe/fe_mesh.h"

namespace footfall {

// The outer faces of solids, counter-clockwise seen from outside, else all faces of shells; elements with nodes on edges are
// cut there, so that all nodes of the surface are corners. Indices of points.
std::vector<Eigen::Vector3i> skin_of(const FeMesh& mesh);

}  // namespace footfall
