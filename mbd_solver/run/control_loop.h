#pragma once
// Sampled control: at its period each controller sees the mechanism and sets voltages, constant until its next sample.

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/dynamics/equations.h"

namespace footfall {

class ControlLoop {
 public:
  // Both must outlive the loop. `up`: unit vector against gravity, in W.
  ControlLoop(std::vector<ControllerEntry>& controllers, const std::vector<StrutEntry>& struts,
              const Eigen::Vector3d& up);

  // Samples every controller that is due at state.time (within rounding) and writes its voltages. `rates`: dy/dt at
  // this time.
  void sample_due(const State& state, Equations& equations, const Eigen::VectorXd& rates, Inputs& inputs);
  // Time of the next sample [s]; infinity without controllers.
  double next_sample() const;
  bool empty() const { return controllers_.empty(); }

 private:
  ControllerMeasurement measure(const ControllerEntry& entry, const State& state, Equations& equations,
                                const Eigen::VectorXd& rates, const Inputs& inputs) const;

  std::vector<ControllerEntry>& controllers_;
  const std::vector<StrutEntry>& struts_;
  Eigen::Vector3d up_;
  std::vector<long> samples_;  // taken so far, per controller
};

}  // namespace footfall
