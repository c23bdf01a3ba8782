#pragma once
// SUNDIALS IDA: variable-order BDF on the same residual and the same analytic Jacobian (KLU). A window with
// other loads or inputs (or a state that was changed from outside, a projection included) is a new initial
// value problem: IDA starts again at first order. While nothing changes it goes on. Where drift is projected, all values
// of its history move by what the projection moves (E. Eich, SIAM J. Numer. Anal. 30 (1993), 1467): order and step stay.
// Its error test is that of a single step, without the correction that one_step carries along: errors of hundreds of steps
// add up. So a step may err by a tenth of the tolerances (below 1e-9 by a share that grows, a third at 1e-10).
// Over singular positions OneStep goes in its place (ida_passage.cpp).
// Drift is projected as soon as it is a part of that: conditions of singular positions do not forgive any.

#include <memory>
#include <string>

#include "mbd_solver/integrator/integrator.h"

namespace footfall {

class Ida : public Integrator {
 public:
  Ida(Equations& equations, const IntegratorOptions& options);
  ~Ida() override;

  std::string name() const override { return "ida"; }
  void advance(State& state, double t_end, const Inputs& inputs, const Rows& rows) override;
  const Eigen::VectorXd& end_rates() const override;
  void forget() override;
  const IntegratorStatistics& statistics() const override { return statistics_; }
  void resume(const IntegratorStatistics& so_far) override;
  std::string warning() const override;

 private:
  struct Sundials;  // everything that needs a header of SUNDIALS
  std::unique_ptr<Sundials> ida_;
  IntegratorStatistics statistics_;
};

// Of the library, "6.4.1".
std::string sundials_version();

}  // namespace footfall
