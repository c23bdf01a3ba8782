#pragma once
// Reads and writes ASCII STL files for tests: the triangles as LIGGGHTS reads them, number by number.

#include <Eigen/Dense>
#include <fstream>
#include <stdexcept>
#include <string>
#include <vector>

namespace footfall::test {

struct Surface {
  Eigen::Matrix3Xd nodes;
  std::vector<Eigen::Vector3i> triangles;
};

// Vertices with the same coordinates become one node.
inline Surface read_stl(const std::string& path) {
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot open " + path);
  std::vector<Eigen::Vector3d> nodes;
  std::vector<int> corners;
  std::string word;
  while (in >> word) {
    if (word != "vertex") continue;
    Eigen::Vector3d p;
    in >> p[0] >> p[1] >> p[2];
    std::size_t j = 0;
    while (j < nodes.size() && nodes[j] != p) ++j;
    if (j == nodes.size()) nodes.push_back(p);
    corners.push_back(static_cast<int>(j));
  }
  Surface surface;
  surface.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t j = 0; j < nodes.size(); ++j) surface.nodes.col(static_cast<Eigen::Index>(j)) = nodes[j];
  for (std::size_t k = 0; k + 2 < corners.size(); k += 3)
    surface.triangles.emplace_back(corners[k], corners[k + 1], corners[k + 2]);
  return surface;
}

inline void write_stl(const std::string& path, const Surface& surface) {
  std::ofstream out(path);
  out.precision(17);
  out << "solid body\n";
  for (const Eigen::Vector3i& t : surface.triangles) {
    out << " facet normal 0 0 1\n  outer loop\n";
    for (const int j : t)
      out << "   vertex " << surface.nodes(0, j) << " " << surface.nodes(1, j) << " " << surface.nodes(2, j) << "\n";
    out << "  endloop\n endfacet\n";
  }
  out << "endsolid body\n";
}

// Closed box of the given edges [m] around the origin, each face cut into cells x cells squares of two
// triangles.
inline Surface box(const Eigen::Vector3d& edges, int cells) {
  Surface surface;
  std::vector<Eigen::Vector3d> nodes;
  const auto node = [&nodes](const Eigen::Vector3d& p) {
    for (std::size_t j = 0; j < nodes.size(); ++j)
      if ((nodes[j] - p).norm() < 1e-12) return static_cast<int>(j);
    nodes.push_back(p);
    return static_cast<int>(nodes.size()) - 1;
  };
  for (int axis = 0; axis < 3; ++axis)
    for (int side = -1; side <= 1; side += 2)
      for (int i = 0; i < cells; ++i)
        for (int j = 0; j < cells; ++j) {
          const auto corner = [&](int di, int dj) {
            Eigen::Vector3d p;
            p[axis] = 0.5 * side * edges[axis];
            p[(axis + 1) % 3] = ((i + di) / static_cast<double>(cells) - 0.5) * edges[(axis + 1) % 3];
            p[(axis + 2) % 3] = ((j + dj) / static_cast<double>(cells) - 0.5) * edges[(axis + 2) % 3];
            return node(p);
          };
          const int a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
          if (side > 0) {
            surface.triangles.emplace_back(a, b, c);
            surface.triangles.emplace_back(a, c, d);
          } else {
            surface.triangles.emplace_back(a, c, b);
            surface.triangles.emplace_back(a, d, c);
          }
        }
  surface.nodes.resize(3, static_cast<Eigen::Index>(nodes.size()));
  for (std::size_t j = 0; j < nodes.size(); ++j) surface.nodes.col(static_cast<Eigen::Index>(j)) = nodes[j];
  return surface;
}

}  // namespace footfall::test
