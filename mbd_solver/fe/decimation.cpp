// Edges collapse in the order of their quadric errors [Garland and Heckbert 1997], each to the point that keeps the enclosed
// volume [Lindstrom and Turk 1998]. A collapse is tested before it is carried out. Distances by a tree of boxes.

#include "mbd_solver/fe/decimation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <queue>
#include <tuple>
#include <utility>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kRimWeight = 100.0;    // of a plane across the rim, relative to one of the surface
constexpr double kFlat = 1e-6;          // eigenvalues of a quadric below this share of the largest leave the point free
constexpr double kExact = 1e-13;        // an end that changes no shape and volume, in units of the mesh's size
constexpr double kLengthWeight = 1e-9;  // among collapses without error short edges come first
constexpr double kLeastCosine = 0.3;    // of the turn of a triangle in one collapse
constexpr double kSlimmest = 1e-2;      // height over longest edge of a new triangle, unless it was slimmer before
constexpr double kFarthest = 2.0;       // of the new point from the middle of the edge, in lengths of the edge

std::size_t at(int i) { return static_cast<std::size_t>(i); }

// Weighted sum of squared distances from planes: x^T A x - 2 b^T x + c.
struct Quadric {
  Matrix3d A = Matrix3d::Zero();
  Vector3d b = Vector3d::Zero();
  double c = 0.0;

  void add_plane(const Vector3d& n, const Vector3d& p, double weight) {
    const double d = n.dot(p);
    A += weight * n * n.transpose();
    b += weight * d * n;
    c += weight * d * d;
  }
  void add(const Quadric& other) {
    A += other.A;
    b += other.b;
    c += other.c;
  }
  double operator()(const Vector3d& x) const { return std::max(0.0, x.dot(A * x) - 2.0 * b.dot(x) + c); }
};

// The mesh in its own units: centred, of size 1.
class Collapser {
 public:
  Collapser(std::vector<Vector3d> points, std::vector<Vector3i> triangles)
      : points_(std::move(points)), triangles_(std::move(triangles)), left_(triangles_.size()) {
    around_.resize(points_.size());
    stamps_.assign(points_.size(), 0);
    quadrics_.resize(points_.size());
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      for (const int corner : triangles_[t]) around_[at(corner)].push_back(static_cast<int>(t));
    for (const Vector3i& t : triangles_) {
      const Vector3d n = normal(t);
      const double area = n.norm();
      for (const int corner : t) quadrics_[at(corner)].add_plane(n / area, points_[at(t(0))], area);
    }
    std::map<std::pair<int, int>, std::pair<int, int>> uses;  // how many, and the last triangle
    for (std::size_t k = 0; k < triangles_.size(); ++k)
      for (int i = 0; i < 3; ++i) {
        const int a = triangles_[k](i), b = triangles_[k]((i + 1) % 3);
        auto& use = uses[{std::min(a, b), std::max(a, b)}];
        ++use.first;
        use.second = static_cast<int>(k);
      }
    fixed_.assign(points_.size(), false);
    rim_.assign(points_.size(), false);
    for (const auto& [edge, use] : uses) {
      const auto [a, b] = edge;
      if (use.first > 2) fixed_[at(a)] = fixed_[at(b)] = true;
      if (use.first != 1) continue;
      rim_[at(a)] = rim_[at(b)] = true;
      const Vector3d along = points_[at(b)] - points_[at(a)];
      const Vector3d across = along.cross(normal(triangles_[at(use.second)]));
      for (const int end : {a, b})
        quadrics_[at(end)].add_plane(across.normalized(), points_[at(a)], kRimWeight * along.squaredNorm());
    }
    for (const auto& use : uses) offer(use.first.first, use.first.second);
  }

  void reduce(std::size_t most) {
    while (left_ > most && !queue_.empty()) {
      const Offer best = queue_.top();
      queue_.pop();
      if (stamps_[at(best.a)] + stamps_[at(best.b)] == best.stamp && is_sound(best)) collapse(best);
    }
  }

  // The corners that are left, in their order, and the triangles.
  TriangleMesh result() const {
    TriangleMesh mesh;
    std::vector<int> number(points_.size(), -1);
    for (std::size_t v = 0; v < points_.size(); ++v)
      if (!around_[v].empty()) {
        number[v] = static_cast<int>(mesh.vertices.size());
        mesh.vertices.push_back(points_[v]);
      }
    for (const Vector3i& t : triangles_)
      if (t(0) >= 0) mesh.triangles.emplace_back(number[at(t(0))], number[at(t(1))], number[at(t(2))]);
    return mesh;
  }

