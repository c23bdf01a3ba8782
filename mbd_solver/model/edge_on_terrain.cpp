// Cells of the ground along the plane of the circle; those that may hold a place are quartered until the derivatives vary so little
// that they hold one at most, which Newton's method finds.

#include "mbd_solver/model/edge_on_terrain.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kCoarsestCell = 1.0 / 6.0;  // of the radius
constexpr int kMostColumns = 400;            // of cells across the circle
constexpr int kMostRows = 400;               // of cells along its plane
constexpr int kDeepest = 8;                  // halves of a cell, at which two places may be as one
constexpr double kMargin = 1.5;              // on what derivatives may be between the corners of a cell
constexpr double kOnePlace = 0.9;            // relative variation of the derivatives below which there is one place

// Both equations at a place of the ground, with their derivatives by its x and y.
struct FacingPair {
  Eigen::Vector2d place;
  Terrain::Height here;
  double inside, w;   // R - rho, w [m]
  Eigen::Vector2d f;  // [m]
  Eigen::Matrix2d J;
};

class EdgeSearch {
 public:
  EdgeSearch(Terrain& terrain, const Eigen::Vector3d& centre, double R, const Eigen::Vector3d& a,
             std::vector<EdgePlace>& out)
      : terrain_(terrain), centre_(centre), R_(R), a_(a), out_(out) {
    u_ = a.cross(Eigen::Vector3d::UnitZ()).normalized();
    v_ = u_.cross(a);
    const TerrainParts& parts = terrain.parts();
    const double size = std::min(terrain.grain(), kCoarsestCell * R);
    cell_ = Eigen::Vector2d::Constant(size);
    if (parts.map) {  // on its cells, at whose corners its bends are largest
      cell_ = parts.map->step;
      first_ = parts.origin.head<2>() + parts.map->first;
      for (int k = 0; k < 2; ++k) cell_[k] /= std::ceil(cell_[k] / (kCoarsestCell * R));
    } else {
      first_ = centre.head<2>();
    }
  }

  void find(double top) {
    // The circle is deepest below the top where its half chord is `wide`.
    const double deep = std::min(1.0, (top - centre_.z()) / (R_ * v_.z()));
    if (deep <= -1.0) return;
    const double wide = deep < 0.0 ? R_ * std::sqrt(1.0 - deep * deep) : R_;
    along_ = std::abs(u_.x()) >= std::abs(u_.y()) ? 0 : 1;
    const double reach = wide * std::abs(u_[along_]) + R_ * std::abs(v_[along_]) + cell_[along_];
    if (2.0 * reach > kMostColumns * cell_[along_]) cell_ *= std::ceil(2.0 * reach / (kMostColumns * cell_[along_]));
    const auto column_of = [&](double x) { return std::floor((x - first_[along_]) / cell_[along_]); };
    top_ = std::min(top - centre_.z(), R_ * v_.z());
    Side left, right;
    for (double i = column_of(centre_[along_] - reach); i <= column_of(centre_[along_] + reach); i += 1.0) {
      left.clear();
      std::swap(left, right);
      column(i, left, right);
    }
  }

 private:
  using Side = std::vector<std::pair<double, FacingPair>>;  // corners of a column on one side, by row
  using Corners = std::array<FacingPair, 4>;

  FacingPair at(const Eigen::Vector2d& place) const {
    FacingPair out;
    out.place = place;
    out.here = terrain_.at(place.x(), place.y());
    const Eigen::Vector2d& g = out.here.slope;
    Eigen::Matrix2d B;
    B << out.here.bend[0], out.here.bend[2], out.here.bend[2], out.here.bend[1];
    const Eigen::Vector3d d(place.x() - centre_.x(), place.y() - centre_.y(), out.here.h - centre_.z());
    const double U = u_.dot(d), V = v_.dot(d), w = a_.dot(d), rho = std::max(1e-9 * R_, std::hypot(U, V));
    const double N_u = -g.dot(u_.head<2>()), N_v = v_.z() - g.dot(v_.head<2>());
    const double e_u = U / rho, e_v = V / rho, t_u = -e_v, t_v = e_u;  // e and t = a x e
    const Eigen::Vector2d U_x = u_.head<2>(), V_x = v_.head<2>() + v_.z() * g, w_x = a_.head<2>() + a_.z() * g,
                          N_u_x = -B * u_.head<2>(), N_v_x = -B * v_.head<2>();
    const double N_t = N_u * t_u + N_v * t_v;
    out.inside = R_ - rho;
    out.w = w;
    out.f = {rho * N_t, w};
    out.J.row(0) = U_x * N_v + U * N_v_x - V_x * N_u - V * N_u_x;
    out.J.row(1) = w_x;
    return out;
  }

