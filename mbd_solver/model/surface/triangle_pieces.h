#pragma once
// Triangles as connected pieces: corners welded, turned alike, with the normals of faces, edges and corners.

#include <Eigen/Dense>
#include <array>
#include <vector>

namespace footfall {

struct PieceTriangle {
  Eigen::Vector3i corners;
  int piece = 0;
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();  // unit vector
  // Sum of the normals of what meets at each edge (from corner k to k + 1) and at each corner, by their angles there:
  // a point is outside when it stands on their side (Baerentzen and Aanaes 2005).
  std::array<Eigen::Vector3d, 3> edge_normal, corner_normal;
  std::array<bool, 3> edge_is_border{}, corner_is_border{};
};

struct TrianglePieces {
  std::vector<Eigen::Vector3d> vertices;
  std::vector<PieceTriangle> triangles;
  std::vector<bool> open;  // of each piece: it has a border, or cannot be turned alike
};

// Throws InputError for a triangle without area.
TrianglePieces triangle_pieces(const Eigen::Matrix3Xd& vertices, const std::vector<Eigen::Vector3i>& triangles);

// The point of a triangle that is nearest to p.
struct NearestPoint {
  Eigen::Vector3d point;
  int edge = -1;    // it stands on this edge; -1: not
  int corner = -1;  // on this corner; -1: not
};
NearestPoint nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c);

}  // namespace footfall