 private:
  struct Offer {
    double cost;
    int a, b;
    long stamp;  // sum of the stamps of both ends, which only grow
    Vector3d to;
    bool operator<(const Offer& other) const {  // the cheapest is on top
      return std::tie(cost, a, b) > std::tie(other.cost, other.a, other.b);
    }
  };

  // Twice the area along the normal.
  Vector3d normal(const Vector3d& a, const Vector3d& b, const Vector3d& c) const { return (b - a).cross(c - a); }
  Vector3d normal(const Vector3i& t) const { return normal(points_[at(t(0))], points_[at(t(1))], points_[at(t(2))]); }

  std::vector<int> neighbours(int v) const {
    std::vector<int> result;
    for (const int t : around_[at(v)])
      for (const int corner : triangles_[at(t)])
        if (corner != v) result.push_back(corner);
    std::sort(result.begin(), result.end());
    result.erase(std::unique(result.begin(), result.end()), result.end());
    return result;
  }
  static bool has(const Vector3i& t, int v) { return t(0) == v || t(1) == v || t(2) == v; }

  void offer(int a, int b) {
    if (fixed_[at(a)] || fixed_[at(b)]) return;
    Quadric q = quadrics_[at(a)];
    q.add(quadrics_[at(b)]);
    const Vector3d &p = points_[at(a)], &r = points_[at(b)];
    const double length = (r - p).norm();
    // With triangles (x_i, y_i, z_i) around the edge, n_i = (y_i - x_i) x (z_i - x_i), the volume stays if
    //   g . v = s,   g = sum n_i,   s = sum n_i . x_i   [Lindstrom and Turk 1998, 5]
    Vector3d g = Vector3d::Zero();
    double s = 0.0;
    bool inside = true;  // no rim: the surface encloses a defined volume
    for (const int end : {a, b}) {
      inside = inside && !rim_[at(end)];
      for (const int t : around_[at(end)]) {
        const Vector3i& corner = triangles_[at(t)];
        if (end == b && has(corner, a)) continue;
        const Vector3d n = normal(corner);
        g += n;
        s += n.dot(points_[at(corner(0))]);
      }
    }
    const double cost_of_length = kLengthWeight * length * length * q.A.trace();
    std::optional<Vector3d> to;
    if (rim_[at(a)] != rim_[at(b)]) to = rim_[at(a)] ? p : r;
    for (const Vector3d* end : {&p, &r})
      if (!to && q(*end) <= kExact * q.A.trace() * length * length &&
          (!inside || std::abs(g.dot(*end) - s) <= kExact * g.norm() * length))
        to = *end;
    if (!to) {
      // Least error nearest to the middle m of the edge: v = m + A^+ (b - A m); then onto the plane of equal volume, along
      // the direction that costs least.
      const Vector3d m = 0.5 * (p + r);
      const Eigen::SelfAdjointEigenSolver<Matrix3d> eigen(q.A);
      const Vector3d& values = eigen.eigenvalues();
      const double least = kFlat * values(2);
      const Vector3d rest = eigen.eigenvectors().transpose() * (q.b - q.A * m);
      Vector3d shift, soft = eigen.eigenvectors().transpose() * g;
      for (int i = 0; i < 3; ++i) {
        shift(i) = values(i) > least ? rest(i) / values(i) : 0.0;
        soft(i) /= std::max(values(i), least);
      }
      Vector3d v = m + eigen.eigenvectors() * shift;
      const Vector3d step = eigen.eigenvectors() * soft;
      if (inside && g.dot(step) > 0.0) v += step * ((s - g.dot(v)) / g.dot(step));
      if ((v - m).norm() > kFarthest * length || !v.allFinite()) return;
      to = v;
    }
    queue_.push({q(*to) + cost_of_length, a, b, stamps_[at(a)] + stamps_[at(b)], *to});
  }

