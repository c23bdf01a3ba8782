// Natural splines solve a tridiagonal system for the second derivatives (Thomas), closed ones a cyclic system (LDLT).
// Monotone curves limit the slopes of Hermite pieces (Fritsch and Butland 1984).

#include "mbd_solver/model/laws/curves.h"

#include <Eigen/SparseCholesky>
#include <algorithm>
#include <cmath>
#include <cstddef>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

// Right side of the equations for second derivatives: left m_{i-1} + 2 (left + right) m_i + right m_{i+1} = this.
double bend(double y_before, double y, double y_after, double left, double right) {
  return 6.0 * ((y_after - y) / right - (y - y_before) / left);
}

constexpr double kStraight = 1e-12;  // change of slope that is round-off [-]

}  // namespace

std::vector<double> corners_of_lines(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> corners;
  double before = 0.0;  // slope
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double after = i + 1 < x.size() ? (y[i + 1] - y[i]) / (x[i + 1] - x[i]) : 0.0;
    if (std::abs(after - before) > kStraight * std::max(std::abs(after), std::abs(before))) corners.push_back(x[i]);
    before = after;
  }
  return corners;
}

CubicSpline::CubicSpline(const std::string& name, std::vector<double> x, std::vector<double> y, Ends ends)
    : x_(std::move(x)), y_(std::move(y)), m_(x_.size(), 0.0), closed_(ends == Ends::kClosed) {
  const std::size_t least = closed_ ? 3 : 2;
  if (x_.size() < least || x_.size() != y_.size())
    throw InputError(code::kTableShape,
                     name + " requires at least " + (closed_ ? "three" : "two") + " points, with one value at each.");
  for (std::size_t i = 1; i < x_.size(); ++i) {
    if (!(x_[i] > x_[i - 1]))
      throw InputError(code::kCurveNotRising, name + ": " + number_text(x_[i]) + " follows " + number_text(x_[i - 1]) +
                                                  "; expected strictly rising values.");
  }
  if (closed_) {
    FOOTFALL_DEMAND(y_.front() == y_.back());
    bend_closed();
  } else {
    bend_natural();
  }
}

// Tridiagonal, Thomas' algorithm.
void CubicSpline::bend_natural() {
  const std::size_t n = x_.size();
  std::vector<double> upper(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = x_[i] - x_[i - 1], right = x_[i + 1] - x_[i];
    const double rhs = bend(y_[i - 1], y_[i], y_[i + 1], left, right);
    const double pivot = 2.0 * (left + right) - left * upper[i - 1];
    upper[i] = right / pivot;
    m_[i] = (rhs - left * m_[i - 1]) / pivot;
  }
  for (std::size_t i = n - 1; i-- > 1;) m_[i] -= upper[i] * m_[i + 1];
}

// Cyclic: the last point is the first one. The matrix is diagonally dominant, hence positive definite.
void CubicSpline::bend_closed() {
  const std::size_t n = x_.size() - 1;
  const auto width = [&](std::size_t i) { return x_[i % n + 1] - x_[i % n]; };
  std::vector<Eigen::Triplet<double>> entries;
  Eigen::VectorXd rhs(static_cast<Eigen::Index>(n));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n, after = (i + 1) % n;
    const double left = width(before), right = width(i);
    const auto row = static_cast<Eigen::Index>(i);
    entries.emplace_back(row, before, left);
    entries.emplace_back(row, i, 2.0 * (left + right));
    entries.emplace_back(row, after, right);
    rhs[row] = bend(y_[before], y_[i], y_[after], left, right);
  }
  Eigen::SparseMatrix<double> A(rhs.size(), rhs.size());
  A.setFromTriplets(entries.begin(), entries.end());
  const Eigen::VectorXd m = Eigen::SimplicialLDLT<Eigen::SparseMatrix<double>>(A).solve(rhs);
  std::copy(m.begin(), m.end(), m_.begin());
  m_.back() = m_.front();
}

CubicSpline::Value CubicSpline::at(double x) const {
  if (closed_) {
    const double period = last() - first();
    x -= period * std::floor((x - first()) / period);
  } else if (x <= first() || x >= last()) {
    const double end = x <= first() ? first() : last();
    const Value at_end = inside(x <= first() ? 0 : x_.size() - 2, end);
    return {at_end.value + at_end.slope * (x - end), at_end.slope, 0.0, 0.0};
  }
  const auto next = std::upper_bound(x_.begin() + 1, x_.end() - 1, x);
  return inside(static_cast<std::size_t>(next - x_.begin()) - 1, x);
}

CubicSpline::Value CubicSpline::inside(std::size_t i, double x) const {
  const double h = x_[i + 1] - x_[i];
  const double b = (x - x_[i]) / h, a = 1.0 - b;
  return {a * y_[i] + b * y_[i + 1] + ((a * a * a - a) * m_[i] + (b * b * b - b) * m_[i + 1]) * h * h / 6.0,
          (y_[i + 1] - y_[i]) / h + ((1.0 - 3.0 * a * a) * m_[i] + (3.0 * b * b - 1.0) * m_[i + 1]) * h / 6.0,
          a * m_[i] + b * m_[i + 1], (m_[i + 1] - m_[i]) / h};
}

MonotoneCurve::MonotoneCurve(const std::string& name, std::vector<double> x, std::vector<double> y)
    : x_(std::move(x)), y_(std::move(y)) {
  if (x_.size() != y_.size() || x_.size() < 2)
    throw InputError(code::kTableShape, name + ": the table has " + std::to_string(x_.size()) + " abscissas and " +
                                            std::to_string(y_.size()) +
                                            " values; expected equal numbers, at least two.");
  const std::size_t n = x_.size();
  for (std::size_t i = 0; i < n; ++i) {
    if (!std::isfinite(x_[i]) || !std::isfinite(y_[i]))
      throw InputError(code::kTableShape,
                       name + ": entry " + std::to_string(i + 1) + " of the table is not a finite number.");
    if (i > 0 && x_[i] <= x_[i - 1])
      throw InputError(code::kCurveNotRising,
                       name + ": abscissa " + number_text(x_[i]) + " follows " + number_text(x_[i - 1]) +
                           "; expected strictly rising values. Sort the table and remove duplicates.");
  }
  // Fritsch-Butland slopes: the weighted harmonic mean of the two neighbouring secants, 0 where they differ in sign. At
  // the ends the secant; a piece is monotone for slopes up to three secants (Fritsch-Carlson).
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
