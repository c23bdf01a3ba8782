// The field is evaluated with its first and second derivatives at once. Bounds of the second derivatives, of the map by tiles,
// tell at little cost where nothing can touch.

#include "mbd_solver/model/terrain.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>

#include "coupler/base/errors.h"
#include "mbd_solver/base/lanes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/spline_grid.h"

namespace footfall {
namespace {

constexpr double kFootFound = 1e-14;  // of a step of Newton's method, relative to the sizes of the numbers
constexpr int kMostPlaces = 240;      // of them along each axis
constexpr int kLevels = 3;            // of halves of a cell
constexpr int kBlock = 8;             // cells along each side of a block, which is left out as a whole if it can
constexpr double kBowl = 0.9;         // a ball of this share of the least radius of curvature has one contact

}  // namespace

void HeightGrid::read(int column, int row, int count, double* out) const {
  const auto wide = static_cast<std::size_t>(columns), from = static_cast<std::size_t>(column),
             n = static_cast<std::size_t>(count);
  if (!numbers) {
    std::copy_n(&heights[static_cast<std::size_t>(row) * wide + from], n, out);
    return;
  }
  numbers(static_cast<std::size_t>(rows - 1 - row) * wide + from, n, out);
  for (std::size_t k = 0; k < n; ++k) out[k] = (out[k] - below) * scale;
}

// The map of the file, and the waves of a random surface: these have a period in x and y, of which one is sampled, finely enough
// that they are what the spline makes of them.
struct Terrain::Map {
  std::optional<SplineGrid> site, rough;
  double period = 0.0, rough_bend = 0.0, rough_top = 0.0;

  // Samples from waves[first] on; waves[first - 1] has the period.
  void sample(const std::vector<GroundWave>& waves, std::size_t first) {
    constexpr double kPerWave = 8.0;  // samples of the shortest wave
    constexpr int kMargin =
        28;  // samples beyond the period, in which the ends of the spline fade out (0.27^28 = 1e-16)
    period = 2.0 * kPi / waves[first - 1].k.x();
    double k = 0.0;
    for (std::size_t i = first; i < waves.size(); ++i) k = std::max(k, waves[i].k.norm());
    const int count = static_cast<int>(std::ceil(kPerWave * period * k / (2.0 * kPi)));
    auto samples = std::make_shared<HeightGrid>();
    HeightGrid& grid = *samples;
    grid.columns = grid.rows = count + 2 * kMargin;
    grid.step = Eigen::Vector2d::Constant(period / count);
    grid.first = -kMargin * grid.step;
    const std::size_t n = grid.columns;
    grid.heights.assign(n * n, 0.0);
    std::vector<double> sine(n), cosine(n);
    for (std::size_t i = first; i < waves.size(); ++i) {
      const GroundWave& wave = waves[i];
      for (std::size_t a = 0; a < n; ++a) {
        const double x = wave.k.x() * (grid.first.x() + static_cast<double>(a) * grid.step.x());
        sine[a] = wave.amplitude * std::sin(x);
        cosine[a] = wave.amplitude * std::cos(x);
      }
      for (std::size_t b = 0; b < n; ++b) {
        const double y = wave.k.y() * (grid.first.y() + static_cast<double>(b) * grid.step.y()) + wave.phase;
        const double s = std::sin(y), c = std::cos(y);
        for (std::size_t a = 0; a < n; ++a) grid.heights[b * n + a] += sine[a] * c + cosine[a] * s;
      }
    }
    rough.emplace(std::move(samples));
    rough_bend = rough->largest_bend();
    rough_top = rough->highest();
  }
  void add_rough(const Eigen::Vector2d& place, Height& out) {
    rough->add(
        {place.x() - period * std::floor(place.x() / period), place.y() - period * std::floor(place.y() / period)},
        out);
  }
  double largest_bend(const Eigen::Vector2d& place, double reach) {
    return rough_bend + (site ? site->largest_bend(place, reach) : 0.0);
  }
};

// Rocks by cells of the ground.
struct Terrain::RockCells {
  double cell = 1.0;  // larger than the largest diameter [m]
  std::unordered_map<long, std::vector<int>> at;

