#include "mbd_solver/model/laws/time_function.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"

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

class Spline : public TimeFunction {
 public:
  Spline(std::vector<double> times, std::vector<double> values)
      : t_(std::move(times)), f_(std::move(values)), m_(t_.size(), 0.0) {
    if (t_.size() < 2 || t_.size() != f_.size())
      throw InputError("a table over time needs at least two points, and as many values as times.");
    for (std::size_t i = 1; i < t_.size(); ++i) {
      if (!(t_[i] > t_[i - 1]))
        throw InputError("the times of a table must rise: " + std::to_string(t_[i]) + " s follows " +
                         std::to_string(t_[i - 1]) + " s.");
    }
    // Second derivatives m of the natural spline: tridiagonal system, Thomas' algorithm.
    const std::size_t n = t_.size();
    std::vector<double> upper(n, 0.0);
    for (std::size_t i = 1; i + 1 < n; ++i) {
      const double left = t_[i] - t_[i - 1], right = t_[i + 1] - t_[i];
      const double rhs = 6.0 * ((f_[i + 1] - f_[i]) / right - (f_[i] - f_[i - 1]) / left);
      const double pivot = 2.0 * (left + right) - left * upper[i - 1];
      upper[i] = right / pivot;
      m_[i] = (rhs - left * m_[i - 1]) / pivot;
    }
    for (std::size_t i = n - 1; i-- > 1;) m_[i] -= upper[i] * m_[i + 1];
  }
  TimeValue at(double t) const override {
    if (t <= t_.front()) return tangent(inside(0, t_.front()), t - t_.front());
    if (t >= t_.back()) return tangent(inside(t_.size() - 2, t_.back()), t - t_.back());
    const auto next = std::upper_bound(t_.begin(), t_.end(), t);
    return inside(static_cast<std::size_t>(next - t_.begin()) - 1, t);
  }

 private:
  static TimeValue tangent(const TimeValue& end, double dt) { return {end.value + end.rate * dt, end.rate, 0.0}; }
  TimeValue inside(std::size_t i, double t) const {
    const double h = t_[i + 1] - t_[i];
    const double b = (t - t_[i]) / h, a = 1.0 - b;
    return {a * f_[i] + b * f_[i + 1] + ((a * a * a - a) * m_[i] + (b * b * b - b) * m_[i + 1]) * h * h / 6.0,
            (f_[i + 1] - f_[i]) / h + ((1.0 - 3.0 * a * a) * m_[i] + (3.0 * b * b - 1.0) * m_[i + 1]) * h / 6.0,
            a * m_[i] + b * m_[i + 1]};
  }

  std::vector<double> t_, f_, m_;
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
  return std::make_shared<Spline>(std::move(times), std::move(values));
}

TimeFunctionPtr sum(std::vector<TimeFunctionPtr> terms) { return std::make_shared<Sum>(std::move(terms)); }

}  // namespace footfall
