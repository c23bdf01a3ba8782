#include "liggghts_fix/facet_width.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <utility>

namespace footfall {
namespace {

// LIGGGHTS counts facets as coplanar by this cosine, where the script gives no other curvature.
const double kFlat = 1.0 - 1e-5, kEdge = std::cos(60.0 * M_PI / 180.0);

}  // namespace

std::vector<double> curved_facet_widths(const Eigen::Matrix3Xd& rho0, const std::vector<CornerNodes>& corners) {
  std::vector<double> width(corners.size(), std::numeric_limits<double>::infinity());
  std::vector<Eigen::Vector3d> normal(corners.size());
  std::vector<double> height(corners.size());
  std::map<std::pair<int, int>, std::vector<std::size_t>> beside;  // triangles at an edge
  for (std::size_t t = 0; t < corners.size(); ++t) {
    const auto& [a, b, c] = corners[t];
    const Eigen::Vector3d ab = rho0.col(b) - rho0.col(a), ac = rho0.col(c) - rho0.col(a), bc = ac - ab;
    const Eigen::Vector3d twice_area = ab.cross(ac);
    height[t] = twice_area.norm() / std::max({ab.norm(), ac.norm(), bc.norm()});
    normal[t] = twice_area.normalized();
    for (const auto& [i, j] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)})
      beside[{std::min(i, j), std::max(i, j)}].push_back(t);
  }
  for (const auto& [edge, triangles] : beside)
    for (const std::size_t s : triangles)
      for (const std::size_t t : triangles) {
        const double cosine = std::abs(normal[s].dot(normal[t]));
        if (cosine < kFlat && cosine > kEdge) width[t] = height[t];
      }
  return width;
}

}  // namespace footfall
