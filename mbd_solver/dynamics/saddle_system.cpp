// One sparse LU of [M, Phi_v^T; Phi_v, -eps] per position serves accelerations, responses, reactions and the projection of
// drift. Redundant rows rest (constraint_rows.h), so that the matrix remains regular.

#include "mbd_solver/dynamics/saddle_system.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <map>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/dynamics/codes.h"
#include "mbd_solver/dynamics/equations.h"

namespace footfall {
namespace {

// eps of the equations of motion relative to the diagonal of Phi_v M^-1 Phi_v^T.
constexpr double kRegularisation = 1e-12;
// A body lighter than this share of the heaviest body connected to it counts in eps with this share. Between two heavy bodies
// a light one makes only the diagonal of Phi_v M^-1 Phi_v^T large; eps would be as large as the terms that hold the two.
constexpr double kLight = 1e-6;
// A lighter body is lost in the round-off of the heaviest.
constexpr double kLost = 1e-15;

// Per body: the factor of its contribution to eps, 1 except for very light bodies. Throws InputError.
std::vector<double> shares_in_eps(const Model& model) {
  // Sets of connected bodies, each with its heaviest mass at its root.
  std::vector<int> parent;
  std::vector<double> heaviest;
  for (int i = 0; i < model.body_count(); ++i) {
    parent.push_back(i);
    heaviest.push_back(model.body(i).mass());
  }
  const auto root = [&parent](int i) {
    while (parent[i] != i) {
      parent[i] = parent[parent[i]];
      i = parent[i];
    }
    return i;
  };
  const auto connect = [&](int a, int b) {
    if (a == kGround || b == kGround) return;
    a = root(a);
    b = root(b);
    parent[b] = a;
    double& at_a = heaviest[a];
    at_a = std::max(at_a, heaviest[b]);
  };
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joint(j);
    connect(joint.m1.body, joint.m2.body);
    if (joint.row_of < 0) continue;
    for (const int other : {model.joint(joint.row_of).m1.body, model.joint(joint.row_of).m2.body})
      for (const int own : {joint.m1.body, joint.m2.body}) connect(other, own);
  }
  std::vector<double> shares;
  for (int i = 0; i < model.body_count(); ++i) {
    const double share = heaviest[root(i)];
    if (model.body(i).mass() < kLost * share)
      throw InputError(code::kMassRatio,
                       "body \"" + model.body(i).name() + "\" has a mass of " + number_text(model.body(i).mass(), 3) +
                           " kg and is connected by joints to a body of " + number_text(share, 3) +
                           " kg; the ratio exceeds 1e15 and is lost in round-off. Make it heavier, or remove it.");
    shares.push_back(std::min(1.0, model.body(i).mass() / (kLight * share)));
  }
  return shares;
}

// Unit rows depend on each other if the independent part of one is shorter than this.
constexpr double kDependent = 1e-4;
// Combinations of unit rows with a squared length above this are not zero; drift is far below.
constexpr double kIndependent = 1e-8;
// Other rows are selected to rest if a combination exceeds this; its own row counts 1.
constexpr double kTooLarge = 30.0;
std::string at_time(double t) { return "t = " + plain_text(t) + " s: "; }

// delta of make_smallest(), and its refinements: each reduces the error by the factor delta.
constexpr double kSoft = 1e-8;
constexpr int kRefinements = 2;

// Positions are projected until the largest |phi| is below this or no longer falls; round-off of metres is 1e-16.
constexpr double kClosed = 1e-13;
constexpr int kMostProjections = 4;
// Drift below these remains: a tenth or less of the documented accuracy.
constexpr double kNoDrift = 1e-10;      // [m or rad]
constexpr double kNoSpeedDrift = 2e-9;  // [m/s or rad/s]
// A joint that remains open by more than this after projection has failed.
constexpr double kOpen = 1e-6;  // [m or rad]
// The same without projection (Baumgarte terms, or none).
constexpr double kOpenWithoutProjection = 1e-3;  // [m or rad]; assembly closes as much silently

// row_of_pair: scratch of the largest pair of bodies.
Drift measure_drift(const Model& model, const Layout& layout, const Kinematics& kinematics, double t,
                    Eigen::VectorXd& row_of_pair, Eigen::Ref<Eigen::VectorXd> phi, Eigen::Ref<Eigen::VectorXd> rate) {
  Drift out;
  phi.setZero();
  rate.setZero();
  for (int j = 0; j < model.joint_count(); ++j) {
    const Joint& joint = model.joint(j);
    MarkerVectors vectors(kinematics.pair(joint.m1.body, joint.m2.body), joint.m1, joint.m2);
    int row = layout.joint_row[j];
    for (const ConstraintRow& condition : joint.rows) {
      const RowValue value =
          measure_row(condition, t, vectors, row_of_pair.head(vectors.pair().size()), kinematics.turns(j));
      phi[row] += value.phi;
      rate[row] += value.rate;
      ++row;
    }
  }
  if (layout.row_count > 0) {
    out.position = phi.cwiseAbs().maxCoeff(&out.worst_row);
    out.velocity = rate.lpNorm<Eigen::Infinity>();
  }
  out.position_left = out.position;
  out.velocity_left = out.velocity;
  return out;
}

void require_closed(const Model& model, const Layout& layout, double t, const Drift& drift, double tolerance) {
  if (drift.position_left <= tolerance) return;
  const int index = layout.row_joint[drift.worst_row];
  const Joint& joint = model.joint(index);
  const ConstraintRow& row = joint.rows[drift.worst_row - layout.joint_row[index]];
  std::ostringstream text;
  text.imbue(std::locale::classic());
  text.precision(3);
  text << "t = " << plain_text(t) << " s: joint \"" << joint.name << "\" (" << joint.kind << ") is open by "
       << drift.position_left << (row.unit == ConstraintRow::Unit::kLength ? " m" : " rad")
       << " and cannot be closed (limit " << tolerance
       << "). Check for masses or inertias that differ by more than a factor of 1e6 between neighbours, for a position "
          "in which the mechanism jams, and for motions that contradict each other; then reduce rtol or max_step.";
  throw NumericalError(code::kJointOpened, text.str());
}

}  // namespace

