#pragma once
// Dry friction of one coordinate, with true stick: an elastic-plastic bristle (Dupont, Hayward, Armstrong, Altpeter
// 2002). Its deflection z is the inner state; at rest it is a spring, and holds without creeping.
//   F  = k z + d(v) (1 - a) + c v,   k = F_c / delta
//   dz = v (1 - a z / z_s),          z_s(v) = sign(v) g(v) / k,   g(v) = F_c + (F_b - F_c) exp(-(v / v_s)^2)
//   a(z, v) = 0 while |z| < z_0 or z and v have different signs, then rises to 1 at |z_s|:  it slides, F = +-g(v) + c v
//   d(v) = 0.3 F_c u / sqrt(1 + u^2), u = v / v_s: damps the spring while it sticks;  z_0 = 0.7 delta
// Stored: k z^2 / 2. Dissipated: k z (v - dz) + (1 - a) d(v) v + c v^2, none of which is negative. theory 3.6.

#include "mbd_solver/model/laws/strut_law.h"

namespace footfall {

// Units of a displacement; of an angle read rad for m and N m for N.
struct JointFrictionParameters {
  double coulomb = 0.0;                // F_c: when it slides fast > 0 [N]
  double breakaway = 0.0;              // F_b: what it holds at rest >= F_c [N]
  double stribeck_speed = 0.01;        // v_s: at which F_b has fallen towards F_c > 0 [m/s]
  double viscous = 0.0;                // c >= 0 [N s/m]
  double stick_displacement = 1.0e-4;  // delta: deflection under F_c > 0 [m]
};

class JointFriction final : public StrutLaw {
 public:
  explicit JointFriction(const JointFrictionParameters& parameters);  // throws InputError for a value out of its range

  std::string_view kind() const override { return "joint_friction"; }
  int state_count() const override { return 1; }
  Eigen::VectorXd initial_state() const override { return Eigen::VectorXd::Zero(1); }
  void evaluate(const StrutInput& in, StrutOutput& out) const override;
  double stored_energy(const StrutInput& in) const override { return 0.5 * stiffness_ * in.z[0] * in.z[0]; }
  void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const override;  // kFriction >= 0

 private:
  struct Sliding;
  JointFrictionParameters parameters_;
  double stiffness_;  // k [N/m]
};

}  // namespace footfall
