// The length of the next window from an error estimate and a stability limit, per body (window_choice.h, theory 7.8);
// before the first contact from the time until a boundary can meet a grain.

#include "mbd_solver/coupling/window_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall {

double flight_time(const BodyMotion& motion, const ModalBoundary& boundary, const Placement& placement,
                   const Eigen::Vector3d& up, const LandingSite* site, bool known) {
  if (!placement.ground_known) return 0.0;
  const Eigen::Matrix3Xd& rho0 = boundary.rho0();
  const double lowest = up.dot(motion.r) + (up.transpose() * motion.rotation() * rho0).minCoeff();
  const double reach = rho0.colwise().norm().maxCoeff();
  const double speed = motion.w.norm() * reach - up.dot(motion.dr);
  double radius = 0.0;  // of beams
  for (const BeamSegment& segment : boundary.segments()) radius = std::max(radius, segment.radius);
  double ground = placement.ground_height;
  if (site) {
    const Eigen::Vector3d displacement = motion.r - site->r;
    const double turned = Eigen::AngleAxisd(site->R_WB.transpose() * motion.rotation()).angle();
    if ((displacement - up * up.dot(displacement)).norm() + turned * reach < site->stray && std::isfinite(site->height))
      ground = site->height;
  }
  const double height = lowest - radius - ground;
  if (height <= 0.0) return 0.0;
  const double bend = known ? (motion.dw.norm() + motion.w.squaredNorm()) * reach - up.dot(motion.ddr) : 0.0;
  if (bend > 0.0) return 2.0 * height / (speed + std::sqrt(speed * speed + 2.0 * bend * height));
  return speed > 0.0 ? height / speed : std::numeric_limits<double>::infinity();
}

namespace {

constexpr double kSafety = 0.9;  // of the tolerance
// Share of the time until a boundary can meet a grain. Grains may have risen since their height was measured; they are
// then met in a window no longer than the descent over that rise.
constexpr double kApproach = 0.5;
constexpr double kGrowth = 2.0;          // from one window to the next
constexpr double kForget = 0.95;         // of the stiffness so far, per window: contacts may open and close again
constexpr double kForgetResponse = 0.9;  // of K_s, per window
constexpr double kAim = 0.8;             // of the limit of omega H: contacts stiffen within a window
constexpr double kGrainAngle = 0.8;      // largest omega_g H
constexpr double kFast = 3.0;            // response to a fast disturbance over that to the displacement of a window

}  // namespace

WindowChoice::WindowChoice(const CouplingSpec& spec, double dt, double weight, const OmegaHLimit& limit)
    : spec_(spec), dt_(dt), limit_(limit), force_scale_(weight) {}

void WindowChoice::History::visit(Archive& archive) {
  archive.members<&History::stiffness, &History::response, &History::grain_omega2, &History::touched, &History::force,
                  &History::place>(*this);
}

void WindowChoice::visit(Archive& archive) {
  archive.members<&WindowChoice::force_scale_, &WindowChoice::history_, &WindowChoice::estimate_, &WindowChoice::n_>(
      *this);
}

double WindowChoice::response(const Body& body, History& history) {
  const double displacement = (body.place - history.place).norm(), change = (body.force - history.force).norm();
  const bool known = history.touched && displacement > body.gap;
  if (known) history.response = std::max(kFast * change / displacement, kForgetResponse * history.response);
  history.touched = body.stiffness > 0.0;
  history.force = body.force;
  history.place = body.place;
  return known ? std::min(body.stiffness, history.response) : body.stiffness;
}

double WindowChoice::longest(const Body& body, double stiffness, double grain_omega2) {
  if (body.stiffness <= 0.0 && body.flight > 0.0) return std::max(1.0, kApproach * body.flight / dt_);
  if (stiffness <= 0.0) return 1.0;
  const int n = limit_.substeps(std::sqrt(stiffness / body.mass) * dt_, spec_.max_substeps, kAim);
  return grain_omega2 > 0.0 ? std::min<double>(n, kGrainAngle / (std::sqrt(grain_omega2) * dt_)) : n;
}

void WindowChoice::start(const std::vector<Body>& bodies) {
  history_.assign(bodies.size(), {});
  double n = spec_.max_substeps;
  for (const Body& body : bodies) n = std::min(n, longest(body, 0.0, 0.0));
  n_ = std::max(1, static_cast<int>(n));
}

void WindowChoice::observe(int n, const std::vector<Body>& bodies) {
  double stiffest = 0.0, fastest = 0.0;  // contact of all bodies so far
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    force_scale_ = std::max(force_scale_, bodies[i].force.norm());
    history_[i].stiffness = std::max(bodies[i].stiffness, kForget * history_[i].stiffness);
    // A body that has left the grains may meet them again as before; for a body that is led no other value shows how.
    const double kept = bodies[i].stiffness > 0.0 && std::isfinite(bodies[i].mass) ? kForget : 1.0;
    history_[i].grain_omega2 = std::max(bodies[i].grain_omega2, kept * history_[i].grain_omega2);
    stiffest = std::max(stiffest, history_[i].stiffness);
    fastest = std::max(fastest, history_[i].grain_omega2);
  }
  estimate_ = 0.0;
  double next = std::min<double>(spec_.max_substeps, kGrowth * n);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    const bool touched = history_[i].stiffness > 0.0;
    double K_s = response(body, history_[i]);
    // Among grains a contact may begin at any time: the path must be right for it.
    if (body.stiffness <= 0.0 && body.flight <= 0.0) K_s = touched ? history_[i].stiffness : stiffest;
    history_[i].force_error = body.stiffness > 0.0 ? K_s * body.gap : 0.0;
    if (force_scale_ > 0.0) estimate_ = std::max(estimate_, K_s * body.gap / force_scale_);
    next = std::min(
        next, longest(body, touched ? history_[i].stiffness : stiffest, touched ? history_[i].grain_omega2 : fastest));
  }
  if (estimate_ > 0.0) next = std::min(next, n * std::sqrt(kSafety * spec_.tolerance / estimate_));
  n_ = std::max(1, static_cast<int>(next));
}

}  // namespace footfall