SaddleSystem::SaddleSystem(Equations& equations, const Assembly& assembly)
    : equations_(equations),
      model_(equations.model()),
      layout_(equations.layout()),
      kinematics_(equations.kinematics()),
      pattern_(model_, layout_, kinematics_) {
  int largest = 0;
  for (int i = 0; i < model_.body_count(); ++i) {
    scratch_.inertia.emplace_back(model_.body(i).mode_count());
    largest = std::max(largest, 6 + model_.body(i).mode_count());
  }
  scratch_.row = Eigen::VectorXd::Zero(2 * largest);
  scratch_.M = Eigen::MatrixXd::Zero(2 * largest, 2 * largest);
  own_ = Eigen::VectorXd::Zero(layout_.v_size);
  // Between modes only: close to singular positions the solution depends on round-off, and so on the order of pivots.
  Eigen::VectorXd share = Eigen::VectorXd::Constant(layout_.v_size, ThinLu::kRoundOff);
  for (const int v : layout_.body_v) share.segment<6>(v).setZero();
  lu_ = std::make_unique<ThinLu>(pattern_.matrix, share);
  for (const RedundantGroup& group : assembly.redundant) redundancies_.emplace_back(group);
  if (!redundancies_.empty()) smallest_lu_ = std::make_unique<ThinLu>(pattern_.matrix, share);
  scratch_.x = scratch_.rest_x = Eigen::VectorXd::Zero(layout_.v_size + layout_.row_count);
  scratch_.two = Eigen::MatrixXd::Zero(scratch_.x.size(), 2);
  scratch_.reaction = Eigen::VectorXd::Zero(layout_.v_size);
  scratch_.phi_rate = Eigen::VectorXd::Zero(layout_.row_count);
  scratch_.y = scratch_.rhs = Eigen::VectorXd::Zero(layout_.size());
  scratch_.last_q = Eigen::VectorXd::Zero(layout_.q_size);
  scratch_.last_v = Eigen::VectorXd::Zero(layout_.v_size);
  row_size_ = smallest_size_ = eps_ = regularisation_ = Eigen::VectorXd::Zero(layout_.row_count);
  set_row_sizes(assembly.state);
  set_regularisation();
}

SaddleSystem::~SaddleSystem() = default;

// --- Regularisation and redundant rows.

