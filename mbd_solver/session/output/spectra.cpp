// Recursive filters run over the samples; the Fourier transform is Eigen's.
#include "mbd_solver/session/output/spectra.h"

#include <unsupported/Eigen/FFT>

#include <algorithm>
#include <cmath>
#include <complex>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/codes.h"

namespace footfall {
namespace {

constexpr double kUneven = 1e-6;  // of a step
constexpr double kSamplesPerPeriod = 40.0;

// Smallwood's ramp-invariant filter for the absolute acceleration of an oscillator.
class Oscillator {
 public:
  Oscillator(double frequency, double quality, double step) {
    const double w = 2.0 * kPi * frequency, zeta = 1.0 / (2.0 * quality), wd = w * std::sqrt(1.0 - zeta * zeta);
    const double E = std::exp(-zeta * w * step), K = wd * step, C = E * std::cos(K), S = E * std::sin(K);
    b0_ = 1.0 - S / K;
    b1_ = 2.0 * (S / K - C);
    b2_ = E * E - S / K;
    a1_ = 2.0 * C;
    a2_ = -E * E;
  }
  double next(double x) {
    const double y = b0_ * x + b1_ * x1_ + b2_ * x2_ + a1_ * y1_ + a2_ * y2_;
    x2_ = x1_;
    x1_ = x;
    y2_ = y1_;
    y1_ = y;
    return y;
  }

