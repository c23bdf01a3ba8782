// What Equations answers by a direct solve of the saddle system  [M, Phi_v^T; Phi_v, -eps] [x; lambda] = [f; g], with
// resting rows (redundancy.h) where rows depend on each other.

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {
namespace {

// Rows depend on each other when what is new in one of them is shorter than this; unit rows.
constexpr double kDependent = 1e-4;
// Combinations of unit rows with a length (squared) above this are not zero any more; drift is far below.
constexpr double kIndependent = 1e-8;
// Other rows are chosen to rest when a combination is larger than this; its own row counts 1.
constexpr double kTooLarge = 30.0;
std::string at_time(double t) { return "t = " + std::to_string(t) + " s: "; }

}  // namespace

void Equations::forget() {
  work_->saddle_lu->forget();
  work_->saddle_factored = false;
  if (work_->smallest_lu) work_->smallest_lu->forget();
  work_->redundancies_known = work_->redundancies.empty();
}

bool Equations::factor_saddle(const State& state) {
  Workspace& w = *work_;
  // The matrix depends on the position alone: once is enough, as where each body of a coupling asks for its mass.
  if (w.saddle_factored && w.redundancies.empty() && w.saddle_time == state.time && w.saddle_q == state.q) return true;
  const auto factor = [&] {
    fill_saddle(state.time, 1.0, w.regularisation);
    w.saddle_time = state.time;
    w.saddle_q = state.q;
    return w.saddle_factored = w.saddle_lu->factor(w.saddle_own);
  };
  if (!w.redundancies_known) find_redundancies(state);
  bool done = factor();
  if (w.redundancies.empty()) return done;
  Rest rest = done ? judge_rest() : Rest::kLost;
  if (rest == Rest::kGood) return true;
  if (rest == Rest::kBadRows) {
    choose_resting_rows();
    done = factor();
    rest = done ? judge_rest() : Rest::kLost;
  }
  if (rest == Rest::kGood) return true;
  find_redundancies(state);
  return factor();
}

void Equations::renew_rest(const State& state) {
  if (!work_->redundancies.empty()) factor_at(state);
}

// One solve for a sum of all combinations, each with a weight of its own size and sign.
Equations::Rest Equations::judge_rest() {
  Workspace& w = *work_;
  const auto each_resting = [&](auto use) {  // use(row, weight)
    double phase = 0.0;
    for (const Redundancy& redundancy : w.redundancies) {
      for (const int i : redundancy.resting()) {
        phase += 0.618034;
        phase -= std::floor(phase);
        const int row = redundancy.rows()[static_cast<std::size_t>(i)];
        use(row, (phase < 0.5 ? -1.0 - phase : phase) / std::sqrt(w.smallest_size[row]));
      }
    }
  };
  w.rest_x.setZero();
  each_resting([&](int row, double weight) { w.rest_x[layout_.v_size + row] = -w.smallest_size[row] * weight; });
  w.saddle_lu->solve(w.rest_x);
  const Eigen::Ref<const Eigen::VectorXd> lambda = w.rest_x.tail(layout_.row_count);
  // x^T M x = -x^T Phi_v^T lambda, and Phi_v x is not zero in resting rows alone.
  double length2 = 0.0, resting = 0.0;
  each_resting([&](int row, double weight) {
    length2 += w.smallest_size[row] * std::abs((weight - lambda[row]) * lambda[row]);
    resting += 1.0;
  });
  double size2 = 0.0, largest = 0.0;
  for (const Redundancy& redundancy : w.redundancies) {
    for (const int row : redundancy.rows()) {
      const double size = std::sqrt(w.smallest_size[row]) * std::abs(lambda[row]);
      size2 += size * size;
      largest = std::max(largest, size);
    }
  }
  if (!std::isfinite(size2) || length2 > kIndependent * size2) return Rest::kLost;
  return largest > kTooLarge * std::sqrt(std::max(resting, 1.0)) ? Rest::kBadRows : Rest::kGood;
}

// Groups do not touch each other, so one solve serves a resting row of each.
void Equations::choose_resting_rows() {
  Workspace& w = *work_;
  std::size_t most = 0;
  for (const Redundancy& redundancy : w.redundancies) most = std::max(most, redundancy.resting().size());
  for (std::size_t k = 0; k < most; ++k) {
    w.rest_x.setZero();
    for (const Redundancy& redundancy : w.redundancies) {
      if (k >= redundancy.resting().size()) continue;
      const int row = redundancy.rows()[static_cast<std::size_t>(redundancy.resting()[k])];
      w.rest_x[layout_.v_size + row] = -std::sqrt(w.smallest_size[row]);
    }
    w.saddle_lu->solve(w.rest_x);
    for (Redundancy& redundancy : w.redundancies)
      if (k < redundancy.resting().size()) redundancy.take(static_cast<int>(k), w.rest_x.tail(layout_.row_count));
  }
  for (Redundancy& redundancy : w.redundancies) redundancy.rest_anew();
  rest_rows();
}

// From the state alone.
void Equations::find_redundancies(const State& state) {
  Workspace& w = *work_;
  ConstraintRows rows(model_, layout_);
  rows.evaluate(state);
  const std::vector<RedundantGroup> found = rows.redundant(kDependent);
  for (Redundancy& redundancy : w.redundancies) {
    // A group at this state is part of one at the start, or new: a singular position on the way, which eps serves.
    Eigen::MatrixXd U = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(redundancy.rows().size()), redundancy.count());
    Eigen::Index columns = 0;
    for (const RedundantGroup& group : found) {
      if (!std::includes(redundancy.joints().begin(), redundancy.joints().end(), group.joints.begin(),
                         group.joints.end()))
        continue;
      const Eigen::Index taken = std::min(group.U.cols(), U.cols() - columns);
      for (std::size_t i = 0; i < group.rows.size(); ++i) {
        const auto at = std::lower_bound(redundancy.rows().begin(), redundancy.rows().end(), group.rows[i]);
        U.row(at - redundancy.rows().begin()).segment(columns, taken) =
            group.U.row(static_cast<Eigen::Index>(i)).head(taken);
      }
      columns += taken;
    }
    redundancy.rest(U.leftCols(columns));
  }
  rest_rows();
  w.redundancies_known = true;
}