void SaddleSystem::set_row_sizes(const State& state) {
  equations_.load(state);
  const std::vector<double> shares = shares_in_eps(model_);
  for_each_row(
      model_, layout_, kinematics_, state.time, scratch_.row,
      [&](const RowPlace& at, const PairMotion& pair, const Eigen::Ref<Eigen::VectorXd>& phi_v, const RowValue&) {
        const Joint& joint = model_.joint(at.joint);
        const int bodies[2] = {joint.m1.body, joint.m2.body};
        double size = 0.0, held = 0.0;
        for (int i = 0; i < 2; ++i) {
          const int n = pair.body[i]->size();
          if (n == 0) continue;
          Eigen::Ref<Eigen::MatrixXd> M = scratch_.M.topLeftCorner(n, n);
          body_mass_matrix(model_.body(bodies[i]), *pair.body[i], scratch_.inertia[bodies[i]], M);
          const Eigen::VectorXd part = phi_v.segment(pair.offset(i), n);
          const double length2 = part.dot(Eigen::MatrixXd(M).ldlt().solve(part));
          size += length2;
          held += shares[bodies[i]] * length2;
        }
        row_size_[at.row] += size;  // of a gear without terms of two members on one body: an estimate
        eps_[at.row] += kRegularisation * held;
      });
  smallest_size_ = row_size_;
  for (const Redundancy& redundancy : redundancies_) {
    for (std::size_t i = 0; i < redundancy.rows().size(); ++i) {
      const double s = redundancy.s()[static_cast<Eigen::Index>(i)];
      smallest_size_[redundancy.rows()[i]] = s * s;
    }
  }
}

void SaddleSystem::set_regularisation() {
  if (!redundancies_.empty()) ++resting_row_changes_;
  regularisation_ = eps_;
  // The row of a rotor: lambda = J q''.
  for (int row = 0; row < layout_.row_count; ++row) {
    const int joint = layout_.row_joint[row];
    const int first = layout_.joint_row[joint];
    const double inertia = model_.joint(joint).rows[row - first].inertia;
    if (inertia > 0.0) regularisation_[row] = 1.0 / inertia;
  }
  for (const Redundancy& redundancy : redundancies_)
    for (const int i : redundancy.resting()) {
      const int row = redundancy.rows()[i];
      regularisation_[row] = smallest_size_[row];
    }
}

void SaddleSystem::expect_multipliers(const Eigen::Ref<const Eigen::VectorXd>& expected,
                                      Eigen::Ref<Eigen::VectorXd> F_lambda) const {
  for (int row = 0; row < layout_.row_count; ++row)
    if (regularisation_[row] == eps_[row]) F_lambda[row] += eps_[row] * expected[row];
}

void SaddleSystem::forget() {
  lu_->forget();
  factored_ = false;
  if (smallest_lu_) smallest_lu_->forget();
  redundancies_known_ = redundancies_.empty();
}

bool SaddleSystem::factor_saddle(const State& state) {
  // The matrix depends on the position alone: one factorization serves all coupled bodies.
  if (factored_ && redundancies_.empty() && factored_time_ == state.time && factored_q_ == state.q) return true;
  const auto factor = [&] {
    fill_saddle(state.time, 1.0, regularisation_);
    factored_time_ = state.time;
    factored_q_ = state.q;
    return factored_ = lu_->factor(own_);
  };
  if (!redundancies_known_) find_redundancies(state);
  bool done = factor();
  if (redundancies_.empty()) return done;
  Rest rest = done ? judge_resting_rows() : Rest::kLost;
  if (rest == Rest::kGood) return true;
  if (rest == Rest::kBadRows) {
    choose_resting_rows();
    done = factor();
    rest = done ? judge_resting_rows() : Rest::kLost;
  }
  if (rest == Rest::kGood) return true;
  find_redundancies(state);
  return factor();
}

void SaddleSystem::update_resting_rows(const State& state) {
  if (!redundancies_.empty()) factor_at(state);
}

