// Central differences, the eigenvalues of J^T J, and counts of sets that meet targets.
#include "mbd_solver/studies/calibrate/determination.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/studies/calibrate/optimum.h"
#include "mbd_solver/studies/campaign/sampling.h"

namespace footfall {
namespace {

constexpr double kSmallestStep = 1e-9;  // of a position; closer sets are equal
constexpr double kLeastSlope = 1e-6;    // tolerances per range: less is round-distance
constexpr double kLeastCost = 0.5;      // tolerances

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

Determination determination_of(const CalibrationSpec& spec, const Evaluation& best,
                               const std::vector<const Evaluation*>& around) {
  FOOTFALL_DEMAND(around.size() == 2 * best.point.size());
  const auto n = static_cast<Eigen::Index>(best.point.size());
  const std::vector<double> all = best.residuals(spec);
  const Eigen::Map<const Eigen::VectorXd> r(all.data(), static_cast<Eigen::Index>(all.size()));
  Eigen::MatrixXd jacobian = Eigen::MatrixXd::Zero(r.size(), n);  // rows as in r, a column per parameter
  Determination d;
  d.sensitivity = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(spec.targets.size()), n);
  for (Eigen::Index i = 0, row = 0; i < n; ++i, row = 0) {
    const auto at = static_cast<std::size_t>(i);
    const Evaluation &up = *around[2 * at], &down = *around[2 * at + 1];
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
        double& slope = d.sensitivity(static_cast<Eigen::Index>(t), i);
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
    const auto at = static_cast<std::size_t>(i);
    const double u = best.point[at], low = std::max(0.0, u - q * sd[i]), high = std::min(1.0, u + q * sd[i]);
    d.intervals.push_back({spec.parameters[at].value(low), spec.parameters[at].value(high),
                           std::min(1.0, 2.0 * q * sd[i]), u < 1e-3 || u > 1.0 - 1e-3});
  }
  return d;
}

std::vector<TradeOff> trade_offs_of(const CalibrationSpec& spec, const Evaluation& best,
                                    const Eigen::MatrixXd& sensitivity) {
  std::vector<TradeOff> trade_offs;
  const auto single = [&](std::size_t t) { return !spec.targets[t].is_curve() && !best.targets[t].failed; };
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    if (!single(t) || best.targets[t].is_met()) continue;
    TradeOff trade_off;
    trade_off.target = t;
    const Eigen::VectorXd g = sensitivity.row(static_cast<Eigen::Index>(t));
    trade_off.step = g.norm() > kLeastSlope ? -best.targets[t].residuals.front() / g.squaredNorm() * g : 0.0 * g;
    for (std::size_t s = 0; s < spec.targets.size(); ++s) {
      if (s == t || !single(s)) continue;
      const double y = best.targets[s].values.front(),
                   change = sensitivity.row(static_cast<Eigen::Index>(s)).dot(trade_off.step);
      const double after = residual_of(spec.targets[s], y + spec.targets[s].tolerance * change);
      const double cost = std::abs(after) - std::abs(residual_of(spec.targets[s], y));
      if (cost >= kLeastCost) trade_off.costs.emplace_back(s, cost);
    }
    std::sort(trade_off.costs.begin(), trade_off.costs.end(),
              [](const auto& a, const auto& b) { return a.second > b.second; });
    trade_offs.push_back(trade_off);
  }
  return trade_offs;
}

namespace {

constexpr double kBetter = 1e-9, kForbidden = 1e30;  // of the misfit

TargetSpec narrowed(TargetSpec target) {
  if (!target.is_band()) return target;
  const double inside = std::min(kInsideBounds * target.tolerance, 0.5 * (target.most - target.least));
  target.least += inside;
  target.most -= inside;
  return target;
}

}  // namespace

