#pragma once
// A curve through a table y(x), x rising strictly, by cubic Hermite pieces with limited slopes (Fritsch and
// Carlson 1980): once continuously differentiable, monotone wherever the table is, never beyond the values of
// a piece's two ends. Held constant outside the table.

#include <string>
#include <vector>

namespace footfall {

class MonotoneCurve {
 public:
  // At least two points. Throws InputError starting with `name` if x does not rise strictly, or a number is
  // not finite.
  MonotoneCurve(const std::string& name, std::vector<double> x, std::vector<double> y);

  double value(double x) const;
  double slope(double x) const;  // dy/dx; at the table's two ends that of the inside, 0 beyond

 private:
  std::vector<double> x_, y_, slope_;
};

}  // namespace footfall