// One solve for the sum of all combinations, each with its own weight and sign.
SaddleSystem::Rest SaddleSystem::judge_resting_rows() {
  const auto each_resting = [&](auto use) {  // use(row, weight)
    double phase = 0.0;
    for (const Redundancy& redundancy : redundancies_) {
      for (const int i : redundancy.resting()) {
        phase += 0.618034;
        phase -= std::floor(phase);
        const int row = redundancy.rows()[i];
        use(row, (phase < 0.5 ? -1.0 - phase : phase) / std::sqrt(smallest_size_[row]));
      }
    }
  };
  scratch_.rest_x.setZero();
  each_resting([&](int row, double weight) { scratch_.rest_x[layout_.v_size + row] = -smallest_size_[row] * weight; });
  lu_->solve(scratch_.rest_x);
  const Eigen::Ref<const Eigen::VectorXd> lambda = scratch_.rest_x.tail(layout_.row_count);
  // x^T M x = -x^T Phi_v^T lambda, and Phi_v x is not zero in resting rows alone.
  double length2 = 0.0, resting = 0.0;
  each_resting([&](int row, double weight) {
    length2 += smallest_size_[row] * std::abs((weight - lambda[row]) * lambda[row]);
    resting += 1.0;
  });
  double size2 = 0.0, largest = 0.0;
  for (const Redundancy& redundancy : redundancies_) {
    for (const int row : redundancy.rows()) {
      const double size = std::sqrt(smallest_size_[row]) * std::abs(lambda[row]);
      size2 += size * size;
      largest = std::max(largest, size);
    }
  }
  if (!std::isfinite(size2) || length2 > kIndependent * size2) return Rest::kLost;
  return largest > kTooLarge * std::sqrt(std::max(resting, 1.0)) ? Rest::kBadRows : Rest::kGood;
}

// Groups are independent: one solve serves one resting row of each group.
void SaddleSystem::choose_resting_rows() {
  std::size_t most = 0;
  for (const Redundancy& redundancy : redundancies_) most = std::max(most, redundancy.resting().size());
  for (std::size_t k = 0; k < most; ++k) {
    scratch_.rest_x.setZero();
    for (const Redundancy& redundancy : redundancies_) {
      if (k >= redundancy.resting().size()) continue;
      const int row = redundancy.rows()[redundancy.resting()[k]];
      scratch_.rest_x[layout_.v_size + row] = -std::sqrt(smallest_size_[row]);
    }
    lu_->solve(scratch_.rest_x);
    for (Redundancy& redundancy : redundancies_)
      if (k < redundancy.resting().size())
        redundancy.set_combination(static_cast<int>(k), scratch_.rest_x.tail(layout_.row_count));
  }
  for (Redundancy& redundancy : redundancies_) redundancy.reselect();
  set_regularisation();
}

// Depends on the state alone.
void SaddleSystem::find_redundancies(const State& state) {
  ConstraintRows rows(model_, layout_);
  rows.evaluate(state);
  const std::vector<RedundantGroup> found = rows.redundant(kDependent);
  // A group at this state is part of one at the start, or belongs to a singular position, which eps regularises.
  std::vector<const Redundancy*> owner(static_cast<std::size_t>(model_.joint_count()), nullptr);
  std::map<const Redundancy*, std::vector<const RedundantGroup*>> parts;
  for (const Redundancy& redundancy : redundancies_)
    for (const int joint : redundancy.joints()) owner[joint] = &redundancy;
  for (const RedundantGroup& group : found) parts[owner[group.joints.front()]].push_back(&group);
  for (Redundancy& redundancy : redundancies_) {
    Eigen::MatrixXd U = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(redundancy.rows().size()), redundancy.count());
    Eigen::Index columns = 0;
    for (const RedundantGroup* part : parts[&redundancy]) {
      const RedundantGroup& group = *part;
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
  set_regularisation();
  redundancies_known_ = true;
}

// --- Solutions.

void SaddleSystem::fill_saddle(double t, double mass, const Eigen::VectorXd& diagonal) {
  double* values = pattern_.matrix.valuePtr();
  Eigen::Map<Eigen::VectorXd>(values, pattern_.matrix.nonZeros()).setZero();
  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const int n = kinematics_.of(i).size();
    Eigen::Ref<Eigen::MatrixXd> M = scratch_.M.topLeftCorner(n, n);
    body_mass_matrix(model_.body(i), kinematics_.of(i), scratch_.inertia[at], M);
    for (int k = 0; k < n; ++k) pattern_.mass[at].add_column(values, k, mass * M.col(k));
    own_.segment(layout_.body_v[at], n) = mass * M.diagonal();
  }
  for_each_row(
      model_, layout_, kinematics_, t, scratch_.row,
      [&](const RowPlace& at, const PairMotion& pair, const Eigen::Ref<Eigen::VectorXd>& phi_v, const RowValue&) {
        const PairPlaces& places = pattern_.joints[at.joint];
        for (int i = 0; i < 2; ++i) {
          const int n = pair.body[i]->size();
          if (n == 0) continue;
          places.v_extra[i].add_column(values, at.local, phi_v.segment(pair.offset(i), n));
          for (int k = 0; k < n; ++k) places.extra_v[i].add(values, at.local, k, phi_v[pair.offset(i) + k]);
        }
      });
  for (std::size_t row = 0; row < pattern_.diagonal.size(); ++row)
    values[pattern_.diagonal[row]] -= diagonal[static_cast<Eigen::Index>(row)];
}

