// Which multipliers, where the equations of motion leave a choice: eps acts on what they differ by from those that are
// expected, and of redundant ones those are handed out that are smallest, or zero where rows rest (redundancy.h).

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {
namespace {

// delta of make_smallest(), and how often it is refined: what delta leaves falls by delta each time.
constexpr double kSoft = 1e-8;
constexpr int kRefinements = 2;

}  // namespace

void Equations::expect_multipliers(const Eigen::Ref<const Eigen::VectorXd>& expected,
                                   Eigen::Ref<Eigen::VectorXd> F_lambda) const {
  const Workspace& w = *work_;
  for (int row = 0; row < layout_.row_count; ++row)
    if (w.regularisation[row] == w.eps[row]) F_lambda[row] += w.eps[row] * expected[row];
}

// force += sign Phi_v^T lambda, with the Phi_v of the last fill_saddle().
void Equations::add_reaction(const Eigen::Ref<const Eigen::VectorXd>& lambda, double sign,
                             Eigen::Ref<Eigen::VectorXd> force) const {
  const Workspace& w = *work_;
  const int* outer = w.saddle.outerIndexPtr();
  const int* inner = w.saddle.innerIndexPtr();
  const double* values = w.saddle.valuePtr();
  for (int row = 0; row < layout_.row_count; ++row) {
    for (int k = outer[layout_.v_size + row]; k < outer[layout_.v_size + row + 1]; ++k)
      if (inner[k] < layout_.v_size) force[inner[k]] += sign * values[k] * lambda[row];
  }
}

// min sum (s_i lambda_i)^2 for a given Phi_v^T lambda = f:  [delta M, Phi_v^T; Phi_v, -s^2] [a; lambda] = [f; 0], delta -> 0
void Equations::make_smallest(double t, Eigen::Ref<Eigen::VectorXd> lambda) {
  Workspace& w = *work_;
  if (w.redundancies.empty()) return;
  fill_saddle(t, kSoft, w.smallest_size);
  if (!w.smallest_lu->factor(w.saddle_own)) return;  // lambda stays one that holds
  w.reaction.setZero();
  add_reaction(lambda, 1.0, w.reaction);
  lambda.setZero();
  for (int i = 0; i <= kRefinements; ++i) {
    w.rest_x.head(layout_.v_size) = w.reaction;
    w.rest_x.tail(layout_.row_count).setZero();
    w.smallest_lu->solve(w.rest_x);
    lambda += w.rest_x.tail(layout_.row_count);
    add_reaction(w.rest_x.tail(layout_.row_count), -1.0, w.reaction);
  }
}

void Equations::smallest_multipliers(const State& state, Eigen::Ref<Eigen::VectorXd> lambda) {
  if (work_->redundancies.empty()) return;
  load(state);
  make_smallest(state.time, lambda);
}

// a = 0 and lambda = 0 where rows rest solve  [M, Phi_v^T; Phi_v, -eps] [a; lambda] = [Phi_v^T lambda; 0].
void Equations::rest_multipliers(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                 Eigen::Ref<Eigen::VectorXd> lambda) {
  Workspace& w = *work_;
  if (w.redundancies.empty()) return;
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size), w.empty);
  w.kinematics.load_turns(layout_, y.segment(layout_.z0(), layout_.z_size));
  fill_saddle(t, 1.0, w.regularisation);
  w.saddle_factored = w.saddle_lu->factor(w.saddle_own);
  if (!w.saddle_factored) return;
  w.rest_x.setZero();
  add_reaction(lambda, 1.0, w.rest_x.head(layout_.v_size));
  w.saddle_lu->solve(w.rest_x);
  lambda = w.rest_x.tail(layout_.row_count);
}

}  // namespace footfall
