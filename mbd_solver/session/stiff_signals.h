#pragma once
// Signals of other programs (FMUs, Python files) that close a loop of force and motion: a spring in an FMU on a body here. Held values
// feed such a motion, the more the larger omega H is; a run reports it.

#include <string>
#include <vector>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/session/observe/spring_fit.h"

namespace footfall {

class StiffSignals {
 public:
  // All must outlive this.
  StiffSignals(const Scene& scene, const Mechanism& mechanism, const Assembly& assembly, const Baumgarte& baumgarte);

  bool empty() const { return watched_.empty(); }
  // After signals were sampled at this state. inputs: with their new values.
  void observe(const State& state, const Inputs& inputs);
  const std::vector<std::string>& warnings() const { return warnings_; }

 private:
  struct Watched {
    std::string signal, program;  // "engine.thrust", "engine.fmu"
    int place = 0;                // among the inputs
    double period = 0.0;          // [s]
    bool late = false;            // its outputs answer the inputs of the sample before
    long samples = 0;
    double x = 0.0, v = 0.0;  // displacement [m or rad] and velocity [m/s or rad/s] in the direction of its force
    double last_x = 0.0, last_v = 0.0;  // at the sample before
    SpringFit fit = {};
    bool told = false;
  };
  void observe(Watched& w, const State& state, const Inputs& inputs);
  void tell(Watched& w, double time, const SpringAndDamper& found, double mass);

  Equations equations_;  // of its own: what is integrated remembers nothing of this
  std::vector<Watched> watched_;
  std::vector<std::string> warnings_;
  Inputs varied_;
  Eigen::VectorXd y_, rates_, response_, momentum_;
};

}  // namespace footfall