// The error of eps in phi'', eps lambda, is removed once.
void SaddleSystem::solve_saddle() {
  lu_->solve(scratch_.x);
  scratch_.rest_x.setZero();
  expect_multipliers(scratch_.x.tail(layout_.row_count), scratch_.rest_x.tail(layout_.row_count));
  lu_->solve(scratch_.rest_x);
  scratch_.x -= scratch_.rest_x;
}

void SaddleSystem::accelerations(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out) {
  stage_rates(state, inputs, out);
  make_smallest(state.time, out.tail(layout_.row_count));
}

void SaddleSystem::stage_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out) {
  // Residual at dv = 0, lambda = 0 is minus the right-hand side.
  equations_.check_inputs(inputs);
  out.setZero();
  scratch_.y.head(layout_.q_size) = state.q;
  scratch_.y.segment(layout_.v0(), layout_.v_size) = state.v;
  scratch_.y.segment(layout_.z0(), layout_.z_size) = state.z;
  scratch_.y.tail(layout_.row_count).setZero();
  try {
    equations_.residual(state.time, scratch_.y, out, inputs, scratch_.rhs);
  } catch (const NumericalError& error) {
    throw NumericalError(at_time(state.time) + error.what());
  }
  out.head(layout_.q_size) = -scratch_.rhs.head(layout_.q_size);
  out.segment(layout_.z0(), layout_.z_size) = -scratch_.rhs.segment(layout_.z0(), layout_.z_size);

  scratch_.x.head(layout_.v_size) = -scratch_.rhs.segment(layout_.v0(), layout_.v_size);
  scratch_.x.tail(layout_.row_count) = -scratch_.rhs.tail(layout_.row_count);
  const bool solvable = factor_saddle(state);
  if (solvable) solve_saddle();
  out.segment(layout_.v0(), layout_.v_size) = scratch_.x.head(layout_.v_size);
  out.tail(layout_.row_count) = scratch_.x.tail(layout_.row_count);
  if (solvable && out.allFinite()) return;

  for (Eigen::Index i = 0; i < scratch_.y.size(); ++i) {
    if (!std::isfinite(scratch_.y[i]) || !std::isfinite(out[i]))
      throw NumericalError(code::kNotFinite, at_time(state.time) + equations_.entry_name(static_cast<int>(i)) +
                                                 " or its rate is not finite.");
  }
  throw NumericalError(code::kSingular,
                       at_time(state.time) + "the equations of motion are singular. Check that every body has a mass.");
}

void SaddleSystem::factor_at(const State& state) {
  equations_.load(state);
  factor_saddle(state);
}

void SaddleSystem::respond(const State& state, Eigen::Ref<Eigen::VectorXd> f) {
  equations_.load(state);
  const bool solvable = factor_saddle(state);
  scratch_.x.head(layout_.v_size) = f;
  scratch_.x.tail(layout_.row_count).setZero();
  if (solvable) lu_->solve(scratch_.x);
  f = scratch_.x.head(layout_.v_size);
  if (!solvable || !f.allFinite())
    throw NumericalError(
        code::kSingular,
        at_time(state.time) + "the equations of motion are singular. Check that every body has a mass.");
}