void Equations::fill_saddle(double t, double mass, const Eigen::VectorXd& diagonal) {
  Workspace& w = *work_;
  double* values = w.saddle.valuePtr();
  Eigen::Map<Eigen::VectorXd>(values, w.saddle.nonZeros()).setZero();
  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const int n = w.kinematics.of(i).size();
    Eigen::Ref<Eigen::MatrixXd> M = w.M.topLeftCorner(n, n);
    body_mass_matrix(model_.body(i), w.kinematics.of(i), w.inertia[at], M);
    for (int k = 0; k < n; ++k) w.saddle_mass[at].add_column(values, k, mass * M.col(k));
    w.saddle_own.segment(layout_.body_v[at], n) = mass * M.diagonal();
  }
  for_each_row(
      model_, layout_, w.kinematics, t, w.row,
      [&](const RowPlace& at, const PairMotion& pair, const Eigen::Ref<Eigen::VectorXd>& phi_v, const RowValue&) {
        const PairPlaces& places = w.saddle_joint[static_cast<std::size_t>(at.joint)];
        for (int i = 0; i < 2; ++i) {
          const int n = pair.body[i]->size();
          if (n == 0) continue;
          places.v_extra[i].add_column(values, at.local, phi_v.segment(pair.offset(i), n));
          for (int k = 0; k < n; ++k) places.extra_v[i].add(values, at.local, k, phi_v[pair.offset(i) + k]);
        }
      });
  for (std::size_t row = 0; row < w.saddle_diagonal.size(); ++row)
    values[w.saddle_diagonal[row]] -= diagonal[static_cast<Eigen::Index>(row)];
}

// With what eps leaves of phi'', eps lambda, taken back once.
void Equations::solve_saddle() {
  Workspace& w = *work_;
  w.saddle_lu->solve(w.saddle_x);
  w.rest_x.setZero();
  expect_multipliers(w.saddle_x.tail(layout_.row_count), w.rest_x.tail(layout_.row_count));
  w.saddle_lu->solve(w.rest_x);
  w.saddle_x -= w.rest_x;
}

void Equations::accelerations(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out) {
  stage_rates(state, inputs, out);
  make_smallest(state.time, out.tail(layout_.row_count));
}

