#pragma once
// On-off skyhook (Karnopp 1974), strut by strut: a strut is on while its damper force opposes the motion of
// the body. A compressing strut (rate > 0) pushes the body up, so
//   U_i = on   if velocity * rate_i < 0 (body sinks while the strut compresses, or rises while it extends),
//   else off
// and U_i keeps its value while |rate_i| < deadband or |velocity| < deadband: no chatter at rest.

#include "mbd_solver/model/controllers/controller.h"

namespace footfall {

struct SkyhookControllerParameters {
  int outputs = 4;                           // controlled struts >= 1
  double period = kDefaultControllerPeriod;  // > 0 [s]
  double on = 1.0;                           // voltage in [0, 1] [-]
  double off = 0.0;                          // voltage in [0, on] [-]; also the value before the first decision
  double deadband = 0.01;                    // >= 0 [m/s]
};

class SkyhookController final : public Controller {
 public:
  explicit SkyhookController(const SkyhookControllerParameters& parameters);  // throws InputError

  std::string_view kind() const override { return "skyhook"; }
  int output_count() const override { return parameters_.outputs; }
  double period() const override { return parameters_.period; }
  void sample(const ControllerMeasurement& m, Eigen::Ref<Eigen::VectorXd> voltages) override;
  Eigen::VectorXd memory() const override { return held_; }
  void restore(const Eigen::Ref<const Eigen::VectorXd>& memory) override;

 private:
  SkyhookControllerParameters parameters_;
  Eigen::VectorXd held_;  // last voltages
};

}  // namespace footfall
