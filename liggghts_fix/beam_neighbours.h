#pragma once
// Which grains may touch a chain, and which of its segments: a list that stays true for a while, so that a step looks
// only at pairs that are near. A chain far from the grains costs a comparison of two boxes when the list is made, and
// none of its nodes needs to be looked at until one may have come near.
//
// A pair is on the list when its gap is below
//   margin = 1.5 skin + what the contact model asks for beyond touch.
// LIGGGHTS lets no grain go further than skin/2 from where it last re-neighboured, that is skin from anywhere it was
// since; nodes may go skin/2 before the list is made anew. Together 1.5 skin: no touch is missed.
//
// In a periodic box a chain stands wherever its body is, and grains touch the image that is nearest to them: a chain has
// one contact with a grain, also where it is longer than the box.

#include <Eigen/Geometry>
#include <vector>

#include "liggghts_fix/beam_contact.h"

namespace footfall {

// Grains as LIGGGHTS keeps them: borrowed for the length of a call.
struct GrainView {
  int count = 0;
  const double* const* x = nullptr;  // count pointers to three coordinates [m]
  const double* radius = nullptr;    // [m]
  const int* mask = nullptr;         // bits of the groups a grain belongs to; null: all grains take part
  int group_bit = 1;
};

// Where all grains of a view are.
struct GrainExtent {
  GrainExtent() = default;
  GrainExtent(const GrainView& grains);
  Eigen::AlignedBox3d box;      // of their surfaces
  double largest_radius = 0.0;  // [m]
};

class BeamNeighbours {
 public:
  // skin [m]; reach: contact models with forces over a gap (liquid bridges) see gaps up to reach * radius of the grain;
  // periods: of the box [m], 0 in directions that are not periodic.
  BeamNeighbours(double skin, double reach = 0.0, const Eigen::Vector3d& periods = Eigen::Vector3d::Zero())
      : skin_(skin), reach_(reach), periods_(periods) {}

  // The grains have new numbers or places for which LIGGGHTS made new lists: the next update() makes ours.
  void grains_renumbered(const GrainExtent& grains);
  // Makes the list if the grains were renumbered or a node went further than skin/2 since it was made; true if it did.
  // Call after the nodes moved, at every step but those that clearance() allows to leave out; the grains must be those
  // of the last grains_renumbered(), at their present places.
  bool update(const BeamChain& chain, const GrainView& grains);

  // As long as no node went this far since the list was made, no grain can touch the chain, and there is nothing to be
  // updated [m]; 0 when that cannot be told.
  double clearance() const { return renumbered_ ? 0.0 : clearance_; }

  int size() const { return static_cast<int>(grain_.size()); }            // grains on the list
  int pair_count() const { return static_cast<int>(segment_.size()); }    // pairs on the list
  int grain(int k) const { return grain_[static_cast<std::size_t>(k)]; }  // number of the k-th grain
  // The touch with the smallest gap over the segments near the k-th grain, which stands at x with radius r.
  BeamTouch closest(const BeamChain& chain, int k, const Eigen::Vector3d& x, double r) const;

  long builds() const { return builds_; }        // how often a list was made
  long box_tests() const { return box_tests_; }  // spheres against boxes of segments, in all builds

 private:
  void build(const BeamChain& chain, const GrainView& grains);
  // The images that may touch a grain, of a chain in this box; returns how far the nearest one is from all grains [m].
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
  Eigen::Matrix3Xd x_build_;  // nodes when the list was made
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
