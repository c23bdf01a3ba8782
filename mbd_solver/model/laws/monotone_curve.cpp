#include "mbd_solver/model/laws/monotone_curve.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "coupler/base/errors.h"
#include "coupler/base/parameter_check.h"
#include "coupler/base/text.h"

namespace footfall {

MonotoneCurve::MonotoneCurve(const std::string& name, std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)) {
  if (x_.size() != y_.size() || x_.size() < 2)
    throw InputError(name + ": the table has " + std::to_string(x_.size()) + " abscissas and " +
                     std::to_string(y_.size()) + " values; expected the same number of each, at least two.");
  const std::size_t n = x_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(x_[i]) || !std::isfinite(y_[i]))
      throw InputError(name + ": entry " + std::to_string(i + 1) + " of the table is not a finite number.");
    if (i > 0 && x_[i] <= x_[i - 1])
      throw InputError(name + ": abscissa " + number_text(x_[i]) + " follows " + number_text(x_[i - 1]) +
                       "; expected strictly rising values. Sort the table and remove doubles.");
  }
  // Fritsch-Butland slopes: the weighted harmonic mean of the two neighbouring secants, 0 where they differ
  // in sign; at the ends the secant, which keeps the piece monotone (Fritsch-Carlson: slopes up to 3 secants
  // do).
  std::vector<double> secant(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) secant[i] = (y_[i + 1] - y_[i]) / (x_[i + 1] - x_[i]);
  slope_.assign(n, 0.0);
  slope_.front() = secant.front();
  slope_.back() = secant.back();
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (secant[i - 1] * secant[i] <= 0.0) continue;
    const double h0 = x_[i] - x_[i - 1], h1 = x_[i + 1] - x_[i];
    slope_[i] = 3.0 * (h0 + h1) / ((2.0 * h1 + h0) / secant[i - 1] + (h1 + 2.0 * h0) / secant[i]);
  }
}

double MonotoneCurve::value(double x) const {
  if (x <= x_.front()) return y_.front();
  if (x >= x_.back()) return y_.back();
  const std::size_t i = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h;
  return (1.0 + 2.0 * t) * (1.0 - t) * (1.0 - t) * y_[i] + t * t * (3.0 - 2.0 * t) * y_[i + 1] +
         h * t * (1.0 - t) * ((1.0 - t) * slope_[i] - t * slope_[i + 1]);
}

double MonotoneCurve::slope(double x) const {
  if (x < x_.front() || x > x_.back()) return 0.0;
  const std::size_t above = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin());
  const std::size_t i = std::min(above, x_.size() - 1) - 1;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h;
  return 6.0 * t * (1.0 - t) * (y_[i + 1] - y_[i]) / h + (1.0 - t) * (1.0 - 3.0 * t) * slope_[i] +
         t * (3.0 * t - 2.0) * slope_[i + 1];
}

}  // namespace footfall
