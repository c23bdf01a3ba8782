#pragma once
// Neighbour list of a chain: which grains may touch it, and which of its segments. The list is valid for several steps,
// so that a step computes only near pairs. A chain far from the grains costs a comparison of two boxes when the list is
// built, and none of its nodes is visited until one may have come near.
//
// A pair is on the list when its gap is below
//   margin = 1.5 skin + the reach of the contact model beyond touch.
// LIGGGHTS lets no grain move further than skin/2 from its position at the last re-neighbouring, that is skin from any
// position since; nodes may move skin/2 before the list is built anew. Together 1.5 skin: no touch is missed.
//
// In a periodic box a chain may be anywhere, and grains touch its nearest image: a chain has one contact with a grain,
// also where it is longer than the box.

#include <Eigen/Geometry>
#include <vector>

#include "liggghts_fix/link/beam_chain.h"

namespace footfall {

// The grains of LIGGGHTS, borrowed for the duration of a call.
struct GrainView {
  int count = 0;
  const double* const* x = nullptr;  // count pointers to three coordinates [m]
  const double* radius = nullptr;    // [m]
  const int* mask = nullptr;         // bits of the groups a grain belongs to; null: all grains take part
  int group_bit = 1;
};

// The extent of all grains of a view.
struct GrainExtent {
  GrainExtent() = default;
  GrainExtent(const GrainView& grains);
  Eigen::AlignedBox3d box;      // of their surfaces
  double largest_radius = 0.0;  // [m]
};

class BeamNeighbours {
 public:
  // skin [m]; reach: contact models with forces over a gap (liquid bridges) act at gaps up to reach * radius of the grain;
  // periods: of the box [m], 0 in directions that are not periodic.
  BeamNeighbours(double skin, double reach = 0.0, const Eigen::Vector3d& periods = Eigen::Vector3d::Zero())
      : skin_(skin), reach_(reach), periods_(periods) {}

  // LIGGGHTS has renumbered or moved the grains and built new lists: the next update() builds this one.
  void grains_renumbered(const GrainExtent& grains);
  // Builds the list if the grains were renumbered or a node has moved further than skin/2 since; true if it did. Call
  // after the nodes have moved, in every step except where clearance() allows to skip it; the grains must be the
  // grains of the last grains_renumbered(), at their present positions.
  bool update(const BeamChain& chain, const GrainView& grains);

  // As long as no node has moved this far since the list was built, no grain can touch the chain, and no update is needed
  // [m]; 0: unknown.
  double clearance() const { return renumbered_ ? 0.0 : clearance_; }

  int size() const { return static_cast<int>(grain_.size()); }          // grains on the list
  int pair_count() const { return static_cast<int>(segment_.size()); }  // pairs on the list
  int grain(int k) const { return grain_[k]; }                          // number of the k-th grain
  // The touch with the smallest gap over the segments near the k-th grain, which is at x with radius r.
  BeamTouch closest(const BeamChain& chain, int k, const Eigen::Vector3d& x, double r) const;

  long builds() const { return builds_; }        // how often a list was built
  long box_tests() const { return box_tests_; }  // spheres against boxes of segments, in all builds

 private:
  void build(const BeamChain& chain, const GrainView& grains);
  // Finds the images, of a chain in this box, that may touch a grain; returns the distance of the nearest one from all
  // grains [m].
  double find_images(const Eigen::AlignedBox3d& chain_box, double far);
  void build_boxes(const BeamChain& chain, int box, int first, int last);
  void collect(const BeamChain& chain, int box, int first, int last, const Eigen::Vector3d& x, double r);

  double skin_;
  double reach_;
  Eigen::Vector3d periods_;
  std::vector<Eigen::Vector3d> images_;  // multiples of the periods [m]
  bool renumbered_ = true;
  double clearance_ = 0.0;    // [m]
  GrainExtent extent_;        // when the grains were renumbered
  Eigen::Matrix3Xd x_build_;  // nodes when the list was built
  std::vector<Eigen::AlignedBox3d>
      box_;  // binary tree over runs of consecutive segments: 0 all, 2k+1 and 2k+2 the halves of k
  std::vector<int> grain_;
  std::vector<int> first_;  // segments of the k-th grain: segment_[first_[k]] to segment_[first_[k + 1] - 1]
  std::vector<int> segment_;
  std::vector<int> image_;  // of each pair, into images_
  long builds_ = 0;
  long box_tests_ = 0;
};

}  // namespace footfall
