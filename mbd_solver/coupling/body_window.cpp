// Path of a boundary as mean values over the DEM steps, with the weights of the scheme; the load that the integrator
// applies; work and impulse that remain at the end of a window. Equations: body_window.h, theory 7.

#include "mbd_solver/coupling/body_window.h"

#include <cmath>
#include <utility>

#include "coupler/message_fields.h"

namespace footfall {

void slow_down_fast_modes(const BodyMotion& before, const Eigen::VectorXd& stiffness, double H, BodyMotion& motion) {
  for (Eigen::Index i = 0; i < motion.da.size(); ++i) {
    const double Omega = std::sqrt(stiffness[i]), theta = Omega * H;
    if (!(theta > 0.01)) continue;  // weight below 1e-8
    const double offset = before.dda[i] / stiffness[i];
    const double rate =
        2.0 / H * (offset * (1.0 - std::sin(theta) / theta) + before.da[i] * (1.0 - std::cos(theta)) / (Omega * theta));
    const double fourth = std::pow(theta, 4), weight = fourth / (1.0 + fourth);
    motion.da[i] += weight * (rate - motion.da[i]);
    motion.dda[i] *= 1.0 - weight;
  }
}

PredictedWindow::PredictedWindow(const Scheme& scheme, const BodyMotion& initial)
    : scheme_(scheme), walk_(scheme, initial) {
  path_.r_mean = path_.r_end = initial.r;
  path_.L_mean = path_.L_end = initial.L;
  path_.a_end = initial.a;
}

void PredictedWindow::begin(const BodyMotion& start, int n, double dt, int closing, const KnownPath& known) {
  const StepWeights weights = scheme_.weights();
  Eigen::Vector3d r = Eigen::Vector3d::Zero(), theta = Eigen::Vector3d::Zero();  // from the start of the window
  Vector6d v = Vector6d::Zero();
  const auto add = [&](double weight) {
    const BodyMotion& pose = walk_.pose();
    r += weight * (pose.r - start.r);
    theta += weight * rotation_vector(start.L, pose.L);
    v.head<3>() += weight * pose.dr;
    v.tail<3>() += weight * pose.w;
  };
  // The force that opens the window acts since the last DEM step of the window before.
  add(weights.opening);
  walk_.begin_window(start, n, dt, closing, known);
  for (int i = 1; i <= n; ++i) {
    walk_.advance();
    add(i < n ? 1.0 : weights.closing);
  }
  path_.r_mean = start.r + r / n;
  path_.L_mean = turned(start.L, theta / n);
  path_.v_mean = v / n;
  path_.r_end = walk_.pose().r;
  path_.L_end = walk_.pose().L;
  path_.a_end = walk_.pose().a;
  path_.left_open << walk_.left_open().r, walk_.left_open().theta_W;
}

BodyWindow::BodyWindow(const Scheme& scheme, const Body& body, const BodyMotion& initial, const BodyLoad& last)
    : scheme_(scheme),
      body_(body),
      predicted_(scheme, initial),
      start_(initial),
      load_(last),
      before_(initial.mode_count()) {
  if (load_.mean.Q_a.size() != initial.mode_count()) load_.mean = MeanLoad(initial.mode_count());
}

// State, path and reaction are set anew by the next window.
void BodyWindow::visit(Archive& archive) {
  archive("predicted", predicted_);
  archive("load", load_);
  archive("n", n_);
}

Matrix6d BodyWindow::rigid_inertia() const {
  Matrix6d M = Matrix6d::Zero();
  M.diagonal().head<3>().setConstant(body_.mass());
  const Eigen::Matrix3d A = start_.rotation();
  M.bottomRightCorner<3, 3>() = A * body_.rigid_inertia() * A.transpose();
  return M;
}

void BodyWindow::begin(int n, double dt, BodyMotion& motion, int closing, const KnownPath& known) {
  start_ = motion;
  n_before_ = n_;
  n_ = n;
  length_ = n * dt;
  scheme_.set_path_rates(rigid_inertia(), load_, length_, motion);
  if (body_.mode_count() > 0) slow_down_fast_modes(start_, body_.modal()->stiffness, length_, motion);
  predicted_.begin(motion, n, dt, closing, known);
}

void BodyWindow::apply(const BodyLoad& load, ExternalLoad& applied) {
  std::swap(before_, load_.mean);
  load_ = load;
  reaction_ = scheme_.reaction(rigid_inertia(), load_, predicted_.path(), length_);
  applied.F_W = load_.mean.F_W;
  applied.T_B = load_.mean.T_B;
  if (load_.mean.Q_a.size() > 0) applied.Q_a = load_.mean.Q_a;
  applied.tangent = reaction_;
}

double BodyWindow::pending_work(const BodyMotion& computed) const {
  const double ratio = n_before_ > 0 ? static_cast<double>(n_) / n_before_ : 0.0;
  return scheme_.pending_work({load_, before_, ratio}, predicted_.path(), computed);
}

// By the means of this window and of the window before, extrapolated to its end.
double BodyWindow::pending_modal_work(const BodyMotion& computed) const {
  if (computed.mode_count() == 0) return 0.0;
  const double ratio = n_before_ > 0 ? static_cast<double>(n_) / n_before_ : 0.0, share = ratio / (1.0 + ratio);
  const Eigen::VectorXd &Q = load_.mean.Q_a, &before = before_.Q_a;
  return (Q + share * (Q - before)).dot(computed.a - predicted_.path().a_end);
}

std::optional<Eigen::Vector3d> BodyWindow::surplus_impulse(const BodyMotion& computed) const {
  if (!reaction_) return std::nullopt;
  return footfall::surplus_impulse(*reaction_, start_, computed, length_);
}

}  // namespace footfall
