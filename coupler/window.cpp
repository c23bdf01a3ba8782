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

}  // namespace

BoundaryPath::BoundaryPath(const Scheme& scheme, const BodyMotion& initial)
    : scheme_(scheme),
      start_(initial),
      pose_(initial),
      before_(initial),
      shifted_(initial),
      step_(initial.mode_count()),
      jump_(initial.mode_count()),
      gap_(initial.mode_count()) {}

// All other members are set anew in each window.
void BoundaryPath::visit(Archive& archive) {
  archive("pose", pose_);
  archive("travelled", travelled_);
  archive("amplitude", amplitude_);
}

void BoundaryPath::begin_window(const BodyMotion& start, int n, double dt) {
  FOOTFALL_DEMAND(n > 0 && dt > 0.0 && start.mode_count() == start_.mode_count());
  start_ = start;
  shifted_ = start;
  n_ = n;
  i_ = 0;
  dt_ = dt;
  set_zero(jump_);
  difference(start_, pose_, gap_);

  // Is the predicted motion a constant velocity from the current position?
  const double H = n * dt;
  scheme_.predict(start_, 0.0, before_);
  const Eigen::Vector3d velocity = before_.dr;
  const bool resting = before_.w.isZero(0.0) && before_.da.isZero(0.0);
  scheme_.predict(start_, H, before_);
  travelled_ = std::max({travelled_, start_.r.norm(), H * velocity.norm()});
  amplitude_ = std::max(amplitude_, start_.a.size() == 0 ? 0.0 : start_.a.cwiseAbs().maxCoeff());
  steady_ = resting && before_.dr == velocity && before_.w.isZero(0.0) && before_.da.isZero(0.0) &&
            gap_.r.norm() <= kRoundOff * travelled_ && gap_.theta_W.norm() <= kRoundOff &&
            (gap_.a.size() == 0 || gap_.a.cwiseAbs().maxCoeff() <= kRoundOff * amplitude_);
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
  set_pose_at(0.0);
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
  }
  difference(before_, pose_, step_);
}

// prediction(tau) with the gap closed by g(u) = 1 - 4 u + 3 u^2, u = tau / H: g(0) = 1, g(1) = 0, and zero
// mean over the window.
void BoundaryPath::set_pose_at(double tau) {
  const double H = n_ * dt_;
  const double u = tau / H;
  const double g = i_ == n_ ? 0.0 : 1.0 + u * (-4.0 + 3.0 * u);
  const double g_rate = (-4.0 + 6.0 * u) / H;
  shifted_.r = start_.r + g * gap_.r;
  shifted_.L = turned(start_.L, g * gap_.theta_W);
  shifted_.a = start_.a + g * gap_.a;
  scheme_.predict(shifted_, tau, pose_);
  // The predicted rotation follows the one that closes the gap, and rotates its angular velocity.
  const Eigen::Vector3d turn_rate = g_rate * gap_.theta_W;
  pose_.dr += g_rate * gap_.r;
  if (!turn_rate.isZero(0.0)) pose_.w += pose_.rotation() * (shifted_.rotation().transpose() * turn_rate);
  pose_.da += g_rate * gap_.a;
}

}  // namespace footfall
