#pragma once
// OpenTURNS for campaigns and calibrations: designs, distributions, quantiles, sensitivities, response surfaces.
// sampling.cpp includes it, and optimum.cpp for minima.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/campaign/statistics.h"
#include "mbd_solver/studies/sweep_file.h"

namespace footfall {

// The drawn values of all runs. A run has the same values in every case.
class Draws {
 public:
  // `points`: of the unit cube, before correlations, instead of the design. Throws InputError when the correlations
  // contradict each other.
  explicit Draws(const SweepSpec& spec, const std::vector<std::vector<double>>* points = nullptr);

  std::size_t count() const { return values_.size(); }                                 // runs of a case
  const std::vector<std::size_t>& parameters() const { return parameters_; }           // of SweepSpec::parameters
  const std::vector<double>& values(std::size_t run) const { return values_[run]; }    // of a discrete one its place
  const std::vector<double>& positions(std::size_t run) const { return units_[run]; }  // quantiles, 0 to 1
  std::uint32_t seed(std::size_t run) const;  // of the run, below 2^31; different in every run
  bool independent() const { return independent_; }
  Moments moments(std::size_t place) const { return moments_[place]; }  // of the distribution of a parameter

 private:
  void draw_whole_rows(const SweepSpec& spec);

  std::vector<std::size_t> parameters_;
  std::vector<std::vector<double>> values_, units_;
  std::vector<Moments> moments_;
  std::uint32_t base_;
  bool independent_ = true;
};

std::string openturns_version();

// Seed number `place` of those that begin at `base`: a permutation of the numbers below 2^31.
std::uint32_t scattered(std::uint32_t base, std::uint32_t place);

// Places (from 0) of the sorted values that bound the quantile `share` with 95 % confidence, whatever the distribution;
// -1 or `count`: there is no bound.
std::pair<long, long> quantile_bounds(std::size_t count, double share);

// Tolerance limits [Wilks 1941]: place (from 0) of the sorted values below which, with 95 % confidence, at least `share` of
// the distribution is; `count`: too few values. Counted from the largest value it is the limit above which that share is.
std::size_t tolerance_place(std::size_t count, double share);

// Sobol' indices by polynomial chaos: share of the variance by each input alone, and with its interactions.
struct Sensitivity {
  std::vector<double> first, total;
  // Their 95 % intervals: the scatter of the coefficients, plus the variance that the polynomial does not explain, or
  // explains only in its own runs, because it may belong to any input.
  std::vector<std::pair<double, double>> first_interval, total_interval;
  double explained = 0.0;  // of the variance of a quarter of the runs that was held back (Q2); poor below 0.8
};
// x: of each run the independent inputs, uniform in 0 to 1.
Sensitivity sobol_indices(const std::vector<std::vector<double>>& x, const std::vector<double>& y);
// A smooth function of scattered, noisy numbers at points of the unit cube: Kriging with a plane (a constant where points are
// too few) and the Matern covariance of nu = 5/2, with that length and noise, of a few, whose likelihood is largest. Of
// fewer than three points their mean.
using Surface = std::function<std::vector<double>(const std::vector<std::vector<double>>& points)>;
Surface response_surface(const std::vector<std::vector<double>>& x, const std::vector<double>& y);
// Points of the unit cube, each number in another one of `count` equal parts.
std::vector<std::vector<double>> latin_hypercube(std::size_t count, std::size_t width, std::uint64_t seed);
// q with P(|t| > q) = 1 - confidence, of Student's distribution; degrees 0: of the normal distribution.
double two_sided_quantile(double confidence, int degrees);
// x with P(X <= x) = share, of the beta distribution with these exponents (counted from 1 for the uniform one).
double beta_quantile(double a, double b, double share);
// Spearman's coefficient of each input with y.
std::vector<double> rank_correlations(const std::vector<std::vector<double>>& x, const std::vector<double>& y);

}  // namespace footfall
