// Corners are welded and pieces oriented once; a box tree then finds the triangles near a point, and the local minima of
// their distances are the contacts.

#include "mbd_solver/model/elements/contact_surface.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/AABB.h>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>
#include <utility>

#include "coupler/base/errors.h"
#include "mbd_solver/model/codes.h"

namespace footfall {
namespace {

constexpr double kSamePlace = 1e-9;  // distance of corners that are welded [of the size of the surface]

using Cell = std::tuple<long, long, long>;
using Edge = std::pair<int, int>;

Edge edge_of(const Eigen::Vector3i& t, int k) {
  const int a = t[k], b = t[(k + 1) % 3];
  return {std::min(a, b), std::max(a, b)};
}

class Welder {
 public:
  explicit Welder(double tolerance) : tolerance_(tolerance) {}
  int add(const Eigen::Vector3d& p, std::vector<Eigen::Vector3d>& vertices) {
    const auto cell = [&](int k) { return std::lround(std::floor(p[k] / (4.0 * tolerance_))); };
    const long x = cell(0), y = cell(1), z = cell(2);
    for (long i = x - 1; i <= x + 1; ++i)
      for (long j = y - 1; j <= y + 1; ++j)
        for (long k = z - 1; k <= z + 1; ++k) {
          const auto found = cells_.find({i, j, k});
          if (found == cells_.end()) continue;
          if ((vertices[found->second] - p).norm() <= tolerance_) return found->second;
        }
    const int index = static_cast<int>(vertices.size());
    vertices.push_back(p);
    cells_[{x, y, z}] = index;
    return index;
  }

 private:
  double tolerance_;
  std::map<Cell, int> cells_;
};

using TrianglesAtEdge = std::map<Edge, std::vector<std::size_t>>;

TrianglesAtEdge triangles_at_edges(const TrianglePieces& out) {
  TrianglesAtEdge at_edge;
  for (std::size_t i = 0; i < out.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) at_edge[edge_of(out.triangles[i].corners, k)].push_back(i);
  return at_edge;
}

bool runs(const Eigen::Vector3i& t, const Edge& edge) {  // from first to second
  for (int k = 0; k < 3; ++k)
    if (t[k] == edge.first && t[(k + 1) % 3] == edge.second) return true;
  return false;
}

// Follows edges that two triangles share, and gives each triangle the orientation of its predecessor.
void orient_pieces(TrianglePieces& out, const TrianglesAtEdge& at_edge) {
  std::vector<bool> seen(out.triangles.size(), false);
  for (std::size_t start = 0; start < out.triangles.size(); ++start) {
    if (seen[start]) continue;
    const int piece = static_cast<int>(out.open.size());
    bool open = false;
    double volume = 0.0;
    std::vector<std::size_t> way{start};
    seen[start] = true;
    for (std::size_t next = 0; next < way.size(); ++next) {
      PieceTriangle& t = out.triangles[way[next]];
      t.piece = piece;
      for (int k = 0; k < 3; ++k) {
        const Edge edge = edge_of(t.corners, k);
        const std::vector<std::size_t>& both = at_edge.at(edge);
        if (both.size() != 2) {
          open = true;
          continue;
        }
        const std::size_t other = both[0] == way[next] ? both[1] : both[0];
        const bool alike = runs(out.triangles[other].corners, edge) != runs(t.corners, edge);
        if (!seen[other]) {
          if (!alike) std::swap(out.triangles[other].corners[1], out.triangles[other].corners[2]);
          seen[other] = true;
          way.push_back(other);
        } else if (!alike) {
          open = true;  // a Moebius strip
        }
      }
    }
    for (const std::size_t i : way) {
      const auto v = [&](int k) { return out.vertices[out.triangles[i].corners[k]]; };
      volume += v(0).dot(v(1).cross(v(2)));
    }
    if (!open && volume < 0.0)
      for (const std::size_t i : way) std::swap(out.triangles[i].corners[1], out.triangles[i].corners[2]);
    out.open.push_back(open);
  }
}

void add_normals(TrianglePieces& out, const TrianglesAtEdge& at_edge) {
  std::vector<Eigen::Vector3d> at_corner(out.vertices.size(), Eigen::Vector3d::Zero());
  std::vector<bool> border(out.vertices.size(), false);
  for (PieceTriangle& t : out.triangles) {
    const auto v = [&](int k) { return out.vertices[t.corners[k % 3]]; };
    const Eigen::Vector3d across = (v(1) - v(0)).cross(v(2) - v(0));
    if (!(across.norm() > 0.0)) throw InputError(code::kMeshDefect, "a triangle has no area");
    t.normal = across.normalized();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d to = v(k + 1) - v(k), from = v(k + 2) - v(k);
      const double angle = std::atan2(to.cross(from).norm(), to.dot(from));
      at_corner[t.corners[k]] += angle * t.normal;
    }
  }
  for (const auto& [edge, triangles] : at_edge) {
    if (triangles.size() == 2) continue;
    border[edge.first] = border[edge.second] = true;
  }
  for (PieceTriangle& t : out.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t corner = t.corners[static_cast<Eigen::Index>(k)];
      t.corner_normal[k] = at_corner[corner];
      t.corner_is_border[k] = border[corner];
      t.edge_normal[k].setZero();
      const std::vector<std::size_t>& at = at_edge.at(edge_of(t.corners, static_cast<int>(k)));
      t.edge_is_border[k] = at.size() != 2;
      for (const std::size_t i : at) t.edge_normal[k] += out.triangles[i].normal;
    }
  }
}

}  // namespace

