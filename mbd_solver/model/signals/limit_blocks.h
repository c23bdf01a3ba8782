#pragma once
// Limits of a signal and of its rate.

#include <algorithm>
#include <optional>

#include "mbd_solver/model/signals/signal_block.h"

namespace footfall {

// y = u within [min, max]
class Saturation final : public SignalBlock {
 public:
  Saturation(std::optional<double> min, std::optional<double> max) : min_(min), max_(max) {}
  double value(const BlockValues& u, const BlockValues&) const override {
    double y = u[0];
    if (min_) y = std::max(y, *min_);
    if (max_) y = std::min(y, *max_);
    return y;
  }

 private:
  std::optional<double> min_, max_;
};

// y_k = y_(k-1) + (u_k - y_(k-1)), this change within +- r T. Sampled only: its rate jumps.
class RateLimit final : public SignalBlock {
 public:
  explicit RateLimit(double largest_rate) : rate_(largest_rate) {}  // r > 0 [unit/s]
  int state_count() const override { return 1; }                    // y_(k-1)
  void settle(const BlockValues& u, Eigen::Ref<Eigen::VectorXd> z) const override { z[0] = u[0]; }
  double value(const BlockValues&, const BlockValues& z) const override { return z[0]; }
  double sample(const BlockValues& u, double period, Eigen::Ref<Eigen::VectorXd> z) const override {
    z[0] += std::clamp(u[0] - z[0], -rate_ * period, rate_ * period);
    return z[0];
  }

 private:
  double rate_;
};

}  // namespace footfall
