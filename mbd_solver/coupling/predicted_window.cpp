#include "mbd_solver/coupling/predicted_window.h"

namespace footfall {

PredictedWindow::PredictedWindow(const Scheme& scheme, const BodyMotion& initial)
    : scheme_(scheme), walk_(scheme, initial) {
  path_.r_mean = path_.r_end = initial.r;
  path_.L_mean = path_.L_end = initial.L;
}

void PredictedWindow::begin(const BodyMotion& start, int n, double dt) {
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
  // The force that opens the window stands since the last substep of the window before.
  add(weights.opening);
  walk_.begin_window(start, n, dt);
  for (int i = 1; i <= n; ++i) {
    walk_.advance();
    add(i < n ? 1.0 : weights.closing);
  }
  path_.r_mean = start.r + r / n;
  path_.L_mean = turned(start.L, theta / n);
  path_.v_mean = v / n;
  path_.r_end = walk_.pose().r;
  path_.L_end = walk_.pose().L;
}

}  // namespace footfall