TrianglePieces triangle_pieces(const Eigen::Matrix3Xd& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  TrianglePieces out;
  const double size = (vertices.rowwise().maxCoeff() - vertices.rowwise().minCoeff()).norm();
  Welder welder(kSamePlace * size);
  for (const Eigen::Vector3i& t : triangles) {
    PieceTriangle triangle;
    for (int k = 0; k < 3; ++k) triangle.corners[k] = welder.add(vertices.col(t[k]), out.vertices);
    out.triangles.push_back(triangle);
  }
  const TrianglesAtEdge at_edge = triangles_at_edges(out);
  orient_pieces(out, at_edge);
  add_normals(out, at_edge);
  return out;
}

// The regions of Ericson, Real-Time Collision Detection (2005), 5.1.5.
NearestPoint nearest_on_triangle(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c) {
  const Eigen::Vector3d ab = b - a, ac = c - a, ap = p - a, bp = p - b, cp = p - c;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0.0 && d2 <= 0.0) return {a, -1, 0};
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0.0 && d4 <= d3) return {b, -1, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) return {a + d1 / (d1 - d3) * ab, 0, -1};
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0.0 && d5 <= d6) return {c, -1, 2};
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) return {a + d2 / (d2 - d6) * ac, 2, -1};
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0) return {b + (d4 - d3) / ((d4 - d3) + (d5 - d6)) * (c - b), 1, -1};
  const double sum = 1.0 / (va + vb + vc);
  return {a + vb * sum * ab + vc * sum * ac, -1, -1};
}

namespace {

constexpr double kOneSurface = 0.93969262078590838;  // cos 20 degrees: minima with closer normals are one contact
constexpr double kSamePoint = 1e-12;                 // distance of equal nearest points [of their size]
constexpr double kOnIt = 1e-14;                      // a closer point has no direction to its nearest point [m]

double sign_of(double x) { return x < 0.0 ? -1.0 : 1.0; }

}  // namespace

struct ContactSurface::Triangles {
  using Candidate = NearTriangle;

  TrianglePieces pieces;
  fcl::BVHModel<fcl::AABBd> tree;

