#pragma once
// Minima and least squares of OpenTURNS, whose numbers are std::vector; only optimum.cpp includes it. Exceptions of the
// functions that are minimized leave the search.

#include <functional>
#include <vector>

namespace footfall {

struct Bounds {
  std::vector<double> least, most;
};

struct MinimumTask {
  const char* method;  // of NLopt, without derivatives: GN_DIRECT_L, LN_SBPLX
  std::vector<double> start;
  Bounds bounds;
  double precision = 1e-4;   // ends the search: change of all numbers
  double first_step = 0.15;  // of a local search
  int most = 10000;          // evaluations
};

// The best point that was tried. Throws InputError when NLopt refuses.
std::vector<double> minimum(const MinimumTask& task, const std::function<double(const std::vector<double>&)>& value);

struct LeastSquaresTask {
  std::vector<double> start;
  Bounds bounds;
  double step = 0.01;       // of central differences, within the bounds
  double precision = 1e-4;  // ends the search: relative change of all numbers
  int most = 10000;         // evaluations
};
using Residuals = std::function<std::vector<std::vector<double>>(const std::vector<std::vector<double>>& points)>;

// The minimum of |r|^2 by the method of Levenberg and Marquardt (MINPACK), with derivatives by central differences whose
// points are asked for together. Points without residuals (empty) count as very bad ones.
std::vector<double> least_squares(const LeastSquaresTask& task, const Residuals& residuals);

}  // namespace footfall
