#include "mbd_solver/fe/triangle_mesh.h"

#include <array>
#include <cmath>
#include <map>

#include "coupler/base/errors.h"

namespace footfall {

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
  TriangleMesh result = mesh;
  for (Eigen::Vector3d& x : result.vertices) x = R * x + p;
  return result;
}

// Vertices are sorted into cells of the size of the tolerance; a partner is in the same or in a neighbouring
// cell.
TriangleMesh welded(const TriangleMesh& mesh, double tolerance) {
  FOOTFALL_DEMAND(tolerance > 0.0);
  using Cell = std::array<long, 3>;
  TriangleMesh result;
  std::map<Cell, std::vector<int>> cells;
  std::vector<int> number(mesh.vertices.size(), -1);
  const auto find_or_add = [&](const Eigen::Vector3d& x) {
    Cell home{};
    for (int i = 0; i < 3; ++i) home[static_cast<std::size_t>(i)] = std::lround(x(i) / tolerance);
    for (long i = -1; i <= 1; ++i)
      for (long j = -1; j <= 1; ++j)
        for (long k = -1; k <= 1; ++k) {
          const auto cell = cells.find({home[0] + i, home[1] + j, home[2] + k});
          if (cell == cells.end()) continue;
          for (int candidate : cell->second)
            if ((result.vertices[static_cast<std::size_t>(candidate)] - x).norm() <= tolerance) return candidate;
        }
    const int added = static_cast<int>(result.vertices.size());
    result.vertices.push_back(x);
    cells[home].push_back(added);
    return added;
  };
  for (const Eigen::Vector3i& triangle : mesh.triangles) {
    Eigen::Vector3i corners;
    for (int i = 0; i < 3; ++i) {
      FOOTFALL_DEMAND(triangle(i) >= 0 && triangle(i) < static_cast<int>(mesh.vertices.size()));
      int& n = number[static_cast<std::size_t>(triangle(i))];
      if (n < 0) n = find_or_add(mesh.vertices[static_cast<std::size_t>(triangle(i))]);
      corners(i) = n;
    }
    result.triangles.push_back(corners);
  }
  return result;
}

}  // namespace footfall
