// What a step tells beyond its ends: the rates that a stage of the next step starts from, and states in between.
#include <algorithm>
#include <array>
#include <cmath>

#include "mbd_solver/integrator/one_step.h"
#include "mbd_solver/integrator/tableau.h"
#include "mbd_solver/integrator/work_integral.h"

namespace footfall {
namespace {

constexpr double kReach = 3.0;          // steps longer than this many steps before are not predicted from those
constexpr std::size_t kPredictors = 3;  // rates that a stage is predicted from: a parabola

}  // namespace

void OneStep::predict(int stage, double h) {
  // The parabola through the rates nearest in time, of this step and of the one before; the latter are moved by what has
  // jumped since. Times in steps h from the start of this one.
  struct Known {
    double time;
    const Eigen::VectorXd* rates;
    bool before;
  };
  std::array<Known, kMostStages + 3> known{};
  std::size_t count = 0;
  const double target = tableau_->c[static_cast<std::size_t>(stage)];
  for (std::size_t j = 0; j < static_cast<std::size_t>(stage); ++j) known[count++] = {tableau_->c[j], &K_[j], false};
  if (h_before_ > 0.0 && h < kReach * h_before_) {
    for (std::size_t k = 0; k + 1 < before_.size(); ++k)
      known[count++] = {(predictor_time(k) - 1.0) * h_before_ / h, &before_[k], true};
  }
  std::sort(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(count),
            [&](const Known& a, const Known& b) { return std::abs(a.time - target) < std::abs(b.time - target); });
  count = std::min(count, kPredictors);
  std::array<double, kPredictors> times{};
  for (std::size_t j = 0; j < count; ++j) times[j] = known[j].time;
  Eigen::VectorXd& K = K_[static_cast<std::size_t>(stage)];
  K.setZero();
  for (std::size_t j = 0; j < count; ++j) {
    const double weight = lagrange(times, count, j, target);
    K += weight * *known[j].rates;
    if (known[j].before) K += weight * (K_[0] - before_.back());
  }
}

double OneStep::predictor_time(std::size_t k) const { return tableau_before_->c[k]; }

void OneStep::interpolate(double time, double h) {
  const int m = equations_.layout().lambda0();
  const DenseWeights w(*tableau_, (time - start_.time) / h);
  row_ = start_;
  row_.time = time;
  known_ = y_;
  row_rates_.setZero();
  for (std::size_t i = 0; i <= last(); ++i) {
    known_.head(m) += (h * w.b[i]) * K_[i].head(m);
    row_rates_ += w.slope[i] * K_[i];
    add_work(energy_[i], h * w.b[i], row_);
  }
  equations_.unpack(known_, row_);
}

}  // namespace footfall
