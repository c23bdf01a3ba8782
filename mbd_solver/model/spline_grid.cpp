// Several places are computed at once, each in its cell, where the field is a polynomial. Coefficients are stored for whole tiles.

#include "mbd_solver/model/spline_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/base/lanes.h"

namespace footfall {
namespace {

constexpr int kPart = 16;  // cells of a map along each side of a part, of which a bound of the bends is known
constexpr int kTile = 64;  // cells along each side of a tile, of which the coefficients are found at once
constexpr int kFade = 32;  // samples around a tile that have a share in its coefficients: the next has 0.27^32 = 5e-19

// From four coefficients of the spline to the powers of the place between them.
template <class Real>
FOOTFALL_IN_LINE void from_spline(Real& a, Real& b, Real& c, Real& d) {
  const Real low = a - 2.0 * b + c, high = b - 2.0 * c + d, slope = 0.5 * (c - a);
  a = b + (1.0 / 6.0) * low;
  b = slope;
  c = 0.5 * low;
  d = (1.0 / 6.0) * (high - low);
}
// Of a cubic of these powers: the value, its first and half its second derivative.
template <class Real>
FOOTFALL_IN_LINE void evaluate(const Real& x, const Real& a, const Real& b, const Real& c, const Real& d, Real* out) {
  const Real last = x * d;
  out[0] = a + x * (b + x * (c + last));
  out[1] = b + x * (2.0 * c + 3.0 * last);
  out[2] = c + 3.0 * last;
}
// From four numbers of each place, out[number] of all places.
using Four = Lanes<4>::Real;
FOOTFALL_IN_LINE void transpose(const double* const* from, Lanes<4>::Real* out) {
  Four c[4];
  for (int k = 0; k < 4; ++k) std::memcpy(&c[k], from[k], sizeof(Four));
  const Four a = __builtin_shufflevector(c[0], c[1], 0, 4, 2, 6), b = __builtin_shufflevector(c[0], c[1], 1, 5, 3, 7),
             d = __builtin_shufflevector(c[2], c[3], 0, 4, 2, 6), e = __builtin_shufflevector(c[2], c[3], 1, 5, 3, 7);
  out[0] = __builtin_shufflevector(a, d, 0, 1, 4, 5);
  out[1] = __builtin_shufflevector(b, e, 0, 1, 4, 5);
  out[2] = __builtin_shufflevector(a, d, 2, 3, 6, 7);
  out[3] = __builtin_shufflevector(b, e, 2, 3, 6, 7);
}
FOOTFALL_IN_LINE void transpose(const double* const* from, Lanes<8>::Real* out) {
  Four low[4], high[4];
  transpose(from, low);
  transpose(from + 4, high);
  for (int k = 0; k < 4; ++k) out[k] = __builtin_shufflevector(low[k], high[k], 0, 1, 2, 3, 4, 5, 6, 7);
}

}  // namespace

struct SplineGrid::Tile {
  int stride = 0;         // coefficients in a row: one more than cells on the left, two on the right
  std::vector<double> c;  // row after row
  std::array<double, (kTile / kPart) * (kTile / kPart)> bend{};  // of each part, largest [1/m]
  std::array<double, (kTile / kPart) * (kTile / kPart)>
      top{};  // of its coefficients, largest: none of its places is higher [m]
};

namespace {

// Places in cells of a map, which is a polynomial in each.
template <class L>
struct CellPlaces {
  typename L::Real x, y;                // in cells, from 0 to 1
  typename L::Real beyond_x, beyond_y;  // the edge of the map [cells]
  typename L::Real c[16];               // c[4 j + i]: the factor of x^i y^j
};

// Along one axis, from the first sample on [cells].
template <class L>
FOOTFALL_IN_LINE void find_cells(const typename L::Real& u, int samples, typename L::Ints& cell,
                                 typename L::Real& within, typename L::Real& beyond) {
  const typename L::Real none = L::all(0.0), most = L::all(samples - 1);
  typename L::Real inside = u > 0.0 ? u : none;  // also of what is not a number: no place
  inside = inside > most ? most : inside;
  cell = __builtin_convertvector(inside, typename L::Ints);
  cell -= (cell == samples - 1) & 1;
  within = inside - __builtin_convertvector(cell, typename L::Real);
  beyond = u - inside;
}

template <class L>
FOOTFALL_IN_LINE void find_places(SplineGrid& map, const typename L::Real& x, const typename L::Real& y,
                                  CellPlaces<L>& at) {
  const HeightGrid& grid = map.grid();
  typename L::Ints i, j;
  find_cells<L>((x - grid.first.x()) * map.by().x(), grid.columns, i, at.x, at.beyond_x);
  find_cells<L>((y - grid.first.y()) * map.by().y(), grid.rows, j, at.y, at.beyond_y);
  const double* rows[4][L::kCount];
  for (int k = 0; k < L::kCount; ++k) {
    const auto column = static_cast<unsigned>(i[k]), row = static_cast<unsigned>(j[k]);
    const SplineGrid::Tile& tile = map.tile(static_cast<int>(column / kTile), static_cast<int>(row / kTile));
    rows[0][k] = &tile.c[(row % kTile) * static_cast<unsigned>(tile.stride) + column % kTile];
    for (int n = 1; n < 4; ++n) rows[n][k] = rows[n - 1][k] + tile.stride;
  }
  for (int n = 0; n < 4; ++n) {
    typename L::Real* const c = at.c + 4 * n;
    transpose(rows[n], c);
    from_spline(c[0], c[1], c[2], c[3]);
  }
  for (int n = 0; n < 4; ++n) from_spline(at.c[n], at.c[4 + n], at.c[8 + n], at.c[12 + n]);
}

// f[i][j]: the derivative, i times along x and j along y; half of it where i or j is two, a quarter where both are.
template <class L>
FOOTFALL_IN_LINE void evaluate(const CellPlaces<L>& at, const typename L::Real& x, const typename L::Real& y,
                               typename L::Real (*f)[3]) {
  typename L::Real along[4][3];
  for (int j = 0; j < 4; ++j) {
    const typename L::Real* const c = at.c + 4 * j;
    evaluate(x, c[0], c[1], c[2], c[3], along[j]);
  }
  for (int i = 0; i < 3; ++i) evaluate(y, along[0][i], along[1][i], along[2][i], along[3][i], f[i]);
}

// Beyond an edge nothing bends across it.
FOOTFALL_IN_LINE void add_height(SplineGrid& map, double place_x, double place_y, Terrain::Height& out) {
  using L = Lanes<4>;
  const double by_x = map.by().x(), by_y = map.by().y();
  CellPlaces<L> at;
  find_places<L>(map, L::all(place_x), L::all(place_y), at);
  L::Real f[3][3];
  evaluate<L>(at, at.x, at.y, f);
  const double x = at.beyond_x[0], y = at.beyond_y[0];
  out.h += f[0][0][0] + x * f[1][0][0] + y * (f[0][1][0] + x * f[1][1][0]);
  out.slope.x() += (f[1][0][0] + y * f[1][1][0]) * by_x;
  out.slope.y() += (f[0][1][0] + x * f[1][1][0]) * by_y;
  out.bend[0] += x != 0.0 ? 0.0 : (f[2][0][0] + y * f[2][1][0]) * (2.0 * by_x * by_x);
  out.bend[1] += y != 0.0 ? 0.0 : (f[0][2][0] + x * f[1][2][0]) * (2.0 * by_y * by_y);
  out.bend[2] += f[1][1][0] * (by_x * by_y);
}

// Newton's method of Terrain::descend(), each point for itself: from step to step most stay in their cells.
template <class L>
FOOTFALL_IN_LINE void find_feet(SplineGrid& map, const SplineGrid::Frame& frame, bool only_below, Terrain::Feet& feet,
                                Terrain::Height* fields) {
  using Real = typename L::Real;
  using Mask = typename L::Mask;
  const double slope_x = frame.slope.x(), slope_y = frame.slope.y(), by_x = map.by().x(), by_y = map.by().y();
  for (int first = 0; first < feet.count; first += L::kCount) {
    const typename L::Vector p = L::load(feet.points.data() + first, feet.points.rows());
    Real place_x = p.x - frame.origin.x(), place_y = p.y - frame.origin.y();
    const Real height = frame.origin.z() + slope_x * place_x + slope_y * place_y;
    if (!std::isinf(frame.period)) {
      place_x -= frame.period * L::floor(place_x / frame.period);
      place_y -= frame.period * L::floor(place_y / frame.period);
    }
    CellPlaces<L> at;
    Real x = L::all(0.0), y = x, least = x, h_out = x, x_out = x, y_out = x, gx_out = x, gy_out = x;
    Real xx_out = x, yy_out = x, xy_out = x;
    Mask open = x == x, above = ~open, found = above, moved = open;  // moved: to another cell
    for (int i = 0; i < kFootSteps && L::any(open); ++i) {
      if (i == 0) {
        find_places<L>(map, place_x, place_y, at);
        open = (at.beyond_x == 0.0) & (at.beyond_y == 0.0);
        for (int k = feet.count - first; k < L::kCount; ++k) open[k] = 0;
      } else if (L::any(moved)) {
        CellPlaces<L> to;
        find_places<L>(map, place_x + x, place_y + y, to);
        at.x = moved ? to.x - x * by_x : at.x;
        at.y = moved ? to.y - y * by_y : at.y;
        for (int k = 0; k < 16; ++k) at.c[k] = moved ? to.c[k] : at.c[k];
        open &= ~moved | ((to.beyond_x == 0.0) & (to.beyond_y == 0.0));
      }
      Real f[3][3];
      evaluate<L>(at, at.x + x * by_x, at.y + y * by_y, f);
      const Real h = height + slope_x * x + slope_y * y + f[0][0], d = h - p.z;
      const Real g_x = slope_x + f[1][0] * by_x, g_y = slope_y + f[0][1] * by_y;
      const Real h_xx = f[2][0] * (2.0 * by_x * by_x), h_yy = f[0][2] * (2.0 * by_y * by_y),
                 h_xy = f[1][1] * (by_x * by_y);
      const Real merit = x * x + y * y + d * d;
      if (i > 0) {
        open &= merit <= least * (1.0 + 1e-12) + 1e-30;
      } else if (only_below) {
        above = open & (d < -kAboveField);
        open &= ~above;
      }
      least = merit;
      const Real r_x = x + d * g_x, r_y = y + d * g_y;
      const Real xx = 1.0 + g_x * g_x + d * h_xx, xy = g_x * g_y + d * h_xy, yy = 1.0 + g_y * g_y + d * h_yy;
      const Real determinant = xx * yy - xy * xy, inverse = 1.0 / determinant;
      open &= (xx > 0.0) & (determinant > 0.0);
      const Real s_x = (xy * r_y - yy * r_x) * inverse, s_y = (xy * r_x - xx * r_y) * inverse;
      x += s_x;
      y += s_y;
      // What the field has beyond these terms of a last step is below round-off.
      const Mask last = open & (s_x * s_x + s_y * s_y <= kLastFootStep * kLastFootStep);
      if (L::any(last)) {
        x_out = last ? x : x_out;
        y_out = last ? y : y_out;
        h_out = last ? h + g_x * s_x + g_y * s_y : h_out;
        gx_out = last ? g_x + h_xx * s_x + h_xy * s_y : gx_out;
        gy_out = last ? g_y + h_xy * s_x + h_yy * s_y : gy_out;
        xx_out = last ? h_xx : xx_out;
        yy_out = last ? h_yy : yy_out;
        xy_out = last ? h_xy : xy_out;
      }
      found |= last;
      const Real to_x = at.x + x * by_x, to_y = at.y + y * by_y;
      open &= ~last;
      moved = open & ~((to_x >= 0.0) & (to_x <= 1.0) & (to_y >= 0.0) & (to_y <= 1.0));
    }
    const Real n_z = 1.0 / L::square_root(1.0 + gx_out * gx_out + gy_out * gy_out);
    L::store((gx_out * x_out + gy_out * y_out + (p.z - h_out)) * n_z, feet.distance.data() + first);
    L::store({-gx_out * n_z, -gy_out * n_z, n_z}, feet.normal.data() + first, feet.normal.rows());
    L::store(p.x + x_out, feet.place.data() + first);
    L::store(p.y + y_out, feet.place.data() + feet.place.rows() + first);
    for (int k = 0; k < L::kCount && first + k < feet.count; ++k) {
      feet.near[first + k] = found[k]   ? Terrain::Near::kFoot
                             : above[k] ? Terrain::Near::kAbove
                                        : Terrain::Near::kElsewhere;
      if (fields != nullptr) fields[first + k] = {h_out[k], {gx_out[k], gy_out[k]}, {xx_out[k], yy_out[k], xy_out[k]}};
    }
  }
}

struct AddHeight {
  template <class L>
  static FOOTFALL_IN_LINE void run(SplineGrid& map, double x, double y, Terrain::Height& out) {
    add_height(map, x, y, out);
  }
};
struct FindFeet {
  template <class L>
  static FOOTFALL_IN_LINE void run(SplineGrid& map, const SplineGrid::Frame& frame, bool only_below,
                                   Terrain::Feet& feet, Terrain::Height* fields) {
    find_feet<L>(map, frame, only_below, feet, fields);
  }
};
const auto kAddHeight = BestLanes<AddHeight, SplineGrid&, double, double, Terrain::Height&>::choose();
const auto kFindFeet =
    BestLanes<FindFeet, SplineGrid&, const SplineGrid::Frame&, bool, Terrain::Feet&, Terrain::Height*>::choose();

// Rows of `wide` numbers each, of which the first and the last are beyond the ends: from samples f_1 ... f_n in each of `count` columns
// in place to the coefficients of a cubic B-spline through them: f_i = (c_i-1 + 4 c_i + c_i+1) / 6, no second derivative at the ends.
void find_coefficients(double* rows, int samples, std::ptrdiff_t wide, int count) {
  std::vector<double> factor(static_cast<std::size_t>(samples), 0.0);
  for (int i = 2; i < samples; ++i) {
    const double pivot = factor[i] = 1.0 / (4.0 - factor[i - 1]);
    double* const here = rows + i * wide;
    for (int k = 0; k < count; ++k) here[k] = (6.0 * here[k] - (here - wide)[k]) * pivot;
  }
  for (int i = samples - 1; i >= 2; --i) {
    double* const here = rows + i * wide;
    for (int k = 0; k < count; ++k) here[k] -= factor[i] * (here + wide)[k];
  }
  double* const last = rows + samples * wide;
  for (int k = 0; k < count; ++k) {
    rows[k] = 2.0 * (rows + wide)[k] - (rows + 2 * wide)[k];
    (last + wide)[k] = 2.0 * last[k] - (last - wide)[k];
  }
}

}  // namespace

SplineGrid::SplineGrid(std::shared_ptr<const HeightGrid> samples) : grid_(std::move(samples)) {
  const HeightGrid& grid = *grid_;
  FOOTFALL_DEMAND(grid.columns >= 2 && grid.rows >= 2 && grid.step.minCoeff() > 0.0);
  tiles_x_ = (grid.columns - 2) / kTile + 1;
  tiles_y_ = (grid.rows - 2) / kTile + 1;
  parts_x_ = (grid.columns - 2) / kPart + 1;
  parts_y_ = (grid.rows - 2) / kPart + 1;
  by_ = grid.step.cwiseInverse();
  tiles_.resize(static_cast<std::size_t>(tiles_x_) * static_cast<std::size_t>(tiles_y_));
}

void SplineGrid::add(const Eigen::Vector2d& place, Terrain::Height& out) {
  kAddHeight(*this, place.x(), place.y(), out);
}

void SplineGrid::find_feet(const Frame& frame, bool only_below, Terrain::Feet& feet, Terrain::Height* at) {
  kFindFeet(*this, frame, only_below, feet, at);
}

template <class Use>
void SplineGrid::each_part(const Eigen::Vector2d& place, double reach, Use use) {
  const HeightGrid& grid = *grid_;
  const auto part = [&](double x, int axis, int parts) {
    const double t = (x - grid.first[axis]) / grid.step[axis] / kPart;
    return static_cast<int>(t > 0.0 ? std::min(t, static_cast<double>(parts - 1)) : 0.0);
  };
  constexpr int kAcross = kTile / kPart;
  const int a_0 = part(place.x() - reach, 0, parts_x_), a_1 = part(place.x() + reach, 0, parts_x_);
  const int b_0 = part(place.y() - reach, 1, parts_y_), b_1 = part(place.y() + reach, 1, parts_y_);
  for (int b = b_0; b <= b_1; ++b)
    for (int a = a_0; a <= a_1; ++a)
      use(tile(a / kAcross, b / kAcross), static_cast<std::size_t>((b % kAcross) * kAcross + a % kAcross));
}

double SplineGrid::largest_bend(const Eigen::Vector2d& place, double reach) {
  double largest = 0.0;
  each_part(place, reach, [&](const Tile& here, std::size_t part) { largest = std::max(largest, here.bend[part]); });
  return largest;
}
double SplineGrid::largest_bend() {
  double largest = 0.0;
  for (int b = 0; b < tiles_y_; ++b)
    for (int a = 0; a < tiles_x_; ++a)
      for (const double bend : tile(a, b).bend) largest = std::max(largest, bend);
  return largest;
}

double SplineGrid::highest(const Eigen::Vector2d& place, double reach) {
  const Eigen::Array2d u = (place - grid_->first).array() / grid_->step.array(), wide = reach / grid_->step.array();
  if ((u - wide).minCoeff() < 0.0 || (u + wide)[0] > grid_->columns - 1 || (u + wide)[1] > grid_->rows - 1)
    return std::numeric_limits<double>::infinity();
  double highest = -std::numeric_limits<double>::infinity();
  each_part(place, reach, [&](const Tile& here, std::size_t part) { highest = std::max(highest, here.top[part]); });
  return highest;
}
double SplineGrid::highest() {
  double highest = -std::numeric_limits<double>::infinity();
  for (int b = 0; b < tiles_y_; ++b)
    for (int a = 0; a < tiles_x_; ++a)
      for (const double top : tile(a, b).top) highest = std::max(highest, top);
  return highest;
}

// The spline is a mean of the coefficients around, and so is any plane of its values at their places.
double SplineGrid::highest(const Eigen::Vector2d& place, double reach, const Eigen::Vector2d& slope) {
  constexpr double kMost = 40000.0;  // coefficients
  const HeightGrid& grid = *grid_;
  const Eigen::Array2d u = (place - grid.first).array() * by_.array(), wide = reach * by_.array();
  const Eigen::Array2d low = (u - wide).floor(), high = (u + wide).floor();
  if (!(low.minCoeff() >= 0.0 && (u + wide)[0] <= grid.columns - 1 && (u + wide)[1] <= grid.rows - 1 &&
        (high - low + 4.0).prod() <= kMost))
    return std::numeric_limits<double>::infinity();
  double most = -std::numeric_limits<double>::infinity();
  for (int j = static_cast<int>(low[1]) - 1; j <= std::min(static_cast<int>(high[1]) + 2, grid.rows); ++j) {
    const int b = std::min(std::max(j, 0) / kTile, tiles_y_ - 1);
    for (int i = static_cast<int>(low[0]) - 1; i <= std::min(static_cast<int>(high[0]) + 2, grid.columns); ++i) {
      const int a = std::min(std::max(i, 0) / kTile, tiles_x_ - 1);
      const Tile& from = tile(a, b);
      const double c = from.c[(j - b * kTile + 1) * from.stride + i - a * kTile + 1];
      const Eigen::Vector2d away = grid.first + Eigen::Vector2d(i * grid.step.x(), j * grid.step.y()) - place;
      most = std::max(most, c - slope.dot(away));
    }
  }
  return most;
}

const SplineGrid::Tile& SplineGrid::make_tile(int a, int b) {
  const HeightGrid& grid = *grid_;
  const int i_0 = a * kTile, i_1 = std::min(i_0 + kTile, grid.columns - 1);  // samples at its edges
  const int j_0 = b * kTile, j_1 = std::min(j_0 + kTile, grid.rows - 1);
  const int left = std::max(0, i_0 - kFade), right = std::min(grid.columns - 1, i_1 + kFade);
  const int low = std::max(0, j_0 - kFade), high = std::min(grid.rows - 1, j_1 + kFade);
  const int columns = right - left + 1, rows = high - low + 1, inner = i_1 - i_0 + 3;
  // Turned first, so that along both axes whole rows are computed at once.
  std::vector<double> row(static_cast<std::size_t>(columns)),
      turned(static_cast<std::size_t>(columns + 2) * static_cast<std::size_t>(rows)),
      all(static_cast<std::size_t>(rows + 2) * static_cast<std::size_t>(inner));
  for (int j = 0; j < rows; ++j) {
    grid.read(left, low + j, columns, row.data());
    for (int i = 0; i < columns; ++i)
      turned[static_cast<std::size_t>(i + 1) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(j)] = row[i];
  }
  find_coefficients(turned.data(), columns, rows, rows);
  const auto of = [&](int i, int j) -> double& {  // coefficient i, j of the map
    return all[static_cast<std::size_t>(j - low + 1) * static_cast<std::size_t>(inner) +
               static_cast<std::size_t>(i - i_0 + 1)];
  };
  for (int j = 0; j < rows; ++j)
    for (int i = i_0 - 1; i <= i_1 + 1; ++i)
      of(i, low + j) =
          turned[static_cast<std::size_t>(i - left + 1) * static_cast<std::size_t>(rows) + static_cast<std::size_t>(j)];
  find_coefficients(all.data(), rows, inner, inner);

  auto tile = std::make_shared<Tile>();
  tile->stride = inner;
  tile->c.reserve(static_cast<std::size_t>(tile->stride) * static_cast<std::size_t>(j_1 - j_0 + 3));
  for (int j = j_0 - 1; j <= j_1 + 1; ++j)
    for (int i = i_0 - 1; i <= i_1 + 1; ++i) tile->c.push_back(of(i, j));
  // A second derivative is between those differences of the coefficients around it.
  const double xx = 1.0 / (grid.step.x() * grid.step.x()), yy = 1.0 / (grid.step.y() * grid.step.y()),
               xy = 1.0 / (grid.step.x() * grid.step.y());
  std::size_t part = 0;
  for (int y = j_0; y < j_0 + kTile; y += kPart) {
    for (int x = i_0; x < i_0 + kTile; x += kPart, ++part) {
      const int x_1 = std::min(x + kPart, i_1), y_1 = std::min(y + kPart, j_1);
      double h_xx = 0.0, h_yy = 0.0, h_xy = 0.0, top = -std::numeric_limits<double>::infinity();
      for (int j = y - 1; j <= y_1 + 1 && x < i_1 && y < j_1; ++j) {
        for (int i = x - 1; i <= x_1 + 1; ++i) {
          const double here = of(i, j);
          top = std::max(top, here);
          if (i >= x && i <= x_1) h_xx = std::max(h_xx, std::abs(of(i - 1, j) - 2.0 * here + of(i + 1, j)));
          if (j >= y && j <= y_1) h_yy = std::max(h_yy, std::abs(of(i, j - 1) - 2.0 * here + of(i, j + 1)));
          if (i <= x_1 && j <= y_1)
            h_xy = std::max(h_xy, std::abs(here - of(i + 1, j) - of(i, j + 1) + of(i + 1, j + 1)));
        }
      }
      tile->bend[part] = std::max(h_xx * xx, h_yy * yy) + h_xy * xy;
      tile->top[part] = top;
    }
  }
  tiles_[b * tiles_x_ + a] = tile;
  return *tile;
}

}  // namespace footfall
