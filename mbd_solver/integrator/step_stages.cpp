// Stages are predicted from earlier rates, then solved one after the other; a stage that converges
// slowly gets its own Jacobian.

#include "mbd_solver/integrator/step_stages.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mbd_solver/dynamics/kinematics.h"

namespace footfall {
namespace {

constexpr int kMostBefore = 4;          // stored rates of a step
constexpr double kReach = 3.0;          // longer steps, in steps before, do not use the rates before
constexpr std::size_t kPredictors = 3;  // rates in a prediction: a parabola

}  // namespace

RatePredictor::RatePredictor(int stages, Eigen::Index size) {
  before_.assign(static_cast<std::size_t>(std::min(stages, kMostBefore)), Eigen::VectorXd::Zero(size));
}

// A parabola through the rates nearest in time. Rates of the step before are moved by the jump since. Times in steps h from the start of this step.
void RatePredictor::predict(const Tableau& tableau, int stage, double h, std::vector<Eigen::VectorXd>& rates) const {
  struct Known {
    double time;
    const Eigen::VectorXd* rates;
    bool before;
  };
  std::array<Known, kMostStages + 3> known{};
  std::size_t count = 0;
  const double target = tableau.c[stage];
  for (std::size_t j = 0; j < static_cast<std::size_t>(stage); ++j) known[count++] = {tableau.c[j], &rates[j], false};
  if (h_ > 0.0 && h < kReach * h_) {
    for (std::size_t k = 0; k + 1 < before_.size(); ++k)
      known[count++] = {(tableau_->c[k] - 1.0) * h_ / h, &before_[k], true};
  }
  std::sort(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(count),
            [&](const Known& a, const Known& b) { return std::abs(a.time - target) < std::abs(b.time - target); });
  count = std::min(count, kPredictors);
  std::array<double, kPredictors> times{};
  for (std::size_t j = 0; j < count; ++j) times[j] = known[j].time;
  Eigen::VectorXd& K = rates[stage];
  K.setZero();
  for (std::size_t j = 0; j < count; ++j) {
    const double weight = lagrange(times, count, j, target);
    K += weight * *known[j].rates;
    if (known[j].before) K += weight * (rates[0] - before_.back());
  }
}

void RatePredictor::accept(const Tableau& tableau, double h, std::vector<Eigen::VectorXd>& K) {
  for (std::size_t k = 0; k + 1 < before_.size(); ++k) before_[k].swap(K[k]);
  before_.back().swap(K[tableau.last()]);
  K[0] = before_.back();
  h_ = h;
  tableau_ = &tableau;
}

namespace {

// Remaining error of Newton relative to the error of the step: invisible in the error estimate and
// in the sum over many steps. The error of a first step is estimated; none counts as less than
// kLeastError, because of round-off.
constexpr double kNewton = 0.03, kFirstError = 1e-2, kLeastError = 1e-4, kRoundOff = 1e-12;
// Of the energy of motion and deformation, against which errors of work are small; and the same at rest, where a velocity
// within its tolerance is off by more than itself. An error of work is usual up to kMostWorkError times the error of the state.
constexpr double kEnergyShare = 0.01, kRest = 100.0, kMostWorkError = 1e3;
// Convergence rate of a stage from which the next stage has its own Jacobian: a stiff force
// whose direction turns within the step makes the Jacobian of its start useless, and the error that Newton then
// leaves, small in every coordinate, adds up over many steps.
constexpr double kStale = 0.1;

}  // namespace

StepData::StepData(const Layout& layout, const Tableau& first, int most_stages) : tableau(&first) {
  const std::size_t stages = most_stages;
  y = Eigen::VectorXd::Zero(layout.size());
  K.assign(stages, y);
  Y.assign(stages, y);
  energy.resize(stages);
}

StepStages::StepStages(Equations& equations, const IntegratorOptions& options, int stages, StepData& step,
                       IntegratorStatistics& statistics)
    : equations_(equations),
      options_(options),
      step_(step),
      norm_(equations.layout(), options),
      newton_(equations, norm_, statistics, failure_),
      predictor_(stages, equations.layout().size()) {
  Ydot_ = known_ = F_ = step.y;
  dx_ = Eigen::VectorXd::Zero(equations.layout().v_size);
  for (int i = 0; i < equations.model().body_count(); ++i) mass_ += equations.model().body(i).mass();
}

double StepStages::newton_tolerance(double h, double error_before) const {
  const double expected = predictor_.has_step() && predictor_.tableau() == step_.tableau
                              ? error_before * std::pow(h / predictor_.step(), step_.tableau->estimated_order + 1)
                              : kFirstError;
  return kNewton * std::clamp(expected, std::min(std::max(kLeastError, kRoundOff / options_.rtol), 1.0), 1.0);
}

bool StepStages::solve(double t, double h, const Treatment& treatment, const Inputs& inputs) {
  norm_.set(step_.y);
  failure_.reason.clear();
  const double tolerance = newton_tolerance(h, treatment.error_before);
  for (std::size_t i = 1; i <= step_.last(); ++i)
    if (!solve_stage(i, t, h, tolerance, treatment, inputs)) return false;
  return true;
}

bool StepStages::solve_stage(std::size_t i, double t, double h, double tolerance, const Treatment& treatment,
                             const Inputs& inputs) {
  const Tableau& tableau = *step_.tableau;
  const int m = equations_.layout().lambda0(), rows = equations_.layout().row_count;
  const double c = 1.0 / (h * tableau.gamma), slow = treatment.slow, t_stage = t + tableau.c[i] * h;
  Eigen::VectorXd &Y = step_.Y[i], &K = step_.K[i];
  known_ = step_.y;
  for (std::size_t j = 0; j < i; ++j)
    if (tableau.a[i][j] != 0.0) known_ += (h * tableau.a[i][j]) * step_.K[j];
  predictor_.predict(tableau, static_cast<int>(i), h, step_.K);
  const auto begin = [&] {
    Y.head(m) = known_.head(m) + (h * tableau.gamma) * K.head(m);
    Y.tail(rows) = K.tail(rows);
  };
  begin();
  const bool own = treatment.at_stages || (treatment.stiff && i > 1 && newton_.rate() > kStale);
  if (own) {
    if (!newton_.refresh(t_stage, Y, K, c, slow, inputs)) return false;
  } else if (newton_.needs_jacobian(c, i == 1, slow)) {
    // At the start of the step: the prediction of the first implicit stage differs from it by O(h).
    if (!newton_.refresh(t, step_.y, step_.K[0], c, slow, inputs)) return false;
  }
  if (newton_.solve(t_stage, c, known_, tolerance, slow, inputs, Y, K)) return true;
  // Once more with the Jacobian of this stage, if the Jacobian of the start of this step is not enough.
  if (own || !newton_.fresh()) return false;
  begin();
  return newton_.refresh(t_stage, Y, K, c, slow, inputs) &&
         newton_.solve(t_stage, c, known_, tolerance, slow, inputs, Y, K);
}

// e = h sum (b - b^) K, filtered: J x = c (dF/dydot) e, positions eliminated as in the Jacobian.
double StepStages::estimated_error(double t, double h) {
  const Layout& layout = equations_.layout();
  const double c = 1.0 / (h * step_.tableau->gamma);
  const int m = layout.lambda0(), lower = layout.size() - layout.q_size;
  const Eigen::VectorXd& end = step_.Y[step_.last()];
  Ydot_.setZero();
  for (std::size_t j = 0; j <= step_.last(); ++j) Ydot_.head(m) += (h * step_.tableau->error[j]) * step_.K[j].head(m);
  equations_.apply_mass(end, Ydot_, t + h, F_);
  to_increments(layout, end.head(layout.q_size), Ydot_.head(layout.q_size), dx_);
  Eigen::Ref<Eigen::VectorXd> x = F_.tail(lower);
  x *= c;
  equations_.jacobian().subtract_stiffness(dx_, x);
  newton_.apply_inverse(x);
  dx_ += x.head(layout.v_size) / c;
  from_increments(layout, end.head(layout.q_size), dx_, F_.head(layout.q_size));
  failure_.worst = norm_.worst(F_);
  return norm_(F_);
}

// Integrals of powers are further unknowns, W' = P, without influence on the others: their error is
// h sum (b - b^) P. It is compared with the energies that all powers have transferred, and with a
// share of the kinetic energy. Where the state is far more exact than that, powers may be round-off at rest, or have just
// begun, and need no short steps; or the motion is exact while a damper gives heat. There it counts against the energy of
// deformation as well, and against what the absolute tolerance of velocities, dv, leaves open of the kinetic energy: m v dv,
// and at rest m dv^2.
double StepStages::work_error(double t, double h, double work_scale, double state_error, const Inputs& inputs) {
  const std::size_t last = step_.last();
  std::vector<EnergySample>& energy = step_.energy;
  work_error_.dissipated = {};
  work_error_.supplied = {};
  work_error_.load_work = Eigen::VectorXd::Zero(equations_.model().body_count());
  for (std::size_t i = 0; i <= last; ++i) {
    if (i == last) {
      equations_.energy(t + h, step_.Y[i], inputs, energy[i]);
    } else if (i > 0) {
      equations_.powers(t + step_.tableau->c[i] * h, step_.Y[i], inputs, energy[i]);
    }
    add_work_error(energy[i], h * step_.tableau->error[i], work_error_);
  }
  work_error_.scale = 0.5 * h * (size_of_powers(energy[0]) + size_of_powers(energy[last]));
  const double error = work_error_.total();
  if (error == 0.0) return 0.0;
  const StoredEnergy& stored = energy[last].stored;
  const double transferred = work_scale + work_error_.scale;
  const double relative = error / (options_.rtol * (transferred + kEnergyShare * stored[Stored::kKinetic]));
  if (relative <= kMostWorkError * state_error) return relative;
  double held = -std::abs(stored[Stored::kGravity]);
  for (const double part : stored.by_kind) held += std::abs(part);
  const double momentum = std::sqrt(2.0 * mass_ * stored[Stored::kKinetic]), dv = options_.atol_velocity;
  const double limit =
      options_.rtol * (transferred + kEnergyShare * held) + (kEnergyShare * momentum + kRest * mass_ * dv) * dv;
  return std::max(kMostWorkError * state_error, error / limit);
}

}  // namespace footfall
