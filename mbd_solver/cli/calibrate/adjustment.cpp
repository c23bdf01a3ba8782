#include "mbd_solver/cli/calibrate/adjustment.h"

#include <algorithm>
#include <array>

#include "mbd_solver/cli/calibrate/descent.h"

namespace footfall {

namespace {

constexpr std::array<double, 5> kMoves = {1.0, 0.5, 0.2, 0.1, 0.05};  // times h, as down_from() goes

TargetSpec narrowed(TargetSpec target) {
  if (!target.is_band()) return target;
  const double inside = std::min(kInsideBounds * target.tolerance, 0.5 * (target.most - target.least));
  target.least += inside;
  target.most -= inside;
  return target;
}

}  // namespace

Shares adjusted(const CalibrationSpec& spec, const Evaluation& whole, const Eigen::MatrixXd& sensitivity) {
  std::vector<TargetSpec> targets;
  for (const TargetSpec& target : spec.targets) targets.push_back(narrowed(target));
  std::vector<double> steps(kMoves.begin(), kMoves.end());
  for (double& step : steps) step *= spec.step;
  DescentBounds within;
  for (const double share : whole.shares) {
    within.least.push_back(std::max(0.0, share - spec.step));
    within.most.push_back(std::min(1.0, share + spec.step));
  }
  const auto phi = [&](const Shares& u) {
    Eigen::VectorXd step(static_cast<Eigen::Index>(u.size()));
    for (std::size_t i = 0; i < u.size(); ++i) step[static_cast<Eigen::Index>(i)] = u[i] - whole.shares[i];
    if (broken_by(spec, u) > 0.0) return std::numeric_limits<double>::infinity();
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
  return down_from(whole.shares, within, steps, phi);
}

}  // namespace footfall
