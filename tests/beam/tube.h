#pragma once
// A bent tube: as a chain of segments for the beam wall, and as triangles for stock LIGGGHTS.

#include <Eigen/Dense>
#include <fstream>
#include <string>
#include <vector>

namespace footfall::test {

// A polyline of equal segments along a circular arc in the x-z plane: from (arc_radius, 0, 0) on by `angle`
// about the origin.
struct BentTube {
  double arc_radius = 0.1;    // [m]
  double angle = M_PI / 3.0;  // [rad]
  int segments = 4;
  double radius = 0.03;  // of the tube [m]

  Eigen::Vector3d radial(double i) const {  // at the i-th node, away from the arc's centre
    const double a = angle * i / segments;
    return {std::cos(a), 0.0, std::sin(a)};
  }
  Eigen::Vector3d node(int i) const { return arc_radius * radial(i); }
  // Point of segment s at mu, at the distance `away` from the axis in the direction phi around it; phi = 0 is
  // away from the arc's centre.
  Eigen::Vector3d beside(int s, double mu, double phi, double away) const {
    return (1.0 - mu) * node(s) + mu * node(s + 1) +
           away * (std::cos(phi) * radial(s + 0.5) + std::sin(phi) * Eigen::Vector3d::UnitY());
  }

  std::vector<std::string> nodes() const {
    std::vector<std::string> lines;
    for (int i = 0; i <= segments; ++i) {
      const Eigen::Vector3d x = node(i);
      char line[100];
      std::snprintf(line, sizeof line, "%.17g %.17g %.17g", x.x(), x.y(), x.z());
      lines.emplace_back(line);
    }
    return lines;
  }

  // The surface with `around` flat facets about the axis, their corners on the tube, mitred at the joints,
  // open at both ends. The middles of its facets are at phi = 2 pi k / around.
  void write_stl(const std::string& path, int around) const {
    const double mitre = 1.0 / std::cos(0.5 * angle / segments);
    std::vector<std::vector<Eigen::Vector3d>> rings;  // corners at the nodes
    for (int i = 0; i <= segments; ++i) {
      rings.emplace_back();
      for (int k = 0; k < around; ++k) {
        const double phi = 2.0 * M_PI * (k + 0.5) / around;
        // Cut by the plane through the node and the centre of the arc; at the ends, where no segment follows,
        // too.
        rings.back().push_back(node(i) + radius * (std::cos(phi) * mitre * radial(i) +
                                                   std::sin(phi) * Eigen::Vector3d::UnitY()));
      }
    }
    std::ofstream out(path);
    out.precision(17);
    out << "solid tube\n";
    const auto triangle = [&out](const Eigen::Vector3d& a, const Eigen::Vector3d& b,
                                 const Eigen::Vector3d& c) {
      const Eigen::Vector3d n = (b - a).cross(c - a).normalized();
      out << "facet normal " << n.transpose() << "\nouter loop\n";
      for (const Eigen::Vector3d& v : {a, b, c}) out << "vertex " << v.transpose() << "\n";
      out << "endloop\nendfacet\n";
    };
    for (std::size_t i = 0; i + 1 < rings.size(); ++i)
      for (std::size_t k = 0; k < rings[i].size(); ++k) {
        const std::size_t next = (k + 1) % rings[i].size();
        triangle(rings[i][k], rings[i + 1][k], rings[i + 1][next]);
        triangle(rings[i][k], rings[i + 1][next], rings[i][next]);
      }
    out << "endsolid tube\n";
  }
};

}  // namespace footfall::test
