// Smooth edges join facets to pieces by disjoint sets; the facets around a node that smooth edges join are neighbours.

#include "liggghts_fix/link/surface_pieces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <set>
#include <tuple>
#include <utility>

namespace footfall {
namespace {

// Cosine of the smallest angle between facets that is more than round-off of the nodes.
const double kFlatTurn = std::cos(1e-4);

// A point this close to an edge counts as on it [of the facet's size].
constexpr double kOnEdge = 1e-9;

// Disjoint sets of 0 ... n - 1.
class Sets {
 public:
  explicit Sets(std::size_t n) : parent_(n) { std::iota(parent_.begin(), parent_.end(), 0); }
  int of(int i) {
    int root = i;
    while (parent_[root] != root) root = parent_[root];
    while (i != root) i = std::exchange(parent_[i], root);
    return root;
  }
  void join(int i, int j) { parent_[of(i)] = of(j); }

 private:
  std::vector<int> parent_;
};

struct SmoothEdge {
  int facet, other;
  int node[2];
};

// Unit vector in the facet, across the edge from a to b, towards the third corner.
Eigen::Vector3d inward(const Eigen::Matrix3Xd& rho0, const CornerNodes& corners, int a, int b) {
  const int c = corners[0] + corners[1] + corners[2] - a - b;
  const Eigen::Vector3d along = (rho0.col(b) - rho0.col(a)).normalized(), to_c = rho0.col(c) - rho0.col(a);
  return (to_c - to_c.dot(along) * along).normalized();
}

// Cosine from which LIGGGHTS takes facets as coplanar by default, and cosine of the largest angle that is no edge.
const double kCoplanar = 1.0 - 1e-5, kEdge = std::cos(60.0 * M_PI / 180.0);

}  // namespace

SurfacePieces::SurfacePieces(const Eigen::Matrix3Xd& rho0, std::vector<CornerNodes> corners, double edge_angle)
    : corners_(std::move(corners)), piece_(corners_.size()), neighbours_(corners_.size()), inside_(corners_.size()) {
  std::map<std::pair<int, int>, std::vector<int>> at_edge;
  for (std::size_t t = 0; t < corners_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners_[t][k], b = corners_[t][(k + 1) % 3];
      at_edge[{std::min(a, b), std::max(a, b)}].push_back(static_cast<int>(t));
    }

  // In one plane the inward directions are opposite: the cosine of the angle is minus their product.
  const double sharp = std::cos(edge_angle);
  std::vector<SmoothEdge> smooth;
  std::map<std::pair<int, int>, int> smooth_pairs;
  Sets pieces(corners_.size());
  for (const auto& [edge, facets] : at_edge)
    for (std::size_t i = 0; i < facets.size(); ++i)
      for (std::size_t j = i + 1; j < facets.size(); ++j) {
        const auto [a, b] = edge;
        const double turn =
            -inward(rho0, this->corners(facets[i]), a, b).dot(inward(rho0, this->corners(facets[j]), a, b));
        if (turn <= sharp) continue;
        if (turn < kFlatTurn) curved_ = true;
        smooth.push_back({facets[i], facets[j], {a, b}});
        ++smooth_pairs[edge];
        pieces.join(facets[i], facets[j]);
      }
  for (std::size_t t = 0; t < corners_.size(); ++t) piece_[t] = pieces.of(static_cast<int>(t));

  // An edge is inside a piece when it has two facets, one on each side.
  std::set<int> on_border;  // nodes
  const auto is_inside = [&](const std::pair<int, int>& edge) {
    return at_edge.at(edge).size() == 2 && smooth_pairs.count(edge) > 0;
  };
  for (const auto& [edge, facets] : at_edge)
    if (!is_inside(edge)) on_border.insert({edge.first, edge.second});
  for (std::size_t t = 0; t < corners_.size(); ++t)
    for (std::size_t k = 0; k < 3; ++k) {
      const int a = corners_[t][k], b = corners_[t][(k + 1) % 3];
      inside_[t].edge[k] = is_inside({std::min(a, b), std::max(a, b)});
      inside_[t].corner[k] = on_border.count(a) == 0;
    }

  // Around each node: the facets that its smooth edges join.
  std::map<int, std::vector<const SmoothEdge*>> at_node;
  for (const SmoothEdge& edge : smooth)
    for (const int node : edge.node) at_node[node].push_back(&edge);
  for (const auto& [node, edges] : at_node) {
    std::vector<int> facets;
    for (const SmoothEdge* edge : edges) facets.insert(facets.end(), {edge->facet, edge->other});
    std::sort(facets.begin(), facets.end());
    facets.erase(std::unique(facets.begin(), facets.end()), facets.end());
    const auto place = [&facets](int facet) {
      return static_cast<int>(std::lower_bound(facets.begin(), facets.end(), facet) - facets.begin());
    };
    Sets fans(facets.size());
    for (const SmoothEdge* edge : edges) fans.join(place(edge->facet), place(edge->other));
    for (const int s : facets)
      for (const int t : facets)
        if (s != t && fans.of(place(s)) == fans.of(place(t))) neighbours_[s].push_back(t);
  }
  for (std::vector<int>& around : neighbours_) {
    std::sort(around.begin(), around.end());
    around.erase(std::unique(around.begin(), around.end()), around.end());
  }
}

bool SurfacePieces::are_neighbours(int facet, int other) const {
  const std::vector<int>& around = neighbours_[facet];
  return std::binary_search(around.begin(), around.end(), other);
}

bool SurfacePieces::inside_piece(int facet, const std::array<double, 3>& weights) const {
  const Inside& inside = inside_[facet];
  for (std::size_t k = 0; k < 3; ++k) {
    if (weights[k] > 1.0 - kOnEdge) return inside.corner[k];
    if (weights[(k + 2) % 3] < kOnEdge && !inside.edge[k] && weights[k] > kOnEdge && weights[(k + 1) % 3] > kOnEdge)
      return false;
  }
  return true;
}

bool yields_to(const FacetTouch& facet, const FacetTouch& other, const SurfacePieces& pieces) {
  if (other.gap > facet.gap) return false;
  if (!pieces.curved() && (facet.on_border || other.on_border)) return false;
  const auto place = [](const FacetTouch& touch) { return std::tuple(touch.gap, !touch.acts, touch.facet); };
  return place(other) < place(facet) && pieces.are_neighbours(facet.facet, other.facet);
}

std::vector<double> curved_facet_widths(const Eigen::Matrix3Xd& rho0, const std::vector<CornerNodes>& corners) {
  std::vector<double> width(corners.size(), std::numeric_limits<double>::infinity());
  std::vector<Eigen::Vector3d> normal(corners.size());
  std::vector<double> height(corners.size());
  std::map<std::pair<int, int>, std::vector<std::size_t>> at_edge;  // triangles
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const auto& [a, b, c] = corners[t];
    const Eigen::Vector3d ab = rho0.col(b) - rho0.col(a), ac = rho0.col(c) - rho0.col(a), bc = ac - ab;
    const Eigen::Vector3d twice_area = ab.cross(ac);
    height[t] = twice_area.norm() / std::max({ab.norm(), ac.norm(), bc.norm()});
    normal[t] = twice_area.normalized();
    for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      at_edge[{std::min(i, j), std::max(i, j)}].push_back(t);
  }
  for (const auto& [edge, triangles] : at_edge)
    for (const std::size_t s : triangles)
      for (const std::size_t t : triangles) {
        const double cosine = std::abs(normal[s].dot(normal[t]));
        if (cosine < kCoplanar && cosine > kEdge) width[t] = height[t];
      }
  return width;
}

}  // namespace footfall
