#include "mbd_solver/cli/calibrate/adjustment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace footfall {

namespace {

constexpr std::array<double, 5> kMoves = {1.0, 0.5, 0.2, 0.1, 0.05};  // times h, one parameter at a time

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
  const auto phi = [&](const Shares& u) {
    Eigen::VectorXd step(static_cast<Eigen::Index>(u.size()));
    for (std::size_t i = 0; i < u.size(); ++i) step[static_cast<Eigen::Index>(i)] = u[i] - whole.shares[i];
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
  Shares u = whole.shares;
  double least = phi(u);
  for (const double move : kMoves)
    for (bool better = true; better;) {
      better = false;
      for (std::size_t i = 0; i < u.size(); ++i)
        for (const double sign : {1.0, -1.0}) {
          const double from = u[i];
          u[i] = std::clamp(from + sign * move * spec.step, std::max(0.0, whole.shares[i] - spec.step),
                            std::min(1.0, whole.shares[i] + spec.step));
          const double tried = broken_by(spec, u) > 0.0 ? std::numeric_limits<double>::infinity() : phi(u);
          if (tried < least - 1e-9)
            least = tried, better = true;
          else
            u[i] = from;
        }
    }
  return u;
}

}  // namespace footfall
