#pragma once
// PID with limits and anti-windup.
//   v = bias + kp e + ki I + kd D,   y = v within [min, max]
//   I' = e + (y - v) / kp:  at a limit the integral stops growing
//   D = the second input where there is one, else the filtered rate D = w (e - z), z' = w (e - z), w = 2 pi f
// Sampled: I moves by Euler's rule, z exactly; without f the rate is the difference over a period, D = (e_k - e_k-1) / T.

#include <optional>

#include "mbd_solver/model/signals/signal_block.h"

namespace footfall {

struct PidBlockParameters {
  double kp = 0.0, ki = 0.0, kd = 0.0;  // >= 0 [unit, unit/s, unit s]
  double bias = 0.0;
  std::optional<double> min, max;
  double derivative_frequency = 0.0;  // f >= 0 [Hz]; 0: none, for sampled ones alone
  bool rate_is_given = false;         // by the second input
  double period = 0.0;                // [s]; 0: continuous
};

class PidBlock final : public SignalBlock {
 public:
  explicit PidBlock(const PidBlockParameters& parameters);  // throws InputError

  int input_count() const override { return parameters_.rate_is_given ? 2 : 1; }
  int state_count() const override { return (has_integral() ? 1 : 0) + (has_rate() ? 1 : 0); }
  void settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const override;
  double value(const BlockValues& u, const BlockValues& z) const override;
  void rates(const BlockValues& u, const BlockValues& z, Eigen::Ref<Eigen::VectorXd> dz) const override;
  void advance(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override;

 private:
  bool has_integral() const { return parameters_.ki > 0.0; }
  bool has_rate() const { return parameters_.kd > 0.0 && !parameters_.rate_is_given; }
  double asked_for(const BlockValues& u, const BlockValues& z) const;  // v
  double limited(double v) const;
  double integral_rate(const BlockValues& u, const BlockValues& z) const;  // I'

  PidBlockParameters parameters_;
  double w_ = 0.0;  // [rad/s]
};

}  // namespace footfall
