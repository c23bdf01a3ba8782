#pragma once
// A map of heights as a cubic B-spline through its samples, as a terrain needs it: heights with derivatives, feet, bounds.

#include <limits>

#include "mbd_solver/model/terrain.h"

namespace footfall {

inline constexpr int kFootSteps = 30;          // of Newton's method to a foot, at most; three are usual
inline constexpr double kLastFootStep = 1e-9;  // a step below this needs no further look at the field [m]
inline constexpr double kAboveField = 1e-9;    // a place above this height does not touch, round-off included [m]

// Coefficients are computed tile by tile, near bodies: most of a large map is never used. Copies share the tiles that
// exist.
class SplineGrid {
 public:
  explicit SplineGrid(std::shared_ptr<const HeightGrid> samples);
  const HeightGrid& grid() const { return *grid_; }

  void add(const Eigen::Vector2d& place, Terrain::Height& out);

  // Where the map lies: the field is origin.z + slope.(x, y) + map, x and y from the origin; along both axes it repeats after the period.
  struct Frame {
    Eigen::Vector3d origin;
    Eigen::Vector2d slope;
    double period = std::numeric_limits<double>::infinity();
  };
  // Feet of points, with the field there if `at` is not null. only_below: kAbove for points above the field. Where near is not kFoot the
  // foot means nothing.
  void find_feet(const Frame& frame, bool only_below, Terrain::Feet& feet, Terrain::Height* at);

  // The largest bend of all parts within the reach, or of the whole; outside the map the ground is extrapolated.
  double largest_bend(const Eigen::Vector2d& place, double reach);
  double largest_bend();
  double highest(const Eigen::Vector2d& place, double reach);
  double highest();
  // Within the reach of the place the map is below this height + slope.(x, y), x and y from the place; infinite at an
  // edge, or if the search would take long.
  double highest(const Eigen::Vector2d& place, double reach, const Eigen::Vector2d& slope);

  struct Tile;
  const Tile& tile(int a, int b) {
    const Tile* const known = tiles_[b * tiles_x_ + a].get();
    return known != nullptr ? *known : make_tile(a, b);
  }
  const Eigen::Vector2d& by() const { return by_; }  // cells per metre

 private:
  template <class Use>
  void each_part(const Eigen::Vector2d& place, double reach, Use use);
  const Tile& make_tile(int a, int b);

  std::shared_ptr<const HeightGrid> grid_;
  Eigen::Vector2d by_;
  int tiles_x_, tiles_y_, parts_x_, parts_y_;
  std::vector<std::shared_ptr<const Tile>> tiles_;  // made where they are first looked at
};

}  // namespace footfall
