#pragma once
// SUNDIALS IDA: variable-order BDF on the same residual and the same reduced Jacobian as OneStep. A window with other
// loads or inputs (or a state changed from outside, projection included) is a new initial value problem: IDA restarts
// at first order; otherwise it continues. When drift is projected, all values of its history move with the projection
// (E. Eich, SIAM J. Numer. Anal. 30 (1993), 1467), so that order and step remain. Its error test judges single steps,
// and errors of hundreds of steps accumulate: the error of a step is limited to a tenth of the tolerances (below 1e-9
// to a share that grows, a third at 1e-10). Drift is projected as soon as it reaches a part of this limit, because
// conditions of singular positions amplify it. OneStep replaces IDA over singular positions.

#include <memory>
#include <string>

#include "mbd_solver/integrator/integrator.h"

namespace footfall {

class Ida : public Integrator {
 public:
  Ida(Equations& equations, const IntegratorOptions& options);
  ~Ida() override;

  std::string name() const override { return "ida"; }
  void begin(State& state, double t_end, const Inputs& inputs, const WindowStops& stops) override;
  WindowStop next() override;
  void end_window() override;
  const Eigen::VectorXd& end_rates() const override;
  void forget() override;
  const IntegratorStatistics& statistics() const override { return statistics_; }
  void resume(const IntegratorStatistics& so_far) override;
  std::string warning() const override;

 private:
  struct Sundials;  // everything that requires a header of SUNDIALS
  std::unique_ptr<Sundials> ida_;
  IntegratorStatistics statistics_;
};

// Version of the library, "6.4.1".
std::string sundials_version();

}  // namespace footfall
