#pragma once
// The surface of the ground: a height field h(x, y), and rocks, which are spheres. Theory 6.8.
//   h = z_0 + slope.(x, y) + map + craters + waves,  in W, x and y from the origin of the terrain
//   map      cubic B-spline through the samples (second derivatives are continuous; along an edge they vanish there, and
//            outside the map the surface is extrapolated linearly)
//   crater   u = r / R:  within -depth + (depth + rim)(2 u^2 - u^4), slope zero at the crest; outside rim (1 - (u - 1)^2)^2 to
//            u = 2
//   wave     amplitude sin(k.(x, y) + phase)
// Distance of a point p, from its foot c, the nearest point of the surface, negative below:
//   p = c + phi n(c),  n = (-h_x, -h_y, 1) / sqrt(1 + h_x^2 + h_y^2),  dn/dp = S (I + phi S)^-1,  S = dn/dc
// The foot is found by Newton's method, so the distance is exact to round-off while |phi| is below the radius of curvature.

#include <Eigen/Dense>
#include <functional>
#include <limits>
#include <memory>
#include <vector>

namespace footfall {

// Samples of a height, row after row.
struct HeightGrid {
  int columns = 0, rows = 0;                        // along x and y, >= 2
  Eigen::Vector2d first = Eigen::Vector2d::Zero();  // place of the first sample [m]
  Eigen::Vector2d step = Eigen::Vector2d::Ones();   // > 0 [m]
  std::vector<double> heights;  // [m]; empty: (number - below) scale, of numbers whose first row is the last
  // Numbers of a large map, which remain where they are: writes `count` of them from the number `first` on.
  std::function<void(std::size_t first, std::size_t count, double* out)> numbers;
  double below = 0.0, scale = 1.0;
  // Heights of a row, from this column on [m].
  void read(int column, int row, int count, double* out) const;
  double at(int column, int row) const {
    double height;
    read(column, row, 1, &height);
    return height;
  }
};

struct Crater {
  Eigen::Vector2d centre;  // from the origin [m]
  double radius;           // of the crest > 0 [m]
  double depth = 0.0;      // below the ground around it [m]
  double rim = 0.0;        // height of the crest above the ground around it [m]
};

struct GroundWave {
  Eigen::Vector2d k;        // wave vector [rad/m]
  double amplitude, phase;  // [m], [rad]
};

struct Rock {
  Eigen::Vector2d place;  // from the origin [m]
  double radius;          // > 0 [m]
  double buried = 0.5;    // share of its diameter below the ground at its place, 0 to 1
};

struct TerrainParts {
  Eigen::Vector3d origin = Eigen::Vector3d::Zero();  // in W [m]
  Eigen::Vector2d slope = Eigen::Vector2d::Zero();   // rise per length along x and y
  std::shared_ptr<const HeightGrid> map;
  std::vector<Crater> craters;
  std::vector<GroundWave> waves;
  std::vector<Rock> rocks;
};

// A query completes the map of the field at its place: every user therefore has its own Terrain. Copies share all
// completed parts.
class Terrain {
 public:
  struct Height {
    double h = 0.0;  // of W [m]
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    Eigen::Vector3d bend = Eigen::Vector3d::Zero();  // h_xx, h_yy, h_xy [1/m]
  };
  // The foot of a point, on the field or on a rock.
  struct Foot {
    double distance = 0.0;                              // phi [m]
    Eigen::Vector3d normal = Eigen::Vector3d::UnitZ();  // n, out of the ground
    Eigen::Matrix3d bend = Eigen::Matrix3d::Zero();     // dn/dp [1/m]
    Eigen::Vector2d place = Eigen::Vector2d::Zero();    // of the foot, x and y in W [m]
    int rock = -1;                                      // -1: the field
    double sign = 1.0;                                  // -1: a saddle of the distance
  };
  struct Sphere {
    Eigen::Vector3d centre;  // in W [m]
    double radius;           // [m]
  };
  // Around a place the field is below height + slope.(x, y) + bend |(x, y)|^2 / 2, x and y from the place, and below top, a height of W.
  struct Lid {
    double height = 0.0, bend = 0.0, top = 0.0;
    Eigen::Vector2d slope = Eigen::Vector2d::Zero();
    std::vector<int> rocks;  // that may be within the reach
    // A ball is above the field; its centre is the centre of the lid.
    bool above(const Eigen::Vector3d& centre, double reach) const;
  };

