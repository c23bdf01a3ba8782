// Time integrals of force, moment, modal force and work over the DEM steps, divided by the length of the window.

#include "coupler/load_average.h"

#include "coupler/base/errors.h"

namespace footfall {

void MeanLoad::set_zero() {
  F_W.setZero();
  T_B.setZero();
  Q_a.setZero();
  work = 0.0;
  jump_work = 0.0;
  impulse_W.setZero();
}

void apply(const MeanLoad& mean, const BodyMotion& motion, GeneralizedForce& out) {
  out.F_W = mean.F_W;
  out.T_W = motion.rotation() * mean.T_B;
  out.Q_a = mean.Q_a;
}

LoadAverage::LoadAverage(const Scheme& scheme, int modes) : weights_(scheme.weights()), opening_(modes), sum_(modes) {}

void LoadAverage::set_opening_force(const GeneralizedForce& Q, const BodyMotion& pose) {
  opening_.F_W = Q.F_W;
  opening_.T_B = pose.rotation().transpose() * Q.T_W;
  opening_.Q_a = Q.Q_a;
}

void LoadAverage::begin_window(const BoundaryStep& jump, const BodyMotion& pose) {
  sum_.set_zero();
  time_ = 0.0;
  // The force before the jump does its work.
  sum_.jump_work = opening_.F_W.dot(jump.r) + opening_.T_B.dot(pose.rotation().transpose() * jump.theta_W) +
                   opening_.Q_a.dot(jump.a);
  sum_.work = sum_.jump_work;
}

Eigen::Vector3d LoadAverage::add_step(const GeneralizedForce& Q, const BodyMotion& pose, const BoundaryStep& step,
                                      double dt) {
  const double c0 = weights_.opening, c1 = weights_.closing;
  const Eigen::Matrix3d R_BW = pose.rotation().transpose();
  const Eigen::Vector3d T_B = R_BW * Q.T_W;
  // A rotation vector has the same components in B before and after the turn that it describes.
  const Eigen::Vector3d theta_B = R_BW * step.theta_W;
  const Eigen::Vector3d F_mean = c0 * opening_.F_W + c1 * Q.F_W;
  const Eigen::Vector3d T_mean = c0 * opening_.T_B + c1 * T_B;
  sum_.F_W += dt * F_mean;
  sum_.T_B += dt * T_mean;
  sum_.work += F_mean.dot(step.r) + T_mean.dot(theta_B);
  sum_.impulse_W += 0.5 * dt * (opening_.F_W + Q.F_W);
  if (opening_.Q_a.size() > 0) {
    sum_.Q_a += dt * (c0 * opening_.Q_a + c1 * Q.Q_a);
    sum_.work += c0 * opening_.Q_a.dot(step.a) + c1 * Q.Q_a.dot(step.a);
    opening_.Q_a = Q.Q_a;
  }
  opening_.F_W = Q.F_W;
  opening_.T_B = T_B;
  time_ += dt;
  return F_mean;
}

const MeanLoad& LoadAverage::finish() {
  FOOTFALL_DEMAND(time_ > 0.0);
  sum_.F_W /= time_;
  sum_.T_B /= time_;
  sum_.Q_a /= time_;
  return sum_;
}

}  // namespace footfall
