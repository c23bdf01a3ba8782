#pragma once
// The round surface of which a mesh is a tessellation: it passes through the nodes, with a common normal at each node of
// a smooth piece.
//
// After T. Nagata, Simple local interpolation of surfaces using normal vectors, CAGD 22, 327 (2005): each edge becomes a
// parabola perpendicular to the normals at its ends, each facet a quadratic patch through its edges. On a sphere or
// cylinder of radius R_s and with facets of width w the error is at most w^4 / (128 R_s^3); the error of flat facets is
// w^2 / (8 R_s).

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "liggghts_fix/link/surface_pieces.h"

namespace footfall {

// One facet: S(b) = sum_i b_i x_i + b_0 b_1 q_01 + b_1 b_2 q_12 + b_2 b_0 q_20, with b_0 + b_1 + b_2 = 1.
class RoundFacet {
 public:
  // Columns: corners x_i [m], unit normals there.
  RoundFacet(const Eigen::Matrix3d& corners, const Eigen::Matrix3d& normals);

  struct Nearest {
    std::array<double, 3> weights;  // b
    Eigen::Vector3d point;          // S(b) [m]
  };
  // The point of the facet nearest to p.
  Nearest nearest(const Eigen::Vector3d& p) const;
  Eigen::Vector3d at(double b1, double b2) const;
  // Upper bound of the distance from the flat facet [m].
  double largest_bulge() const { return 0.25 * q_.colwise().norm().sum(); }

 private:
  bool inner(const Eigen::Vector3d& p, double& b1, double& b2) const;
  double on_edge(const Eigen::Vector3d& p, int edge) const;

  Eigen::Matrix3d x_, q_;  // q: of the edges 01, 12, 20
};

class RoundSurface {
 public:
  // nodes [m]: of the undeformed body, 3 x N.
  RoundSurface(const SurfacePieces& pieces, const Eigen::Matrix3Xd& nodes);

  // Moves the surface: turned with a rigid body, or deformed.
  void turn(const Eigen::Matrix3d& R_WB) { R_WB_ = R_WB; }
  void deform(const SurfacePieces& pieces, const Eigen::Matrix3Xd& nodes_W);

  // All three normals are equal to the normal of the flat facet.
  bool is_flat(int facet) const { return flat_[facet]; }
  RoundFacet facet(int facet, const Eigen::Matrix3d& corners_W) const { return {corners_W, R_WB_ * normals_[facet]}; }
  // The largest bulge of all facets of the undeformed body [m].
  double largest_bulge() const { return bulge_; }

 private:
  std::vector<Eigen::Matrix3d> normals_;  // at the corners of each facet
  std::vector<bool> flat_;
  Eigen::Matrix3d R_WB_ = Eigen::Matrix3d::Identity();
  double bulge_ = 0.0;
};

}  // namespace footfall