  bool is_sound(const Offer& o) const {
    // The ends have no other neighbours in common than the third corners of the triangles at the edge.
    std::vector<int> third;
    for (const int t : around_[at(o.a)])
      if (has(triangles_[at(t)], o.b))
        for (const int corner : triangles_[at(t)])
          if (corner != o.a && corner != o.b) third.push_back(corner);
    if (third.empty() || (third.size() == 2 && rim_[at(o.a)] && rim_[at(o.b)])) return false;
    const std::vector<int> of_a = neighbours(o.a), of_b = neighbours(o.b);
    std::vector<int> common;
    std::set_intersection(of_a.begin(), of_a.end(), of_b.begin(), of_b.end(), std::back_inserter(common));
    std::sort(third.begin(), third.end());
    if (common != third) return false;
    // No triangle turns over, becomes a needle or the double of another one.
    std::vector<std::pair<int, int>> opposite;
    for (const int end : {o.a, o.b})
      for (const int t : around_[at(end)]) {
        const Vector3i& corner = triangles_[at(t)];
        if (has(corner, o.a) && has(corner, o.b)) continue;
        std::array<Vector3d, 3> now, then;
        std::vector<int> others;
        for (int i = 0; i < 3; ++i) {
          now[at(i)] = points_[at(corner(i))];
          then[at(i)] = corner(i) == end ? o.to : now[at(i)];
          if (corner(i) != end) others.push_back(corner(i));
        }
        opposite.emplace_back(std::min(others[0], others[1]), std::max(others[0], others[1]));
        const Vector3d n = normal(now[0], now[1], now[2]), m = normal(then[0], then[1], then[2]);
        if (!(n.dot(m) > kLeastCosine * n.norm() * m.norm())) return false;
        if (slimness(then) < std::min(kSlimmest, slimness(now))) return false;
      }
    if (opposite.empty()) return false;
    std::sort(opposite.begin(), opposite.end());
    return std::adjacent_find(opposite.begin(), opposite.end()) == opposite.end();
  }
  double slimness(const std::array<Vector3d, 3>& x) const {
    const double longest =
        std::max({(x[1] - x[0]).squaredNorm(), (x[2] - x[1]).squaredNorm(), (x[0] - x[2]).squaredNorm()});
    return normal(x[0], x[1], x[2]).norm() / longest;
  }

  void collapse(const Offer& o) {
    std::vector<int> kept;
    for (const int end : {o.a, o.b})
      for (const int t : around_[at(end)]) {
        Vector3i& corner = triangles_[at(t)];
        if (corner(0) < 0) continue;
        if (!(has(corner, o.a) && has(corner, o.b))) {
          kept.push_back(t);
          continue;
        }
        for (const int v : corner)
          if (v != o.a && v != o.b)
            around_[at(v)].erase(std::remove(around_[at(v)].begin(), around_[at(v)].end(), t), around_[at(v)].end());
        corner.setConstant(-1);
        --left_;
      }
    for (const int t : kept)
      for (int& v : triangles_[at(t)])
        if (v == o.b) v = o.a;
    std::sort(kept.begin(), kept.end());
    around_[at(o.a)] = std::move(kept);
    around_[at(o.b)].clear();
    points_[at(o.a)] = o.to;
    rim_[at(o.a)] = rim_[at(o.a)] || rim_[at(o.b)];
    quadrics_[at(o.a)].add(quadrics_[at(o.b)]);
    // Edges around the moved corner, and those around its neighbours, whose triangles have changed.
    const std::vector<int> near = neighbours(o.a);
    ++stamps_[at(o.a)];
    ++stamps_[at(o.b)];
    for (const int v : near) ++stamps_[at(v)];
    for (const int v : near) {
      offer(o.a, v);
      for (const int w : neighbours(v))
        if (w != o.a && (v < w || !std::binary_search(near.begin(), near.end(), w))) offer(v, w);
    }
  }

  std::vector<Vector3d> points_;
  std::vector<Vector3i> triangles_;       // -1: collapsed
  std::vector<std::vector<int>> around_;  // triangles at each corner
  std::vector<Quadric> quadrics_;
  std::vector<long> stamps_;  // number of changes of the parts on which an offer depends
  std::vector<bool> fixed_;   // at an edge of more than two triangles
  std::vector<bool> rim_;
  std::priority_queue<Offer> queue_;
  std::size_t left_;
};

// Squared distance of p from a triangle: the foot on its plane where it is inside, else the nearest of its edges.
double squared_distance(const Vector3d& p, const std::array<Vector3d, 3>& x) {
  const Vector3d n = (x[1] - x[0]).cross(x[2] - x[0]);
  bool inside = true;
  double least = std::numeric_limits<double>::max();
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector3d &a = x[i], along = x[(i + 1) % 3] - a;
    inside = inside && n.dot(along.cross(p - a)) >= 0.0;
    const double t = std::clamp(along.dot(p - a) / along.squaredNorm(), 0.0, 1.0);
    least = std::min(least, (p - a - t * along).squaredNorm());
  }
  return inside ? std::min(least, n.dot(p - x[0]) * n.dot(p - x[0]) / n.squaredNorm()) : least;
}

