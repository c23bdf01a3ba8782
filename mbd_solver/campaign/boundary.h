#pragma once
// Where in one or two numbers an outcome has a given probability: a line or a curve of second degree, fitted to runs.

#include <Eigen/Core>
#include <array>
#include <vector>

#include "mbd_solver/campaign/statistics.h"

namespace footfall {

// The score x b of a logistic curve is log(level / (1 - level)) on the boundary. Terms of second degree are included only if
// they lower the information criterion of Schwarz, -2 log L + terms log n: otherwise a fit to one boundary may bend back to
// a second one. No boundary is reported where there are no runs: outside their convex hull, and for curves that nearby runs
// on both sides do not support.
class Boundary {
 public:
  using Point = std::array<double, 2>;  // x, y; of one number y = 0
  // happened: 0 or 1 of each point.
  Boundary(std::vector<Point> points, std::vector<int> happened, bool two, double level);

  struct Crossing {
    double x = 0.0, y = 0.0, low = 0.0, high = 0.0;  // the band is along y, or along x when `along_x`
    bool along_x = false;
  };
  std::vector<Crossing> crossings() const;
  // Crossings of the line through the median of x, else of y, else of the nearest lines that have a crossing; of one number all.
  std::vector<Crossing> middle() const;
  bool in_band(double x, double y) const;          // within the runs, and the score is 0 within its deviation
  double agreement() const { return agreement_; }  // share of the runs on the right side
  bool fitted() const { return fitted_; }          // at least five runs have the outcome, and five lack it
  bool curved() const { return curved_; }          // has terms of second degree
  double low(int axis) const { return low_[axis]; }
  double high(int axis) const { return high_[axis]; }

 private:
  Eigen::VectorXd terms(double x, double y) const;
  double score(double x, double y) const;  // 0 on the boundary
  bool sampled(double x, double y) const;  // within the convex hull of the runs
  // True if, among the nearest runs that straight lines reach without another crossing, some on the one side have the
  // outcome, and some on the other side lack it.
  bool borne_out(double x, double y) const;
  std::vector<Crossing> along(int axis, double other) const;

  std::vector<Point> points_, hull_;
  std::vector<int> happened_;
  bool two_, curved_ = false;
  double level_;  // score at the boundary
  double low_[2] = {0.0, 0.0}, high_[2] = {1.0, 1.0};
  Logistic fit_;
  double agreement_ = 0.0;
  bool fitted_ = false;
};

}  // namespace footfall
