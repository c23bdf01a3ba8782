#pragma once
// Which facets of a mesh make up one smooth surface, and which of several facets that a grain overlaps it touches. No
// LIGGGHTS headers.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "liggghts_fix/mesh_match.h"

namespace footfall {

// Smooth: two facets at an edge turn by less than the edge angle. A piece is a set of facets that smooth edges join.
// Whatever the winding of the facets; found once, of the undeformed mesh. Facets are numbered as mesh elements.
class SurfacePieces {
 public:
  // rho0 [m]: nodes, 3 x N; corners: nodes of the facets; edge_angle [rad]: from here an edge is sharp.
  SurfacePieces(const Eigen::Matrix3Xd& rho0, std::vector<CornerNodes> corners, double edge_angle);

  // Does some smooth edge turn at all? Otherwise all faces are flat.
  bool curved() const { return curved_; }
  int piece(int facet) const { return piece_[static_cast<std::size_t>(facet)]; }
  const CornerNodes& corners(int facet) const { return corners_[static_cast<std::size_t>(facet)]; }
  // Do two facets share a node around which smooth edges lead from one to the other?
  bool are_neighbours(int facet, int other) const;

 private:
  std::vector<CornerNodes> corners_;
  std::vector<int> piece_;
  std::vector<std::vector<int>> neighbours_;  // sorted
  bool curved_ = false;
};

// A facet within reach of a grain.
struct FacetTouch {
  int facet = 0;                    // number of the mesh element
  double gap = 0.0;                 // from the grain's surface to the facet; negative: overlap [m]
  std::array<double, 3> weights{};  // of the facet's corners, at its point nearest to the grain's centre [-]
};

// Does the grain not touch `facet` because of `other`? A grain touches a surface where their distance is least among
// all points around: `other` is closer, and either belongs to the same smooth surface beside `facet`, or holds the
// edge or corner on which the nearest point of `facet` lies. Of two that are equally close the smaller number counts, on
// any rank.
bool yields(const FacetTouch& facet, const FacetTouch& other, const SurfacePieces& pieces);

}  // namespace footfall