  // Rows at which the plane of the circle may meet the ground, (place - centre).a = 0 from its deepest place to the top, and on to both
  // sides.
  void column(double i, Side& left, Side& right) const {
    const int other = 1 - along_;
    double low = 1e300, high = -1e300;
    for (const double x : {first_[along_] + i * cell_[along_], first_[along_] + (i + 1.0) * cell_[along_]}) {
      for (const double z : {-R_ * v_.z(), top_}) {
        const double y = -(a_[along_] * (x - centre_[along_]) + a_.z() * z) / a_[other];
        low = std::min(low, y);
        high = std::max(high, y);
      }
    }
    const auto row_of = [&](double y) { return std::floor((centre_[other] + y - first_[other]) / cell_[other]); };
    const double first_row = row_of(low), last_row = row_of(high);
    const auto corner = [&](Side& side, double column, double j) -> const FacingPair& {
      for (const auto& [known, pair] : side)
        if (known == j) return pair;
      Eigen::Vector2d place;
      place[along_] = first_[along_] + column * cell_[along_];
      place[other] = first_[other] + j * cell_[other];
      return side.emplace_back(j, at(place)).second;
    };
    const auto cell_of = [&](double j) -> Corners {
      const FacingPair a = corner(left, i, j), b = corner(right, i + 1.0, j), c = corner(left, i, j + 1.0),
                       d = corner(right, i + 1.0, j + 1.0);
      if (along_ == 0) return {a, b, c, d};
      return {a, c, b, d};
    };
    bool on_first = false, on_last = false;
    for (double j = first_row; j <= last_row; j += 1.0) {
      on_last = search(cell_of(j), 0);
      if (j == first_row) on_first = on_last;
    }
    for (double j = first_row - 1.0; on_first && j > first_row - kMostRows; j -= 1.0) on_first = search(cell_of(j), 0);
    for (double j = last_row + 1.0; on_last && j < last_row + kMostRows; j += 1.0) on_last = search(cell_of(j), 0);
  }

  // false: the cell is above the circle, or away from all that it may touch.
  bool search(const Corners& at_corners, int level) const {
    const Eigen::Array2d size = (at_corners[3].place - at_corners[0].place).array();
    const FacingPair& one = at_corners[0];
    double bend = 0.0, steep = 0.0, inside = one.inside, low_w = one.w, high_w = low_w;
    Eigen::Array2d low = at_corners[0].f.array(), high = low;
    Eigen::Array22d least = at_corners[0].J.array(), most = least;
    for (const FacingPair& pair : at_corners) {
      bend = std::max(bend, pair.here.bend.cwiseAbs().maxCoeff());
      steep = std::max(steep, pair.here.slope.squaredNorm());
      inside = std::max(inside, pair.inside);
      low_w = std::min(low_w, pair.w);
      high_w = std::max(high_w, pair.w);
      low = low.min(pair.f.array());
      high = high.max(pair.f.array());
      least = least.min(pair.J.array());
      most = most.max(pair.J.array());
    }
    const double bulge = kMargin / 8.0 * size.square().sum();  // per bend, beyond what the corners have between them
    const double more_inside = bulge * (bend + 2.0 * (1.0 + steep) / R_);
    if (inside + more_inside <= 0.0) return false;
    const Eigen::Array22d largest = least.abs().max(most.abs()), range = kMargin * (most - least) + 0.05 * largest;
    const Eigen::Array2d may = ((level == 0 ? largest : range).matrix() * (0.5 * size).matrix()).array();
    if ((low > may).any() || (high < -may).any()) return low_w <= 0.0 && high_w >= 0.0;
    if (level > 0) {
      const Eigen::Matrix2d J = 0.25 * (at_corners[0].J + at_corners[1].J + at_corners[2].J + at_corners[3].J);
      const double determinant = J.determinant();
      if (determinant != 0.0) {
        const Eigen::Matrix2d inverse = J.inverse();
        const Eigen::Matrix2d vary = (most - J.array()).max(J.array() - least).matrix() * kMargin;
        if ((inverse.cwiseAbs() * vary).rowwise().sum().maxCoeff() < kOnePlace || level == kDeepest) {
          const Eigen::Vector2d middle = 0.5 * (at_corners[0].place + at_corners[3].place),
                                f = 0.25 * (at_corners[0].f + at_corners[1].f + at_corners[2].f + at_corners[3].f);
          Eigen::Array2d step = -(inverse * f).array();
          step = step.max(-0.5 * size).min(0.5 * size);
          converge(middle + step.matrix(), middle, size, level == kDeepest ? 1.0 : 0.5 + 1e-7);
          return true;
        }
      } else if (level == kDeepest) {
        return true;
      }
    }
    const Eigen::Vector2d &first = at_corners[0].place, half = 0.5 * size.matrix();
    const FacingPair south = at(first + Eigen::Vector2d(half.x(), 0.0)),
                     west = at(first + Eigen::Vector2d(0.0, half.y())), middle = at(first + half),
                     east = at(first + Eigen::Vector2d(size.x(), half.y())),
                     north = at(first + Eigen::Vector2d(half.x(), size.y()));
    bool any = search({at_corners[0], south, west, middle}, level + 1);
    any = search({south, at_corners[1], middle, east}, level + 1) || any;
    any = search({west, middle, at_corners[2], north}, level + 1) || any;
    return search({middle, east, north, at_corners[3]}, level + 1) || any;
  }

