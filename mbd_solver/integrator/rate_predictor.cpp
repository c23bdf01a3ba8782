// A parabola through the rates nearest in time.

#include "mbd_solver/integrator/rate_predictor.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace footfall {
namespace {

constexpr int kMostBefore = 4;          // stored rates of a step
constexpr double kReach = 3.0;          // longer steps, in steps before, do not use the rates before
constexpr std::size_t kPredictors = 3;  // rates in a prediction: a parabola

}  // namespace

RatePredictor::RatePredictor(int stages, Eigen::Index size) {
  before_.assign(static_cast<std::size_t>(std::min(stages, kMostBefore)), Eigen::VectorXd::Zero(size));
}

// Rates of the step before are moved by the jump since. Times in steps h from the start of this step.
void RatePredictor::predict(const Tableau& tableau, int stage, double h, std::vector<Eigen::VectorXd>& rates) const {
  struct Known {
    double time;
    const Eigen::VectorXd* rates;
    bool before;
  };
  std::array<Known, kMostStages + 3> known{};
  std::size_t count = 0;
  const double target = tableau.c[stage];
  for (std::size_t j = 0; j < static_cast<std::size_t>(stage); ++j) known[count++] = {tableau.c[j], &rates[j], false};
  if (h_ > 0.0 && h < kReach * h_) {
    for (std::size_t k = 0; k + 1 < before_.size(); ++k)
      known[count++] = {(tableau_->c[k] - 1.0) * h_ / h, &before_[k], true};
  }
  std::sort(known.begin(), known.begin() + static_cast<std::ptrdiff_t>(count),
            [&](const Known& a, const Known& b) { return std::abs(a.time - target) < std::abs(b.time - target); });
  count = std::min(count, kPredictors);
  std::array<double, kPredictors> times{};
  for (std::size_t j = 0; j < count; ++j) times[j] = known[j].time;
  Eigen::VectorXd& K = rates[stage];
  K.setZero();
  for (std::size_t j = 0; j < count; ++j) {
    const double weight = lagrange(times, count, j, target);
    K += weight * *known[j].rates;
    if (known[j].before) K += weight * (rates[0] - before_.back());
  }
}

void RatePredictor::accept(const Tableau& tableau, double h, std::vector<Eigen::VectorXd>& K) {
  for (std::size_t k = 0; k + 1 < before_.size(); ++k) before_[k].swap(K[k]);
  before_.back().swap(K[tableau.last()]);
  K[0] = before_.back();
  h_ = h;
  tableau_ = &tableau;
}

}  // namespace footfall
