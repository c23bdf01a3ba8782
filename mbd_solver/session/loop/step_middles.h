#pragma once
// The middles of steps without grains, where a peak may exceed the values at the ends: a rate that comes
// near its largest so far is beyond both of its ends, by more than kBeyond of it.

#include <algorithm>
#include <cmath>

#include "mbd_solver/integrator/integrator.h"

namespace footfall {

class StepMiddles {
 public:
  bool are_peaks(StepView& step) {
    step.at(step.end(), state_, end_);
    step.at(0.5 * (step.begin() + step.end()), state_, rates_);
    if (largest_.size() == 0) largest_ = Eigen::VectorXd::Zero(end_.size());
    largest_ = largest_.cwiseMax(end_.cwiseAbs()).cwiseMax(rates_.cwiseAbs());
    const bool known = time_ == step.begin();
    bool peaks = !known;
    const double round_off = kRoundOff * largest_.maxCoeff();
    for (Eigen::Index i = 0; i < rates_.size() && !peaks; ++i) {
      const double low = std::min(begin_[i], end_[i]), high = std::max(begin_[i], end_[i]);
      peaks = std::max(rates_[i] - high, low - rates_[i]) > kBeyond * largest_[i] + round_off &&
              std::abs(rates_[i]) > kNear * largest_[i];
    }
    begin_.swap(end_);
    time_ = step.end();
    return peaks;
  }
  const State& state() const { return state_; }  // in the middle of the last step
  const Eigen::VectorXd& rates() const { return rates_; }

 private:
  static constexpr double kBeyond = 1e-3, kNear = 0.5;  // [-]
  static constexpr double kRoundOff = 1e-10;            // of the largest rate of all [-]

  State state_;
  Eigen::VectorXd rates_, begin_, end_, largest_;
  double time_ = -1.0;  // of the last end [s]
};

}  // namespace footfall
