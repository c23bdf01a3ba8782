#pragma once
// The stage "gauss_newton": least squares, which NLopt does not have. From a set u with residuals r, and derivatives J
// by central differences of `step` (their sets are run side by side),
//
//   (J^T J + lambda I) d = -J^T r,   u + d cut at the ranges
//
// [Levenberg, Marquardt]. A better set is taken, and lambda falls to a tenth; else it grows ten times. Ends when d is
// within the stage's precision, or lambda is at its end. A search begun anew goes the same way, as walk() does.

#include "mbd_solver/cli/calibrate/search.h"

namespace footfall {

struct LeastSquaresQuestions {
  std::function<std::optional<std::vector<double>>(const Shares&)> residuals;  // none: not known yet; empty: failed
  std::function<bool(const Shares&)> may_go_on;
};

StageWay walk_least_squares(const StageSpec& stage, const Shares& start, double step,
                            const LeastSquaresQuestions& questions);

}  // namespace footfall
