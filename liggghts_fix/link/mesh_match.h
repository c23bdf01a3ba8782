#pragma once
// Which triangle of a LIGGGHTS mesh is which triangle of a body's boundary, and the order of a mesh after a restart.

#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

#include "coupler/body_motion.h"
#include "coupler/modal_boundary.h"

namespace footfall {

// A triangle of a mesh in LIGGGHTS: its number and its corners in W [m].
struct MeshTriangle {
  int id = 0;
  std::array<Eigen::Vector3d, 3> corners;
};

// Boundary nodes at the three corners of a mesh triangle, in the mesh's order.
using CornerNodes = std::array<int, 3>;

// The boundary nodes at the corners of every mesh triangle, in any order of triangles and vertices. The boundary is at
// `pose`; corners may differ by kMeshTolerance times the size of the boundary (meshes in ASCII files have about six
// digits). Throws InputError naming mesh, body and place when a mesh triangle is not one of the boundary.
inline constexpr double kMeshTolerance = 1e-5;
std::vector<CornerNodes> match_mesh(const std::string& mesh, const ModalBoundary& boundary, const BodyMotion& pose,
                                    const std::vector<MeshTriangle>& triangles);

// The order of a rank's elements of a mesh after a restart file is read. The file holds the elements of rank 0, then
// the elements of rank 1, ... Each rank reads all of them and deletes foreign elements, from the first on; the last
// element takes the place of a deleted one. Returns for every place which of this rank's elements is there. before,
// after: numbers of elements of lower and of higher ranks.
std::vector<int> order_after_restart(int before, int own, int after);

}  // namespace footfall