void Equations::stage_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out) {
  // Residual at dv = 0, lambda = 0 is minus the right-hand side.
  Workspace& w = *work_;
  demand_fitting(inputs);
  out.setZero();
  w.y.head(layout_.q_size) = state.q;
  w.y.segment(layout_.v0(), layout_.v_size) = state.v;
  w.y.segment(layout_.z0(), layout_.z_size) = state.z;
  w.y.tail(layout_.row_count).setZero();
  try {
    residual(state.time, w.y, out, inputs, w.rhs);
  } catch (const NumericalError& error) {
    throw NumericalError(at_time(state.time) + error.what());
  }
  out.head(layout_.q_size) = -w.rhs.head(layout_.q_size);
  out.segment(layout_.z0(), layout_.z_size) = -w.rhs.segment(layout_.z0(), layout_.z_size);

  w.saddle_x.head(layout_.v_size) = -w.rhs.segment(layout_.v0(), layout_.v_size);
  w.saddle_x.tail(layout_.row_count) = -w.rhs.tail(layout_.row_count);
  const bool solvable = factor_saddle(state);
  if (solvable) solve_saddle();
  out.segment(layout_.v0(), layout_.v_size) = w.saddle_x.head(layout_.v_size);
  out.tail(layout_.row_count) = w.saddle_x.tail(layout_.row_count);
  if (solvable && out.allFinite()) return;

  for (Eigen::Index i = 0; i < w.y.size(); ++i) {
    if (!std::isfinite(w.y[i]) || !std::isfinite(out[i]))
      throw NumericalError(at_time(state.time) + entry_name(static_cast<int>(i)) + " or its rate is not finite.");
  }
  throw NumericalError(at_time(state.time) + "the equations of motion are singular; does every body have a mass?");
}

void Equations::factor_at(const State& state) {
  load(state);
  factor_saddle(state);
}

void Equations::respond(const State& state, Eigen::Ref<Eigen::VectorXd> f) {
  Workspace& w = *work_;
  load(state);
  const bool solvable = factor_saddle(state);
  w.saddle_x.head(layout_.v_size) = f;
  w.saddle_x.tail(layout_.row_count).setZero();
  if (solvable) w.saddle_lu->solve(w.saddle_x);
  f = w.saddle_x.head(layout_.v_size);
  if (!solvable || !f.allFinite())
    throw NumericalError(at_time(state.time) + "the equations of motion are singular; does every body have a mass?");
}

bool Equations::correct_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out,
                              Eigen::Ref<Eigen::VectorXd> change) {
  Workspace& w = *work_;
  if (!w.saddle_factored || !w.redundancies.empty()) return false;
  demand_fitting(inputs);
  pack(state, out.tail(layout_.row_count), w.y);
  try {
    residual(state.time, w.y, out, inputs, w.rhs);
  } catch (const NumericalError&) {
    return false;
  }
  expect_multipliers(w.y.tail(layout_.row_count), w.rhs.tail(layout_.row_count));
  out.head(layout_.q_size) -= w.rhs.head(layout_.q_size);
  out.segment(layout_.z0(), layout_.z_size) -= w.rhs.segment(layout_.z0(), layout_.z_size);
  w.saddle_x.head(layout_.v_size) = w.rhs.segment(layout_.v0(), layout_.v_size);
  w.saddle_x.tail(layout_.row_count) = w.rhs.tail(layout_.row_count);
  w.saddle_lu->solve(w.saddle_x);
  change.setZero();
  change.segment(layout_.v0(), layout_.v_size) = w.saddle_x.head(layout_.v_size);
  change.tail(layout_.row_count) = w.saddle_x.tail(layout_.row_count);
  out.segment(layout_.v0(), layout_.v_size) -= w.saddle_x.head(layout_.v_size);
  out.tail(layout_.row_count) -= w.saddle_x.tail(layout_.row_count);
  return out.allFinite();
}

void Equations::apply_mass(const Eigen::Ref<const Eigen::VectorXd>& y, const Eigen::Ref<const Eigen::VectorXd>& x,
                           double t, Eigen::Ref<Eigen::VectorXd> out) {
  Workspace& w = *work_;
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size), w.empty);
  out = x;
  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const int n = w.kinematics.of(i).size(), v = layout_.v0() + layout_.body_v[at];
    body_mass_product(model_.body(i), w.kinematics.of(i), x.segment(v, n), w.inertia[at], out.segment(v, n));
  }
  for_each_row(
      model_, layout_, w.kinematics, t, w.row,
      [&](const RowPlace& at, const PairMotion& pair, const Eigen::Ref<Eigen::VectorXd>& phi_v, const RowValue&) {
        const Joint& joint = model_.joint(at.joint);
        const std::array<int, 2> v = pair_v(layout_, joint.m1.body, joint.m2.body);
        double sum = at.adds ? out[layout_.lambda0() + at.row] : 0.0;
        for (int i = 0; i < 2; ++i) {
          const int n = pair.body[i]->size();
          if (n > 0)
            sum += phi_v.segment(pair.offset(i), n).dot(x.segment(layout_.v0() + v[static_cast<std::size_t>(i)], n));
        }
        out[layout_.lambda0() + at.row] = sum;
      });
}

}  // namespace footfall
