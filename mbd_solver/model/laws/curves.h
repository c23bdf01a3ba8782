#pragma once
// Curves through points y(x), x rising strictly: a cubic spline, a monotone cubic that never overshoots, and corners of straight lines.

#include <string>
#include <vector>

namespace footfall {

// The points x at which straight lines through all points, held constant outside, change their slope.
std::vector<double> corners_of_lines(const std::vector<double>& x, const std::vector<double>& y);

// Cubic pieces, twice continuously differentiable.
class CubicSpline {
 public:
  // kNatural: zero curvature at both ends, continued by the tangents. kClosed: period x_n - x_0, y_n = y_0, the
  // curvature is continuous at the seam.
  enum class Ends { kNatural, kClosed };

  struct Value {
    double value = 0.0, slope = 0.0, curvature = 0.0;
    double third = 0.0;  // third derivative, constant in a piece
  };

  // At least two points, three of a closed curve. Throws InputError, beginning with `name`, if x does not rise.
  CubicSpline(const std::string& name, std::vector<double> x, std::vector<double> y, Ends ends = Ends::kNatural);

  Value at(double x) const;
  double first() const { return x_.front(); }
  double last() const { return x_.back(); }
  bool closed() const { return closed_; }

 private:
  Value inside(std::size_t piece, double x) const;
  void bend_natural();  // m_
  void bend_closed();

  std::vector<double> x_, y_, m_;  // m: second derivatives at the points
  bool closed_;
};

// A curve through a table y(x), x rising strictly, by cubic Hermite pieces with limited slopes (Fritsch and
// Carlson 1980): once continuously differentiable, monotone wherever the table is, never beyond the values of
// a piece's two ends. Held constant outside the table.
class MonotoneCurve {
 public:
  // At least two points. Throws InputError, beginning with `name`, if x does not rise strictly or a number is not
  // finite.
  MonotoneCurve(const std::string& name, std::vector<double> x, std::vector<double> y);

  double value(double x) const;
  double slope(double x) const;  // dy/dx; at the table's two ends the inner slope, 0 beyond

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace footfall
