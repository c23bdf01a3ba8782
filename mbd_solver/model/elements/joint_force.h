#pragma once
// What acts on one coordinate q of a joint (joint_coordinate.h): a sum of laws, as those of a strut, with q in the
// place of the stroke and force = -(generalized force on q).
//   Q = -F(q, q', z, t) dq/dx
// An angle goes on over any number of turns: the first inner state z_0 only tells how many whole turns there are,
// (joints/whole_turns.h). theory 3.6.

#include <memory>
#include <vector>

#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/joints/joint_coordinate.h"
#include "mbd_solver/model/laws/linear_spring_damper.h"
#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

struct JointForceSample {
  double q = 0.0;       // [rad or m]
  double rate = 0.0;    // [rad/s or m/s]
  double force = 0.0;   // on q, all laws together [N m or N]
  double supply = 0.0;  // power that drives bring in [W]
};

class JointForce : public ForceElement {
 public:
  // Markers of the joint, z along its axis. command_index: of the signal that commands the laws, among the voltages and
  // signals of a run; -1: none. Not to be evaluated from two threads at once (it owns scratch).
  JointForce(std::string name, Marker m1, Marker m2, Coordinate coordinate, std::vector<std::unique_ptr<StrutLaw>> laws,
             int command_index = -1);

  int state_count() const override { return states_; }
  int voltage_count() const override { return command_index_ + 1; }
  Eigen::VectorXd initial_state() const override;
  void add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const override;
  bool add_derivatives(const ElementInput& in, ElementDerivatives& out) const override;
  void add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const override;
  void add_supply(const ElementInput& in, Supplied& power) const override;  // kDrive

  JointForceSample sample(const ElementInput& in) const;
  const std::vector<std::unique_ptr<StrutLaw>>& laws() const { return laws_; }

 private:
  double continued(const ElementInput& in, double alpha) const;  // q
  StrutInput law_input(const ElementInput& in, const JointCoordinate& at, std::size_t law) const;
  const StrutOutput& evaluate(const ElementInput& in, const JointCoordinate& at, std::size_t law) const;

  Marker m1_, m2_;
  Coordinate coordinate_;
  std::vector<std::unique_ptr<StrutLaw>> laws_;
  std::vector<int> first_state_;
  int states_;
  int command_index_;
  mutable std::vector<StrutOutput> out_;  // one per law
  mutable std::vector<StrutPower> power_;
  mutable Eigen::VectorXd row_, row_rate_;  // scratch rows of size n
  mutable CoordinateScratch scratch_;
};

// Spring and damper on the angle about the common z axis of two markers: torque on body 2 about z1
//   T = -k (phi - phi0) - c phi',  phi0 = free_stroke
// theory 3.5.
std::unique_ptr<JointForce> torsional_spring(std::string name, Marker m1, Marker m2,
                                             const LinearSpringDamperParameters& parameters);

}  // namespace footfall