bool SaddleSystem::correct_rates(const State& state, const Inputs& inputs, Eigen::Ref<Eigen::VectorXd> out,
                                 Eigen::Ref<Eigen::VectorXd> change) {
  if (!factored_ || !redundancies_.empty()) return false;
  equations_.check_inputs(inputs);
  equations_.layout().pack(state, out.tail(layout_.row_count), scratch_.y);
  try {
    equations_.residual(state.time, scratch_.y, out, inputs, scratch_.rhs);
  } catch (const NumericalError&) {
    return false;
  }
  expect_multipliers(scratch_.y.tail(layout_.row_count), scratch_.rhs.tail(layout_.row_count));
  out.head(layout_.q_size) -= scratch_.rhs.head(layout_.q_size);
  out.segment(layout_.z0(), layout_.z_size) -= scratch_.rhs.segment(layout_.z0(), layout_.z_size);
  scratch_.x.head(layout_.v_size) = scratch_.rhs.segment(layout_.v0(), layout_.v_size);
  scratch_.x.tail(layout_.row_count) = scratch_.rhs.tail(layout_.row_count);
  lu_->solve(scratch_.x);
  change.setZero();
  change.segment(layout_.v0(), layout_.v_size) = scratch_.x.head(layout_.v_size);
  change.tail(layout_.row_count) = scratch_.x.tail(layout_.row_count);
  out.segment(layout_.v0(), layout_.v_size) -= scratch_.x.head(layout_.v_size);
  out.tail(layout_.row_count) -= scratch_.x.tail(layout_.row_count);
  return out.allFinite();
}

double SaddleSystem::log_determinant(const State& state) {
  equations_.load(state);
  return factor_saddle(state) ? lu_->log_determinant() : -std::numeric_limits<double>::infinity();
}

// --- Multipliers.

// force += sign Phi_v^T lambda, with the Phi_v of the last fill_saddle().
void SaddleSystem::add_reaction(const Eigen::Ref<const Eigen::VectorXd>& lambda, double sign,
                                Eigen::Ref<Eigen::VectorXd> force) const {
  const int* outer = pattern_.matrix.outerIndexPtr();
  const int* inner = pattern_.matrix.innerIndexPtr();
  const double* values = pattern_.matrix.valuePtr();
  for (int row = 0; row < layout_.row_count; ++row) {
    for (int k = outer[layout_.v_size + row]; k < outer[layout_.v_size + row + 1]; ++k)
      if (inner[k] < layout_.v_size) force[inner[k]] += sign * values[k] * lambda[row];
  }
}

// min sum (s_i lambda_i)^2 for a given Phi_v^T lambda = f:  [delta M, Phi_v^T; Phi_v, -s^2] [a; lambda] = [f; 0], delta -> 0
void SaddleSystem::make_smallest(double t, Eigen::Ref<Eigen::VectorXd> lambda) {
  if (redundancies_.empty()) return;
  fill_saddle(t, kSoft, smallest_size_);
  if (!smallest_lu_->factor(own_)) return;  // lambda remains valid
  scratch_.reaction.setZero();
  add_reaction(lambda, 1.0, scratch_.reaction);
  lambda.setZero();
  for (int i = 0; i <= kRefinements; ++i) {
    scratch_.rest_x.head(layout_.v_size) = scratch_.reaction;
    scratch_.rest_x.tail(layout_.row_count).setZero();
    smallest_lu_->solve(scratch_.rest_x);
    lambda += scratch_.rest_x.tail(layout_.row_count);
    add_reaction(scratch_.rest_x.tail(layout_.row_count), -1.0, scratch_.reaction);
  }
}

void SaddleSystem::smallest_multipliers(const State& state, Eigen::Ref<Eigen::VectorXd> lambda) {
  if (redundancies_.empty()) return;
  equations_.load(state);
  make_smallest(state.time, lambda);
}

// a = 0 and lambda = 0 where rows rest solve  [M, Phi_v^T; Phi_v, -eps] [a; lambda] = [Phi_v^T lambda; 0].
void SaddleSystem::multipliers_without_resting_rows(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                    Eigen::Ref<Eigen::VectorXd> lambda) {
  if (redundancies_.empty()) return;
  equations_.load(y);
  fill_saddle(t, 1.0, regularisation_);
  factored_ = lu_->factor(own_);
  if (!factored_) return;
  scratch_.rest_x.setZero();
  add_reaction(lambda, 1.0, scratch_.rest_x.head(layout_.v_size));
  lu_->solve(scratch_.rest_x);
  lambda = scratch_.rest_x.tail(layout_.row_count);
}

// --- Drift.

