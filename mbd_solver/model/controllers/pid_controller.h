#pragma once
// PID on the vertical acceleration: hold the deceleration of the body at a set value by adding or taking
// damping force.
//   e = set_point - a,   U = clamp(bias + kp e + ki integral(e) - kd jerk, 0, 1),   the same for every strut
// a and jerk come from the acceleration filter. The integral is held while U is saturated and e would push it
// further (anti-windup), and it only runs while the body brakes (a > 0), so that free fall does not wind it
// up.

#include "mbd_solver/model/controllers/acceleration_filter.h"
#include "mbd_solver/model/controllers/controller.h"

namespace footfall {

struct PidControllerParameters {
  int outputs = 4;                                    // controlled struts >= 1
  double period = kDefaultControllerPeriod;           // > 0 [s]
  double filter_frequency = kDefaultFilterFrequency;  // corner of the acceleration filter, 0 = none [Hz]
  double set_point = 29.4;                            // wanted upward acceleration > 0 (3 g) [m/s2]
  double kp = 0.03;                                   // >= 0 [s2/m]
  double ki = 0.5;                                    // >= 0 [s/m]
  double kd = 0.0;                                    // >= 0 [s3/m]
  double bias = 0.0;                                  // U without error, in [0, 1] [-]
};

class PidController final : public Controller {
 public:
  explicit PidController(const PidControllerParameters& parameters);  // throws InputError

  std::string_view kind() const override { return "pid"; }
  int output_count() const override { return parameters_.outputs; }
  double period() const override { return parameters_.period; }
  void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) override;
  Eigen::VectorXd memory() const override;
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) override;

 private:
  PidControllerParameters parameters_;
  AccelerationFilter filter_;
  double integral_ = 0.0;  // of e [m/s]
};

}  // namespace footfall
