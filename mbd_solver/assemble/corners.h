#pragma once
// The times at which functions of time in a scene have corners or jumps: tables of forces, commands and prescribed
// motions, signals of time or of the time in a state, and conditions of events on them. Steps of the integrator end there: a
// pulse that is shorter than a step is not passed over.

#include <string>
#include <vector>

#include <Eigen/Dense>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/assemble/time_functions.h"
#include "mbd_solver/model/control/given_signals.h"

namespace footfall {

class Corners {
 public:
  // Objects to which the mechanism refers must outlive this object.
  Corners(const Scene& scene, const Mechanism& mechanism);

  // The first corner after t [s] while the inputs of the run have these values; at infinity: none. Where a value jumps,
  // `before` is the last time before the jump, at which a step ends, and `after` the first time behind it, where the next one
  // starts. At t = before, too, the corner is still to come.
  Corner next(double t, const Eigen::VectorXd& values);
  // Likewise, with the times between corners at which steps of the mechanism end for the integrals of curved functions.
  Corner next_step_end(double t, const Eigen::VectorXd& values);
  double next_time(double t, const Eigen::VectorXd& values) { return next(t, values).after; }  // [s] > t
  std::string name_of_next(double t,
                           const Eigen::VectorXd& values);  // of the function or signals that have the first one
  std::vector<std::string> warnings() const;  // about signals that vary too fast, as far as next() has looked

 private:
  std::vector<NamedFunction> functions_;
  std::vector<SignalNode> conditions_;  // of events without a period
  GivenSignals signals_;
};

}  // namespace footfall
