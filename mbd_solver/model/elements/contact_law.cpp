// Normal force, clipped slip, and the damping that gives a coefficient of restitution (found by bisection).

#include "mbd_solver/model/elements/contact_law.h"

#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/base/codes.h"

namespace footfall {
namespace {

// g(u) and its derivative, see the header.
struct Approach {
  double value, slope;
};
Approach approach(double u) {
  if (u >= 0.0) return {1.0 + u, 1.0};
  const double e = std::exp(u);
  return {e, e};
}

// Energy per k/m absorbed by a damped approach at u = d v, minus that returned at rebound speed w = d e v (times d^2).
double restitution_defect(double u, double e) {
  const double w = e * u;
  return (u - std::log1p(u)) - ((w - 1.0) * std::exp(w) + 1.0);
}

}  // namespace

double contact_damping_for_restitution(double e, double impact_speed) {
  if (!(e > 0.0 && e <= 1.0))
    throw InputError(code::kParameterOutOfRange, "restitution is " + std::to_string(e) + "; it must be in (0, 1].");
  if (!(impact_speed > 0.0))
    throw InputError(code::kParameterOutOfRange, "the impact speed of a restitution must be positive.");
  if (e == 1.0) return 0.0;
  // The defect rises from 0 like (1 - e^2) u^2 / 2 and falls to minus infinity: bracket the zero, then halve.
  double low = 1e-9, high = 1.0;
  while (restitution_defect(high, e) > 0.0) high *= 2.0;
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (restitution_defect(middle, e) > 0.0 ? low : high) = middle;
  }
  return 0.5 * (low + high) / impact_speed;
}

double creep_speed(double mu, double slip_speed, double slope) {
  const double tangent = std::tan(slope);
  if (!(tangent < mu)) return std::numeric_limits<double>::infinity();
  return slip_speed * tangent / std::sqrt(mu * mu - tangent * tangent);
}

void ContactLaw::check(const std::string& where) const {
  if (!(stiffness > 0.0)) throw InputError(code::kParameterOutOfRange, where + "stiffness must be positive.");
  if (!(damping >= 0.0 && friction >= 0.0))
    throw InputError(code::kParameterOutOfRange, where + "damping and friction must not be negative.");
  if (!(slip_speed > 0.0)) throw InputError(code::kParameterOutOfRange, where + "slip_speed must be positive.");
}

ContactLaw::Clipped ContactLaw::clip(const Eigen::Vector3d& u) const {
  const double size = u.norm(), most = kStretch * slip_speed;
  if (size <= most) return {u, Eigen::Matrix3d::Identity()};
  const Eigen::Vector3d e = u / size;
  return {most * e, (most / size) * (Eigen::Matrix3d::Identity() - e * e.transpose())};
}

ContactLaw::Normal ContactLaw::normal_force(double overlap, double closing) const {
  const double root = std::sqrt(overlap);
  const Approach g = approach(damping * closing);
  Normal out;
  out.elastic = stiffness * overlap * root;
  out.force = out.elastic * g.value;
  out.by_overlap = 1.5 * stiffness * root * g.value;
  out.by_closing = out.elastic * damping * g.slope;
  return out;
}

}  // namespace footfall
