// The angle by the quotient rule on its sine and cosine, both dot products of axes.

#include "mbd_solver/model/elements/joint_coordinate.h"

namespace footfall {

JointCoordinate::JointCoordinate(Coordinate kind, const PairMotion& pair, const Marker& m1, const Marker& m2)
    : angle_(kind == Coordinate::kAngle) {
  if (!angle_) {
    a_ = KinematicVector::axis(pair, 0, m1, axis_of(kind));
    b_ = KinematicVector::difference(pair, m1, m2);
    q_ = a_.value().dot(b_.value());
    dq_ = dot_rate(a_, b_);
    ddq_ = dot_acc(a_, b_);
    return;
  }
  x1_ = KinematicVector::axis(pair, 0, m1, 0);
  a_ = KinematicVector::axis(pair, 0, m1, 1);
  b_ = KinematicVector::axis(pair, 1, m2, 0);
  s_ = a_.value().dot(b_.value());
  c_ = x1_.value().dot(b_.value());
  ds_ = dot_rate(a_, b_);
  dc_ = dot_rate(x1_, b_);
  rho_ = s_ * s_ + c_ * c_;
  drho_ = 2.0 * (s_ * ds_ + c_ * dc_);
  q_ = std::atan2(s_, c_);
  dq_ = (c_ * ds_ - s_ * dc_) / rho_;
  ddq_ = (c_ * dot_acc(a_, b_) - s_ * dot_acc(x1_, b_)) / rho_ - dq_ * drho_ / rho_;
}

void JointCoordinate::add_gradient(double factor, Eigen::Ref<Eigen::VectorXd> out) const {
  if (!angle_) return add_dot(a_, b_, factor, out);
  add_dot(a_, b_, factor * c_ / rho_, out);
  add_dot(x1_, b_, -factor * s_ / rho_, out);
}

void JointCoordinate::add_rate_by_position(double factor, CoordinateScratch& scratch,
                                           Eigen::Ref<Eigen::VectorXd> out) const {
  if (!angle_) return add_dot_rate(a_, b_, factor, out);
  // rho q' = c s' - s c':  (C s' + c s'_x - S c' - s c'_x - q' rho_x) / rho,  rho_x = 2 (s S + c C)
  const Eigen::Index n = out.size();
  Eigen::Ref<Eigen::VectorXd> S = scratch.s.head(n), C = scratch.c.head(n);
  S.setZero();
  C.setZero();
  add_dot(a_, b_, 1.0, S);
  add_dot(x1_, b_, 1.0, C);
  add_dot_rate(a_, b_, factor * c_ / rho_, out);
  add_dot_rate(x1_, b_, -factor * s_ / rho_, out);
  out += (factor * (ds_ - 2.0 * dq_ * c_) / rho_) * C - (factor * (dc_ + 2.0 * dq_ * s_) / rho_) * S;
}

void JointCoordinate::add_acc_by_position(double factor, CoordinateScratch& scratch,
                                          Eigen::Ref<Eigen::VectorXd> out) const {
  if (!angle_) return add_dot_acc(a_, b_, factor, out);
  // ((c s'' - s c'')_x - q'_x rho' - q' rho'_x - q'' rho_x) / rho,  rho'_x = 2 (S s' + s s'_x + C c' + c c'_x)
  const Eigen::Index n = out.size();
  Eigen::Ref<Eigen::VectorXd> row = scratch.row.head(n);
  row.setZero();
  add_rate_by_position(-drho_ / rho_, scratch, row);  // fills S and C
  const Eigen::Ref<Eigen::VectorXd> S = scratch.s.head(n), C = scratch.c.head(n);
  const double dds = dot_acc(a_, b_), ddc = dot_acc(x1_, b_);
  row += ((dds - 2.0 * (dq_ * dc_ + ddq_ * c_)) / rho_) * C - ((ddc + 2.0 * (dq_ * ds_ + ddq_ * s_)) / rho_) * S;
  add_dot_rate(a_, b_, -2.0 * dq_ * s_ / rho_, row);
  add_dot_rate(x1_, b_, -2.0 * dq_ * c_ / rho_, row);
  add_dot_acc(a_, b_, c_ / rho_, row);
  add_dot_acc(x1_, b_, -s_ / rho_, row);
  out += factor * row;
}

void JointCoordinate::add_acc_by_velocity(double factor, CoordinateScratch& scratch,
                                          Eigen::Ref<Eigen::VectorXd> out) const {
  if (!angle_) return add_dot_acc_by_velocity(a_, b_, factor, out);
  // (c s''_v - s c''_v - q'_v rho' - q' rho_x) / rho
  const Eigen::Index n = out.size();
  Eigen::Ref<Eigen::VectorXd> row = scratch.row.head(n);
  row.setZero();
  add_gradient(-drho_ / rho_, row);
  add_dot(a_, b_, -2.0 * dq_ * s_ / rho_, row);
  add_dot(x1_, b_, -2.0 * dq_ * c_ / rho_, row);
  add_dot_acc_by_velocity(a_, b_, c_ / rho_, row);
  add_dot_acc_by_velocity(x1_, b_, -s_ / rho_, row);
  out += factor * row;
}

void JointCoordinate::add_second(double factor, CoordinateScratch& scratch, Eigen::Ref<Eigen::MatrixXd> K) const {
  if (!angle_) return add_dot_second(a_, b_, factor, K);
  // q_x = (c S - s C) / rho:  (c s_xx - s c_xx + S C^T - C S^T - q_x rho_x^T) / rho
  const Eigen::Index n = K.rows();
  Eigen::Ref<Eigen::VectorXd> S = scratch.s.head(n), C = scratch.c.head(n), row = scratch.row.head(n);
  S.setZero();
  C.setZero();
  row.setZero();
  add_dot(a_, b_, 1.0, S);
  add_dot(x1_, b_, 1.0, C);
  add_gradient(1.0, row);
  for (Eigen::Index j = 0; j < n; ++j) {
    const double by_rho = 2.0 * (s_ * S[j] + c_ * C[j]);
    K.col(j) += (factor / rho_) * (C[j] * S - S[j] * C - by_rho * row);
  }
  add_dot_second(a_, b_, factor * c_ / rho_, K);
  add_dot_second(x1_, b_, -factor * s_ / rho_, K);
}

}  // namespace footfall
