#include "mbd_solver/model/laws/time_function.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/model/laws/cubic_spline.h"

namespace footfall {
namespace {

constexpr double kTwoPi = 6.283185307179586;

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

class Table : public TimeFunction {
 public:
  Table(std::vector<double> times, std::vector<double> values)
      : spline_("a table over time", std::move(times), std::move(values)) {}
  TimeValue at(double t) const override {
    const CubicSpline::Value f = spline_.at(t);
    return {f.value, f.slope, f.curvature};
  }

 private:
  CubicSpline spline_;
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

 private:
  std::vector<TimeFunctionPtr> terms_;
};

}  // namespace

TimeFunctionPtr polynomial(std::vector<double> coefficients) {
  return std::make_shared<Polynomial>(std::move(coefficients));
}

TimeFunctionPtr ramp(double from, double to, double t0, double duration) {
  if (!(duration > 0.0)) throw InputError("the duration of a ramp must be positive.");
  return std::make_shared<Ramp>(from, to, t0, duration);
}

TimeFunctionPtr sine(double amplitude, double frequency, double phase, double mean) {
  return std::make_shared<Sine>(amplitude, frequency, phase, mean);
}

TimeFunctionPtr table(std::vector<double> times, std::vector<double> values) {
  return std::make_shared<Table>(std::move(times), std::move(values));
}

TimeFunctionPtr sum(std::vector<TimeFunctionPtr> terms) { return std::make_shared<Sum>(std::move(terms)); }

}  // namespace footfall
