#pragma once
// A curve through points y(x), x rising strictly, by cubic pieces: twice continuously differentiable.

#include <string>
#include <vector>

namespace footfall {

class CubicSpline {
 public:
  // kNatural: no curvature at its two ends, and beyond them their tangents. kClosed: of period x_n - x_0, with
  // y_n = y_0; the curvature goes on through the seam.
  enum class Ends { kNatural, kClosed };

  struct Value {
    double value = 0.0, slope = 0.0, curvature = 0.0;
    double third = 0.0;  // of the piece; it jumps from one to the next
  };

  // At least two points, three of a closed curve; InputError, which begins with `name`, where x does not rise.
  CubicSpline(const std::string& name, std::vector<double> x, std::vector<double> y, Ends ends = Ends::kNatural);

  Value at(double x) const;
  double first() const { return x_.front(); }
  double last() const { return x_.back(); }

 private:
  Value inside(std::size_t piece, double x) const;
  void bend_natural();  // m_
  void bend_closed();

  std::vector<double> x_, y_, m_;  // m: second derivatives at the points
  bool closed_;
};

}  // namespace footfall
