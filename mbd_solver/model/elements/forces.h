#pragma once
// Forces and torques at a marker, and on a coordinate of a joint.

#include <memory>
#include <optional>
#include <vector>

#include "mbd_solver/model/elements/joint_coordinate.h"
#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/laws/strut_law.h"
#include "mbd_solver/model/laws/time_function.h"

namespace footfall {

// --- A torque on the node of a marker, and the angular velocity that it works on. All add to their last argument.

// Angular velocity of the marker's node in W: w + A Psi da [rad/s].
inline Eigen::Vector3d angular_velocity(const BodyKinematics& body, const Marker& marker) {
  if (body.modes == 0) return body.w;
  const Eigen::Vector3d bending = marker.Psi * body.da;
  return body.w + body.A * bending;
}

// Q += [0; T; Psi^T A^T T] in the columns of the slot. T in W [N m].
inline void add_torque(const PairMotion& pair, int slot, const Marker& marker, const Eigen::Vector3d& T,
                       Eigen::Ref<Eigen::VectorXd> Q) {
  const BodyKinematics& body = *pair.body[slot];
  if (body.ground) return;
  const int offset = pair.offset(slot);
  Q.segment<3>(offset + 3) += T;
  if (body.modes > 0) {
    const Eigen::Vector3d local = body.A.transpose() * T;
    Q.segment(offset + 6, body.modes).noalias() += marker.Psi.transpose() * local;
  }
}

// K += d[0; T; Psi^T A^T T]/dx at fixed T: d(Psi^T A^T T)/dtheta = Psi^T A^T T~
inline void add_torque_derivative(const PairMotion& pair, int slot, const Marker& marker, const Eigen::Vector3d& T,
                                  Eigen::Ref<Eigen::MatrixXd> K) {
  const BodyKinematics& body = *pair.body[slot];
  for (int k = 0; k < body.modes; ++k) {
    const Eigen::Vector3d column = body.A * marker.Psi.col(k);
    K.block<1, 3>(pair.offset(slot) + 6 + k, pair.offset(slot) + 3) += column.cross(T).transpose();
  }
}

// A function of time (null: zero) plus inputs[signal] (-1: none).
struct Magnitude {
  Magnitude(TimeFunctionPtr f = nullptr, int place = -1) : function(std::move(f)), signal(place) {}
  bool is_given() const { return function || signal >= 0; }
  double at(const ElementInput& in) const {
    return (function ? function->at(in.time).value : 0.0) + (signal >= 0 ? in.inputs[signal] : 0.0);
  }
  TimeFunctionPtr function;
  int signal;
};

// A force f and a torque m at a marker of a body, along and about a direction e: the marker's z axis, which turns with the
// body (and its node), or a direction fixed in W.
//   Q = X_p^T f e + W^T m e,  p' = X_p v,  w = W v of the marker's node;   power f e.p' + m e.w
// theory 3.6.
class AppliedForce : public ForceElement {
 public:
  // marker: on a body. fixed_direction: unit vector of W; default the marker's z axis.
  AppliedForce(std::string name, Marker marker, std::optional<Eigen::Vector3d> fixed_direction, Magnitude force,
               Magnitude torque);

  std::array<int, 2> read_inputs() const override { return {force_.signal, torque_.signal}; }
  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;

  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput&, StoredEnergy&, Dissipated&) const override {}
  void add_supply(const ElementInput& in, Supplied& power) const override;  // kForce

 private:
  struct Scratch;
  KinematicVector direction(const PairMotion& pair) const;

  Marker marker_;
  std::optional<Eigen::Vector3d> fixed_direction_;
  Magnitude force_, torque_;  // [N], [N m]
};

struct JointForceSample {
  double q = 0.0;       // [rad or m]
  double rate = 0.0;    // [rad/s or m/s]
  double force = 0.0;   // on q, all laws together [N m or N]
  double supply = 0.0;  // power supplied by drives [W]
};

// Force on one coordinate q of a joint (joint_coordinate.h): a sum of laws of struts, with q as the stroke and
// force = -(generalized force on q).
//   Q = -F(q, q', z, t) dq/dx
// Angles count any number of turns: the first inner state z_0 counts them (nearest_turn). theory 3.6.
class JointForce : public ForceElement, public Switching {
 public:
  // Markers of the joint, z along its axis. command_index: of the signal that commands the laws, among the inputs; -1: none.
  JointForce(std::string name, Marker m1, Marker m2, Coordinate coordinate, std::vector<std::unique_ptr<StrutLaw>> laws,
             int command_index = -1);

  int state_count() const override { return states_; }
  std::array<int, 2> read_inputs() const override { return {command_index_, -1}; }
  Eigen::VectorXd initial_state() const override;
  std::unique_ptr<ElementScratch> scratch(SharedCopies& shared) const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;
  bool switches() const override { return switches_; }
  double switch_value(const ElementInput& in) const override;
  bool switch_states(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> z) const override;
  void add_supply(const ElementInput& in, Supplied& power) const override;  // kDrive

  JointForceSample sample(const ElementInput& in) const;
  const std::vector<std::unique_ptr<StrutLaw>>& laws() const { return laws_; }

 private:
  struct Scratch;
  double with_turns(const ElementInput& in, double alpha) const;  // q
  StrutInput law_input(const ElementInput& in, const JointCoordinate& at, std::size_t law) const;
  const StrutOutput& evaluate(const ElementInput& in, const JointCoordinate& at, std::size_t law) const;

  Marker m1_, m2_;
  Coordinate coordinate_;
  std::vector<std::unique_ptr<StrutLaw>> laws_;
  std::vector<int> first_state_;
  int states_;
  int command_index_;
  bool switches_ = false;
};

// Spring and damper on the angle about the common z axis of two markers: torque on body 2 about z1
//   T = -k (phi - phi0) - c phi',  phi0 = free_stroke
// theory 3.5.
std::unique_ptr<JointForce> torsional_spring(std::string name, Marker m1, Marker m2,
                                             const LinearSpringDamperParameters& parameters);

}  // namespace footfall
