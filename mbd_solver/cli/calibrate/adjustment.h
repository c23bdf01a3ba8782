#pragma once
// Whole runs differ from the cheap ones of a search: some targets are lost, some are won. The set next to one that was
// run whole which should meet more, to first order:
//
//   y_t(u) = y_t of the whole runs at u0 + S_t . (u - u0),   least  Phi(y(u)) + |u - u0|^2 / h^2,   |u_i - u0_i| <= h
//
// S: derivatives from the search's differences, and h their step: further away they say nothing. Bounds count from kInsideBounds tolerances within, because a set on a bound is
// as likely to be out as in. Curves have no part in it.

#include "mbd_solver/cli/calibrate/determination.h"

namespace footfall {

constexpr double kInsideBounds = 0.5;  // [tolerances]

// `sensitivity`: of Determination. Equal to the set of `whole` when no step is worth it.
Shares adjusted(const CalibrationSpec& spec, const Evaluation& whole, const Eigen::MatrixXd& sensitivity);

}  // namespace footfall
