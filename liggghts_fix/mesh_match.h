#pragma once
// Which triangle of a body's boundary is which triangle of a LIGGGHTS mesh. No LIGGGHTS headers: tested alone.

#include <Eigen/Dense>
#include <array>
#include <string>
#include <vector>

#include "coupler/body_motion.h"
#include "coupler/modal_boundary.h"

namespace footfall {

// A mesh triangle as LIGGGHTS holds it: its number in the mesh and its corners in W [m].
struct MeshTriangle {
  int id = 0;
  std::array<Eigen::Vector3d, 3> corners;
};

// Boundary nodes at the three corners of a mesh triangle, in the mesh's order.
using CornerNodes = std::array<int, 3>;

// For every mesh triangle the boundary nodes at its corners, whatever the order of triangles and vertices. The boundary
// stands at `pose`; corners may be off by kMeshTolerance times the size of the boundary (meshes in ASCII files carry
// six digits or so). Throws InputError naming mesh, body and place when a mesh triangle is none of the boundary's.
inline constexpr double kMeshTolerance = 1e-5;
std::vector<CornerNodes> match_mesh(const std::string& mesh, const ModalBoundary& boundary, const BodyMotion& pose,
                                    const std::vector<MeshTriangle>& triangles);

}  // namespace footfall
