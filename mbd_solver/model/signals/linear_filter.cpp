#include "mbd_solver/model/signals/linear_filter.h"

#include "coupler/base/parameter_check.h"
#include "coupler/base/pi.h"
#include "coupler/matrix_exponential.h"

namespace footfall {

LinearFilter::LinearFilter(const Matrix& A, const Vector& b, const Vector& c, double d, double period)
    : A_(A), A_period_(A), b_(b), c_(c), b_period_(b), d_(d) {
  require_not_negative("filter", "period", period, "s");
  if (period == 0.0) return;
  const Eigen::Index n = b.size();
  Eigen::MatrixXd both = Eigen::MatrixXd::Zero(n + 1, n + 1);  // [z; u]' = [A, b; 0, 0] [z; u]
  both.topLeftCorner(n, n) = A;
  both.topRightCorner(n, 1) = b;
  const Eigen::MatrixXd moved = matrix_exponential(both * period);
  A_period_ = moved.topLeftCorner(n, n);
  b_period_ = moved.topRightCorner(n, 1);
}

LinearFilter LinearFilter::low_pass(double frequency, double period) {
  require_positive("lowpass", "frequency", frequency, "Hz");
  const double w = 2.0 * kPi * frequency;
  return {Matrix::Constant(1, 1, -w), Vector::Constant(1, w), Vector::Ones(1), 0.0, period};
}

LinearFilter LinearFilter::low_pass_2(double frequency, double damping, double period) {
  require_positive("lowpass2", "frequency", frequency, "Hz");
  require_positive("lowpass2", "damping", damping, "");
  const double w = 2.0 * kPi * frequency;
  // z = [y; y'/w]: both of the size of the signal
  Matrix A(2, 2);
  A << 0.0, w, -w, -2.0 * damping * w;
  return {A, (Vector(2) << 0.0, w).finished(), (Vector(2) << 1.0, 0.0).finished(), 0.0, period};
}

LinearFilter LinearFilter::notch(double frequency, double damping, double period) {
  require_positive("notch", "frequency", frequency, "Hz");
  require_positive("notch", "damping", damping, "");
  LinearFilter low = low_pass_2(frequency, damping, period);
  // y = u - 2 D w s / (s^2 + 2 D w s + w^2) u, of which z_2 is the part w s / (...) u
  low.c_ << 0.0, -2.0 * damping;
  low.d_ = 1.0;
  return low;
}

void LinearFilter::settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const {
  z.setZero();
  z[0] = u[0];  // A z + b u = 0 in all of them
}

double LinearFilter::value(const BlockValues& u, const BlockValues& z) const {
  double y = d_ * u[0];
  for (Eigen::Index i = 0; i < z.size(); ++i) y += c_[i] * z[i];
  return y;
}

void LinearFilter::rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const {
  dz.noalias() = A_.lazyProduct(z);
  dz += u[0] * b_;
}

void LinearFilter::advance(const BlockValues& u, double, Eigen::Ref<Eigen::VectorXd> z) const {
  const Vector next = A_period_.lazyProduct(z) + u[0] * b_period_;
  z = next;
}

}  // namespace footfall