 private:
  double b0_, b1_, b2_, a1_, a2_;
  double x1_ = 0.0, x2_ = 0.0, y1_ = 0.0, y2_ = 0.0;
};

// One pass of the filter of a class, at rest at the first value before it.
void pass_filter(std::vector<double>& x, double wa, bool backwards) {
  const double root = std::sqrt(2.0), sum = 1.0 + root * wa + wa * wa;
  const double a0 = wa * wa / sum, b1 = -2.0 * (wa * wa - 1.0) / sum, b2 = (root * wa - 1.0 - wa * wa) / sum;
  const std::size_t count = x.size();
  const auto at = [&](std::size_t k) { return backwards ? count - 1 - k : k; };
  double x1 = x[at(0)], x2 = x1, y1 = x1, y2 = x1;
  for (std::size_t k = 0; k < count; ++k) {
    double& value = x[at(k)];
    const double y = a0 * (value + 2.0 * x1 + x2) + b1 * y1 + b2 * y2;
    x2 = x1;
    x1 = value;
    y2 = y1;
    y1 = y;
    value = y;
  }
}

}  // namespace

EvenTimes even_times(const std::vector<double>& time, const std::string& file) {
  if (time.size() < 4)
    throw InputError(code::kRowsForSpectrum,
                     file + ": has " + std::to_string(time.size()) + " rows, expected at least four for a spectrum");
  const double step = time[1] - time[0];
  for (std::size_t k = 1; k < time.size(); ++k) {
    if (std::abs(time[k] - time[0] - static_cast<double>(k) * step) <=
        kUneven * step * std::max(1.0, static_cast<double>(k)))
      continue;
    if (k + 1 == time.size()) return {step, k};
    throw InputError(
        code::kRowsForSpectrum,
        file + ": the rows at " + number_text(time[k - 1], 9) + " s and " + number_text(time[k], 9) +
            " s are not a step of " + number_text(step, 6) +
            " s apart, expected rows at even times; run again with output.interval of at least the time step of "
            "the grains");
  }
  return {step, time.size()};
}

std::vector<double> shock_frequencies(double step, std::size_t rows) {
  const double lowest = 1.0 / (step * static_cast<double>(rows)), highest = 0.2 / step;
  std::vector<double> frequencies;
  for (int k = 0;; ++k) {
    const double f = lowest * std::exp2(k / 12.0);
    if (f > highest) break;
    frequencies.push_back(f);
  }
  return frequencies;
}

Spectrum shock_response(const std::vector<double>& x, double step, double quality,
                        const std::vector<double>& frequencies) {
  Spectrum spectrum{frequencies, {}};
  for (const double f : frequencies) {
    const auto parts = std::max(1.0, std::ceil(kSamplesPerPeriod * f * step));
    Oscillator oscillator(f, quality, step / parts);
    const auto beyond = static_cast<std::size_t>(std::ceil(1.0 / (f * step)));
    double largest = std::abs(x.front()), before = 0.0;
    for (std::size_t k = 1; k < x.size() + beyond; ++k) {
      const double now = (k < x.size() ? x[k] : x.back()) - x.front();
      for (double part = 1.0; part <= parts; part += 1.0)
        largest = std::max(largest, std::abs(x.front() + oscillator.next(before + (now - before) * part / parts)));
      before = now;
    }
    spectrum.value.push_back(largest);
  }
  return spectrum;
}

std::size_t default_window(std::size_t rows) { return std::max<std::size_t>(4, rows / 8); }

Spectrum power_density(const std::vector<double>& x, double step, std::size_t window) {
  const std::size_t count = std::min(window, x.size()), shift = std::max<std::size_t>(1, count / 4);
  std::vector<double> hann(count), part(count);
  double power = 0.0;
  for (std::size_t k = 0; k < count; ++k) {
    hann[k] = 0.5 - 0.5 * std::cos(2.0 * kPi * static_cast<double>(k) / static_cast<double>(count));
    power += hann[k] * hann[k];
  }
  const std::size_t lines = count / 2 + 1;
  Spectrum spectrum{std::vector<double>(lines), std::vector<double>(lines, 0.0)};
  Eigen::FFT<double> fft;
  std::vector<std::complex<double>> transform;
  // Samples near the ends are in fewer windows: the first and the last count for those that would reach beyond.
  const std::size_t last = (x.size() - count) / shift * shift;
  const double all = static_cast<double>(x.size()) / static_cast<double>(shift);
  const double beyond = std::max(0.0, all - static_cast<double>(last / shift + 1)) / 2.0;
  double windows = 0.0;
  for (std::size_t first = 0; first <= last; first += shift) {
    const double weight = 1.0 + (first == 0 ? beyond : 0.0) + (first == last ? beyond : 0.0);
    double mean = 0.0;
    for (std::size_t k = 0; k < count; ++k) mean += x[first + k] / static_cast<double>(count);
    for (std::size_t k = 0; k < count; ++k) part[k] = hann[k] * (x[first + k] - mean);
    fft.fwd(transform, part);
    for (std::size_t k = 0; k < lines; ++k) spectrum.value[k] += weight * std::norm(transform[k]);
    windows += weight;
  }
  for (std::size_t k = 0; k < lines; ++k) {
    const bool once = k == 0 || 2 * k == count;  // without a partner at a negative frequency
    spectrum.value[k] *= (once ? 1.0 : 2.0) * step / (power * windows);
    spectrum.frequency[k] = static_cast<double>(k) / (static_cast<double>(count) * step);
  }
  return spectrum;
}

std::vector<double> class_filtered(const std::vector<double>& x, double step, int channel_class) {
  constexpr double kCorner = 2.0775;  // of a pass over the class [SAE J211-1]
  std::vector<double> y = x;
  if (y.empty()) return y;
  const double wa = std::tan(kPi * kCorner * channel_class * step);
  pass_filter(y, wa, false);
  pass_filter(y, wa, true);
  return y;
}

History filtered_history(const History& history, const std::vector<std::string>& columns, int channel_class,
                         const std::string& file) {
  constexpr double kRate = 10.0;  // samples per period of the class [SAE J211-1]
  const EvenTimes times = even_times(history.column("time"), file);
  if (times.step * kRate * channel_class > 1.0 + kUneven)
    throw InputError(code::kRowsForSpectrum,
                     file + ": has rows every " + number_text(times.step, 4) + " s, expected at most " +
                         number_text(1.0 / (kRate * channel_class), 4) + " s for CFC " + std::to_string(channel_class) +
                         " (SAE J211: ten samples per period of the class); run again with a shorter output.interval");
  if (static_cast<double>(times.rows) * times.step * channel_class < 1.0)
    throw InputError(code::kRowsForSpectrum,
                     file + ": lasts " + number_text(static_cast<double>(times.rows) * times.step, 4) +
                         " s, expected at least a period of CFC " + std::to_string(channel_class) + ", " +
                         number_text(1.0 / channel_class, 4) + " s: what the filter makes of less is its own start");
  History filtered;
  const auto add = [&](const std::string& name, std::vector<double> values) {
    filtered.names.push_back(name);
    filtered.units.push_back(history.units[history.find(name)]);
    values.resize(times.rows);
    filtered.columns.push_back(std::move(values));
  };
  add("time", history.column("time"));
  for (const std::string& name : columns) {
    std::vector<double> values = history.column(name);
    values.resize(times.rows);
    add(name, class_filtered(values, times.step, channel_class));
  }
  return filtered;
}

}  // namespace footfall
