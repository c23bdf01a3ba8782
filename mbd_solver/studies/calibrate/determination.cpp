// Central differences, the eigenvalues of J^T J, and counts of sets that meet targets.
#include "mbd_solver/studies/calibrate/determination.h"

#include <algorithm>
#include <array>
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

// d y / d u_i of one number of the sets; 0 if one end of the difference lacks it.
template <class Number>
double slope(const std::vector<const Evaluation*>& around, std::size_t i, const Number& number) {
  const Evaluation &up = *around[2 * i], &down = *around[2 * i + 1];
  const double width = up.point[i] - down.point[i];
  if (width < kSmallestStep) return 0.0;
  const std::optional<double> a = number(up), b = number(down);
  return a && b ? (*a - *b) / width : 0.0;
}

// y of a target that is a single number, in tolerances.
Eigen::VectorXd gradient(const CalibrationSpec& spec, std::size_t t, const Evaluation& best,
                         const std::vector<const Evaluation*>& around) {
  Eigen::VectorXd g(static_cast<Eigen::Index>(best.point.size()));
  for (std::size_t i = 0; i < best.point.size(); ++i)
    g[static_cast<Eigen::Index>(i)] = slope(around, i, [&](const Evaluation& e) -> std::optional<double> {
      if (e.targets[t].failed || e.targets[t].values.empty()) return {};
      return e.targets[t].values.front() / spec.targets[t].tolerance;
    });
  return g;
}

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
  const std::vector<double> r = best.residuals(spec);
  Determination d;
  d.jacobian = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(r.size()), n);
  d.sensitivity = Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(spec.targets.size()), n);
  Eigen::Index row = 0;
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const TargetResult& target = best.targets[t];
    const double root = std::sqrt(spec.targets[t].weight);
    for (std::size_t k = 0; k < target.residuals.size(); ++k, ++row)
      for (Eigen::Index i = 0; i < n; ++i) {
        const auto at = static_cast<std::size_t>(i);
        d.jacobian(row, i) = slope(around, at, [&](const Evaluation& e) -> std::optional<double> {
          if (target.failed || e.targets[t].failed) return {};
          return root * capped(e.targets[t].residuals[k], spec.cap);
        });
        if (target.failed) continue;
        const double of_value = slope(around, at, [&](const Evaluation& e) -> std::optional<double> {
          if (e.targets[t].failed) return {};
          return e.targets[t].values[k] / spec.targets[t].tolerance;
        });
        double& sum = d.sensitivity(static_cast<Eigen::Index>(t), i);
        sum = target.residuals.size() == 1
                  ? of_value
                  : std::sqrt(sum * sum + of_value * of_value / static_cast<double>(target.residuals.size()));
      }
  }
  for (Eigen::Index k = 0; k < d.jacobian.rows(); ++k)
    if (d.jacobian.row(k).cwiseAbs().maxCoeff() > kLeastSlope) ++d.rows;
  const int freedom = d.rows - static_cast<int>(n);
  if (freedom > 0) d.scale = std::max(1.0, best.misfit / freedom);
  const double q = two_sided_quantile(spec.confidence, d.scale > 1.0 ? freedom : 0);

  // By directions, to find those that no target determines: wider than the range.
  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> eigen(d.jacobian.transpose() * d.jacobian);
  const Eigen::VectorXd slack =
      (d.scale / eigen.eigenvalues().cwiseMax(1e-12).array()).matrix();  // variance of each direction
  const Eigen::MatrixXd covariance = eigen.eigenvectors() * slack.asDiagonal() * eigen.eigenvectors().transpose();
  const Eigen::VectorXd residuals = Eigen::Map<const Eigen::VectorXd>(r.data(), static_cast<Eigen::Index>(r.size()));
  const Eigen::VectorXd along = eigen.eigenvectors().transpose() * (d.jacobian.transpose() * residuals);
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
    Interval interval;
    interval.least = spec.parameters[at].value(low);
    interval.most = spec.parameters[at].value(high);
    interval.share = std::min(1.0, 2.0 * q * sd[i]);
    interval.at_edge = u < 1e-3 || u > 1.0 - 1e-3;
    d.intervals.push_back(interval);
  }
  return d;
}

std::vector<TradeOff> trade_offs_of(const CalibrationSpec& spec, const Evaluation& best,
                                    const std::vector<const Evaluation*>& around) {
  std::vector<TradeOff> trade_offs;
  const auto single = [&](std::size_t t) { return !spec.targets[t].is_curve() && !best.targets[t].failed; };
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    if (!single(t) || best.targets[t].is_met()) continue;
    TradeOff trade_off;
    trade_off.target = t;
    const Eigen::VectorXd g = gradient(spec, t, best, around);
    trade_off.moved = g.norm() > kLeastSlope;
    trade_off.step = Eigen::VectorXd::Zero(g.size());
    if (trade_off.moved) trade_off.step = -best.targets[t].residuals.front() * g / g.squaredNorm();
    for (std::size_t s = 0; s < spec.targets.size() && trade_off.moved; ++s) {
      if (s == t || !single(s)) continue;
      const double y = best.targets[s].values.front();
      const double after = y + spec.targets[s].tolerance * gradient(spec, s, best, around).dot(trade_off.step);
      const double cost = std::abs(residual_of(spec.targets[s], after)) - std::abs(residual_of(spec.targets[s], y));
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
  Bounds within;
  for (const double share : whole.point) {
    within.least.push_back(std::max(0.0, share - spec.step));
    within.most.push_back(std::min(1.0, share + spec.step));
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
  const UnitPoint best = minimum({"LN_SBPLX", whole.point, within, 1e-4 * spec.step, 0.5 * spec.step}, phi);
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

namespace {

// Among the targets from `first` on, without those in `out`: with the first one, or without it.
std::size_t most_from(std::size_t first, std::vector<int> out, const std::vector<std::vector<std::size_t>>& others) {
  const std::size_t n = others.size();
  while (first < n && out[first] > 0) ++first;
  if (first >= n) return 0;
  std::vector<int> with = out;
  std::size_t open = 0;
  for (const std::size_t other : others[first]) open += other > first && with[other]++ == 0 ? 1 : 0;
  const std::size_t taken = 1 + most_from(first + 1, with, others);
  if (open <= 1) return taken;  // with one conflict at most, taking it is never worse
  return std::max(taken, most_from(first + 1, out, others));
}

}  // namespace

std::size_t most_without_conflict(const Conflicts& conflicts, const std::vector<std::size_t>& targets) {
  const std::size_t n = targets.empty() ? 0 : 1 + *std::max_element(targets.begin(), targets.end());
  std::vector<int> out(n, 1);
  for (const std::size_t target : targets) out[target] = 0;
  std::vector<std::vector<std::size_t>> others(n);
  for (const Conflicts::Pair& pair : conflicts.pairs)
    if (pair.a < n && pair.b < n) others[pair.a].push_back(pair.b), others[pair.b].push_back(pair.a);
  for (const std::size_t target : conflicts.never)
    if (target < n) out[target] = 1;
  return most_from(0, out, others);
}

}  // namespace footfall
