// Drift of the joints: how far they have come apart, and how it is projected away.

#include <cmath>
#include <sstream>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {
namespace {

// Positions are projected until the largest |phi| is below this or no longer falls; round-off of metres is
// 1e-16.
constexpr double kClosed = 1e-13;
constexpr int kMostProjections = 4;
// Drift below these is left alone: a tenth and less of what is promised.
constexpr double kNoDrift = 1e-10;      // [m or rad]
constexpr double kNoSpeedDrift = 2e-9;  // [m/s or rad/s]
// A joint that stays open by more than this after projection has failed: far above round-off, far below what is seen.
constexpr double kOpen = 1e-6;  // [m or rad]
// Without projection (Baumgarte terms, or nothing) joints drift; open by more than this they have failed.
constexpr double kTornOpen = 1e-3;  // [m or rad]; what assembly closes silently

}  // namespace

Equations::Drift Equations::drift(const State& state) {
  Workspace& w = *work_;
  load(state);
  return measure_drift(state.time, w.saddle_x.tail(layout_.row_count), w.phi_rate);
}

Equations::Drift Equations::check_closed(const State& state) {
  const Drift out = drift(state);
  demand_closed(state.time, out, kTornOpen);
  return out;
}

void Equations::demand_closed(double t, const Drift& drift, double tolerance) const {
  if (drift.position_left <= tolerance) return;
  const int index = layout_.row_joint[static_cast<std::size_t>(drift.worst_row)];
  const Joint& joint = model_.joint(index);
  const ConstraintRow& row =
      joint.rows[static_cast<std::size_t>(drift.worst_row - layout_.joint_row[static_cast<std::size_t>(index)])];
  std::ostringstream text;
  text.precision(3);
  text << "t = " << std::to_string(t) << " s: joint \"" << joint.name << "\" (" << joint.kind << ") is open by "
       << drift.position_left << (row.unit == ConstraintRow::Unit::kLength ? " m" : " rad")
       << " and does not close (at most " << tolerance
       << "). Look for masses or inertias that differ by more than a factor of 1e6 between neighbours, for a position "
          "in which the mechanism jams, and for motions that contradict each other; then try a smaller rtol or "
          "max_step.";
  throw NumericalError(text.str());
}

Equations::Drift Equations::measure_drift(double t, Eigen::Ref<Eigen::VectorXd> phi, Eigen::Ref<Eigen::VectorXd> rate) {
  Workspace& w = *work_;
  Drift out;
  phi.setZero();
  rate.setZero();
  for (int j = 0; j < model_.joint_count(); ++j) {
    const Joint& joint = model_.joint(j);
    MarkerVectors vectors(w.joint_pair(joint), joint.m1, joint.m2);
    int row = layout_.joint_row[static_cast<std::size_t>(j)];
    for (const ConstraintRow& condition : joint.rows) {
      const RowValue value =
          measure_row(condition, t, vectors, w.row.head(vectors.pair().size()), w.kinematics.turns(j));
      phi[row] += value.phi;
      rate[row] += value.rate;
      ++row;
    }
  }
  if (layout_.row_count > 0) {
    out.position = phi.cwiseAbs().maxCoeff(&out.worst_row);
    out.velocity = rate.lpNorm<Eigen::Infinity>();
  }
  out.position_left = out.position;
  out.velocity_left = out.velocity;
  return out;
}

Equations::Drift Equations::project(State& state, Close close) {
  Workspace& w = *work_;
  for (int i = 0; i < model_.body_count(); ++i)
    state.q.segment<4>(layout_.body_q[static_cast<std::size_t>(i)] + 3).normalize();
  load(state);
  const Drift before = measure_drift(state.time, w.saddle_x.tail(layout_.row_count), w.phi_rate);
  const auto kept = [](const Drift& drift) { return drift.position <= kNoDrift && drift.velocity <= kNoSpeedDrift; };
  if (close != Close::kFully && kept(before)) return before;
  Drift now = before;
  // Factors of another position lead there more slowly, but cost nothing.
  const bool at_hand = close == Close::kByFactorsAtHand && w.saddle_factored && w.redundancies.empty();
  if (at_hand) remove_drift(kNoDrift, kNoSpeedDrift, true, state, now);
  if (!at_hand || !kept(now)) {
    if (!factor_saddle(state)) {
      demand_closed(state.time, now, kOpen);
      return now;
    }
    remove_drift(kClosed, kClosed, false, state, now);
  }
  demand_closed(state.time, now, kOpen);
  Drift result = before;
  result.position_left = now.position;
  result.velocity_left = now.velocity;
  return result;
}

// With the factors at hand: state.q and state.v, loaded, and their drift.
void Equations::remove_drift(double closed, double closed_speed, bool together, State& state, Drift& now) {
  Workspace& w = *work_;
  Eigen::Ref<Eigen::VectorXd> phi = w.saddle_x.tail(layout_.row_count);
  // dx = -M^-1 Phi_v^T (Phi_v M^-1 Phi_v^T + eps)^-1 phi, and dv likewise from phi': the columns of saddle_two.
  const auto solve = [&](bool positions, bool velocities) {
    auto some = w.saddle_two.middleCols(positions ? 0 : 1, positions && velocities ? 2 : 1);
    some.topRows(layout_.v_size).setZero();
    if (positions) w.saddle_two.col(0).tail(layout_.row_count) = -phi;
    if (velocities) w.saddle_two.col(1).tail(layout_.row_count) = -w.phi_rate;
    w.saddle_lu->solve(some);
  };
  // Positions, with the same factors until phi no longer falls; the first time, where wanted, together with the velocities:
  // one look at the drift judges both.
  for (int i = 0; i < kMostProjections && now.position > closed; ++i) {
    w.last_q = state.q;
    w.last_v = state.v;
    const bool both = together && i == 0 && now.velocity > closed_speed;
    solve(true, both);
    add_increment(layout_, w.saddle_two.col(0).head(layout_.v_size), state.q);
    if (both) state.v += w.saddle_two.col(1).head(layout_.v_size);
    load(state);
    const double last = now.position;
    now = measure_drift(state.time, phi, w.phi_rate);
    if (!(now.position < last)) {  // not finite, or no better: take it back
      state.q = w.last_q;
      state.v = w.last_v;
      load(state);
      now = measure_drift(state.time, phi, w.phi_rate);
      break;
    }
  }
  // The factors are those of a position moved by the drift: repeat.
  for (int i = 0; i < kMostProjections && now.velocity > closed_speed; ++i) {
    w.last_v = state.v;
    solve(false, true);
    state.v += w.saddle_two.col(1).head(layout_.v_size);
    load(state);
    const double last = now.velocity;
    now = measure_drift(state.time, phi, w.phi_rate);
    if (!(now.velocity < last)) {
      state.v = w.last_v;
      load(state);
      now = measure_drift(state.time, phi, w.phi_rate);
      break;
    }
  }
}

}  // namespace footfall
