#pragma once
// Functions of time, for prescribed motions, forces and commands of drives, with two derivatives.

#include <memory>
#include <vector>

namespace footfall {

struct TimeValue {
  double value = 0.0;  // [m or rad]
  double rate = 0.0;   // [1/s]
  double accel = 0.0;  // [1/s2]
};

class TimeFunction {
 public:
  virtual ~TimeFunction() = default;
  virtual TimeValue at(double t) const = 0;
};
using TimeFunctionPtr = std::shared_ptr<const TimeFunction>;

// sum_k c_k t^k; {c0} is a constant, {c0, v} constant velocity.
TimeFunctionPtr polynomial(std::vector<double> coefficients);
// From `from` to `to` between t0 and t0 + duration along a fifth-order smooth step (continuous acceleration),
// constant outside.
TimeFunctionPtr ramp(double from, double to, double t0, double duration);
// mean + amplitude sin(2 pi frequency t + phase), frequency [Hz], phase [rad].
TimeFunctionPtr sine(double amplitude, double frequency, double phase = 0.0, double mean = 0.0);
// How a table (t_i, f_i) is filled: as smooth as what uses it asks for, and no smoother, because a spline leaves the
// range of its points.
//   kSpline   natural cubic spline, beyond its ends their tangents: motions, which need two derivatives
//   kMonotone cubic pieces that stay between the points (monotone_curve.h), constant outside: one derivative
//   kLines    straight lines, constant outside: the value alone
enum class TableShape { kSpline, kMonotone, kLines };
// At least two points, t rising.
TimeFunctionPtr table(std::vector<double> times, std::vector<double> values, TableShape shape);

// Sum of several; an empty sum is zero.
TimeFunctionPtr sum(std::vector<TimeFunctionPtr> terms);

}  // namespace footfall
