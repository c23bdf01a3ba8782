#pragma once
// Linear filters with unit gain at rest, w = 2 pi f:
//   low pass, first order   1 / (1 + s/w)
//   low pass, second order  w^2 / (s^2 + 2 D w s + w^2)
//   notch                   (s^2 + w^2) / (s^2 + 2 D w s + w^2): nothing passes at f, the width is 2 D f
// as z' = A z + b u, y = c.z + d u. Sampled, z moves by exp(A T): the exact answer to inputs that are held.

#include <Eigen/Dense>

#include "mbd_solver/model/signals/signal_block.h"

namespace footfall {

class LinearFilter final : public SignalBlock {
 public:
  // frequency f > 0 [Hz], damping D > 0 [-]; period T > 0 [s] or 0 for a continuous filter. Throw InputError.
  static LinearFilter low_pass(double frequency, double period);
  static LinearFilter low_pass_2(double frequency, double damping, double period);
  static LinearFilter notch(double frequency, double damping, double period);

  int state_count() const override { return static_cast<int>(b_.size()); }
  bool passes_through() const override { return d_ != 0.0; }
  void settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const override;
  double value(const BlockValues& u, const BlockValues& z) const override;
  void rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const override;
  void advance(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override;

 private:
  using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, 2, 2>;  // no allocation
  using Vector = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, 2, 1>;
  LinearFilter(const Matrix& A, const Vector& b, const Vector& c, double d, double period);

  Matrix A_, A_period_;  // A; exp(A T)
  Vector b_, c_, b_period_;
  double d_;
};

}  // namespace footfall
