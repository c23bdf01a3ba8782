#pragma once
// A force f and a torque m at a marker of a body, along and about a direction e: the marker's z axis, which turns
// with the body (and its node), or a direction that stands in W.
// Each is a function of time, plus a signal.
//   Q = X_p^T f e + W^T m e,  p' = X_p v,  w = W v of the marker's node;   power f e.p' + m e.w
// theory 3.6.

#include <algorithm>
#include <optional>

#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

// Function of time, null: zero, plus voltages[signal], -1: none.
struct Magnitude {
  Magnitude(TimeFunctionPtr f = nullptr, int place = -1) : function(std::move(f)), signal(place) {}
  bool is_given() const { return function || signal >= 0; }
  double at(const ElementInput& in) const {
    return (function ? function->at(in.time).value : 0.0) + (signal >= 0 ? in.voltages[signal] : 0.0);
  }
  TimeFunctionPtr function;
  int signal;
};

class AppliedForce : public ForceElement {
 public:
  // marker: on a body. fixed_direction: unit vector of W; not given: the marker's z axis.
  AppliedForce(std::string name, Marker marker, std::optional<Eigen::Vector3d> fixed_direction, Magnitude force,
               Magnitude torque);

  int voltage_count() const override { return std::max(force_.signal, torque_.signal) + 1; }

  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput&, StoredEnergy&, Dissipated&) const override {}
  void add_supply(const ElementInput& in, Supplied& power) const override;  // kForce

 private:
  KinematicVector direction(const PairMotion& pair) const;

  Marker marker_;
  std::optional<Eigen::Vector3d> fixed_direction_;
  Magnitude force_, torque_;    // [N], [N m]
  mutable Eigen::Matrix3Xd X_;  // scratch, 3 x n
};

}  // namespace footfall
