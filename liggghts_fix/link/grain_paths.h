#pragma once
// Grains that a body cannot stop: paths that are long in a time step, and contacts that a grain passes through.

#include <Eigen/Dense>
#include <cstdint>
#include <unordered_map>
#include <vector>

#include "coupler/modal_boundary.h"

namespace footfall {

// Longest way of a grain relative to a body in a time step [of its radius]. A contact that was not deep (kDeep, below) a
// step ago is then still on the same side of the surface.
inline constexpr double kLongestWay = 0.7;

// Does a centre that moves from x_W by way_W [m], relative to the body, pass through a triangle or the axis of a beam?
// Nodes of the boundary in W.
bool path_meets(const ModalBoundary& boundary, const Eigen::Matrix3Xd& nodes_W, const Eigen::Vector3d& x_W,
                const Eigen::Vector3d& way_W);

// A grain has passed a surface when the vector d from its centre to the surface has reversed between two steps:
//   d . d_before < 0,   |d - d_before| <= 2 |v| dt
// The second condition leaves out a grain between two surfaces whose nearer one changes. Only contacts with overlaps of
// more than kDeep can reverse, where ways are not longer than kLongestWay.
class GrainPassages {
 public:
  static constexpr double kDeep = 0.2;  // [of the grain's radius]

  // A contact of this step; way: |v| dt of the grain relative to the surface [m].
  bool passes(std::int64_t step, int tag, const Eigen::Vector3d& d_W, double way);

 private:
  using Contacts = std::unordered_map<int, std::vector<Eigen::Vector3d>>;  // by tag
  std::int64_t step_ = -1;
  Contacts before_, now_;
};

}  // namespace footfall
