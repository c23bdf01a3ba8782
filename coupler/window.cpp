// prediction(tau) + e g(u), and the sums of a steady translation where the motion is one.

#include "coupler/window.h"

#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/message_fields.h"

namespace footfall {
namespace {

// A gap below this, relative to the distance travelled, is the round-off of two ways of summing the same motion.
constexpr double kRoundOff = 1e-12;

void difference(const BodyMotion& from, const BodyMotion& to, BoundaryStep& out) {
  out.r = to.r - from.r;
  out.theta_W = rotation_vector(from.L, to.L);
  out.a = to.a - from.a;
}

void set_zero(BoundaryStep& step) {
  step.r.setZero();
  step.theta_W.setZero();
  step.a.setZero();
}

// to += factor step
void add(const BoundaryStep& step, double factor, BoundaryStep& to) {
  to.r += factor * step.r;
  to.theta_W += factor * step.theta_W;
  to.a += factor * step.a;
}

// g(u) and its derivative.
double closing(double u) { return 1.0 + u * (-4.0 + 3.0 * u); }
double closing_rate(double u) { return -4.0 + 6.0 * u; }

}  // namespace

BoundaryPath::BoundaryPath(const Scheme& scheme, const BodyMotion& initial)
    : scheme_(scheme),
      start_(initial),
      pose_(initial),
      before_(initial),
      shifted_(initial),
      step_(initial.mode_count()),
      jump_(initial.mode_count()),
      gap_(initial.mode_count()),
      left_open_(initial.mode_count()) {}

template <>
inline constexpr auto kFields<BoundaryStep> = kFieldsOf<&BoundaryStep::r, &BoundaryStep::theta_W, &BoundaryStep::a>;

void BoundaryPath::Carried::visit(Archive& archive) {
  archive("gap", gap);
  archive("elapsed", elapsed);
  archive("duration", duration);
}

// All other members are set anew in each window.
void BoundaryPath::visit(Archive& archive) {
  archive.members<&BoundaryPath::pose_, &BoundaryPath::travelled_, &BoundaryPath::amplitude_, &BoundaryPath::carried_,
                  &BoundaryPath::n_, &BoundaryPath::dt_, &BoundaryPath::is_known_>(*this);
}

void BoundaryPath::begin_window(const BodyMotion& start, int n, double dt, int closing, const KnownPath& known) {
  FOOTFALL_DEMAND(n > 0 && dt > 0.0 && start.mode_count() == start_.mode_count());
  FOOTFALL_DEMAND(known.cols() == 0 || known.cols() == n);
  for (Carried& one : carried_) one.elapsed += n_ * dt_;
  start_ = start;
  shifted_ = start;
  n_ = n;
  i_ = 0;
  dt_ = dt;
  known_ = known;
  is_known_ = known_.cols() > 0;
  set_zero(jump_);
  set_zero(left_open_);
  difference(start_, pose_, gap_);
  if (is_known_) {
    gap_.r.setZero();
    gap_.theta_W.setZero();
  }

  // Is the predicted motion a constant velocity from the current position?
  const double H = n * dt;
  scheme_.predict(start_, 0.0, before_);
  const Eigen::Vector3d velocity = before_.dr;
  const bool resting = before_.w.isZero(0.0) && before_.da.isZero(0.0);
  scheme_.predict(start_, H, before_);
  travelled_ = std::max({travelled_, start_.r.norm(), H * velocity.norm()});
  amplitude_ = std::max(amplitude_, start_.a.size() == 0 ? 0.0 : start_.a.cwiseAbs().maxCoeff());
  carry(closing);
  steady_ = !is_known_ && carried_.empty() && resting && before_.dr == velocity && before_.w.isZero(0.0) &&
            before_.da.isZero(0.0) && gap_is_round_off();
  if (steady_) {
    pose_.dr = velocity;
    pose_.w.setZero();
    pose_.da.setZero();
    return;
  }
  if (!scheme_.continuous_path()) {
    difference(pose_, start_, jump_);
    set_zero(gap_);
  }
  if (is_known_) {  // no gap, no jump: the motion before this window was known as well
    jump_.r.setZero();
    jump_.theta_W.setZero();
    return;
  }
  set_pose_at(0.0);
}

bool BoundaryPath::gap_is_round_off() const {
  return gap_.r.norm() <= kRoundOff * travelled_ && gap_.theta_W.norm() <= kRoundOff &&
         (gap_.a.size() == 0 || gap_.a.cwiseAbs().maxCoeff() <= kRoundOff * amplitude_);
}

// Removes carried gaps that are closed, and the others from the gap of the last window; if that one closes over more than
// this window, it joins them.
void BoundaryPath::carry(int closing_n) {
  const double H = n_ * dt_, round_off = 1e-6 * dt_;
  carried_.erase(std::remove_if(carried_.begin(), carried_.end(),
                                [&](const Carried& one) { return one.elapsed > one.duration - round_off; }),
                 carried_.end());
  if (is_known_ || !scheme_.continuous_path()) carried_.clear();
  for (const Carried& one : carried_) add(one.gap, -closing(one.elapsed / one.duration), gap_);
  if (closing_n > n_ && !is_known_ && scheme_.continuous_path() && !gap_is_round_off()) {
    carried_.push_back({gap_, 0.0, closing_n * dt_});
    set_zero(gap_);
  }
  for (const Carried& one : carried_) {
    const double u = (one.elapsed + H) / one.duration;
    if (u < 1.0 - round_off / one.duration) add(one.gap, closing(u), left_open_);
  }
}

void BoundaryPath::advance() {
  FOOTFALL_DEMAND(i_ < n_);
  ++i_;
  before_.r = pose_.r;
  before_.L = pose_.L;
  before_.a = pose_.a;
  if (steady_) {
    pose_.r += pose_.dr * dt_;
  } else {
    set_pose_at(i_ * dt_);
    if (is_known_) follow_known_path();
  }
  difference(before_, pose_, step_);
}

void BoundaryPath::follow_known_path() {
  const auto column = known_.col(i_ - 1);
  pose_.r = column.head<3>();
  pose_.L = column.segment<4>(3);
  pose_.dr = column.segment<3>(7);
  pose_.w = column.tail<3>();
}

// prediction(tau) with the gap closed by g(u) = 1 - 4 u + 3 u^2, u = tau / H: g(0) = 1, g(1) = 0, and zero
// mean over the window.
void BoundaryPath::set_pose_at(double tau) {
  const double H = n_ * dt_;
  const double u = tau / H;
  const double g = i_ == n_ ? 0.0 : closing(u);
  const double g_rate = closing_rate(u) / H;
  shifted_.r = start_.r + g * gap_.r;
  Eigen::Vector3d theta = g * gap_.theta_W, turn_rate = g_rate * gap_.theta_W;
  shifted_.a = start_.a + g * gap_.a;
  for (const Carried& one : carried_) {
    const double part = (one.elapsed + tau) / one.duration;
    if (part >= 1.0) continue;
    shifted_.r += closing(part) * one.gap.r;
    theta += closing(part) * one.gap.theta_W;
    shifted_.a += closing(part) * one.gap.a;
  }
  shifted_.L = turned(start_.L, theta);
  scheme_.predict(shifted_, tau, pose_);
  // The predicted rotation follows the rotation that closes the gap, and rotates its angular velocity.
  pose_.dr += g_rate * gap_.r;
  pose_.da += g_rate * gap_.a;
  for (const Carried& one : carried_) {
    const double part = (one.elapsed + tau) / one.duration;
    if (part >= 1.0) continue;
    const double rate = closing_rate(part) / one.duration;
    pose_.dr += rate * one.gap.r;
    turn_rate += rate * one.gap.theta_W;
    pose_.da += rate * one.gap.a;
  }
  if (!turn_rate.isZero(0.0)) pose_.w += pose_.rotation() * (shifted_.rotation().transpose() * turn_rate);
}

}  // namespace footfall
