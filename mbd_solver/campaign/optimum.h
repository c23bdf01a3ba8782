#pragma once
// Minima and least squares of OpenTURNS, whose numbers are std::vector; only optimum.cpp includes it. Exceptions of the
// functions that are minimized leave the search.

#include <functional>
#include <vector>

namespace footfall {

struct OptimumTask {
  std::vector<double> start, least, most;  // the first point, and the bounds
  double step = 0.15;                      // first step of a local search; of central differences, within the bounds
  double precision = 1e-4;                 // ends the search: change of all numbers; of least squares relative
  int evaluations = 10000;                 // at most
};

// The best point that was tried by a method of NLopt without derivatives: GN_DIRECT_L, LN_SBPLX. Throws InputError when NLopt
// refuses.
std::vector<double> minimum(const char* method, const OptimumTask& task,
                            const std::function<double(const std::vector<double>&)>& value);

// The minimum of |r|^2 by the method of Levenberg and Marquardt (as in MINPACK, by Eigen), with derivatives by
// central differences whose points are requested together. Points without residuals (empty) count as very bad.
using Residuals = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>& points)>;
std::vector<double> least_squares(const OptimumTask& task, const Residuals& residuals);

}  // namespace footfall