  // Newton's method, within `share` of the size about the middle.
  void converge(Eigen::Vector2d place, const Eigen::Vector2d& middle, const Eigen::Array2d& size, double share) const {
    FacingPair pair = at(place);
    bool found = false;
    for (int i = 0; i < 30; ++i) {
      Eigen::Vector2d step = -(pair.J.inverse() * pair.f);
      const double length = step.norm(), most = size.matrix().norm();
      if (!(length < 1e6 * most)) return;
      if (length <= 1e-14 * (1.0 + place.norm())) {
        found = true;
        break;
      }
      if (length > 0.5 * most) step *= 0.5 * most / length;
      place += step;
      if (((place - middle).array().abs() > 1.5 * size).any()) return;
      pair = at(place);
    }
    if (!found && pair.f.norm() > 1e-12 * R_) return;
    if (((place - middle).array().abs() > share * size).any()) return;
    if (!(pair.inside > 0.0)) return;
    EdgePlace one;
    one.sign = pair.J.determinant() > 0.0 ? 1.0 : -1.0;
    one.inside = pair.inside;
    one.at_c = pair.here;
    one.c = {place.x(), place.y(), pair.here.h};
    one.n = Eigen::Vector3d(-pair.here.slope.x(), -pair.here.slope.y(), 1.0).normalized();
    one.e = (one.c - centre_).normalized();
    if (one.n.dot(one.e) > 0.0) one.n = -one.n;
    const bool known = std::any_of(out_.begin(), out_.end(), [&](const EdgePlace& other) {
      return other.sign == one.sign && (other.c - one.c).norm() < 1e-6 * size.maxCoeff();
    });
    if (!known) out_.push_back(one);
  }

  Terrain& terrain_;
  const Eigen::Vector3d centre_;
  const double R_;
  const Eigen::Vector3d a_;
  std::vector<EdgePlace>& out_;
  Eigen::Vector3d u_, v_;
  Eigen::Vector2d cell_, first_ = Eigen::Vector2d::Zero();
  int along_ = 0;
  double top_ = 0.0;  // of the field above the centre, at most of the circle [m]
};

}  // namespace

// d = c - r, r' = dr - arm~ dtheta:  [a.(d x N), a.d] by x and y of c, d(x, y) = -J^-1 of
//   [a x N; a x (d x N) + arm x (a x N)],  [-a; a x d - arm x a]
void EdgePlace::find_ways(const Eigen::Vector3d& a, const Eigen::Vector3d& centre, const Eigen::Vector3d& arm,
                          Eigen::Matrix<double, 3, 6>& of_c, Eigen::Matrix<double, 3, 6>& of_n) const {
  const Eigen::Vector3d d = c - centre, N(-at_c.slope.x(), -at_c.slope.y(), 1.0);
  const double side = n.z() > 0.0 ? 1.0 : -1.0;
  Eigen::Matrix<double, 3, 2> T, N_x;
  T << 1.0, 0.0, 0.0, 1.0, at_c.slope.x(), at_c.slope.y();
  N_x << -at_c.bend[0], -at_c.bend[2], -at_c.bend[2], -at_c.bend[1], 0.0, 0.0;
  Eigen::Matrix2d J;
  for (int k = 0; k < 2; ++k) {
    J(0, k) = a.dot(T.col(k).cross(N) + d.cross(Eigen::Vector3d(N_x.col(k))));
    J(1, k) = a.dot(T.col(k));
  }
  Eigen::Matrix<double, 2, 6> by_body;
  by_body.block<1, 3>(0, 0) = a.cross(N).transpose();
  by_body.block<1, 3>(0, 3) = (a.cross(d.cross(N)) + arm.cross(a.cross(N))).transpose();
  by_body.block<1, 3>(1, 0) = -a.transpose();
  by_body.block<1, 3>(1, 3) = (a.cross(d) - arm.cross(a)).transpose();
  const Eigen::Matrix<double, 2, 6> ways = -(J.inverse() * by_body);
  of_c = T * ways;
  of_c.leftCols<3>() -= Eigen::Matrix3d::Identity();
  of_c.rightCols<3>() += skew(arm + d);
  const Eigen::Matrix<double, 3, 6> by_N = side * N_x * ways;
  of_n = (by_N - n * (n.transpose() * by_N)) / N.norm();
}

void find_edge_places(Terrain& terrain, const Eigen::Vector3d& centre, double R, const Eigen::Vector3d& a, double top,
                      std::vector<EdgePlace>& out) {
  out.clear();
  EdgeSearch(terrain, centre, R, a, out).find(top);
}

}  // namespace footfall