Drift SaddleSystem::drift(const State& state) {
  equations_.load(state);
  return measure_drift(model_, layout_, kinematics_, state.time, scratch_.row, scratch_.x.tail(layout_.row_count),
                       scratch_.phi_rate);
}

Drift SaddleSystem::check_closed(const State& state) {
  const Drift out = drift(state);
  require_closed(model_, layout_, state.time, out, kOpenWithoutProjection);
  return out;
}

Drift SaddleSystem::project(State& state, Close close) {
  for (int i = 0; i < model_.body_count(); ++i) state.q.segment<4>(layout_.body_q[i] + 3).normalize();
  equations_.load(state);
  const Drift before = measure_drift(model_, layout_, kinematics_, state.time, scratch_.row,
                                     scratch_.x.tail(layout_.row_count), scratch_.phi_rate);
  const auto small = [](const Drift& drift) { return drift.position <= kNoDrift && drift.velocity <= kNoSpeedDrift; };
  if (close != Close::kFully && small(before)) return before;
  Drift now = before;
  // Factors of another position converge more slowly, but cost nothing.
  const bool old_factors = close == Close::kWithOldFactors && factored_ && redundancies_.empty();
  if (old_factors) remove_drift(kNoDrift, kNoSpeedDrift, true, state, now);
  if (!old_factors || !small(now)) {
    if (!factor_saddle(state)) {
      require_closed(model_, layout_, state.time, now, kOpen);
      return now;
    }
    remove_drift(kClosed, kClosed, false, state, now);
  }
  require_closed(model_, layout_, state.time, now, kOpen);
  Drift result = before;
  result.position_left = now.position;
  result.velocity_left = now.velocity;
  return result;
}

// With the current factors: state.q and state.v, loaded, and their drift.
void SaddleSystem::remove_drift(double closed, double closed_speed, bool together, State& state, Drift& now) {
  Eigen::Ref<Eigen::VectorXd> phi = scratch_.x.tail(layout_.row_count);
  // dx = -M^-1 Phi_v^T (Phi_v M^-1 Phi_v^T + eps)^-1 phi, and dv likewise from phi': the columns of saddle_two.
  const auto solve = [&](bool positions, bool velocities) {
    auto some = scratch_.two.middleCols(positions ? 0 : 1, positions && velocities ? 2 : 1);
    some.topRows(layout_.v_size).setZero();
    if (positions) scratch_.two.col(0).tail(layout_.row_count) = -phi;
    if (velocities) scratch_.two.col(1).tail(layout_.row_count) = -scratch_.phi_rate;
    lu_->solve(some);
  };
  // Positions, with the same factors until phi no longer falls; if required, the first time together with the velocities, so
  // that one evaluation of the drift serves both.
  for (int i = 0; i < kMostProjections && now.position > closed; ++i) {
    scratch_.last_q = state.q;
    scratch_.last_v = state.v;
    const bool both = together && i == 0 && now.velocity > closed_speed;
    solve(true, both);
    add_increment(layout_, scratch_.two.col(0).head(layout_.v_size), state.q);
    if (both) state.v += scratch_.two.col(1).head(layout_.v_size);
    equations_.load(state);
    const double last = now.position;
    now = measure_drift(model_, layout_, kinematics_, state.time, scratch_.row, phi, scratch_.phi_rate);
    if (!(now.position < last)) {  // not finite, or no better: undo
      state.q = scratch_.last_q;
      state.v = scratch_.last_v;
      equations_.load(state);
      now = measure_drift(model_, layout_, kinematics_, state.time, scratch_.row, phi, scratch_.phi_rate);
      break;
    }
  }
  // The factors belong to a position that differs by the drift: repeat.
  for (int i = 0; i < kMostProjections && now.velocity > closed_speed; ++i) {
    scratch_.last_v = state.v;
    solve(false, true);
    state.v += scratch_.two.col(1).head(layout_.v_size);
    equations_.load(state);
    const double last = now.velocity;
    now = measure_drift(model_, layout_, kinematics_, state.time, scratch_.row, phi, scratch_.phi_rate);
    if (!(now.velocity < last)) {
      state.v = scratch_.last_v;
      equations_.load(state);
      now = measure_drift(model_, layout_, kinematics_, state.time, scratch_.row, phi, scratch_.phi_rate);
      break;
    }
  }
}

}  // namespace footfall
