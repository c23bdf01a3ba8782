#pragma once
// Power laws y = A x_1^p_1 x_2^p_2 ... by least squares on logarithms, with confidence intervals, through all finished runs
// of a sweep, next to published exponents.
//
//   log y_i = log A + sum_k p_k log x_ik + e_i,   e_i independent, normal, of one variance
//
// With n values and m exponents the residuals have n - m - 1 degrees of freedom; coefficient c_k of standard error s_k
// lies in c_k +- t s_k with 95 % confidence, t the quantile of Student's distribution.

#include <Eigen/Core>
#include <string>
#include <utility>
#include <vector>

#include "mbd_solver/studies/results.h"

namespace footfall {

struct PowerLaw {
  double factor = 0.0;                        // A
  std::pair<double, double> factor_interval;  // 95 %
  Eigen::VectorXd exponents, errors;          // p_k and their standard errors
  Eigen::VectorXd lower, upper;               // 95 % interval of p_k
  int degrees_of_freedom = 0;                 // n - m - 1
  double r_squared = 0.0;                     // share of the variance of log y that the law explains
  double scatter = 0.0;  // standard deviation of log y about the law: about the relative scatter of y

  double at(const Eigen::VectorXd& x) const;
};

// x: a row per value, a column per quantity; all positive. Throws InputError for too few rows, or columns that do not vary
// independently.
PowerLaw fit_power_law(const Eigen::MatrixXd& x, const Eigen::VectorXd& y);

// With given exponents: only A is fitted (n - 1 degrees of freedom). r_squared is negative if worse than a constant.
PowerLaw fit_factor(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, const Eigen::VectorXd& exponents);

// Two-sided quantile of Student's distribution: |t| exceeds it with probability 1 - confidence. degrees >= 1.
double student_t(double confidence, int degrees);

struct FitData {
  std::vector<std::size_t> runs;  // finished ones
  Eigen::MatrixXd x;              // one row per run, one column per factor
  Eigen::VectorXd y;              // the metric
};
// Throws InputError when a run has a number that is not positive.
FitData fit_data(const SweepSpec& spec, const FitSpec& fit, const Plan& plan, const std::vector<RunResult>& results);

// Prints every fit and writes fits.csv, fits.md, and NAME.png and NAME.svg (measured over fitted, logarithmic) into
// `folder`; returns the files. Nothing without fits.
std::vector<std::string> write_fits(const SweepSpec& spec, const Plan& plan, const std::vector<RunResult>& results,
                                    const std::string& folder);

}  // namespace footfall
