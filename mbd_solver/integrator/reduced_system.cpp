// The right-hand side of the rows dq - N v passes through the positions on its way: first D^-1, then the stiffness.

#include "mbd_solver/integrator/reduced_system.h"

#include "mbd_solver/dynamics/kinematics.h"

namespace footfall {

ReducedSystem::ReducedSystem(Equations& equations, const Eigen::VectorXd& share)
    : equations_(equations),
      matrix_(equations.jacobian().matrix(), equations.jacobian().local_states()),
      lu_(matrix_.matrix(), share),
      dx_(equations.layout().v_size),
      dq_(equations.layout().q_size) {}

void ReducedSystem::evaluate(double t, const Eigen::VectorXd& y, const Eigen::Ref<const Eigen::VectorXd>& ydot,
                             double c, const Inputs& inputs) {
  equations_.jacobian().evaluate(t, y, ydot, c, inputs);
  at_ = y;
  c_ = c;
}

bool ReducedSystem::factor() { return matrix_.update() && lu_.factor(equations_.jacobian().own_diagonal()); }

void ReducedSystem::solve_whole(Eigen::Ref<Eigen::VectorXd> x) {
  const Layout& layout = equations_.layout();
  const auto q = at_.head(layout.q_size), v = at_.segment(layout.v0(), layout.v_size);
  Eigen::Ref<Eigen::VectorXd> positions = x.head(layout.q_size), lower = x.tail(x.size() - layout.q_size);
  solve_position_rows(layout, v, c_, positions);
  to_increments(layout, q, positions, dx_);
  equations_.jacobian().subtract_stiffness(dx_, lower);
  solve(lower);
  from_increments(layout, q, lower.head(layout.v_size), dq_);
  solve_position_rows(layout, v, c_, dq_);
  positions += dq_;
}

}  // namespace footfall
