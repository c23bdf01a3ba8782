#pragma once
// Functions of time with two derivatives, for prescribed motions, forces and commands of drives.

#include <limits>
#include <memory>
#include <vector>

namespace footfall {

struct TimeValue {
  double value = 0.0;  // [m or rad]
  double rate = 0.0;   // [1/s]
  double accel = 0.0;  // [1/s2]
};

// A time at which a value or derivative of a function jumps; steps of the integrator end there. Where that is the value or its
// first derivative, `before` and `after` are neighbouring numbers, one on either side; else they are equal.
struct Corner {
  Corner() = default;
  explicit Corner(double time) : before(time), after(time) {}
  Corner(double last_before, double first_after) : before(last_before), after(first_after) {}
  double before = std::numeric_limits<double>::infinity(), after = before;  // [s]
};
inline bool operator<(const Corner& a, const Corner& b) { return a.before < b.before; }

class TimeFunction {
 public:
  virtual ~TimeFunction() = default;
  virtual TimeValue at(double t) const = 0;
  // The first corner after t; at infinity: none.
  virtual Corner next_corner(double) const { return {}; }
};
using TimeFunctionPtr = std::shared_ptr<const TimeFunction>;

// sum_k c_k t^k; {c0} is a constant, {c0, v} constant velocity.
TimeFunctionPtr polynomial(std::vector<double> coefficients);
// From `from` to `to` between t0 and t0 + duration along a fifth-order step with continuous acceleration; constant
// outside. Throws InputError unless duration > 0.
TimeFunctionPtr ramp(double from, double to, double t0, double duration);
// mean + amplitude sin(2 pi frequency t + phase), frequency [Hz], phase [rad].
TimeFunctionPtr sine(double amplitude, double frequency, double phase = 0.0, double mean = 0.0);
// Interpolation of a table (t_i, f_i): only as smooth as its use requires, because a spline leaves the range of its
// points.
//   kSpline   natural cubic spline, continued by its tangents: motions, which require two derivatives
//   kMonotone MonotoneCurve, constant outside: one derivative
//   kLines    straight lines, constant outside: the value alone
enum class TableShape { kSpline, kMonotone, kLines };
// At least two points, t rising; else InputError.
TimeFunctionPtr table(std::vector<double> times, std::vector<double> values, TableShape shape);

// Sum of several; an empty sum is zero.
TimeFunctionPtr sum(std::vector<TimeFunctionPtr> terms);

}  // namespace footfall
