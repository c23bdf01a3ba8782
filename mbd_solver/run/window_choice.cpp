#include "mbd_solver/run/window_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall {
namespace {

constexpr double kSafety = 0.9;     // of the tolerance, and of the flight
constexpr double kGrowth = 2.0;     // from one window to the next
constexpr double kForget = 0.95;    // of the stiffness met, per window: contacts that close and open again must not be met unprepared

}  // namespace

WindowChoice::WindowChoice(const CouplingSpec& spec, double dt, double weight) : spec_(spec), dt_(dt), force_scale_(weight) {}

double WindowChoice::longest(const Body& body, double stiffness) const {
  if (body.stiffness <= 0.0 && body.flight > 0.0) return std::max(1.0, kSafety * body.flight / dt_);
  if (stiffness <= 0.0) return 1.0;
  return spec_.warn_omega_h / (std::sqrt(stiffness / body.mass) * dt_);
}

void WindowChoice::start(const std::vector<Body>& bodies) {
  stiffness_.assign(bodies.size(), 0.0);
  double n = spec_.max_substeps;
  for (const Body& body : bodies) n = std::min(n, longest(body, 0.0));
  n_ = std::max(1, static_cast<int>(n));
}

void WindowChoice::observe(int n, const std::vector<Body>& bodies) {
  for (const Body& body : bodies) force_scale_ = std::max(force_scale_, body.force);
  estimate_ = 0.0;
  double next = std::min<double>(spec_.max_substeps, kGrowth * n);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    stiffness_[i] = std::max(body.stiffness, kForget * stiffness_[i]);
    if (force_scale_ > 0.0) estimate_ = std::max(estimate_, body.stiffness * body.gap / force_scale_);
    next = std::min(next, longest(body, stiffness_[i]));
  }
  if (estimate_ > 0.0) next = std::min(next, n * std::sqrt(kSafety * spec_.tolerance / estimate_));
  n_ = std::max(1, static_cast<int>(next));
}

}  // namespace footfall