  explicit Terrain(TerrainParts parts);
  Terrain(const Terrain& other);
  Terrain& operator=(const Terrain&) = delete;
  ~Terrain();

  Height at(double x, double y);   // of the field, x and y in W [m]
  double top(double x, double y);  // with rocks
  // Heights of the field for pictures, row after row, `counts` of them along x and y. A map with closer samples gives the nearest.
  std::vector<double> sketch(const Eigen::Vector2d& first, const Eigen::Vector2d& step, const Eigen::Vector2i& counts);
  // The foot on the field near p, from below or above.
  Foot foot(const Eigen::Vector3d& p);
  enum class With { kNormal, kBend };
  enum class Near { kAbove, kFoot, kElsewhere };  // kElsewhere: not in the cell of a map
  // Feet of many points, side by side: arrays have room for a multiple of kMostLanes.
  struct Feet {
    int count = 0;
    Eigen::ArrayX3d points;             // in W [m]
    std::vector<Near> near;             // what follows is of points with kFoot
    Eigen::ArrayXd distance;            // as in Foot
    Eigen::ArrayX3d normal;             // likewise
    Eigen::ArrayX2d place;              // likewise
    std::vector<Eigen::Matrix3d> bend;  // likewise, where it is asked for
    void clear() { count = 0; }
    void add(const Eigen::Vector3d& point);
    Foot of(int k, With with) const;
  };
  // The feet of the points that are below the field; kAbove for the others.
  void below(Feet& feet, With with);
  bool may_touch(const Eigen::Vector3d& p, double radius);  // false: a ball of this radius > 0 is above the field
  Foot foot(const Eigen::Vector3d& p, int rock) const;
  // Where a ball of this radius >= 0 about p touches the field: minima of the distance within the radius; overwrites out. Where the
  // ground bends more than the ball, also the saddles between them and maxima: a minimum that ends does so in a saddle of the same
  // distance, so that the sum over all by their signs has no jump, and ripples do not count as many grounds.
  void feet(const Eigen::Vector3d& p, double radius, std::vector<Foot>& out);
  double distance(const Eigen::Vector3d& p);  // of the field and all rocks

  Lid lid(const Eigen::Vector3d& centre, double reach);
  // Within the reach the field is below this height + slope.(x, y), x and y from the centre; infinite if only a lid is known [m].
  double plane_above(const Eigen::Vector2d& centre, double reach, const Eigen::Vector2d& slope);

  const std::vector<Sphere>& rocks() const { return spheres_; }
  const TerrainParts& parts() const { return parts_; }
  double grain() const { return grain_; }     // a length [m] over which the bends of the field change little
  bool inside_map(double x, double y) const;  // true without a map

 private:
  struct Map;
  struct RockCells;
  void find_feet(Feet& feet, bool only_below, With with);
  bool find_foot(const Eigen::Vector3d& p, Foot& out);
  Height at_place(const Eigen::Vector2d& place, bool with_map);  // from the origin
  bool stationary(const Eigen::Vector3d& p, const Eigen::Vector2d& start, double reach, Foot& out);
  void find_all(const Eigen::Vector3d& p, double radius, std::vector<Foot>& out);
  bool descend(const Eigen::Vector3d& p, const Eigen::Vector2d& start, Height here, With with, Foot& out);
  double bend_within(const Eigen::Vector2d& place, double reach);  // of the field, at most [1/m]
  double top_within(const Eigen::Vector2d& place, double reach);   // of the field, at most, in W [m]

  TerrainParts parts_;
  std::unique_ptr<Map> map_;
  Feet one_;               // of one point
  bool in_cells_ = false;  // the field is a map or a roughness, and a slope: in each cell a polynomial
  std::vector<Sphere> spheres_;
  std::shared_ptr<const RockCells> rock_cells_;
  double grain_ = std::numeric_limits<double>::infinity();
  double wave_bend_ = 0.0, wave_height_ = 0.0;  // of all waves together, at most [1/m], [m]
};

}  // namespace footfall
