#pragma once
// A bent tube: as a chain of segments for the beam wall, and as triangles for stock LIGGGHTS.

#include <Eigen/Dense>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <sstream>
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
  // open at both ends. The middles of its facets are at phi = 2 pi k / around. Corner k of node i has number
  // around * i + k.
  std::vector<Eigen::Vector3d> corners(int around) const {
    const double mitre = 1.0 / std::cos(0.5 * angle / segments);  // cuts through node and arc's centre, at the ends too
    std::vector<Eigen::Vector3d> list;
    for (int i = 0; i <= segments; ++i)
      for (int k = 0; k < around; ++k) {
        const double phi = 2.0 * M_PI * (k + 0.5) / around;
        list.push_back(node(i) +
                       radius * (std::cos(phi) * mitre * radial(i) + std::sin(phi) * Eigen::Vector3d::UnitY()));
      }
    return list;
  }
  std::vector<Eigen::Vector3i> triangles(int around) const {
    std::vector<Eigen::Vector3i> list;
    for (int i = 0; i < segments; ++i)
      for (int k = 0; k < around; ++k) {
        const int a = around * i + k, b = around * i + (k + 1) % around;
        list.emplace_back(a, a + around, b + around);
        list.emplace_back(a, b + around, b);
      }
    return list;
  }

  void write_stl(const std::string& path, int around) const {
    const std::vector<Eigen::Vector3d> x = corners(around);
    std::ofstream out(path);
    out.precision(17);
    out << "solid tube\n";
    for (const Eigen::Vector3i& t : triangles(around)) {
      const auto at = [&](int c) { return x[static_cast<std::size_t>(t[c])]; };
      out << "facet normal " << (at(1) - at(0)).cross(at(2) - at(0)).normalized().transpose() << "\nouter loop\n";
      for (int c = 0; c < 3; ++c) out << "vertex " << at(c).transpose() << "\n";
      out << "endloop\nendfacet\n";
    }
    out << "endsolid tube\n";
  }
  // The same as nodes and triangles of a scripted body.
  std::string surface_statements(int around) const {
    std::ostringstream text;
    text.precision(17);
    for (const Eigen::Vector3d& x : corners(around)) text << "node " << x.transpose() << "\n";
    for (const Eigen::Vector3i& t : triangles(around)) text << "triangle " << t.transpose() << "\n";
    return text.str();
  }
};

}  // namespace footfall::test
