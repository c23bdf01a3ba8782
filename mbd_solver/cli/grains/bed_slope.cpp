#include "mbd_solver/cli/grains/bed_slope.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"

namespace footfall {
namespace {

constexpr double kSlice = 2.0, kApart = 0.25;  // width of a slice, between their middles [grain diameters]
constexpr std::size_t kLeastSlices = 3;

// Angle and R^2 of y = a + b x, in closed form: b = S_xy / S_xx, R^2 = S_xy^2 / (S_xx S_yy), sums about the means.
void fit_line(const std::vector<double>& x, const std::vector<double>& y, BedSlope& slope) {
  slope.angle = slope.r_squared = std::numeric_limits<double>::quiet_NaN();
  if (x.size() < kLeastSlices) return;
  const auto n = static_cast<double>(x.size());
  double mean_x = 0.0, mean_y = 0.0, xx = 0.0, xy = 0.0, yy = 0.0;
  for (std::size_t i = 0; i < x.size(); ++i) mean_x += x[i] / n, mean_y += y[i] / n;
  for (std::size_t i = 0; i < x.size(); ++i) {
    const double dx = x[i] - mean_x, dy = y[i] - mean_y;
    xx += dx * dx, xy += dx * dy, yy += dy * dy;
  }
  if (!(xx > 0.0)) return;
  slope.angle = std::atan(std::abs(xy / xx)) * 180.0 / kPi;
  if (yy > 0.0) slope.r_squared = xy * xy / (xx * yy);
}

}  // namespace

BedSlope bed_slope(const BedFrame& bed, const SlopeBounds& bounds) {
  const double r = bounds.radius, width = kSlice * 2.0 * r, apart = kApart * 2.0 * r, left = bounds.left + 0.5 * width;
  const long count = std::max(0L, std::lround(std::floor((bounds.right - bounds.left - width) / apart)) + 1);
  std::vector<double> top(static_cast<std::size_t>(count), -std::numeric_limits<double>::infinity());
  for (int i = 0; i < bed.count(); ++i) {
    const double at = (bed.x(0, i) - left) / apart, reach = 0.5 * width / apart;  // in slices
    const long first = std::max(0L, std::lround(std::ceil(at - reach)));
    const long last = std::min(count - 1, std::lround(std::floor(at + reach)));
    for (long k = first; k <= last; ++k) {
      double& slice = top[static_cast<std::size_t>(k)];
      slice = std::max(slice, bed.x(2, i));
    }
  }
  BedSlope slope;
  std::vector<double> x, y;  // between the bounds
  for (std::size_t k = 0; k < top.size(); ++k) {
    if (!std::isfinite(top[k])) continue;
    slope.x.push_back(left + static_cast<double>(k) * apart);
    slope.height.push_back(top[k]);
    if (top[k] >= bounds.low && top[k] <= bounds.high) x.push_back(slope.x.back()), y.push_back(top[k]);
  }
  fit_line(x, y, slope);
  return slope;
}

BedSlope last_slope(const std::string& folder, double low, double high) {
  const auto frames = find_bed_frames(folder);
  if (frames.empty())
    throw InputError(
        folder +
        ": no dumps of the grains, whose slope is asked for; set particles.box.frames, or dump id x y z radius");
  const BedFrame bed = read_bed_frame(frames.rbegin()->second);
  SlopeBounds bounds;
  if (bed.count() > 0) {
    bounds.radius = *std::max_element(bed.radius.begin(), bed.radius.end());
    bounds.left = bed.x.row(0).minCoeff() - bounds.radius;
    bounds.right = bed.x.row(0).maxCoeff() + bounds.radius;
  }
  bounds.low = low, bounds.high = high;
  return bed_slope(bed, bounds);
}

}  // namespace footfall
