#pragma once
// The kinematics that the rows of one joint share.

#include <Eigen/Dense>
#include <optional>

#include "mbd_solver/model/kinematic_vector.h"

namespace footfall {

// The vectors between two markers, each computed at most once. Forces on them are
// collected, so that all rows of a joint pass through the modes of its bodies once.
class MarkerVectors {
 public:
  MarkerVectors(const PairMotion& pair, const Marker& m1, const Marker& m2) : pair_(pair), m1_(m1), m2_(m2) {}
  const PairMotion& pair() const { return pair_; }
  const Marker& marker(int slot) const { return slot == 0 ? m1_ : m2_; }
  const KinematicVector& axis(int slot, int k) {  // axis k of marker 1 (slot 0) or 2 (slot 1)
    std::optional<KinematicVector>& axis = vectors_[3 * slot + k];
    if (!axis) find_axis(slot, k);
    return *axis;
  }
  const KinematicVector& difference() {  // p2 - p1
    std::optional<KinematicVector>& d = vectors_[kDifference];
    if (!d) d.emplace(pair_, m1_, m2_);
    return *d;
  }

  void push_axis(int slot, int k, const Eigen::Vector3d& f) { push(3 * slot + k, f); }
  void push_difference(const Eigen::Vector3d& f) { push(kDifference, f); }
  // out += sum X^T f of all that was pushed
  void add_pushed(Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  static constexpr int kDifference = 6, kVectors = 7;
  void find_axis(int slot, int k);
  void push(int i, const Eigen::Vector3d& f) {
    if (!pushed_[i]) forces_[i].setZero();
    pushed_[i] = true;
    forces_[i] += f;
  }

  PairMotion pair_;
  const Marker& m1_;
  const Marker& m2_;
  bool pushed_[kVectors] = {};
  std::optional<NodeTurn> turn_[2];
  std::optional<KinematicVector> vectors_[kVectors];
  Eigen::Vector3d forces_[kVectors];  // of those that are pushed
};

}  // namespace footfall
