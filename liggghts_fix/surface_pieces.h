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
  int size() const { return static_cast<int>(corners_.size()); }  // facets
  int piece(int facet) const { return piece_[static_cast<std::size_t>(facet)]; }
  const CornerNodes& corners(int facet) const { return corners_[static_cast<std::size_t>(facet)]; }
  // Do two facets share a node around which smooth edges lead from one to the other?
  bool are_neighbours(int facet, int other) const;
  const std::vector<int>& neighbours(int facet) const { return neighbours_[static_cast<std::size_t>(facet)]; }
  // Is a point of the facet, by the weights of its corners, inside of its piece? Otherwise it lies on a sharp edge or
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
  bool on_border = false;           // of its piece, at a sharp edge
  bool acts = true;                 // LIGGGHTS lets one of the facets at a sharp edge or corner act for all
  std::array<double, 3> weights{};  // of the facet's corners, at its point nearest to the grain's centre [-]
};

// Does the grain not touch `facet` because of `other`? It touches a smooth surface where their distance is least among
// all points around. Of neighbours that are equally close the smaller number counts, on any rank. Where all faces are
// flat at first, sharp edges are LIGGGHTS' own affair: each straight one acts, as on a rigid body.
bool yields(const FacetTouch& facet, const FacetTouch& other, const SurfacePieces& pieces);

}  // namespace footfall
