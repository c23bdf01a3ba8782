#include "mbd_solver/coupling/predicted_window.h"

namespace footfall {

void PredictedWindow::begin(const BodyMotion& start, int n, double dt) {
  const StepWeights weights = scheme_.weights();
  Eigen::Vector3d r = Eigen::Vector3d::Zero(), theta = Eigen::Vector3d::Zero();  // from the start of the window
  Vector6d v = Vector6d::Zero();
  const auto add = [&](double weight) {
    const BodyMotion& pose = path_.pose();
    r += weight * (pose.r - start.r);
    theta += weight * rotation_vector(start.L, pose.L);
    v.head<3>() += weight * pose.dr;
    v.tail<3>() += weight * pose.w;
  };
  // The force that opens the window stands since the last substep of the window before.
  add(weights.opening);
  path_.begin_window(start, n, dt);
  for (int i = 1; i <= n; ++i) {
    path_.advance();
    add(i < n ? 1.0 : weights.closing);
  }
  r_mean_ = start.r + r / n;
  L_mean_ = turned(start.L, theta / n);
  v_mean_ = v / n;
}

Vector6d PredictedWindow::gap(const BodyMotion& computed) const {
  Vector6d gap;
  gap << computed.r - path_.pose().r, rotation_vector(path_.pose().L, computed.L);
  return gap;
}

Vector6d PredictedWindow::end_from_mean() const {
  Vector6d way;
  way << path_.pose().r - r_mean_, rotation_vector(L_mean_, path_.pose().L);
  return way;
}

}  // namespace footfall