  const Eigen::Vector3d& vertex(const PieceTriangle& t, int k) const { return pieces.vertices[t.corners[k]]; }
  Candidate candidate(std::size_t i, const Eigen::Vector3d& p) const {
    const PieceTriangle& t = pieces.triangles[i];
    Candidate out{i, nearest_on_triangle(p, vertex(t, 0), vertex(t, 1), vertex(t, 2)), 0.0};
    const bool on_face = out.at.edge < 0 && out.at.corner < 0;
    out.distance = on_face ? std::abs(t.normal.dot(p - vertex(t, 0))) : (p - out.at.point).norm();
    return out;
  }
  // Of p, seen from the nearest point.
  double side(const Candidate& c, const Eigen::Vector3d& p) const {
    const PieceTriangle& t = pieces.triangles[c.triangle];
    if (c.at.edge >= 0) return sign_of(t.edge_normal[c.at.edge].dot(p - c.at.point));
    if (c.at.corner >= 0) return sign_of(t.corner_normal[c.at.corner].dot(p - c.at.point));
    return sign_of(t.normal.dot(p - vertex(t, 0)));
  }
  bool on_border(const Candidate& c) const {
    const PieceTriangle& t = pieces.triangles[c.triangle];
    return (c.at.edge >= 0 && t.edge_is_border[c.at.edge]) || (c.at.corner >= 0 && t.corner_is_border[c.at.corner]);
  }
  void find(int node, const fcl::AABBd& box, const Eigen::Vector3d& p, std::vector<Candidate>& near) const {
    const fcl::BVNode<fcl::AABBd>& bv = tree.getBV(node);
    if (!bv.bv.overlap(box)) return;
    if (bv.isLeaf()) {
      near.push_back(candidate(static_cast<std::size_t>(bv.primitiveId()), p));
      return;
    }
    find(bv.leftChild(), box, p, near);
    find(bv.rightChild(), box, p, near);
  }
  bool shares(const PieceTriangle& t, int corner) const { return (t.corners.array() == corner).any(); }
  // The nearest point on an edge or corner is a minimum of the distance if no neighbour is nearer.
  bool is_minimum(const Candidate& c, const Eigen::Vector3d& p, const std::vector<Candidate>& near) const {
    if (c.at.edge < 0 && c.at.corner < 0) return true;
    const PieceTriangle& t = pieces.triangles[c.triangle];
    const int first = t.corners[c.at.edge >= 0 ? c.at.edge : c.at.corner];
    const int second = c.at.edge >= 0 ? t.corners[(c.at.edge + 1) % 3] : first;
    const double tolerance = kSamePoint * (p.norm() + c.distance);
    for (const Candidate& other : near) {
      const PieceTriangle& o = pieces.triangles[other.triangle];
      if (!shares(o, first) || !shares(o, second)) continue;
      if ((other.at.point - c.at.point).norm() > tolerance && other.distance < c.distance) return false;
    }
    return true;
  }
  SurfaceTouch touch(const Candidate& c, const Eigen::Vector3d& p, double outside) const {
    const PieceTriangle& t = pieces.triangles[c.triangle];
    SurfaceTouch out;
    const bool on_face = c.at.edge < 0 && c.at.corner < 0;
    const double s = outside * side(c, p);
    out.distance = s * c.distance;
    if (on_face || c.distance < kOnIt) {
      out.normal = outside * t.normal;
      return out;
    }
    out.normal = s / c.distance * (p - c.at.point);
    out.bend = Eigen::Matrix3d::Identity() - out.normal * out.normal.transpose();
    if (c.at.edge >= 0) {
      const Eigen::Vector3d along = (vertex(t, (c.at.edge + 1) % 3) - vertex(t, c.at.edge)).normalized();
      out.bend -= along * along.transpose();
    }
    out.bend /= out.distance;
    return out;
  }
};

ContactSurface::ContactSurface() = default;
ContactSurface::~ContactSurface() = default;
ContactSurface::ContactSurface(ContactSurface&&) noexcept = default;

bool ContactSurface::empty() const { return planes_.empty() && capsules_.empty() && meshes_.empty(); }

bool ContactSurface::may_touch(const Eigen::Vector3d& p, double distance, const SurfaceSides& sides) const {
  for (std::size_t k = 0; k < planes_.size(); ++k)
    if (sides[k] * planes_[k].normal.dot(p - planes_[k].point) < distance) return true;
  for (const Capsule& capsule : capsules_) {
    const double half = 0.5 * (capsule.to - capsule.from).norm();
    if ((p - 0.5 * (capsule.from + capsule.to)).norm() < distance + half + capsule.radius) return true;
  }
  const Eigen::Vector3d wide = Eigen::Vector3d::Constant(distance);
  const fcl::AABBd box(p - wide, p + wide);
  for (const auto& mesh : meshes_)
    if (mesh->tree.getBV(0).bv.overlap(box)) return true;
  return false;
}

void ContactSurface::add_plane(const Eigen::Vector3d& point, const Eigen::Vector3d& normal) {
  planes_.push_back({point, normal});
}

void ContactSurface::add_capsule(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius) {
  capsules_.push_back({from, to, radius});
}

void ContactSurface::add_triangles(const Eigen::Matrix3Xd& vertices, const std::vector<Eigen::Vector3i>& triangles) {
  auto mesh = std::make_unique<Triangles>();
  mesh->pieces = triangle_pieces(vertices, triangles);
  const TrianglePieces& pieces = mesh->pieces;
  std::vector<fcl::Triangle> three;
  for (const PieceTriangle& t : pieces.triangles)
    three.emplace_back(static_cast<std::size_t>(t.corners[0]), static_cast<std::size_t>(t.corners[1]),
                       static_cast<std::size_t>(t.corners[2]));
  mesh->tree.beginModel(static_cast<int>(three.size()), static_cast<int>(pieces.vertices.size()));
  mesh->tree.addSubModel(pieces.vertices, three);
  FOOTFALL_DEMAND(mesh->tree.endModel() == fcl::BVH_OK);
  meshes_.push_back(std::move(mesh));
}