// Boxes around halves of halves of the triangles.
class TriangleTree {
 public:
  explicit TriangleTree(const TriangleMesh& mesh) : mesh_(mesh), order_(mesh.triangles.size()) {
    std::iota(order_.begin(), order_.end(), 0);
    boxes_.resize(4 * order_.size());
    build(0, 0, order_.size());
  }
  double distance(const Vector3d& p) const {
    double least = std::numeric_limits<double>::max();
    search(p, 0, 0, order_.size(), least);
    return std::sqrt(least);
  }

 private:
  std::array<Vector3d, 3> corners(int t) const {
    const Vector3i& c = mesh_.triangles[at(t)];
    return {mesh_.vertices[at(c(0))], mesh_.vertices[at(c(1))], mesh_.vertices[at(c(2))]};
  }
  void build(std::size_t node, std::size_t from, std::size_t to) {
    Eigen::AlignedBox3d& box = boxes_[node];
    for (std::size_t k = from; k < to; ++k)
      for (const Vector3d& x : corners(order_[k])) box.extend(x);
    if (to - from < 2) return;
    Eigen::Index axis = 0;
    box.sizes().maxCoeff(&axis);
    const std::size_t middle = (from + to) / 2;
    const auto place = [&](int t) {
      const auto x = corners(t);
      return x[0](axis) + x[1](axis) + x[2](axis);
    };
    std::nth_element(
        order_.begin() + static_cast<std::ptrdiff_t>(from), order_.begin() + static_cast<std::ptrdiff_t>(middle),
        order_.begin() + static_cast<std::ptrdiff_t>(to), [&](int a, int b) { return place(a) < place(b); });
    build(2 * node + 1, from, middle);
    build(2 * node + 2, middle, to);
  }
  void search(const Vector3d& p, std::size_t node, std::size_t from, std::size_t to, double& least) const {
    if (boxes_[node].squaredExteriorDistance(p) >= least) return;
    if (to - from == 1) {
      least = std::min(least, squared_distance(p, corners(order_[from])));
      return;
    }
    const std::size_t middle = (from + to) / 2, first = 2 * node + 1, second = first + 1;
    if (boxes_[first].squaredExteriorDistance(p) <= boxes_[second].squaredExteriorDistance(p)) {
      search(p, first, from, middle, least);
      search(p, second, middle, to, least);
    } else {
      search(p, second, middle, to, least);
      search(p, first, from, middle, least);
    }
  }

  const TriangleMesh& mesh_;
  std::vector<int> order_;
  std::vector<Eigen::AlignedBox3d> boxes_;
};

double enclosed(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Vector3i& t : mesh.triangles)
    sum += mesh.vertices[at(t(0))].dot(mesh.vertices[at(t(1))].cross(mesh.vertices[at(t(2))])) / 6.0;
  return sum;
}

}  // namespace

Decimation decimated(const TriangleMesh& mesh, std::size_t most) {
  FOOTFALL_DEMAND(!mesh.triangles.empty());
  if (mesh.triangles.size() <= most) return {mesh, 0.0, 0.0};
  Eigen::AlignedBox3d box;
  for (const Vector3d& x : mesh.vertices) box.extend(x);
  const double size = box.diagonal().norm();
  TriangleMesh given = mesh;
  for (Vector3d& x : given.vertices) x = (x - box.center()) / size;
  Collapser collapser(given.vertices, given.triangles);
  collapser.reduce(most);
  Decimation result;
  result.mesh = collapser.result();
  const TriangleTree old_tree(given), new_tree(result.mesh);
  for (const Vector3d& x : given.vertices) result.distance = std::max(result.distance, new_tree.distance(x));
  for (const Vector3d& x : result.mesh.vertices) result.distance = std::max(result.distance, old_tree.distance(x));
  result.distance *= size;
  MeshDemands closed;
  closed.closed = true;
  if (mesh_findings(mesh, closed).empty()) result.volume_change = enclosed(result.mesh) / enclosed(given) - 1.0;
  for (Vector3d& x : result.mesh.vertices) x = box.center() + size * x;
  result.mesh.notes = mesh.notes;
  return result;
}

}  // namespace footfall
