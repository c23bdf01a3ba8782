#pragma once
// Probabilities with intervals: of counts, of boundaries between outcomes, and of two levels of models.

#include <Eigen/Core>
#include <cstdint>
#include <vector>

namespace footfall {

// Sample quantile: `share` of the values are below it; the mean of two values where the share ends between them, as the
// median of an even number. 0 if empty.
double quantile(std::vector<double> values, double share);

// A probability with its 95 % interval.
struct Probability {
  double value = 0.0, low = 0.0, high = 1.0;
  double width() const { return high - low; }
};
// The interval for independent trials; they may be an effective, fractional number. Clopper and Pearson 1934: the bounds
// p with P(X >= hits | low) = P(X <= hits | high) = 0.025, which hold in at least 95 % of all campaigns whatever p is.
Probability clopper_pearson(double hits, double trials);

// With 95 % confidence the probability is at most this: P(X <= hits | bound) = 0.05.
double upper_bound(double hits, double trials);
// The fewest runs, with this many hits among them, whose upper bound is at most p; and the most hits that this many runs may
// have, -1: too few runs. p: 0 to 1 without the ends.
long runs_for(double p, long hits);
long hits_allowed(double p, long runs);

inline constexpr double kToleranceShare = 0.95;  // share of the runs within a tolerance limit

// How often an outcome happened in independent runs, some of them unknown.
struct Tally {
  long hits = 0, misses = 0, unknown = 0;

  void add(int outcome);  // 1, 0, or -1: unknown
  long runs() const { return hits + misses + unknown; }
  // Shares of the runs if it happened in none, and in all, of the unknown runs; 0 and 1 without runs.
  double least() const;
  double most() const;
  // From the lower bound of `least` to the upper bound of `most`; value: the share of the known runs.
  Probability probability() const;
};

// The interval of a share of the known runs, extended to all runs: `unknown` more may have any outcome.
Probability with_unknown(const Probability& p, long known, long unknown);

// The same runs of two cases: where the outcome happened.
struct PairTally {
  long both = 0, first_only = 0, second_only = 0, neither = 0, unknown = 0;

  void add(int first, int second);  // 1, 0, or -1: unknown
  long runs() const { return both + first_only + second_only + neither + unknown; }
  // Probability of the second case minus probability of the first: (c - b) / n, with the interval of Bonett and Price
  // (J. Educ. Behav. Stat. 37, 2012): the normal interval with one more run in either of b and c. Unknown pairs count
  // as c, and as b.
  Probability difference() const;
  // McNemar's exact test, over the known pairs: the chance of counts as unlike as b and c if both were alike.
  double chance() const;
};

// P(y = 1 | x) = 1 / (1 + exp(-x b)), by Firth's penalized likelihood (Biometrika 80, 1993), which is finite where a plane
// separates the outcomes.
struct Logistic {
  Eigen::VectorXd b;
  Eigen::MatrixXd covariance;  // of b

  double score(const Eigen::VectorXd& x) const { return x.dot(b); }
  double deviation(const Eigen::VectorXd& x) const;  // of the score
  double probability(const Eigen::VectorXd& x) const;
};
// A row of x for each y, which is 0 or 1; the first column of x is 1.
Logistic fit_logistic(const Eigen::MatrixXd& x, const Eigen::VectorXd& y);

// Moments of the distribution of an input.
struct Moments {
  double mean = 0.0, deviation = 1.0;
};
// Sensitivity of the mean of y to means and deviations of independent inputs. Among all densities with another mean (or
// deviation) of one input, and the same deviation (or mean), the one nearest to the present one by Kullback-Leibler is used
// [Lemaitre and others, J. Stat. Comput. Simul. 85, 2015]. For a small change the derivatives are coefficients of the linear
// regression of y over z_k and z_k^2, z_k = (x_k - mean) / deviation: dE/dmean = b_k / deviation, dE/dlog(deviation) = 2 c_k.
// No runs are added; intervals of 95 % by the covariance of White (HC3), for 40 events or more.
struct MomentSlopes {
  std::vector<Probability> of_mean;       // of a shift by one deviation
  std::vector<Probability> of_deviation;  // of the logarithm of the deviation
};
// A row of x per run, a column per input. Empty where runs are fewer than five times the coefficients, or an input has fewer
// than three values.
MomentSlopes moment_slopes(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, const std::vector<Moments>& moments);

// Runs that are repeated with a better model, by random groups (Rao, Hartley, Cochran, J. R. Stat. Soc. B 24, 1962): the
// runs are dealt into as many groups, and one of each is drawn with a probability in proportion to its weight.
struct GroupDraw {
  std::size_t run = 0;   // its place
  double factor = 0.0;   // of its correction: weight of the group over weight of the run, over all runs
  double group = 0.0;    // share of the weights of its group
  double members = 0.0;  // of its group
};
std::vector<GroupDraw> draw_by_groups(const std::vector<double>& weights, int count, std::uint64_t seed);

struct TwoLevels {
  Probability cheap, corrected;  // by the model of all runs; with the correction
  double correction = 0.0;
  int missed = 0, false_alarms = 0;  // checked runs: outcome in the better model only; in the cheap model only
};
// cheap: 0 or 1 for every run; better: likewise for every checked run, or -1 where it is unknown. The interval holds in 95 %
// of campaigns wherever the two models differ if every weight is at least BetterModelSpec::kFar of their mean.
TwoLevels two_levels(const std::vector<int>& cheap, const std::vector<GroupDraw>& checked,
                     const std::vector<int>& better);

}  // namespace footfall