SurfaceSides ContactSurface::sides_of(const std::vector<Eigen::Vector3d>& points, double& across) const {
  struct Count {
    int plus = 0, minus = 0;
    double far_plus = 0.0, far_minus = 0.0;  // [m]
    void add(double sign, double distance) {
      ++(sign < 0.0 ? minus : plus);
      double& far = sign < 0.0 ? far_minus : far_plus;
      far = std::max(far, distance);
    }
  };
  SurfaceSides sides;
  across = 0.0;
  const auto take = [&](const Count& count) {
    const bool turned = count.minus > count.plus;
    sides.push_back(turned ? -1.0 : 1.0);
    across = std::max(across, turned ? count.far_plus : count.far_minus);
  };
  for (const Plane& plane : planes_) {
    Count count;
    for (const Eigen::Vector3d& p : points) {
      const double distance = plane.normal.dot(p - plane.point);
      count.add(distance, std::abs(distance));
    }
    take(count);
  }
  for (const auto& mesh : meshes_) {
    std::vector<Count> counts(mesh->pieces.open.size()), beside(counts.size());  // nearest to a border
    std::vector<Triangles::Candidate> nearest(counts.size());
    for (const Eigen::Vector3d& p : points) {
      for (Triangles::Candidate& one : nearest) one.distance = std::numeric_limits<double>::infinity();
      for (std::size_t i = 0; i < mesh->pieces.triangles.size(); ++i) {
        const Triangles::Candidate c = mesh->candidate(i, p);
        Triangles::Candidate& best = nearest[mesh->pieces.triangles[i].piece];
        if (c.distance < best.distance) best = c;
      }
      for (std::size_t k = 0; k < counts.size(); ++k)
        (mesh->on_border(nearest[k]) ? beside : counts)[k].add(mesh->side(nearest[k], p), nearest[k].distance);
    }
    for (std::size_t k = 0; k < counts.size(); ++k) {
      const bool over_it = counts[k].plus + counts[k].minus > 0;
      take(over_it ? counts[k] : Count{beside[k].plus, beside[k].minus, 0.0, 0.0});  // beyond a border none is across
    }
  }
  return sides;
}

void ContactSurface::touches(const Eigen::Vector3d& p, double radius, double depth, const SurfaceSides& sides,
                             std::vector<NearTriangle>& near, std::vector<SurfaceTouch>& out) const {
  out.clear();
  std::size_t piece = 0;  // counts planes and pieces of meshes
  for (const Plane& plane : planes_) {
    const double outside = sides[piece++];
    const double distance = outside * plane.normal.dot(p - plane.point);
    if (distance < radius) out.push_back({distance, outside * plane.normal, Eigen::Matrix3d::Zero()});
  }
  SurfaceTouch nearest;
  nearest.distance = radius;
  for (const Capsule& capsule : capsules_) {
    const Eigen::Vector3d axis = capsule.to - capsule.from;
    const double length = axis.squaredNorm();
    const double share = length > 0.0 ? std::clamp((p - capsule.from).dot(axis) / length, 0.0, 1.0) : 0.0;
    const Eigen::Vector3d d = p - (capsule.from + share * axis);
    const double size = d.norm();
    if (size - capsule.radius >= nearest.distance || size < kOnIt) continue;
    nearest.distance = size - capsule.radius;
    nearest.normal = d / size;
    nearest.bend = Eigen::Matrix3d::Identity() - nearest.normal * nearest.normal.transpose();
    if (share > 0.0 && share < 1.0) nearest.bend -= axis * axis.transpose() / length;
    nearest.bend /= size;
  }
  if (nearest.distance < radius) out.push_back(nearest);

  for (const auto& mesh : meshes_) {
    const Eigen::Vector3d wide = Eigen::Vector3d::Constant(std::max(radius, depth));
    near.clear();
    mesh->find(0, fcl::AABBd(p - wide, p + wide), p, near);
    const std::size_t first_piece = piece;
    piece += mesh->pieces.open.size();
    if (near.empty()) continue;
    std::sort(near.begin(), near.end(),
              [](const Triangles::Candidate& a, const Triangles::Candidate& b) { return a.distance < b.distance; });
    const auto touch = [&](const Triangles::Candidate& c) {
      const std::size_t k = mesh->pieces.triangles[c.triangle].piece;
      const bool alike = mesh->pieces.open[k] && radius > 0.0;  // both sides
      return mesh->touch(c, p, alike ? mesh->side(c, p) : sides[first_piece + k]);
    };
    // Within: the nearest point alone.
    const SurfaceTouch first = touch(near.front());
    if (first.distance < 0.0 || radius == 0.0) {
      if (first.distance < 0.0 && -first.distance < depth && !mesh->on_border(near.front())) out.push_back(first);
      continue;
    }
    const auto of_this_mesh = static_cast<std::ptrdiff_t>(out.size());
    for (const Triangles::Candidate& c : near) {
      if (c.distance >= radius) break;
      const SurfaceTouch one = touch(c);
      if (one.distance < 0.0 || !mesh->is_minimum(c, p, near)) continue;
      const bool known = std::any_of(out.begin() + of_this_mesh, out.end(), [&](const SurfaceTouch& other) {
        return other.normal.dot(one.normal) > kOneSurface;
      });
      if (!known) out.push_back(one);
    }
  }
}

}  // namespace footfall
