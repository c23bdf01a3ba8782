#pragma once
// What OpenTURNS does for a campaign: designs, distributions, quantiles, sensitivities. Only sampling.cpp includes it.

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

#include "mbd_solver/studies/sweep_file.h"

namespace footfall {

// The drawn values of all runs. A run has the same values in every case.
class Draws {
 public:
  // Throws InputError when the correlations contradict each other.
  explicit Draws(const SweepSpec& spec);

  std::size_t count() const { return values_.size(); }                                 // runs of a case
  const std::vector<std::size_t>& parameters() const { return parameters_; }           // of SweepSpec::parameters
  const std::vector<double>& values(std::size_t run) const { return values_[run]; }    // ten digits; discrete: place
  const std::vector<double>& positions(std::size_t run) const { return units_[run]; }  // quantiles, 0 to 1
  std::uint32_t seed(std::size_t run) const;  // of the run, below 2^31; different in every run
  bool independent() const { return independent_; }

 private:
  std::vector<std::size_t> parameters_;
  std::vector<std::vector<double>> values_, units_;
  std::uint32_t base_;
  bool independent_ = true;
};

// Seed number `place` of those that begin at `base`: a permutation of the numbers below 2^31.
std::uint32_t scattered(std::uint32_t base, std::uint32_t place);

// Places (from 0) of the sorted values that bound the quantile `share` with 95 % confidence, whatever the distribution;
// -1 or `count`: there is no bound.
std::pair<long, long> quantile_bounds(std::size_t count, double share);

// Sobol' indices by polynomial chaos: share of the variance by each input alone, and with its interactions.
struct Sensitivity {
  std::vector<double> first, total;
  double explained = 0.0;  // of the variance of a quarter of the runs that was held back (Q2); poor below 0.8
};
// x: of each run the independent inputs, uniform in 0 to 1.
Sensitivity sobol_indices(const std::vector<std::vector<double>>& x, const std::vector<double>& y);
// Spearman's coefficient of each input with y.
std::vector<double> rank_correlations(const std::vector<std::vector<double>>& x, const std::vector<double>& y);

}  // namespace footfall
