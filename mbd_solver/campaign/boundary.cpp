// Two logistic fits, of first and second degree, of which one is chosen; crossings are found by looking along lines for a
// change of sign of the score.
#include "mbd_solver/campaign/boundary.h"

#include <algorithm>
#include <cmath>

namespace footfall {

namespace {

constexpr double kBand = 1.959963984540054;  // deviations, 95 %
constexpr int kSteps = 400;                  // along a line, between looks for the boundary
constexpr long kFewestOnASide = 5;           // runs with the outcome, and without it

double turn(const Boundary::Point& a, const Boundary::Point& b, const Boundary::Point& c) {
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

// Counterclockwise, by monotone chains (Andrew 1979).
std::vector<Boundary::Point> convex_hull(std::vector<Boundary::Point> points) {
  std::sort(points.begin(), points.end());
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Boundary::Point> hull;
  for (int half = 0; half < 2; ++half) {
    const std::size_t first = hull.size();
    for (const Boundary::Point& point : points) {
      while (hull.size() >= first + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0.0) hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double log_likelihood(const Eigen::MatrixXd& x, const Eigen::VectorXd& y, const Logistic& fit) {
  double sum = 0.0;
  for (Eigen::Index i = 0; i < y.size(); ++i) {
    const double s = fit.score(x.row(i)) * (y[i] > 0.5 ? 1.0 : -1.0);
    sum -= s > 0.0 ? std::log1p(std::exp(-s)) : std::log1p(std::exp(s)) - s;
  }
  return sum;
}

}  // namespace

Boundary::Boundary(std::vector<Point> points, std::vector<int> happened, bool two, double level)
    : points_(std::move(points)), happened_(std::move(happened)), two_(two), level_(std::log(level / (1.0 - level))) {
  const long hits = std::count(happened_.begin(), happened_.end(), 1);
  fitted_ = std::min(hits, static_cast<long>(happened_.size()) - hits) >= kFewestOnASide;
  if (points_.empty()) return;
  for (int axis = 0; axis < 2; ++axis) {
    const auto [least, most] = std::minmax_element(
        points_.begin(), points_.end(), [axis](const Point& a, const Point& b) { return a[axis] < b[axis]; });
    low_[axis] = (*least)[axis];
    high_[axis] = (*most)[axis];
    if (!(high_[axis] > low_[axis])) high_[axis] = low_[axis] + 1.0;
  }
  if (two_) hull_ = convex_hull(points_);
  if (!fitted_) return;
  const auto count = static_cast<Eigen::Index>(points_.size());
  Eigen::VectorXd y(count);
  Eigen::MatrixXd x[2];
  Logistic fits[2];
  double likelihoods[2];
  for (const int degree : {0, 1}) {
    curved_ = degree > 0;
    x[degree].resize(count, terms(low_[0], low_[1]).size());
    for (Eigen::Index i = 0; i < count; ++i) {
      const Point& point = points_[i];
      x[degree].row(i) = terms(point[0], point[1]);
      y[i] = happened_[i];
    }
    fits[degree] = fit_logistic(x[degree], y);
    likelihoods[degree] = log_likelihood(x[degree], y, fits[degree]);
  }
  const double more = static_cast<double>(x[1].cols() - x[0].cols()) * std::log(static_cast<double>(count));
  curved_ = 2.0 * (likelihoods[1] - likelihoods[0]) > more;
  fit_ = fits[curved_ ? 1 : 0];
  long right = 0;
  for (std::size_t i = 0; i < points_.size(); ++i)
    right += (score(points_[i][0], points_[i][1]) > 0.0) == (happened_[i] > 0) ? 1 : 0;
  agreement_ = static_cast<double>(right) / static_cast<double>(points_.size());
}

// In numbers of -1 to 1 over the range of the runs.
Eigen::VectorXd Boundary::terms(double x, double y) const {
  const double u = 2.0 * (x - low_[0]) / (high_[0] - low_[0]) - 1.0;
  const double w = 2.0 * (y - low_[1]) / (high_[1] - low_[1]) - 1.0;
  Eigen::VectorXd t((two_ ? 3 : 2) + (!curved_ ? 0 : two_ ? 3 : 1));
  if (two_ && curved_)
    t << 1.0, u, w, u * u, u * w, w * w;
  else if (two_)
    t << 1.0, u, w;
  else if (curved_)
    t << 1.0, u, u * u;
  else
    t << 1.0, u;
  return t;
}

double Boundary::score(double x, double y) const { return fit_.score(terms(x, y)) - level_; }

bool Boundary::sampled(double x, double y) const {
  if (!two_) return x >= low_[0] && x <= high_[0];
  if (hull_.size() < 3) return false;
  for (std::size_t k = 0; k < hull_.size(); ++k)
    if (turn(hull_[k], hull_[(k + 1) % hull_.size()], {x, y}) < 0.0) return false;
  return true;
}

bool Boundary::in_band(double x, double y) const {
  const Eigen::VectorXd t = terms(x, y);
  return sampled(x, y) && std::abs(fit_.score(t) - level_) < kBand * fit_.deviation(t);
}

bool Boundary::borne_out(double x, double y) const {
  constexpr std::size_t kNearest = 10;
  constexpr int kLooks = 8;  // along the line to a run
  std::vector<std::pair<double, std::size_t>> order;
  for (std::size_t i = 0; i < points_.size(); ++i)
    order.emplace_back(
        std::hypot((points_[i][0] - x) / (high_[0] - low_[0]), (points_[i][1] - y) / (high_[1] - low_[1])), i);
  std::sort(order.begin(), order.end());
  std::size_t seen[2] = {0, 0}, right[2] = {0, 0};  // on the side without the outcome, and with it
  for (const auto& [distance, i] : order) {
    const double dx = points_[i][0] - x, dy = points_[i][1] - y;
    const bool side = score(points_[i][0], points_[i][1]) > 0.0;
    if (seen[side] == kNearest) continue;
    bool reached = true;
    for (int k = 1; k < kLooks && reached; ++k)
      reached = (score(x + k * dx / kLooks, y + k * dy / kLooks) > 0.0) == side;
    if (!reached) continue;
    ++seen[side];
    right[side] += (happened_[i] > 0) == side ? 1 : 0;
  }
  return right[0] > 0 && right[1] > 0;
}

// The band about a crossing ends where the score differs from 0 by more than its own deviation allows.
std::vector<Boundary::Crossing> Boundary::along(int axis, double other) const {
  std::vector<Crossing> found;
  if (!fitted_) return found;
  const double step = (high_[axis] - low_[axis]) / kSteps;
  const auto at = [&](double s) { return axis == 0 ? score(s, other) : score(other, s); };
  const auto inside = [&](double s) { return axis == 0 ? in_band(s, other) : in_band(other, s); };
  for (int k = 0; k < kSteps; ++k) {
    double a = low_[axis] + k * step, b = a + step;
    if ((at(a) > 0.0) == (at(b) > 0.0)) continue;
    for (int half = 0; half < 40; ++half) {
      const double middle = 0.5 * (a + b);
      ((at(middle) > 0.0) == (at(a) > 0.0) ? a : b) = middle;
    }
    Crossing c;
    const double root = 0.5 * (a + b);
    c.along_x = axis == 0;
    c.x = axis == 0 ? root : other;
    c.y = axis == 0 ? other : root;
    if (!sampled(c.x, c.y) || !borne_out(c.x, c.y)) continue;
    c.low = c.high = root;
    while (c.low > low_[axis] && inside(c.low)) c.low -= 0.1 * step;
    while (c.high < high_[axis] && inside(c.high)) c.high += 0.1 * step;
    found.push_back(c);
  }
  return found;
}

std::vector<Boundary::Crossing> Boundary::crossings() const {
  if (!two_) return along(0, 0.0);
  constexpr int kLines = 80;
  std::vector<Crossing> all;
  for (const int axis : {1, 0})
    for (int k = 0; k <= kLines; ++k) {
      const int other = 1 - axis;
      const std::vector<Crossing> more = along(axis, low_[other] + k * (high_[other] - low_[other]) / kLines);
      all.insert(all.end(), more.begin(), more.end());
    }
  return all;
}

std::vector<Boundary::Crossing> Boundary::middle() const {
  if (!two_) return along(0, 0.0);
  for (const double share : {0.5, 0.25, 0.75, 0.1, 0.9, 0.02, 0.98})
    for (const int axis : {1, 0}) {
      std::vector<double> others;
      for (const Point& point : points_) others.push_back(point[1 - axis]);
      std::vector<Crossing> found = along(axis, quantile(others, share));
      if (!found.empty()) return found;
    }
  return {};
}

}  // namespace footfall
