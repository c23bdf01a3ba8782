#include "mbd_solver/coupling/window_choice.h"

#include <algorithm>
#include <cmath>
#include <limits>


namespace footfall {

double flight_time(const BodyMotion& motion, const ModalBoundary& boundary, const Placement& placement,
                   const Eigen::Vector3d& up, const LandingSite* site) {
  if (!placement.ground_known) return 0.0;
  const Eigen::Matrix3Xd& rho0 = boundary.rho0();
  const double lowest = up.dot(motion.r) + (up.transpose() * motion.rotation() * rho0).minCoeff();
  const double reach = rho0.colwise().norm().maxCoeff();
  const double speed = motion.w.norm() * reach - up.dot(motion.dr);
  double radius = 0.0;  // of beams
  for (const BeamSegment& segment : boundary.segments()) radius = std::max(radius, segment.radius);
  double ground = placement.ground_height;
  if (site) {
    const Eigen::Vector3d way = motion.r - site->r;
    const double turned = Eigen::AngleAxisd(site->R_WB.transpose() * motion.rotation()).angle();
    if ((way - up * up.dot(way)).norm() + turned * reach < site->stray && std::isfinite(site->height))
      ground = site->height;
  }
  const double height = lowest - radius - ground;
  if (height <= 0.0) return 0.0;
  return speed > 0.0 ? height / speed : std::numeric_limits<double>::infinity();
}

namespace {

constexpr double kSafety = 0.9;  // of the tolerance
// of the time until it can meet a grain: grains may have risen since they were measured, and then it meets them in a
// window no longer than what they rose by would have taken
constexpr double kApproach = 0.5;
constexpr double kGrowth = 2.0;  // from one window to the next
// of the stiffness met, per window: contacts that close and open again must not be met unprepared
constexpr double kForget = 0.95;
constexpr double kForgetAnswer = 0.9;  // of K_s, per window
constexpr double kQuick = 3.0;         // answer to something quick over the answer to the way of a whole window
constexpr double kStanding = 0.9;      // of the stiffness met: contacts stand

}  // namespace

WindowChoice::WindowChoice(const CouplingSpec& spec, double dt, double weight)
    : spec_(spec), dt_(dt), force_scale_(weight) {}

void WindowChoice::Memory::visit(Archive& archive) {
  archive("stiffness", stiffness);
  archive("answer", answer);
  archive("omega_h", omega_h);
  archive("touched", touched);
  archive("force", force);
  archive("place", place);
}

void WindowChoice::visit(Archive& archive) {
  archive("force_scale", force_scale_);
  archive("memory", memory_);
  archive("estimate", estimate_);
  archive("n", n_);
}

double WindowChoice::answer(const Body& body, Memory& memory) {
  const double way = (body.place - memory.place).norm(), change = (body.force - memory.force).norm();
  const bool told = memory.touched && way > body.gap;
  if (told) memory.answer = std::max(kQuick * change / way, kForgetAnswer * memory.answer);
  memory.touched = body.stiffness > 0.0;
  memory.force = body.force;
  memory.place = body.place;
  return told ? std::min(body.stiffness, memory.answer) : body.stiffness;
}

double WindowChoice::largest_omega_h(const Body& body, double stiffness, double answer) const {
  if (stiffness <= 0.0 || body.stiffness < kStanding * stiffness) return spec_.warn_omega_h;
  return spec_.warn_omega_h * std::min(std::sqrt(stiffness / answer), kChosenOmegaH);
}

double WindowChoice::longest(const Body& body, double stiffness, double omega_h) const {
  if (body.stiffness <= 0.0 && body.flight > 0.0) return std::max(1.0, kApproach * body.flight / dt_);
  return stiffness > 0.0 ? omega_h / (std::sqrt(stiffness / body.mass) * dt_) : 1.0;
}

double WindowChoice::allowed_omega_h(std::size_t i) const {
  return std::max(1.25 * memory_[i].omega_h - 0.25 * spec_.warn_omega_h, spec_.warn_omega_h);
}

void WindowChoice::start(const std::vector<Body>& bodies) {
  memory_.assign(bodies.size(), {});
  double n = spec_.max_substeps;
  for (const Body& body : bodies) n = std::min(n, longest(body, 0.0, 0.0));
  n_ = std::max(1, static_cast<int>(n));
}

void WindowChoice::observe(int n, const std::vector<Body>& bodies) {
  double stiffest = 0.0;  // that any body has met
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    force_scale_ = std::max(force_scale_, bodies[i].force.norm());
    memory_[i].stiffness = std::max(bodies[i].stiffness, kForget * memory_[i].stiffness);
    stiffest = std::max(stiffest, memory_[i].stiffness);
  }
  estimate_ = 0.0;
  double next = std::min<double>(spec_.max_substeps, kGrowth * n);
  for (std::size_t i = 0; i < bodies.size(); ++i) {
    const Body& body = bodies[i];
    const double K_s = answer(body, memory_[i]);
    if (force_scale_ > 0.0) estimate_ = std::max(estimate_, K_s * body.gap / force_scale_);
    const double stiffness = memory_[i].stiffness > 0.0 ? memory_[i].stiffness : stiffest;
    memory_[i].omega_h = largest_omega_h(body, stiffness, K_s);
    next = std::min(next, longest(body, stiffness, memory_[i].omega_h));
  }
  if (estimate_ > 0.0) next = std::min(next, n * std::sqrt(kSafety * spec_.tolerance / estimate_));
  n_ = std::max(1, static_cast<int>(next));
}

}  // namespace footfall