  static long key(long i, long j) { return i * 4000037L + j; }
  long index(double x) const { return static_cast<long>(std::floor(x / cell)); }
  template <class Use>
  void each(const std::vector<Sphere>& all, const Eigen::Vector2d& place, double reach, Use use) const {
    const double wide = reach + 0.5 * cell;
    const double across = 2.0 * wide / cell + 2.0;
    if (across * across > static_cast<double>(all.size())) {
      for (std::size_t k = 0; k < all.size(); ++k) use(static_cast<int>(k));
      return;
    }
    for (long j = index(place.y() - wide); j <= index(place.y() + wide); ++j) {
      for (long i = index(place.x() - wide); i <= index(place.x() + wide); ++i) {
        const auto found = at.find(key(i, j));
        if (found == at.end()) continue;
        for (const int k : found->second) use(k);
      }
    }
  }
};

Terrain::Terrain(TerrainParts parts) : parts_(std::move(parts)) {
  const auto random = std::find_if(parts_.waves.begin(), parts_.waves.end(),
                                   [](const GroundWave& wave) { return wave.amplitude == 0.0; });
  if (parts_.map || random != parts_.waves.end()) {
    auto map = std::make_unique<Map>();
    if (parts_.map) map->site.emplace(parts_.map);
    if (random != parts_.waves.end()) {
      map->sample(parts_.waves, static_cast<std::size_t>(random - parts_.waves.begin()) + 1);
      parts_.waves.erase(random, parts_.waves.end());
    }
    map_ = std::move(map);
  }
  in_cells_ =
      map_ && map_->site.has_value() != map_->rough.has_value() && parts_.craters.empty() && parts_.waves.empty();
  if (parts_.map) grain_ = parts_.map->step.minCoeff();
  if (map_ && map_->rough) grain_ = std::min(grain_, map_->rough->grid().step.minCoeff());
  for (const Crater& crater : parts_.craters) grain_ = std::min(grain_, 0.1 * crater.radius);
  for (const GroundWave& wave : parts_.waves) {
    wave_bend_ += std::abs(wave.amplitude) * wave.k.squaredNorm();
    wave_height_ += std::abs(wave.amplitude);
    grain_ = std::min(grain_, kPi / 4.0 / wave.k.norm());
  }
  if (parts_.rocks.empty()) return;
  auto cells = std::make_shared<RockCells>();
  double largest = 0.0;
  for (const Rock& rock : parts_.rocks) {
    const Eigen::Vector2d place = parts_.origin.head<2>() + rock.place;
    const double z = at(place.x(), place.y()).h + (1.0 - 2.0 * rock.buried) * rock.radius;
    spheres_.push_back({{place.x(), place.y(), z}, rock.radius});
    largest = std::max(largest, rock.radius);
  }
  cells->cell = 2.0 * largest;
  for (std::size_t k = 0; k < spheres_.size(); ++k) {
    const Eigen::Vector3d& centre = spheres_[k].centre;
    cells->at[RockCells::key(cells->index(centre.x()), cells->index(centre.y()))].push_back(static_cast<int>(k));
  }
  rock_cells_ = std::move(cells);
}

Terrain::Terrain(const Terrain& other)
    : parts_(other.parts_),
      map_(other.map_ ? std::make_unique<Map>(*other.map_) : nullptr),
      in_cells_(other.in_cells_),
      spheres_(other.spheres_),
      rock_cells_(other.rock_cells_),
      grain_(other.grain_),
      wave_bend_(other.wave_bend_),
      wave_height_(other.wave_height_) {}

Terrain::~Terrain() = default;

Terrain::Height Terrain::at(double x, double y) {
  return at_place(Eigen::Vector2d(x, y) - parts_.origin.head<2>(), true);
}

std::vector<double> Terrain::sketch(const Eigen::Vector2d& first, const Eigen::Vector2d& step,
                                    const Eigen::Vector2i& counts) {
  std::vector<double> out, row;
  const HeightGrid* const grid = map_ && map_->site ? &map_->site->grid() : nullptr;
  const bool nearest = grid != nullptr && (step.array() >= grid->step.array()).all();
  for (int j = 0; j < counts.y(); ++j) {
    const double y = first.y() + j * step.y(), last = first.x() + (counts.x() - 1) * step.x();
    int from = 0, known = -1;
    for (int i = 0; i < counts.x(); ++i) {
      const double x = first.x() + i * step.x();
      if (!nearest || !inside_map(x, y)) {
        out.push_back(at(x, y).h);
        continue;
      }
      const auto sample = [&](double coordinate, int axis) {
        return static_cast<int>(std::lround((coordinate - parts_.origin[axis] - grid->first[axis]) / grid->step[axis]));
      };
      const int column = sample(x, 0), line = sample(y, 1);
      if (line != known) {
        known = line;
        from = column;
        row.resize(static_cast<std::size_t>(std::min(grid->columns - 1, sample(last, 0)) - from + 1));
        grid->read(from, line, static_cast<int>(row.size()), row.data());
      }
      out.push_back(at_place({x - parts_.origin.x(), y - parts_.origin.y()}, false).h + row[column - from]);
    }
  }
  return out;
}

Terrain::Height Terrain::at_place(const Eigen::Vector2d& place, bool with_map) {
  Height out;
  out.h = parts_.origin.z() + parts_.slope.dot(place);
  out.slope = parts_.slope;
  if (map_ && map_->site && with_map) map_->site->add(place, out);
  if (map_ && map_->rough) map_->add_rough(place, out);
  for (const Crater& crater : parts_.craters) {
    const Eigen::Vector2d d = place - crater.centre;
    const double R = crater.radius, square = d.squaredNorm() / (R * R);
    if (square >= 4.0) continue;
    // As a function f of s = u^2: slope 2 f' d / R^2, bend 2 f' / R^2 + 4 f'' d d^T / R^4.
    double by = 0.0, by_by = 0.0;
    if (square <= 1.0) {
      const double deep = crater.depth + crater.rim;
      out.h += -crater.depth + deep * square * (2.0 - square);
      by = 2.0 * deep * (1.0 - square);
      by_by = -2.0 * deep;
    } else {
      const double u = std::sqrt(square), v = u - 1.0, w = 1.0 - v * v;
      out.h += crater.rim * w * w;
      const double f_u = -4.0 * crater.rim * v * w, f_uu = crater.rim * (8.0 * v * v - 4.0 * w);
      by = 0.5 * f_u / u;
      by_by = 0.25 * (f_uu - f_u / u) / square;
    }
    const double R2 = R * R;
    out.slope += (2.0 * by / R2) * d;
    out.bend += Eigen::Vector3d(2.0 * by / R2 + 4.0 * by_by * d.x() * d.x() / (R2 * R2),
                                2.0 * by / R2 + 4.0 * by_by * d.y() * d.y() / (R2 * R2),
                                4.0 * by_by * d.x() * d.y() / (R2 * R2));
  }
  for (const GroundWave& wave : parts_.waves) {
    const double angle = wave.k.dot(place) + wave.phase;
    const double s = wave.amplitude * std::sin(angle), c = wave.amplitude * std::cos(angle);
    out.h += s;
    out.slope += c * wave.k;
    out.bend -= s * Eigen::Vector3d(wave.k.x() * wave.k.x(), wave.k.y() * wave.k.y(), wave.k.x() * wave.k.y());
  }
  return out;
}

double Terrain::top(double x, double y) {
  double top = at(x, y).h;
  if (!rock_cells_) return top;
  const Eigen::Vector2d place(x, y);
  rock_cells_->each(spheres_, place, 0.0, [&](int k) {
    const Sphere& rock = spheres_[k];
    const double left = rock.radius * rock.radius - (rock.centre.head<2>() - place).squaredNorm();
    if (left > 0.0) top = std::max(top, rock.centre.z() + std::sqrt(left));
  });
  return top;
}

namespace {

// dn/dp = -T G^-1 B (G - phi B / |N|)^-1 T^T / |N|,  T = dc/d(x, y), G = T^T T, B = h'', |N| = sqrt(1 + g^2)
Eigen::Matrix3d bend_of_foot(const Eigen::Vector2d& g, const Eigen::Vector3d& bend, double distance) {
  const double length = std::sqrt(1.0 + g.squaredNorm());
  Eigen::Matrix2d B, G;
  B << bend[0], bend[2], bend[2], bend[1];
  G = Eigen::Matrix2d::Identity() + g * g.transpose();
  Eigen::Matrix<double, 3, 2> T;
  T << 1.0, 0.0, 0.0, 1.0, g.x(), g.y();
  const Eigen::Matrix2d turned = G - (distance / length) * B;
  const Eigen::Matrix2d middle = G.inverse() * B * turned.inverse();
  return (-1.0 / length) * T * middle * T.transpose();
}

void write_foot(const Eigen::Vector3d& p, const Eigen::Vector2d& place, const Terrain::Height& here, Terrain::With with,
                Terrain::Foot& out) {
  const Eigen::Vector2d& g = here.slope;
  const Eigen::Vector3d n = Eigen::Vector3d(-g.x(), -g.y(), 1.0) / std::sqrt(1.0 + g.squaredNorm());
  out.normal = n;
  out.distance = n.dot(p - Eigen::Vector3d(place.x(), place.y(), here.h));
  out.place = place;
  out.rock = -1;
  out.sign = 1.0;
  if (with == Terrain::With::kBend) out.bend = bend_of_foot(g, here.bend, out.distance);
}

}  // namespace

// Newton's method for the least distance, from the place `start` at which the field is `here`; false where it ends in no minimum.
bool Terrain::descend(const Eigen::Vector3d& p, const Eigen::Vector2d& start, Height here, With with, Foot& out) {
  Eigen::Vector2d place = start;
  const auto merit = [&](const Eigen::Vector2d& c, double h) {
    return 0.5 * ((c - p.head<2>()).squaredNorm() + (h - p.z()) * (h - p.z()));
  };
  double least = merit(place, here.h);
  bool minimum = false;
  for (int i = 0; i < kFootSteps; ++i) {
    const Eigen::Vector2d g = here.slope;
    const double d = here.h - p.z();
    const Eigen::Vector2d r = place - p.head<2>() + d * g;
    double xx = 1.0 + g.x() * g.x() + d * here.bend[0], xy = g.x() * g.y() + d * here.bend[2],
           yy = 1.0 + g.y() * g.y() + d * here.bend[1];
    double determinant = xx * yy - xy * xy;
    minimum = xx > 0.0 && determinant > 0.0;
    if (!minimum) {
      xx = 1.0 + g.x() * g.x();
      xy = g.x() * g.y();
      yy = 1.0 + g.y() * g.y();
      determinant = xx * yy - xy * xy;
    }
    const Eigen::Vector2d step =
        Eigen::Vector2d(xy * r.y() - yy * r.x(), xy * r.x() - xx * r.y()) * (1.0 / determinant);
    const double size = step.norm();
    if (size <= kFootFound * (place.norm() + std::abs(d) + 1.0)) break;
    if (minimum && size <= kLastFootStep) {  // what the field has beyond these terms is below round-off
      place += step;
      here.h += g.dot(step);
      here.slope += Eigen::Vector2d(here.bend[0] * step.x() + here.bend[2] * step.y(),
                                    here.bend[2] * step.x() + here.bend[1] * step.y());
      break;
    }
    double share = 1.0;
    for (int half = 0; half < 12; ++half, share *= 0.5) {
      const Eigen::Vector2d next = place + share * step;
      const Height there = at(next.x(), next.y());
      const double now = merit(next, there.h);
      if (now > least * (1.0 + 1e-12) + 1e-30 && half < 11) continue;
      place = next;
      here = there;
      least = now;
      break;
    }
  }
  write_foot(p, place, here, with, out);
  return minimum;
}

void Terrain::Feet::add(const Eigen::Vector3d& point) {
  if (count == points.rows()) {  // the new places are on the ground at the origin
    const Eigen::Index room = 2 * count + kMostLanes;
    points.conservativeResizeLike(Eigen::ArrayX3d::Zero(room, 3));
    distance.setZero(room);
    normal.setZero(room, 3);
    place.setZero(room, 2);
    near.resize(static_cast<std::size_t>(room));
  }
  points.row(count++) = point.transpose();
}

Terrain::Foot Terrain::Feet::of(int k, With with) const {
  Foot out;
  out.distance = distance[k];
  out.normal = normal.row(k).transpose();
  out.place = place.row(k).transpose();
  if (with == With::kBend) out.bend = bend[k];
  return out;
}

// Of one map or roughness alone, with the slope, in its cells.
void Terrain::find_feet(Feet& feet, bool only_below, With with) {
  if (!in_cells_) {
    std::fill_n(feet.near.begin(), feet.count, Near::kElsewhere);
    return;
  }
  SplineGrid::Frame frame{parts_.origin, parts_.slope};
  if (map_->rough) frame.period = map_->period;
  SplineGrid& cells = map_->rough ? *map_->rough : *map_->site;
  if (with == With::kNormal) return cells.find_feet(frame, only_below, feet, nullptr);
  std::vector<Height> at(static_cast<std::size_t>(feet.count));
  cells.find_feet(frame, only_below, feet, at.data());
  feet.bend.resize(at.size());
  for (std::size_t k = 0; k < at.size(); ++k)
    if (feet.near[k] == Near::kFoot)
      feet.bend[k] = bend_of_foot(at[k].slope, at[k].bend, feet.distance[static_cast<Eigen::Index>(k)]);
}

// false: by descend(), which has ended in no minimum.
bool Terrain::find_foot(const Eigen::Vector3d& p, Foot& out) {
  one_.clear();
  one_.add(p);
  find_feet(one_, false, With::kBend);
  if (one_.near[0] != Near::kFoot) return descend(p, p.head<2>(), at(p.x(), p.y()), With::kBend, out);
  out = one_.of(0, With::kBend);
  return true;
}

Terrain::Foot Terrain::foot(const Eigen::Vector3d& p) {
  Foot out;
  find_foot(p, out);
  return out;
}

void Terrain::below(Feet& feet, With with) {
  find_feet(feet, true, with);
  Foot foot;
  for (int k = 0; k < feet.count; ++k) {
    Near& near = feet.near[k];
    if (near != Near::kElsewhere) continue;
    const Eigen::Vector3d p = feet.points.row(k);
    const Height here = at(p.x(), p.y());
    near = p.z() > here.h + kAboveField ? Near::kAbove : Near::kFoot;
    if (near == Near::kAbove) continue;
    descend(p, p.head<2>(), here, with, foot);
    feet.distance[k] = foot.distance;
    feet.normal.row(k) = foot.normal.transpose();
    feet.place.row(k) = foot.place.transpose();
    if (with == With::kBend) {
      feet.bend.resize(static_cast<std::size_t>(feet.count));
      feet.bend[k] = foot.bend;
    }
  }
}

bool Terrain::may_touch(const Eigen::Vector3d& p, double radius) {
  const Height here = at(p.x(), p.y());
  const double clear = p.z() - here.h - radius * std::sqrt(1.0 + here.slope.squaredNorm());
  return clear <= kAboveField || clear <= kAboveField + 0.5 * bend_within(p.head<2>(), radius) * radius * radius;
}

Terrain::Foot Terrain::foot(const Eigen::Vector3d& p, int rock) const {
  const Sphere& sphere = spheres_[rock];
  Foot out;
  const Eigen::Vector3d d = p - sphere.centre;
  const double size = std::max(d.norm(), 1e-14);
  out.rock = rock;
  out.distance = size - sphere.radius;
  out.normal = d / size;
  out.bend = (Eigen::Matrix3d::Identity() - out.normal * out.normal.transpose()) / size;
  out.place = sphere.centre.head<2>() + sphere.radius * out.normal.head<2>();
  return out;
}

void Terrain::feet(const Eigen::Vector3d& p, double radius, std::vector<Foot>& out) {
  out.clear();
  Foot one;
  const bool good = find_foot(p, one);
  const double bend = radius == 0.0 ? 0.0 : bend_within(p.head<2>(), 2.0 * radius);
  if (radius == 0.0 || one.distance <= 0.0 || radius * bend < kBowl) {
    out.push_back(one);
    return;
  }
  find_all(p, radius, out);
  if (out.empty() && good && one.distance < radius) out.push_back(one);
}

// Newton's method for any place at which the distance is stationary, not farther than `reach` from the start:
//   r = (x, y)_c - (x, y)_p + (h - z_p) h' = 0
bool Terrain::stationary(const Eigen::Vector3d& p, const Eigen::Vector2d& start, double reach, Foot& out) {
  Eigen::Vector2d place = start;
  for (int i = 0; i < kFootSteps; ++i) {
    const Height here = at(place.x(), place.y());
    const Eigen::Vector2d& g = here.slope;
    const double d = here.h - p.z();
    const Eigen::Vector2d r = place - p.head<2>() + d * g;
    const double xx = 1.0 + g.x() * g.x() + d * here.bend[0], xy = g.x() * g.y() + d * here.bend[2],
                 yy = 1.0 + g.y() * g.y() + d * here.bend[1];
    const double determinant = xx * yy - xy * xy;
    if (determinant == 0.0) return false;
    Eigen::Vector2d step = Eigen::Vector2d(xy * r.y() - yy * r.x(), xy * r.x() - xx * r.y()) / determinant;
    const double size = step.norm();
    if (size <= kFootFound * (place.norm() + std::abs(d) + 1.0)) {
      write_foot(p, place, here, With::kBend, out);
      out.sign = determinant > 0.0 ? 1.0 : -1.0;
      return true;
    }
    if (size > 0.5 * reach) step *= 0.5 * reach / size;
    place += step;
    if (!((place - start).norm() <= reach)) return false;
  }
  return false;
}

// In cells about p, the cells of a map: a cell may hold such a place if neither part of r (see above) is farther from zero at its corners than
// its derivatives there let it come; then its quarters may, and so on. In a cell of a map second derivatives are largest at its corners.
void Terrain::find_all(const Eigen::Vector3d& p, double radius, std::vector<Foot>& out) {
  Eigen::Vector2d cell = Eigen::Vector2d::Constant(radius / 12.0), first = p.head<2>();
  if (parts_.map) {
    const double coarser = std::ceil(2.0 * radius / kMostPlaces / parts_.map->step.minCoeff());
    cell = std::max(1.0, coarser) * parts_.map->step;
    first = parts_.origin.head<2>() + parts_.map->first;
  }
  struct CellCorner {
    Eigen::Array2d r, more_x, more_y;  // more: bounds of the derivatives of r
    double square, steep;
  };
  const auto corner_at = [&](const Eigen::Vector2d& place) {
    const Height here = at(place.x(), place.y());
    const Eigen::Vector2d away = place - p.head<2>();
    const Eigen::Vector2d& g = here.slope;
    const double d = here.h - p.z(), across = std::abs(g.x() * g.y()) + std::abs(d * here.bend[2]);
    return CellCorner{(away + d * g).array(),
                      {1.0 + g.x() * g.x() + std::abs(d * here.bend[0]), across},
                      {across, 1.0 + g.y() * g.y() + std::abs(d * here.bend[1])},
                      away.squaredNorm() + d * d,
                      g.norm()};
  };
  using Cell = std::array<CellCorner, 4>;
  Foot one;
  const auto search = [&](const auto& self, const Eigen::Vector2d& low_end, const Cell& at_corners,
                          const Eigen::Vector2d& size, int level) -> void {
    Eigen::Array2d low = at_corners[0].r, high = low, more_x(0.0, 0.0), more_y = more_x;
    double square = at_corners[0].square, steep = 0.0;
    for (const CellCorner& corner : at_corners) {
      low = low.min(corner.r);
      high = high.max(corner.r);
      more_x = more_x.max(corner.more_x);
      more_y = more_y.max(corner.more_y);
      square = std::min(square, corner.square);
      steep = std::max(steep, corner.steep);
    }
    const double far = radius + size.norm() * (1.0 + steep);  // a corner of a cell that holds a contact is nearer
    if (square > far * far) return;
    const Eigen::Array2d half = 0.5 * size.array();
    const Eigen::Array2d may =
        level == kLevels ? Eigen::Array2d(0.0, 0.0) : Eigen::Array2d((more_x * half).sum(), (more_y * half).sum());
    if ((low > may).any() || (high < -may).any()) return;
    if (level == kLevels) {
      if (!stationary(p, low_end + 0.5 * size, 2.0 * size.norm(), one)) return;
      if (!(one.distance > 0.0 && one.distance < radius)) return;
      const bool known = std::any_of(out.begin(), out.end(), [&](const Foot& other) {
        return other.sign == one.sign && (other.place - one.place).norm() < 1e-7 * radius;
      });
      if (!known) out.push_back(one);
      return;
    }
    const auto inner = [&](double x, double y) {
      return corner_at(low_end + Eigen::Vector2d(x * size.x(), y * size.y()));
    };
    const CellCorner south = inner(0.5, 0.0), west = inner(0.0, 0.5), middle = inner(0.5, 0.5), east = inner(1.0, 0.5),
                     north = inner(0.5, 1.0);
    const Eigen::Vector2d quarter = 0.5 * size, x(quarter.x(), 0.0), y(0.0, quarter.y());
    self(self, low_end, {at_corners[0], south, west, middle}, quarter, level + 1);
    self(self, low_end + x, {south, at_corners[1], middle, east}, quarter, level + 1);
    self(self, low_end + y, {west, middle, at_corners[2], north}, quarter, level + 1);
    self(self, low_end + quarter, {middle, east, north, at_corners[3]}, quarter, level + 1);
  };
  const auto index = [&](double x, int axis) { return std::floor((x - first[axis]) / (kBlock * cell[axis])); };
  const Eigen::Vector2d block = kBlock * cell;
  std::array<std::array<CellCorner, kBlock + 1>, kBlock + 1> corners;
  for (double b = index(p.y() - radius, 1); b <= index(p.y() + radius, 1); b += 1.0) {
    for (double a = index(p.x() - radius, 0); a <= index(p.x() + radius, 0); a += 1.0) {
      const Eigen::Vector2d low_end = first + Eigen::Vector2d(a * block.x(), b * block.y()),
                            centre = low_end + 0.5 * block;
      const double reach = 0.5 * block.norm();
      const Height middle = at(centre.x(), centre.y());
      const double top = middle.h + reach * (middle.slope.norm() + 0.5 * reach * bend_within(centre, reach));
      const double across = ((centre - p.head<2>()).cwiseAbs() - 0.5 * block).cwiseMax(0.0).norm();
      if (std::hypot(across, std::max(0.0, p.z() - top)) > radius) continue;
      const auto corner_of = [&](std::size_t i, std::size_t j) -> Eigen::Vector2d {
        return low_end + Eigen::Vector2d(static_cast<double>(i) * cell.x(), static_cast<double>(j) * cell.y());
      };
      for (std::size_t j = 0; j <= kBlock; ++j)
        for (std::size_t i = 0; i <= kBlock; ++i) corners[j][i] = corner_at(corner_of(i, j));
      for (std::size_t j = 0; j < kBlock; ++j)
        for (std::size_t i = 0; i < kBlock; ++i)
          search(search, corner_of(i, j), {corners[j][i], corners[j][i + 1], corners[j + 1][i], corners[j + 1][i + 1]},
                 cell, 0);
    }
  }
  std::sort(out.begin(), out.end(), [](const Foot& a, const Foot& b) { return a.distance < b.distance; });
}

double Terrain::distance(const Eigen::Vector3d& p) {
  double least = foot(p).distance;
  if (rock_cells_)
    for (const Sphere& rock : spheres_) least = std::min(least, (p - rock.centre).norm() - rock.radius);
  return least;
}

double Terrain::bend_within(const Eigen::Vector2d& place_W, double reach) {
  const Eigen::Vector2d place = place_W - parts_.origin.head<2>();
  double bend = wave_bend_;
  if (map_) bend += map_->largest_bend(place, reach);
  for (const Crater& crater : parts_.craters) {
    const double away = (place - crater.centre).norm() - 1.5 * reach;
    // Within: 4 (depth + rim) / R^2 (1 - s) + 8 (depth + rim) s / R^2; outside 8 rim / R^2.
    if (away < 2.0 * crater.radius) bend += 8.0 * (crater.depth + crater.rim) / (crater.radius * crater.radius);
  }
  return bend;
}

double Terrain::top_within(const Eigen::Vector2d& place_W, double reach) {
  const Eigen::Vector2d place = place_W - parts_.origin.head<2>();
  double top = parts_.origin.z() + parts_.slope.dot(place) + parts_.slope.norm() * reach + wave_height_;
  if (map_) top += map_->rough_top + (map_->site ? map_->site->highest(place, reach) : 0.0);
  for (const Crater& crater : parts_.craters)
    if ((place - crater.centre).norm() < 2.0 * crater.radius + reach) top += crater.rim;
  return top;
}

Terrain::Lid Terrain::lid(const Eigen::Vector3d& centre, double reach) {
  Lid out;
  const Height here = at(centre.x(), centre.y());
  out.height = here.h;
  out.slope = here.slope;
  out.bend = bend_within(centre.head<2>(), reach);
  out.top = top_within(centre.head<2>(), reach) + kAboveField;
  if (rock_cells_)
    rock_cells_->each(spheres_, centre.head<2>(), reach, [&](int k) {
      const Sphere& rock = spheres_[k];
      if ((rock.centre - centre).norm() < rock.radius + reach) out.rocks.push_back(k);
    });
  std::sort(out.rocks.begin(), out.rocks.end());
  return out;
}

double Terrain::plane_above(const Eigen::Vector2d& centre, double reach, const Eigen::Vector2d& slope) {
  if (!in_cells_ || map_->rough) return std::numeric_limits<double>::infinity();
  const Eigen::Vector2d place = centre - parts_.origin.head<2>();
  return parts_.origin.z() + parts_.slope.dot(place) + map_->site->highest(place, reach, slope - parts_.slope);
}

bool Terrain::Lid::above(const Eigen::Vector3d& centre, double reach) const {
  return (centre.z() - height - 0.5 * bend * reach * reach) > reach * std::sqrt(1.0 + slope.squaredNorm());
}

bool Terrain::inside_map(double x, double y) const {
  if (!map_ || !map_->site) return true;
  const HeightGrid& map = map_->site->grid();
  const Eigen::Vector2d u = (Eigen::Vector2d(x, y) - parts_.origin.head<2>() - map.first).cwiseQuotient(map.step);
  return u.minCoeff() >= 0.0 && u.x() <= map.columns - 1 && u.y() <= map.rows - 1;
}

}  // namespace footfall
