// Neighbours are found with a grid of cells; packing and profile count points and columns of a regular grid.
#include "mbd_solver/bed/bed_measures.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <unordered_map>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/bed/codes.h"

namespace footfall {
namespace {

// Grains in the cells of a grid with edge `reach` [m]: all grains within `reach` of a point are in the 27 cells around it.
class Cells {
 public:
  Cells(const Eigen::Matrix3Xd& x, double reach) : edge_(reach) {
    for (int i = 0; i < x.cols(); ++i) cells_[key(cell(x.col(i)))].push_back(i);
  }
  template <typename Visit>
  void near(const Eigen::Vector3d& x, Visit visit) const {
    const std::array<long, 3> c = cell(x);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto found = cells_.find(key({c[0] + i, c[1] + j, c[2] + k}));
          if (found == cells_.end()) continue;
          for (const int grain : found->second) visit(grain);
        }
  }

 private:
  static long key(const std::array<long, 3>& c) {  // a million cells each way
    return ((c[0] + 0x80000) << 40) + ((c[1] + 0x80000) << 20) + (c[2] + 0x80000);
  }
  std::array<long, 3> cell(const Eigen::Vector3d& x) const {
    return {std::lround(std::floor(x.x() / edge_)), std::lround(std::floor(x.y() / edge_)),
            std::lround(std::floor(x.z() / edge_))};
  }
  double edge_;
  std::unordered_map<long, std::vector<int>> cells_;
};

double largest_radius(const BedFrame& bed) {
  return bed.radius.empty() ? 0.0 : *std::max_element(bed.radius.begin(), bed.radius.end());
}
double smallest_radius(const BedFrame& bed) {
  return bed.radius.empty() ? 0.0 : *std::min_element(bed.radius.begin(), bed.radius.end());
}
double radius(const BedFrame& bed, int i) { return bed.radius[i]; }

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

double kinetic_energy(const BedFrame& bed) {
  double energy = 0.0, mass = 0.0;
  for (int i = 0; i < bed.count() && bed.v.cols() > 0; ++i) {
    const double r3 = std::pow(radius(bed, i), 3);
    energy += 0.5 * r3 * bed.v.col(i).squaredNorm();
    mass += r3;
  }
  return mass > 0.0 ? energy / mass : 0.0;
}

double coordination_number(const BedFrame& bed, double gap) {
  if (bed.count() == 0) return 0.0;
  const Cells cells(bed.x, (2.0 + gap) * largest_radius(bed));
  long pairs = 0;
  for (int i = 0; i < bed.count(); ++i)
    cells.near(bed.x.col(i), [&](int j) {
      if (j <= i) return;
      const double reach = radius(bed, i) + radius(bed, j) + gap * std::min(radius(bed, i), radius(bed, j));
      if ((bed.x.col(i) - bed.x.col(j)).squaredNorm() < reach * reach) ++pairs;
    });
  return 2.0 * static_cast<double>(pairs) / bed.count();
}

// Points on a grid, a fifth of the smallest radius apart; each grain marks those that it covers.
double packing_fraction(const BedFrame& bed, const Eigen::Vector3d& top, double R, double depth) {
  if (bed.count() == 0) return 0.0;
  const double step = 0.2 * smallest_radius(bed);
  const long n = static_cast<long>(R / step), m = std::max(1l, static_cast<long>(depth / step));
  const Eigen::Vector3d corner = top - Eigen::Vector3d(static_cast<double>(n) * step, static_cast<double>(n) * step,
                                                       (static_cast<double>(m) - 0.5) * step);
  const long side = 2 * n + 1;
  std::vector<char> covered(side * side * m, 0);
  for (int g = 0; g < bed.count(); ++g) {
    const Eigen::Vector3d c = (bed.x.col(g) - corner) / step;
    const double r = radius(bed, g) / step;
    const auto from = [&](int d) { return std::max(0l, static_cast<long>(std::ceil(c[d] - r))); };
    const auto to = [&](int d, long limit) { return std::min(limit - 1, static_cast<long>(std::floor(c[d] + r))); };
    for (long i = from(0); i <= to(0, side); ++i)
      for (long j = from(1); j <= to(1, side); ++j)
        for (long k = from(2); k <= to(2, m); ++k) {
          const Eigen::Vector3d d(static_cast<double>(i) - c.x(), static_cast<double>(j) - c.y(),
                                  static_cast<double>(k) - c.z());
          if (d.squaredNorm() < r * r) covered[(i * side + j) * m + k] = 1;
        }
  }
  long inside = 0, all = 0;
  for (long i = 0; i < side; ++i)
    for (long j = 0; j < side; ++j) {
      if ((i - n) * (i - n) + (j - n) * (j - n) > n * n) continue;
      for (long k = 0; k < m; ++k) inside += covered[(i * side + j) * m + k];
      all += m;
    }
  return static_cast<double>(inside) / static_cast<double>(all);
}

std::vector<double> surface_profile(const BedFrame& bed, const Eigen::Vector2d& centre, double width, int rings) {
  std::map<std::pair<long, long>, double> tops;  // of columns around the line
  const auto raise = [&](long i, long j, double top) {
    const auto [entry, fresh] = tops.emplace(std::pair(i, j), top);
    if (!fresh) entry->second = std::max(entry->second, top);
  };
  for (int g = 0; g < bed.count(); ++g) {
    const Eigen::Vector2d d = (bed.x.col(g).head<2>() - centre) / width;
    const double r = radius(bed, g) / width, z = bed.x(2, g) / width;
    if (d.norm() > rings + 1.0 + r) continue;
    raise(std::lround(std::floor(d.x())), std::lround(std::floor(d.y())), (z + r) * width);
    // A grain wider than a column reaches into others: there its height above the column's middle counts.
    for (long i = std::lround(std::ceil(d.x() - r - 0.5)); static_cast<double>(i) + 0.5 < d.x() + r; ++i)
      for (long j = std::lround(std::ceil(d.y() - r - 0.5)); static_cast<double>(j) + 0.5 < d.y() + r; ++j) {
        const double beside =
            (d - Eigen::Vector2d(static_cast<double>(i) + 0.5, static_cast<double>(j) + 0.5)).squaredNorm();
        if (beside < r * r) raise(i, j, (z + std::sqrt(r * r - beside)) * width);
      }
  }
  std::vector<double> sum(rings, 0.0);
  std::vector<int> count(rings, 0);
  for (const auto& [column, top] : tops) {
    const auto ring = static_cast<std::size_t>(
        std::hypot(static_cast<double>(column.first) + 0.5, static_cast<double>(column.second) + 0.5));
    if (ring >= sum.size()) continue;
    sum[ring] += top;
    ++count[ring];
  }
  for (std::size_t k = 0; k < sum.size(); ++k)
    sum[k] = count[k] > 0 ? sum[k] / count[k] : std::numeric_limits<double>::quiet_NaN();
  return sum;
}

Separation separation(const BedFrame& a, const BedFrame& b) {
  std::vector<double> distances;
  int apart = 0;
  for (int i = 0, j = 0; i < a.count() && j < b.count();) {
    const int id_a = a.id[i], id_b = b.id[j];
    if (id_a == id_b) {
      distances.push_back((a.x.col(i) - b.x.col(j)).norm());
      if (distances.back() > 0.1 * radius(a, i)) ++apart;
      ++i, ++j;
    } else {
      (id_a < id_b ? i : j) += 1;
    }
  }
  Separation result;
  if (distances.empty()) return result;
  const auto n = static_cast<double>(distances.size());
  for (const double d : distances) result.mean += d / n;
  result.share_apart = apart / n;
  std::sort(distances.begin(), distances.end());
  result.median = distances[distances.size() / 2];
  result.largest = distances.back();
  return result;
}

BedSlope bed_slope(const BedFrame& bed, const SlopeBounds& bounds) {
  const double r = bounds.radius, width = kSlice * 2.0 * r, apart = kApart * 2.0 * r, left = bounds.left + 0.5 * width;
  const long count = std::max(0L, std::lround(std::floor((bounds.right - bounds.left - width) / apart)) + 1);
  std::vector<double> top(count, -std::numeric_limits<double>::infinity());
  for (int i = 0; i < bed.count(); ++i) {
    const double at = (bed.x(0, i) - left) / apart, reach = 0.5 * width / apart;  // in slices
    const long first = std::max(0L, std::lround(std::ceil(at - reach)));
    const long last = std::min(count - 1, std::lround(std::floor(at + reach)));
    for (long k = first; k <= last; ++k) {
      double& slice = top[k];
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
    throw InputError(code::kNoDumps, folder +
                                         ": no dumps of grains, which the slope requires; set "
                                         "particles.box.frame_interval, or dump id x y z radius");
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

BedContacts bed_contacts(const std::vector<GrainPlace>& grains) {
  BedContacts out;
  if (grains.empty()) return out;
  double radius = 0.0;
  Eigen::Matrix3Xd x(3, static_cast<Eigen::Index>(grains.size()));
  for (std::size_t i = 0; i < grains.size(); ++i) {
    radius = std::max(radius, grains[i].radius);
    x.col(static_cast<Eigen::Index>(i)) = grains[i].centre;
  }
  const Eigen::Vector3d low = x.rowwise().minCoeff(), high = x.rowwise().maxCoeff();
  const Cells cells(x, 2.0 * radius);
  const double quarter = 0.25 * (high.z() - low.z());
  long touches = 0;
  std::vector<GrainPlace> inside;
  for (std::size_t i = 0; i < grains.size(); ++i) {
    const GrainPlace& grain = grains[i];
    const Eigen::Vector3d margin = (grain.centre - low).cwiseMin(high - grain.centre);
    const bool counts = margin.head<2>().minCoeff() >= 3.0 * radius && margin.z() >= quarter;
    cells.near(grain.centre, [&](int k) {
      const std::size_t j = k;
      if (j == i || (grain.clump != 0 && grain.clump == grains[j].clump)) return;
      const double overlap = grain.radius + grains[j].radius - (grain.centre - grains[j].centre).norm();
      if (overlap <= 0.0) return;
      out.largest_overlap = std::max(out.largest_overlap, overlap / std::min(grain.radius, grains[j].radius));
      touches += counts ? 1 : 0;
    });
    if (counts) inside.push_back(grain);
  }
  if (!inside.empty()) out.coordination = static_cast<double>(touches) / static_cast<double>(count_grains(inside));
  return out;
}

}  // namespace footfall
