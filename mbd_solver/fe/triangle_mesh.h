#pragma once
// A surface of triangles: what generators and mesh files give, and plates and boundaries are made of.

#include <Eigen/Dense>
#include <vector>

namespace footfall {

struct TriangleMesh {
  std::vector<Eigen::Vector3d> vertices;   // [m]
  std::vector<Eigen::Vector3i> triangles;  // indices into vertices, counter-clockwise seen from the normal's side
};

// The mesh moved by x -> R x + p.
TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& p);

// Vertices nearer to each other than tolerance [m] made one, as STL files need; order of first occurrence is
// kept, vertices that no triangle uses are left out. Triangles are kept as they are, even if they collapse:
// check_mesh finds those.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance);

}  // namespace footfall
