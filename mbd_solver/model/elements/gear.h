#pragma once
// A gear, a rack or a differential: a weighted sum of joint coordinates is zero,
//   phi = sum_i f_i q_i = 0,   q_i = 0 in the reference configuration,   angles over any number of turns (TurnCounter)
// divided by f_1, so that phi has the unit of the first coordinate and its multiplier is minus the torque or force of the
// gear on it: Q_i = -lambda f_i / f_1. It does no work. theory 2.1.
// A cam: one of the coordinates enters as a curve, f_i (y(q_i) - y(0)), and Q_i = -lambda y' f_i / f_1. On an open curve its
// angle starts in the turn nearest to the middle of the curve, counts on from there, and leaves the curve along its tangents.
// The model holds one joint per coordinate, between the two bodies of that coordinate; they share one row.

#include <memory>
#include <string>
#include <vector>

#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/laws/curves.h"
#include "mbd_solver/model/model.h"

namespace footfall {

struct GearMember {
  int joint = 0;  // of the model: its markers, z along the axis
  Coordinate coordinate = Coordinate::kAngle;
  double factor = 1.0;                                 // f_i, not zero [1/rad or 1/m, up to a common unit]
  std::shared_ptr<const CubicSpline> curve = nullptr;  // y of a cam; null: q itself
};

// Returns the index of the first joint that it adds; at least two members. The joints are named NAME, NAME/2 ...
int add_gear(Model& model, const std::string& name, const std::vector<GearMember>& members);

// Counts the turns of an angle for a gear, without any force. theory 2.1.
//   z' = q' + kTurnFollow (q - z)     (joint_coordinate.h)
class TurnCounter : public ForceElement {
 public:
  // Markers of the joint, z along its axis.
  TurnCounter(std::string name, Marker m1, Marker m2);

  int state_count() const override { return 1; }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(1); }
  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput&, StoredEnergy&, Dissipated&) const override {}

 private:
  struct Scratch;
  Marker m1_, m2_;
};

}  // namespace footfall
