#pragma once
// Smooth pieces of a mesh, and which of several facets that a grain overlaps it touches.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "liggghts_fix/link/mesh_match.h"

namespace footfall {

// An edge is smooth when its two facets meet at less than the edge angle, whatever their winding. A piece is a set of
// facets that smooth edges join. Computed once, for the undeformed mesh. Facets are numbered as mesh elements.
class SurfacePieces {
 public:
  // rho0 [m]: nodes, 3 x N; corners: nodes of the facets; edges are sharp from edge_angle [rad] on.
  SurfacePieces(const Eigen::Matrix3Xd& rho0, std::vector<CornerNodes> corners, double edge_angle);

  // Is some piece curved? Otherwise all are flat.
  bool curved() const { return curved_; }
  int size() const { return static_cast<int>(corners_.size()); }  // facets
  int piece(int facet) const { return piece_[facet]; }
  const CornerNodes& corners(int facet) const { return corners_[facet]; }
  // Do two facets share a node around which smooth edges lead from one to the other?
  bool are_neighbours(int facet, int other) const;
  const std::vector<int>& neighbours(int facet) const { return neighbours_[facet]; }
  // Is a point of the facet, given by the weights of its corners, inside its piece? Otherwise it lies on a sharp edge or
  // on the border of the mesh.
  bool inside_piece(int facet, const std::array<double, 3>& weights) const;

 private:
  std::vector<CornerNodes> corners_;
  std::vector<int> piece_;
  std::vector<std::vector<int>> neighbours_;  // sorted
  struct Inside {
    std::array<bool, 3> edge, corner;  // edge k: from corner k to the next
  };
  std::vector<Inside> inside_;
  bool curved_ = false;
};

// A facet within reach of a grain.
struct FacetTouch {
  int facet = 0;                    // number of the mesh element
  double gap = 0.0;                 // from the grain's surface to the facet; negative: overlap [m]
  bool on_border = false;           // the nearest point is on the border of its piece, at a sharp edge
  bool acts = true;                 // of the facets at a sharp edge or corner, LIGGGHTS uses one
  std::array<double, 3> weights{};  // of the facet's corners, at its point nearest to the grain's centre [-]
};

// Does a grain touch `other` instead of `facet`? It touches a smooth surface where the distance has a local minimum. Of
// neighbours at equal distances the one with the smaller number counts, on every rank. Where all pieces are flat, sharp
// edges are left to LIGGGHTS: each straight edge acts, as on a rigid body.
bool yields_to(const FacetTouch& facet, const FacetTouch& other, const SurfacePieces& pieces);

// Smallest height [m] of each triangle that meets a neighbour at an angle between 0.26 and 60 degrees; infinity for the
// others, which are flat or end at an edge. LIGGGHTS lets a grain touch each facet that it overlaps: where a surface is
// curved and its facets are narrower than the contact patch, of radius sqrt(2 R overlap), their forces add up. rho0 [m]:
// nodes, 3 x N; corners: nodes of the triangles.
std::vector<double> curved_facet_widths(const Eigen::Matrix3Xd& rho0, const std::vector<CornerNodes>& corners);

}  // namespace footfall
