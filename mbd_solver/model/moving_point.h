#pragma once
// What forces at a point of a body need where no accelerations and no derivatives are asked for.

#include <Eigen/Dense>

#include "mbd_solver/model/body_kinematics.h"
#include "mbd_solver/model/marker.h"

namespace footfall {

// Position and velocity of a marker's point: r + x, dr + w x x + A S da.
class MovingPoint {
 public:
  MovingPoint() = default;
  MovingPoint(const BodyKinematics& body, const Marker& marker);  // not on the ground
  const Eigen::Vector3d& value() const { return value_; }
  const Eigen::Vector3d& rate() const { return rate_; }
  // out += X^T f, in the columns of the body
  void add_transposed(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  const BodyKinematics* body_ = nullptr;
  const Marker* marker_ = nullptr;
  Eigen::Vector3d value_ = Eigen::Vector3d::Zero(), rate_ = value_, x_ = value_;
};

}  // namespace footfall
