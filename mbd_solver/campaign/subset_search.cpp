// The first level is drawn at random; each further one begins at runs above the last level and takes one step of all chains
// at a time. The last level, or the last that the runs allow, is the threshold itself.
#include "mbd_solver/campaign/subset_search.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

namespace footfall {

namespace {

constexpr std::size_t kChainSteps = 10;  // of a chain: the inverse of the share that a level is aimed at
constexpr std::size_t kMostLevels = 5;   // for which the runs are divided
constexpr double kCorrelation = 0.8;     // r, of a step
constexpr double kBothSides = 1.959963984540054;

}  // namespace

SubsetSearch::SubsetSearch(std::size_t inputs, int runs, double threshold, std::uint64_t seed)
    : inputs_(inputs), left_(runs), threshold_(threshold), engine_(seed) {
  // N + 4 (N - N / 10) runs.
  chains_ =
      std::max<std::size_t>(1, static_cast<std::size_t>(runs) / (kChainSteps + (kMostLevels - 1) * (kChainSteps - 1)));
  size_ = chains_ * kChainSteps;
}

std::vector<std::vector<double>> SubsetSearch::positions() const {
  std::vector<std::vector<double>> all;
  for (const Run& run : proposed_) {
    all.emplace_back();
    for (const double u : run.u) all.back().push_back(0.5 * std::erfc(-u / std::sqrt(2.0)));
  }
  return all;
}

std::vector<std::vector<double>> SubsetSearch::next(const std::vector<double>& values) {
  std::normal_distribution<double> normally;
  const double level = levels_.empty() ? -std::numeric_limits<double>::infinity() : levels_.back().level;
  for (std::size_t i = 0; i < proposed_.size(); ++i) {
    proposed_[i].g = std::isnan(values[i]) ? std::numeric_limits<double>::infinity() : values[i];
    // A refused run stays where its chain is: one step before.
    runs_.push_back(levels_.empty() || proposed_[i].g > level ? proposed_[i] : Run(runs_[runs_.size() - chains_]));
  }
  proposed_.clear();
  if (runs_.size() == size_) raise();
  if (done_) return {};
  const std::size_t count = levels_.empty() ? size_ : chains_;
  for (std::size_t i = 0; i < count; ++i) {
    Run run;
    for (std::size_t k = 0; k < inputs_; ++k) {
      const double n = normally(engine_);
      run.u.push_back(levels_.empty() ? n
                                      : kCorrelation * runs_[runs_.size() - chains_ + i].u[k] +
                                            std::sqrt(1.0 - kCorrelation * kCorrelation) * n);
    }
    proposed_.push_back(run);
  }
  left_ -= static_cast<int>(count);
  return positions();
}

void SubsetSearch::raise() {
  std::vector<double> sorted;
  for (const Run& run : runs_) sorted.push_back(run.g);
  std::sort(sorted.begin(), sorted.end(), std::greater<>());
  double level = sorted[chains_];  // exceeded by a tenth, or by fewer where values are equal
  const bool last = level >= threshold_ || left_ < static_cast<int>(size_ - chains_);
  if (last) level = threshold_;
  const auto above =
      static_cast<double>(std::count_if(runs_.begin(), runs_.end(), [&](const Run& run) { return run.g > level; }));
  const auto all = static_cast<double>(size_);
  const double share = above / all;
  // d^2 = (1 - p) / (p N) (1 + gamma), gamma = 2 sum over k of (1 - k / steps) r_k, r_k: the correlation of [g > level] k
  // steps apart in the chains [Au and Beck 27].
  double gamma = 0.0;
  for (std::size_t k = 1; !levels_.empty() && share > 0.0 && share < 1.0 && k < kChainSteps; ++k) {
    double together = 0.0;
    for (std::size_t i = 0; i + k * chains_ < size_; ++i)
      together += runs_[i].g > level && runs_[i + k * chains_].g > level ? 1.0 : 0.0;
    const double r = (together / static_cast<double>(size_ - k * chains_) - share * share) / (share * (1.0 - share));
    gamma += 2.0 * (1.0 - static_cast<double>(k) / kChainSteps) * r;
  }
  levels_.push_back(
      {level, share, share > 0.0 ? std::sqrt((1.0 - share) / above * (1.0 + std::max(0.0, gamma))) : 0.0});
  done_ = last || !(above > 0.0);
  reached_ = last && above > 0.0;
  if (done_) return;
  std::vector<Run> seeds;
  for (const Run& run : runs_)
    if (run.g > level) seeds.push_back(run);
  for (std::size_t i = seeds.size(); i > 1; --i) std::swap(seeds[i - 1], seeds[engine_() % i]);
  const std::size_t found = seeds.size();
  seeds.resize(chains_);
  for (std::size_t i = found; i < chains_; ++i) seeds[i] = seeds[i % found];
  runs_ = seeds;
}

// log P is taken as normal, with the sum of the variations of all levels: their upper bound [Au and Beck 30].
RareProbability SubsetSearch::result() const {
  RareProbability p;
  p.value = 1.0;
  double before = 1.0;  // of the last level
  for (const Level& level : levels_) {
    before = p.value;
    p.value *= level.share;
    p.variation += level.variation;
  }
  p.reached = reached_;
  const double width = kBothSides * std::sqrt(std::log1p(p.variation * p.variation));
  p.low = p.value * std::exp(-width);
  p.high = std::min(1.0, p.value * std::exp(width));
  // None above the last level: three of so many might have been, as of independent runs.
  if (!reached_) p.low = 0.0, p.high = std::min(1.0, before * std::exp(width) * 3.7 / static_cast<double>(chains_));
  return p;
}

}  // namespace footfall
