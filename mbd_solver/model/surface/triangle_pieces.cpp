#include "mbd_solver/model/surface/triangle_pieces.h"

#include <cmath>
#include <map>
#include <tuple>
#include <utility>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr double kSamePlace = 1e-9;  // corners so near are one [of the size of the surface]

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
          if ((vertices[static_cast<std::size_t>(found->second)] - p).norm() <= tolerance_) return found->second;
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

// Walks from triangle to triangle over edges that two share, and turns each like the one it comes from.
void turn_alike(TrianglePieces& out, const TrianglesAtEdge& at_edge) {
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
      const auto v = [&](int k) { return out.vertices[static_cast<std::size_t>(out.triangles[i].corners[k])]; };
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
    const auto v = [&](int k) { return out.vertices[static_cast<std::size_t>(t.corners[k % 3])]; };
    const Eigen::Vector3d across = (v(1) - v(0)).cross(v(2) - v(0));
    if (!(across.norm() > 0.0)) throw InputError("a triangle has no area");
    t.normal = across.normalized();
    for (int k = 0; k < 3; ++k) {
      const Eigen::Vector3d to = v(k + 1) - v(k), from = v(k + 2) - v(k);
      const double angle = std::atan2(to.cross(from).norm(), to.dot(from));
      at_corner[static_cast<std::size_t>(t.corners[k])] += angle * t.normal;
    }
  }
  for (const auto& [edge, triangles] : at_edge) {
    if (triangles.size() == 2) continue;
    border[static_cast<std::size_t>(edge.first)] = border[static_cast<std::size_t>(edge.second)] = true;
  }
  for (PieceTriangle& t : out.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto corner = static_cast<std::size_t>(t.corners[static_cast<Eigen::Index>(k)]);
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
  turn_alike(out, at_edge);
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

}  // namespace footfall
