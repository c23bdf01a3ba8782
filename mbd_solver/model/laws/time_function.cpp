// Each kind of function is a small class in this file; the factories below choose one.

#include "mbd_solver/model/laws/time_function.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/laws/curves.h"

namespace footfall {
namespace {

constexpr double kTwoPi = 2.0 * kPi;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

Corner first_after(const std::vector<double>& times, double t) {
  const auto next = std::upper_bound(times.begin(), times.end(), t);
  return next == times.end() ? Corner() : Corner(*next);
}
// The first corner of a function whose first derivative jumps at these times.
Corner first_from(const std::vector<double>& times, double t) {
  const auto next = std::lower_bound(times.begin(), times.end(), t);
  return next == times.end() ? Corner() : Corner(*next, std::nextafter(*next, kInfinity));
}

class Polynomial : public TimeFunction {
 public:
  explicit Polynomial(std::vector<double> c) : c_(std::move(c)) {}
  TimeValue at(double t) const override {
    TimeValue f;
    for (std::size_t k = c_.size(); k-- > 0;) {  // Horner, with both derivatives
      f.accel = f.accel * t + 2.0 * f.rate;
      f.rate = f.rate * t + f.value;
      f.value = f.value * t + c_[k];
    }
    return f;
  }

 private:
  std::vector<double> c_;
};

class Ramp : public TimeFunction {
 public:
  Ramp(double from, double to, double t0, double duration) : from_(from), to_(to), t0_(t0), duration_(duration) {}
  TimeValue at(double t) const override {
    const double s = std::clamp((t - t0_) / duration_, 0.0, 1.0);
    const double height = to_ - from_;
    return {from_ + height * s * s * s * (10.0 + s * (6.0 * s - 15.0)),
            height * 30.0 * s * s * (1.0 - s) * (1.0 - s) / duration_,
            height * 60.0 * s * (1.0 - s) * (1.0 - 2.0 * s) / (duration_ * duration_)};
  }
  Corner next_corner(double t) const override { return first_after({t0_, t0_ + duration_}, t); }

 private:
  double from_, to_, t0_, duration_;
};

class Sine : public TimeFunction {
 public:
  Sine(double amplitude, double frequency, double phase, double mean)
      : amplitude_(amplitude), omega_(kTwoPi * frequency), phase_(phase), mean_(mean) {}
  TimeValue at(double t) const override {
    const double s = amplitude_ * std::sin(omega_ * t + phase_);
    const double c = amplitude_ * std::cos(omega_ * t + phase_);
    return {mean_ + s, omega_ * c, -omega_ * omega_ * s};
  }

 private:
  double amplitude_, omega_, phase_, mean_;
};

class SplineTable : public TimeFunction {
 public:
  SplineTable(std::vector<double> times, std::vector<double> values)
      : times_(times), spline_("a table over time", std::move(times), std::move(values)) {}
  TimeValue at(double t) const override {
    const CubicSpline::Value f = spline_.at(t);
    return {f.value, f.slope, f.curvature};
  }
  Corner next_corner(double t) const override { return first_after(times_, t); }

 private:
  std::vector<double> times_;
  CubicSpline spline_;
};

// accel is reported as 0: the acceleration of a monotone curve jumps at its points.
class MonotoneTable : public TimeFunction {
 public:
  MonotoneTable(std::vector<double> times, std::vector<double> values)
      : times_(times), curve_("a table over time", std::move(times), std::move(values)) {}
  TimeValue at(double t) const override { return {curve_.value(t), curve_.slope(t), 0.0}; }
  // The rate of a table that moves jumps at its ends, where it is held; at() has the rate of the inside there.
  Corner next_corner(double t) const override {
    const double first = times_.front();
    return t < first ? Corner(std::nextafter(first, -kInfinity), first) : first_from(times_, t);
  }

 private:
  std::vector<double> times_;
  MonotoneCurve curve_;
};

class LineTable : public TimeFunction {
 public:
  LineTable(std::vector<double> times, std::vector<double> values)
      : times_(std::move(times)), values_(std::move(values)) {
    if (times_.size() < 2 || times_.size() != values_.size() ||
        std::adjacent_find(times_.begin(), times_.end(), std::greater_equal<>()) != times_.end())
      throw InputError(code::kCurveNotRising,
                       "a table over time: expected at least two rising times, and as many values.");
    corners_ = corners_of_lines(times_, values_);
  }
  TimeValue at(double t) const override {
    if (t < times_.front()) return {values_.front(), 0.0, 0.0};
    if (t >= times_.back()) return {values_.back(), 0.0, 0.0};
    const auto above = std::upper_bound(times_.begin(), times_.end(), t);
    const std::size_t i = static_cast<std::size_t>(above - times_.begin()) - 1;
    const double slope = (values_[i + 1] - values_[i]) / (times_[i + 1] - times_[i]);
    return {values_[i] + slope * (t - times_[i]), slope, 0.0};
  }
  Corner next_corner(double t) const override { return first_from(corners_, t); }

 private:
  std::vector<double> times_, values_, corners_;
};

class Sum : public TimeFunction {
 public:
  explicit Sum(std::vector<TimeFunctionPtr> terms) : terms_(std::move(terms)) {}
  TimeValue at(double t) const override {
    TimeValue total;
    for (const TimeFunctionPtr& term : terms_) {
      const TimeValue f = term->at(t);
      total.value += f.value;
      total.rate += f.rate;
      total.accel += f.accel;
    }
    return total;
  }
  Corner next_corner(double t) const override {
    Corner next;
    for (const TimeFunctionPtr& term : terms_) next = std::min(next, term->next_corner(t));
    return next;
  }

 private:
  std::vector<TimeFunctionPtr> terms_;
};

}  // namespace

TimeFunctionPtr polynomial(std::vector<double> coefficients) {
  return std::make_shared<Polynomial>(std::move(coefficients));
}

TimeFunctionPtr ramp(double from, double to, double t0, double duration) {
  if (!(duration > 0.0)) throw InputError(code::kParametersDisagree, "the duration of a ramp must be positive.");
  return std::make_shared<Ramp>(from, to, t0, duration);
}

TimeFunctionPtr sine(double amplitude, double frequency, double phase, double mean) {
  return std::make_shared<Sine>(amplitude, frequency, phase, mean);
}

TimeFunctionPtr table(std::vector<double> times, std::vector<double> values, TableShape shape) {
  switch (shape) {
    case TableShape::kSpline: return std::make_shared<SplineTable>(std::move(times), std::move(values));
    case TableShape::kMonotone: return std::make_shared<MonotoneTable>(std::move(times), std::move(values));
    case TableShape::kLines: return std::make_shared<LineTable>(std::move(times), std::move(values));
  }
  FOOTFALL_DEMAND(false);
}

TimeFunctionPtr sum(std::vector<TimeFunctionPtr> terms) { return std::make_shared<Sum>(std::move(terms)); }

}  // namespace footfall
