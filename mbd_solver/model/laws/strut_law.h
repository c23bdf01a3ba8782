#pragma once
// The force law of a strut along its line, without any mechanism around it: force as a function of stroke, rate and
// inner state. A strut of a scene is a list of such laws between two points; every law can be tested in closed form
// alone.

#include <Eigen/Dense>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "mbd_solver/model/laws/energy.h"

namespace footfall {

// What a law sees. Stroke x = undeformed length - length [m] (compression positive), rate = dx/dt [m/s].
struct StrutInput {
  double stroke = 0.0;   // [m]
  double rate = 0.0;     // [m/s]
  double voltage = 0.0;  // U commanded by a controller or constant, in [0, 1] [-]; constant within a step
  Eigen::Ref<const Eigen::VectorXd> z;  // inner states of this law
  double time = 0.0;                    // [s]
  double command = 0.0;                 // a signal that commands it, beside its function of time, in the unit of that
};

// What a law answers. Force positive in compression (it pushes the ends apart) [N].
struct StrutOutput {
  explicit StrutOutput(int states)
      : dforce_dz(states), dz(states), ddz_dstroke(states), ddz_drate(states), ddz_dz(states, states) {
    set_zero();
  }
  void set_zero() {
    force = dforce_dstroke = dforce_drate = 0.0;
    dforce_dz.setZero();
    dz.setZero();
    ddz_dstroke.setZero();
    ddz_drate.setZero();
    ddz_dz.setZero();
  }
  double force = 0.0;           // [N]
  double dforce_dstroke = 0.0;  // [N/m]
  double dforce_drate = 0.0;    // [N s/m]
  Eigen::VectorXd dforce_dz;    // states
  Eigen::VectorXd dz;           // rate of the inner states
  Eigen::VectorXd ddz_dstroke;
  Eigen::VectorXd ddz_drate;
  Eigen::MatrixXd ddz_dz;  // states x states
};

struct StrutPower {
  Dissipation kind;
  double power;  // >= 0 [W]
};

class StrutLaw {
 public:
  virtual ~StrutLaw() = default;
  virtual std::string_view kind() const = 0;  // "gas_spring", "mr_damper", "honeycomb", ...
  virtual int state_count() const { return 0; }
  virtual Eigen::VectorXd initial_state() const { return {}; }
  // Force, inner rates and all derivatives. `out` is sized to state_count(); every field is overwritten. No allocation.
  // Throws NumericalError where the law has no value (gas volume exhausted), naming stroke and limit.
  virtual void evaluate(const StrutInput& in, StrutOutput& out) const = 0;
  // Energy stored and recoverable at this stroke and state [J], and its kind.
  virtual double stored_energy(const StrutInput& in) const = 0;
  virtual Stored stored_kind() const { return Stored::kStrain; }
  // Dissipated power, appended by kind.
  // Identity: force * rate + supplied power = d(stored)/dt + sum of dissipated power.
  virtual void dissipated_power(const StrutInput& in, std::vector<StrutPower>& out) const = 0;
  // Power that a drive brings in [W].
  virtual double supplied_power(const StrutInput&) const { return 0.0; }
};

}  // namespace footfall
