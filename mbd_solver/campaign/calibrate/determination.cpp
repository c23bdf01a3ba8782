// Central differences, the eigenvalues of J^T J, and counts of sets that meet targets.
#include "mbd_solver/campaign/calibrate/determination.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/campaign/optimum.h"
#include "mbd_solver/campaign/sampling.h"

namespace footfall {
namespace {

constexpr double kSmallestStep = 1e-9;               // of a position; closer sets are equal
constexpr double kLeastSlope = 1e-6;                 // tolerances per range: less is round-off
constexpr double kBetter = 1e-9, kForbidden = 1e30;  // of the misfit

}  // namespace

std::string Interval::is_determined() const { return share < 0.25 ? "yes" : share < 0.75 ? "weakly" : "no"; }

std::vector<UnitPoint> difference_sets(const CalibrationSpec& spec, const UnitPoint& best) {
  std::vector<UnitPoint> sets;
  for (std::size_t i = 0; i < best.size(); ++i)
    for (const double sign : {1.0, -1.0}) {
      UnitPoint set = best;
      set[i] = std::clamp(best[i] + sign * spec.step, 0.0, 1.0);
      sets.push_back(set);
    }
  return sets;
}

Determination determination_of(const CalibrationSpec& spec, const EvaluatedPoint& best, const Sets& around) {
  FOOTFALL_DEMAND(around.size() == 2 * best.point.size());
  const auto n = static_cast<Eigen::Index>(best.point.size());
  const std::vector<double> all = best.residuals(spec);
  const Eigen::Map<const Eigen::VectorXd> r(all.data(), all.size());
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(r.size(), n);  // rows as in r, a column per parameter
  Determination d;
  d.sensitivity = Eigen::MatrixXd::Zero(spec.targets.size(), n);
  for (Eigen::Index i = 0, row = 0; i < n; ++i, row = 0) {
    const std::size_t at = i;
    const EvaluatedPoint &up = *around[2 * at], &down = *around[2 * at + 1];
    const double width = up.point[at] - down.point[at];
    for (std::size_t t = 0; t < spec.targets.size(); ++t) {
      const TargetResult &a = up.targets[t], &b = down.targets[t];
      const std::size_t rows = best.targets[t].residuals.size();
      const bool failed = best.targets[t].failed || a.failed || b.failed || width < kSmallestStep;
      double squares = 0.0;
      for (std::size_t k = 0; k < rows; ++k, ++row) {
        if (failed) continue;
        jacobian(row, i) = std::sqrt(spec.targets[t].weight) *
                           (capped(a.residuals[k], spec.cap) - capped(b.residuals[k], spec.cap)) / width;
        double& slope = d.sensitivity(t, i);
        slope = (a.values[k] - b.values[k]) / width / spec.targets[t].tolerance;
        squares += slope * slope / static_cast<double>(rows);
        if (rows > 1) slope = std::sqrt(squares);
      }
    }
  }
  d.rows = static_cast<int>((jacobian.cwiseAbs().rowwise().maxCoeff().array() > kLeastSlope).count());
  const int freedom = d.rows - static_cast<int>(n);
  if (freedom > 0) d.scale = std::max(1.0, best.misfit / freedom);
  const double q = two_sided_quantile(spec.confidence, d.scale > 1.0 ? freedom : 0);

  // By directions, to find those that no target determines: wider than the range.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(jacobian.transpose() * jacobian);
  const Eigen::VectorXd slack =
      (d.scale / eigen.eigenvalues().cwiseMax(1e-12).array()).matrix();  // variance of each direction
  const Eigen::MatrixXd covariance = eigen.eigenvectors() * slack.asDiagonal() * eigen.eigenvectors().transpose();
  const Eigen::VectorXd along = eigen.eigenvectors().transpose() * (jacobian.transpose() * r);
  for (Eigen::Index k = 0; k < n; ++k) {
    if (2.0 * q * std::sqrt(slack[k]) > 1.0)
      d.loose.push_back(eigen.eigenvectors().col(k));
    else
      d.gain += along[k] * along[k] / eigen.eigenvalues()[k];
  }
  const Eigen::VectorXd sd = covariance.diagonal().cwiseSqrt();
  d.correlation = sd.cwiseInverse().asDiagonal() * covariance * sd.cwiseInverse().asDiagonal();
  for (Eigen::Index i = 0; i < n; ++i) {
    const std::size_t at = i;
    const double u = best.point[at], low = std::max(0.0, u - q * sd[i]), high = std::min(1.0, u + q * sd[i]);
    d.intervals.push_back({spec.parameters[at].value(low), spec.parameters[at].value(high),
                           std::min(1.0, 2.0 * q * sd[i]), u < 1e-3 || u > 1.0 - 1e-3});
  }
  return d;
}

UnitPoint adjusted(const CalibrationSpec& spec, const EvaluatedPoint& whole, const Eigen::MatrixXd& sensitivity) {
  std::vector<TargetSpec> targets = spec.targets;
  for (TargetSpec& target : targets) {
    const double inside = std::min(kInsideBounds * target.tolerance, 0.5 * (target.most - target.least));
    target.least += inside;
    target.most -= inside;
  }
  OptimumTask task{whole.point, {}, {}, 0.5 * spec.step, 1e-4 * spec.step};
  for (const double share : whole.point) {
    task.least.push_back(std::max(0.0, share - spec.step));
    task.most.push_back(std::min(1.0, share + spec.step));
  }
  const auto phi = [&](const UnitPoint& u) {
    Eigen::VectorXd step(u.size());
    for (std::size_t i = 0; i < u.size(); ++i) step[i] = u[i] - whole.point[i];
    if (violation_of(spec, u) > 0.0) return kForbidden;
    double sum = step.squaredNorm() / (spec.step * spec.step);
    for (std::size_t t = 0; t < targets.size(); ++t) {
      if (targets[t].is_curve() || whole.targets[t].failed) continue;
      const double y = whole.targets[t].values.front() + targets[t].tolerance * sensitivity.row(t).dot(step);
      const double r = capped(residual_of(targets[t], y), spec.cap);
      sum += targets[t].weight * r * r;
    }
    return sum;
  };
  const UnitPoint best = minimum("LN_SBPLX", task, phi);
  return phi(best) < phi(whole.point) - kBetter ? best : whole.point;
}

double weight_met(const CalibrationSpec& spec, const EvaluatedPoint& set) {
  double sum = 0.0;
  for (std::size_t t = 0; t < spec.targets.size(); ++t) sum += set.targets[t].is_met() ? spec.targets[t].weight : 0.0;
  return sum;
}

const EvaluatedPoint* most_met(const CalibrationSpec& spec, const Sets& sets) {
  return *std::min_element(sets.begin(), sets.end(), [&](const EvaluatedPoint* a, const EvaluatedPoint* b) {
    return std::pair(-weight_met(spec, *a), a->misfit) < std::pair(-weight_met(spec, *b), b->misfit);
  });
}

Conflicts conflicts_of(const CalibrationSpec& spec, const Sets& sets) {
  const auto count = [&](std::size_t a, std::size_t b) {
    return static_cast<int>(std::count_if(sets.begin(), sets.end(), [&](const EvaluatedPoint* e) {
      return e->targets[a].is_met() && e->targets[b].is_met();
    }));
  };
  Conflicts found;
  for (std::size_t a = 0; a < spec.targets.size(); ++a) {
    if (count(a, a) == 0) found.never.push_back(a);
    for (std::size_t b = a + 1; b < spec.targets.size(); ++b)
      if (count(a, a) > 0 && count(b, b) > 0 && count(a, b) == 0)
        found.pairs.push_back({a, b, count(a, a), count(b, b)});
  }
  return found;
}

}  // namespace footfall
