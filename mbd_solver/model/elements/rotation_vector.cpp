#include "mbd_solver/model/elements/rotation_vector.h"

#include <cmath>

namespace footfall {
namespace {

constexpr double kSmall = 0.01;  // of (|w| / c)^2: below, differences of nearly equal numbers give way to series
constexpr int kTerms = 9;        // of the series: kSmall^kTerms is beyond round-off

// dV/dG_ij of V = b . [w; c].
Eigen::Matrix3d by_products(const Eigen::Vector4d& b) {
  Eigen::Matrix3d B = 0.5 * b[3] * Eigen::Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    B(j, i) += 0.5 * b[k];
    B(i, j) -= 0.5 * b[k];
  }
  return B;
}

}  // namespace

RotationVector::RotationVector(const PairMotion& pair, const Marker& m1, const Marker& m2) {
  Eigen::Matrix3d E1, E2;
  const NodeTurn turn_1(*pair.body[0], m1), turn_2(*pair.body[1], m2);
  for (int k = 0; k < 3; ++k) {
    e1_[k] = KinematicVector::axis(pair, 0, m1, k, turn_1);
    e2_[k] = KinematicVector::axis(pair, 1, m2, k, turn_2);
    E1.col(k) = e1_[k].value();
    E2.col(k) = e2_[k].value();
  }
  const Eigen::Matrix3d G = E1.transpose() * E2;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    w_[k] = 0.5 * (G(j, i) - G(i, j));
  }
  c_ = 0.5 * (G.trace() - 1.0);
  const double sigma = w_.squaredNorm(), s = std::sqrt(sigma);
  rho_ = sigma + c_ * c_;
  angle_ = std::atan2(s, c_);
  const double x = sigma / (c_ * c_);
  if (c_ > 0.0 && x < kSmall) {
    // f = 1/c sum (-x)^n / (2n + 1),  g = 2 df/dsigma,  h = dg/dsigma
    double power = 1.0;  // (-x)^n
    f_ = g_ = h_ = 0.0;
    for (int n = 0; n < kTerms; ++n) {
      f_ += power / (2 * n + 1);
      g_ -= power * (2 * n + 2) / (2 * n + 3);
      h_ += power * (n + 1) * (2 * n + 4) / (2 * n + 5);
      power *= -x;
    }
    f_ /= c_;
    g_ /= c_ * c_ * c_;
    h_ /= c_ * c_ * c_ * c_ * c_;
  } else {
    f_ = angle_ / s;
    g_ = (c_ / rho_ - f_) / sigma;
    h_ = (-c_ / (rho_ * rho_) - 1.5 * g_) / sigma;
  }
  theta_ = f_ * w_;
}

// df/dc = -1 / rho,  d2f/dc2 = 2 c / rho^2,  d2f/dc dw = 2 w / rho^2,  d2f/dw2 = g I + 2 h w w^T

Eigen::Vector4d RotationVector::gradient(const Eigen::Vector3d& p) const {
  const double pw = p.dot(w_);
  Eigen::Vector4d out;
  out.head<3>() = f_ * p + (pw * g_) * w_;
  out[3] = -pw / rho_;
  return out;
}

Eigen::Matrix4d RotationVector::curvature(const Eigen::Vector3d& p) const {
  const double pw = p.dot(w_), rho2 = rho_ * rho_;
  Eigen::Matrix4d out;
  out.topLeftCorner<3, 3>() = g_ * (w_ * p.transpose() + p * w_.transpose()) + (2.0 * pw * h_) * w_ * w_.transpose();
  out.topLeftCorner<3, 3>().diagonal().array() += pw * g_;
  out.topRightCorner<3, 1>() = -p / rho_ + (2.0 * pw / rho2) * w_;
  out.bottomLeftCorner<1, 3>() = out.topRightCorner<3, 1>().transpose();
  out(3, 3) = 2.0 * pw * c_ / rho2;
  return out;
}

Eigen::Matrix<double, 3, 4> RotationVector::jacobian() const {
  Eigen::Matrix<double, 3, 4> J;
  J.leftCols<3>() = g_ * w_ * w_.transpose();
  J.leftCols<3>().diagonal().array() += f_;
  J.col(3) = -w_ / rho_;
  return J;
}

void RotationVector::add_gradient(const Eigen::Vector4d& b, Eigen::Ref<Eigen::VectorXd> out) const {
  const Eigen::Matrix3d B = by_products(b);
  for (int i = 0; i < 3; ++i) {
    e1_[i].add_transposed(B(i, 0) * e2_[0].value() + B(i, 1) * e2_[1].value() + B(i, 2) * e2_[2].value(), out);
    e2_[i].add_transposed(B(0, i) * e1_[0].value() + B(1, i) * e1_[1].value() + B(2, i) * e1_[2].value(), out);
  }
}

void RotationVector::add_second(const Eigen::Vector4d& b, Eigen::Ref<Eigen::MatrixXd> K) const {
  const Eigen::Matrix3d B = by_products(b);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) add_dot_second(e1_[i], e2_[j], B(i, j), K);
}

void RotationVector::add_jacobian(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 4>> columns) const {
  for (int a = 0; a < 4; ++a) add_gradient(Eigen::Vector4d::Unit(a), columns.col(a));
}

}  // namespace footfall
