// Spectra and filters against closed forms, to 1 %.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/output/spectra.h"
#include "tests/support/refused.h"

namespace footfall {
namespace {

constexpr double kStep = 1e-4;  // [s]

std::vector<double> sampled(double duration, const std::function<double(double)>& f) {
  std::vector<double> x;
  for (long k = 0; k <= std::lround(duration / kStep); ++k) x.push_back(f(static_cast<double>(k) * kStep));
  return x;
}

// x = A sin(pi t / T), 0 < t < T, on an oscillator without damping, r = f 2T its frequency over the half-sine's:
//   during the pulse  y = A r / (r^2 - 1) (r sin p - sin r p), p = pi t / T, largest for r > 1 where cos p = cos r p
//   after it          |y| = 2 A r / |r^2 - 1| |cos(pi r / 2)|, r < 1
double half_sine_response(double r) {
  if (r < 1.0) return 2.0 * r / (1.0 - r * r) * std::cos(kPi * r / 2.0);
  double largest = 0.0;  // p = 2 pi n / (r + 1) within the pulse, and the residual
  for (int n = 1; 2.0 * n < r + 1.0; ++n) {
    const double p = 2.0 * kPi * n / (r + 1.0);
    largest = std::max(largest, std::abs(r / (r * r - 1.0) * (r * std::sin(p) - std::sin(r * p))));
  }
  return std::max(largest, 2.0 * r / (r * r - 1.0) * std::abs(std::cos(kPi * r / 2.0)));
}

TEST(ShockResponse, OfAHalfSineIsThatOfTheClosedForm) {
  const double T = 0.011, A = 300.0;  // [s], [m/s2]
  const std::vector<double> x = sampled(0.3, [&](double t) { return t < T ? A * std::sin(kPi * t / T) : 0.0; });
  for (const double r : {0.2, 0.5, 0.9, 1.3, 1.6, 2.5, 4.0, 8.0, 15.0}) {
    const double f = r / (2.0 * T);
    const double found = shock_response(x, kStep, 1e6, {f}).value.front() / A;
    EXPECT_NEAR(found, half_sine_response(r), 0.01 * half_sine_response(r)) << "r = " << r;
  }
}

// A step of the base, with damping: 1 + exp(-pi zeta / sqrt(1 - zeta^2)) for the absolute response.
TEST(ShockResponse, FollowsAStepWithItsDamping) {
  const double zeta = 0.05;  // Q = 10
  const std::vector<double> x = sampled(0.2, [](double t) { return t > 0.01 ? 2.0 : 0.0; });
  // Of the transfer function (2 zeta w s + w^2) / (s^2 + 2 zeta w s + w^2): the largest value over a fine grid of time.
  double expected = 0.0;
  const double root = std::sqrt(1.0 - zeta * zeta);
  for (double p = 0.0; p < 20.0; p += 1e-3)
    expected = std::max(expected, 1.0 - std::exp(-zeta * p) * (std::cos(root * p) - zeta / root * std::sin(root * p)));
  EXPECT_NEAR(shock_response(x, kStep, 10.0, {20.0}).value.front(), 2.0 * expected, 0.01 * 2.0 * expected);
}

// A record that begins away from zero begins at rest there.
TEST(ShockResponse, OfAConstantIsTheConstant) {
  const std::vector<double> x(1000, -1.62);
  for (const double value : shock_response(x, kStep, 10.0, shock_frequencies(kStep, x.size())).value)
    EXPECT_NEAR(value, 1.62, 1e-12);
}

// A chirp of amplitude A from f0 to f1 has its power A^2 / 2 evenly between them.
TEST(PowerDensity, OfAChirpIsEvenBetweenItsFrequencies) {
  const double A = 3.0, f0 = 500.0, f1 = 1500.0, T = 4.0;
  const std::vector<double> x =
      sampled(T, [&](double t) { return A * std::sin(2.0 * kPi * (f0 * t + 0.5 * (f1 - f0) / T * t * t)); });
  for (const std::size_t window : {std::size_t{400}, std::size_t{1000}, default_window(x.size())}) {
    const Spectrum spectrum = power_density(x, kStep, window);
    const double line = spectrum.frequency[1];
    double power = 0.0, middle = 0.0;
    int lines = 0;
    for (std::size_t k = 0; k < spectrum.value.size(); ++k) {
      power += spectrum.value[k] * line;
      if (spectrum.frequency[k] < 800.0 || spectrum.frequency[k] > 1200.0) continue;
      middle += spectrum.value[k];
      ++lines;
    }
    EXPECT_NEAR(power, 0.5 * A * A, 0.01 * 0.5 * A * A) << window;
    const double density = 0.5 * A * A / (f1 - f0);
    EXPECT_NEAR(middle / lines, density, 0.01 * density) << window;
  }
}

TEST(PowerDensity, OfASineIsItsPower) {
  const std::vector<double> x = sampled(1.0, [](double t) { return 7.0 + 2.0 * std::sin(2.0 * kPi * 400.0 * t); });
  double power = 0.0;
  const Spectrum spectrum = power_density(x, kStep, default_window(x.size()));
  for (const double value : spectrum.value) power += value * spectrum.frequency[1];
  EXPECT_NEAR(power, 2.0, 0.02);
}

// Two passes of a Butterworth filter of second order whose corner is bent by the sampling:
// gain 1 / (1 + (tan(pi f dt) / tan(pi 2.0775 CFC dt))^4), without a shift.
TEST(ClassFilter, HasTheGainOfItsClassAndNoShift) {
  for (const int channel_class : {60, 180, 600, 1000}) {
    for (const double share : {0.2, 1.0, 2.0775, 3.0}) {
      const double f = share * channel_class;
      const auto wave = [&](double t) { return std::sin(2.0 * kPi * f * t); };
      const std::vector<double> y = class_filtered(sampled(1.0, wave), kStep, channel_class);
      const double ratio = std::tan(kPi * f * kStep) / std::tan(kPi * 2.0775 * channel_class * kStep);
      const double gain = 1.0 / (1.0 + std::pow(ratio, 4));
      for (std::size_t k = 4000; k < 6000; k += 37)
        EXPECT_NEAR(y[k], gain * wave(static_cast<double>(k) * kStep), 0.01 * gain) << channel_class << " " << f;
    }
  }
  // SAE J211: about -3 dB at 5/3 of the class.
  EXPECT_NEAR(class_filtered(std::vector<double>(100, 4.0), kStep, 60).front(), 4.0, 1e-9);
}

History with_rows(const std::vector<double>& time) {
  return {{"time", "a.az"}, {"s", "m/s2"}, {time, std::vector<double>(time.size(), 1.0)}};
}

TEST(EvenTimes, AreNeeded) {
  std::vector<double> time;
  for (int k = 0; k < 100; ++k) time.push_back(1e-3 * k);
  EXPECT_EQ(even_times(time, "f").rows, 100u);
  time.push_back(0.0994);  // the end of a run
  EXPECT_EQ(even_times(time, "f").rows, 100u);
  time.push_back(0.1);
  EXPECT_TRUE(test::names(test::error_of([&] { even_times(time, "runs/a"); }), {"runs/a", "E0687"}));
}

TEST(ClassFilter, NeedsTenRowsPerPeriodOfItsClass) {
  std::vector<double> time;
  for (int k = 0; k < 100; ++k) time.push_back(1e-3 * k);
  EXPECT_EQ(filtered_history(with_rows(time), {"a.az"}, 60, "f").columns[1].size(), 100u);
  EXPECT_TRUE(test::names(test::error_of([&] { filtered_history(with_rows(time), {"a.az"}, 180, "f"); }),
                          {"CFC 180", "E0687"}));
  time.resize(15);  // less than 1/60 s
  EXPECT_TRUE(test::names(test::error_of([&] { filtered_history(with_rows(time), {"a.az"}, 60, "f"); }),
                          {"CFC 60", "0.015 s", "E0687"}));
}

}  // namespace
}  // namespace footfall