UnitPoint adjusted(const CalibrationSpec& spec, const Evaluation& whole, const Eigen::MatrixXd& sensitivity) {
  std::vector<TargetSpec> targets;
  for (const TargetSpec& target : spec.targets) targets.push_back(narrowed(target));
  OptimumTask task{whole.point, {}, {}, 0.5 * spec.step, 1e-4 * spec.step};
  for (const double share : whole.point) {
    task.least.push_back(std::max(0.0, share - spec.step));
    task.most.push_back(std::min(1.0, share + spec.step));
  }
  const auto phi = [&](const UnitPoint& u) {
    Eigen::VectorXd step(static_cast<Eigen::Index>(u.size()));
    for (std::size_t i = 0; i < u.size(); ++i) step[static_cast<Eigen::Index>(i)] = u[i] - whole.point[i];
    if (violation_of(spec, u) > 0.0) return kForbidden;
    double sum = step.squaredNorm() / (spec.step * spec.step);
    for (std::size_t t = 0; t < targets.size(); ++t) {
      if (targets[t].is_curve() || whole.targets[t].failed) continue;
      const double y = whole.targets[t].values.front() +
                       targets[t].tolerance * sensitivity.row(static_cast<Eigen::Index>(t)).dot(step);
      const double r = capped(residual_of(targets[t], y), spec.cap);
      sum += targets[t].weight * r * r;
    }
    return sum;
  };
  const UnitPoint best = minimum("LN_SBPLX", task, phi);
  return phi(best) < phi(whole.point) - kBetter ? best : whole.point;
}

const Evaluation* most_met(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets) {
  const auto met = [&](const Evaluation* e) {
    double sum = 0.0;
    for (std::size_t t = 0; t < spec.targets.size(); ++t)
      if (e->targets[t].is_met()) sum += spec.targets[t].weight;
    return sum;
  };
  const Evaluation* most = sets.front();
  for (const Evaluation* e : sets)
    if (met(e) > met(most) || (met(e) == met(most) && e->misfit < most->misfit)) most = e;
  return most;
}

std::vector<std::size_t> heaviest_targets(const CalibrationSpec& spec) {
  double most = 0.0;
  for (const TargetSpec& target : spec.targets) most = std::max(most, target.weight);
  std::vector<std::size_t> chosen;
  for (std::size_t t = 0; t < spec.targets.size(); ++t)
    if (spec.targets[t].weight == most) chosen.push_back(t);
  return chosen;
}

int met_of(const Evaluation& set, const std::vector<std::size_t>& targets) {
  return static_cast<int>(
      std::count_if(targets.begin(), targets.end(), [&](std::size_t t) { return set.targets[t].is_met(); }));
}

Conflicts conflicts_of(const CalibrationSpec& spec, const std::vector<const Evaluation*>& sets) {
  const auto count = [&](std::size_t a, std::size_t b) {
    return static_cast<int>(std::count_if(sets.begin(), sets.end(), [&](const Evaluation* e) {
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

std::size_t most_without_conflict(const Conflicts& conflicts, std::vector<std::size_t> targets) {
  const auto drop = [&](std::vector<std::size_t>& from, const auto& which) {
    from.erase(std::remove_if(from.begin(), from.end(), which), from.end());
  };
  const std::vector<std::size_t>& never = conflicts.never;
  drop(targets, [&](std::size_t t) { return std::find(never.begin(), never.end(), t) != never.end(); });
  if (targets.empty()) return 0;
  const std::size_t one = targets.back();
  targets.pop_back();
  std::vector<std::size_t> others = targets;  // that go with it
  drop(others, [&](std::size_t t) {
    return std::any_of(conflicts.pairs.begin(), conflicts.pairs.end(), [&](const Conflicts::Pair& pair) {
      return (pair.a == one && pair.b == t) || (pair.a == t && pair.b == one);
    });
  });
  const std::size_t with = 1 + most_without_conflict(conflicts, others);
  // With one conflict at most, taking it is never worse.
  return others.size() + 1 >= targets.size() ? with : std::max(with, most_without_conflict(conflicts, targets));
}

}  // namespace footfall
