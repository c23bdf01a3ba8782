// One grain pressed into a curved mesh: what it feels, against the exact surface.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

// A ring of longitude and latitude on a sphere, or a cylinder along y, around the origin; w [m]: about the width of a facet.
struct Shape {
  bool sphere;
  double radius;  // [m]
};

Surface tessellated(const Shape& shape, double w, double half_angle) {
  // A patch around the top: cells in angle u (about y) and v (about x; along y on the cylinder).
  const int n = std::max(2, 2 * static_cast<int>(std::ceil(shape.radius * half_angle / w)));
  const double step = w / shape.radius;
  Surface surface;
  surface.nodes.resize(3, (n + 1) * (n + 1));
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) {
      const double u = (i - n / 2) * step, v = (j - n / 2) * step;
      surface.nodes.col(i * (n + 1) + j) =
          shape.radius * (shape.sphere ? Eigen::Vector3d(std::sin(u) * std::cos(v), std::sin(v), std::cos(u) * std::cos(v))
                                       : Eigen::Vector3d(std::sin(u), v, std::cos(u)));
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1, c = b + 1, d = a + 1;
      surface.triangles.emplace_back(a, b, c);
      surface.triangles.emplace_back(a, c, d);
    }
  return surface;
}

constexpr double kR = 0.02, kOverlap = 0.01 * kR;  // of the grains

// Grains that stand still over the top, at random places of one facet's size: force of each over that of the flat wall
// at the overlap with the exact surface.
std::vector<Eigen::Vector2d> forces(const std::string& name, const Shape& shape, double w, const std::string& words,
                           double sign = 1.0) {
  const RunFolder folder("curved_" + name);
  const double patch = std::sqrt(2.0 * kR * kOverlap);
  write_stl((folder.path() / "body.stl").string(), tessellated(shape, w, (2.0 * std::max(patch, w)) / shape.radius));
  constexpr int kGrains = 40;
  std::ostringstream in;
  in.precision(17);
  in << script_head("-0.6 0.6 -0.6 0.6 -0.6 0.6", "* * *", 1e-7);
  // The pair law would make overlapping grains push each other: they are excluded.
  in << "neigh_modify exclude type 1 1\n";
  std::srand(7);
  for (int i = 0; i < kGrains; ++i) {
    const double u = (2.0 * std::rand() / RAND_MAX - 1.0) * w / shape.radius;
    const double v = (2.0 * std::rand() / RAND_MAX - 1.0) * w / shape.radius;
    const Eigen::Vector3d n = shape.sphere
                                  ? Eigen::Vector3d(std::sin(u) * std::cos(v), std::sin(v), std::cos(u) * std::cos(v))
                                  : Eigen::Vector3d(std::sin(u), 0.0, std::cos(u));
    const Eigen::Vector3d at = (shape.radius + sign * (kR - kOverlap)) * n + (shape.sphere ? 0.0 : shape.radius * v) * Eigen::Vector3d::UnitY();
    in << "create_atoms 1 single " << at.x() << " " << at.y() << " " << at.z() << " units box\n";
  }
  in << "set group all diameter " << 2 * kR
     << " density 2600\nfix geo all couple/mbd/geometry body cap\nfix m all mesh/surface fix geo type 2 curvature 1e-6\n"
     << mesh_wall() << "fix mbd all couple/mbd every 1 " << words << " mesh m cap\n"
     << dump_every(1, "grains") << "thermo 1\nrun 1\n";
  folder.write("in", in.str());
  const Outcome outcome = folder.coupled(1, "-in in", "until 1e-7 body cap body.stl 0 0 0 prescribed 0 0 0 0 0 0");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  const double E = 1.0 / ((1.0 - 0.25 * 0.25) / 35e6 + (1.0 - 0.1 * 0.1) / 207e9);
  const double F = 4.0 / 3.0 * E * std::sqrt(kR) * std::pow(kOverlap, 1.5);
  std::vector<Eigen::Vector2d> found;
  for (const std::vector<double>& row : read_dump(folder.read("grains.1"))) {
    const Eigen::Vector3d x(row[1], shape.sphere ? row[2] : 0.0, row[3]), f(row[10], row[11], row[12]);
    const double along = sign * f.dot(x.normalized());
    found.emplace_back(along / F, (f - sign * along * x.normalized()).norm() / F);
  }
  EXPECT_EQ(found.size(), static_cast<std::size_t>(kGrains));
  return found;
}

TEST(Explore, Table) {
  const double patch = std::sqrt(2.0 * kR * kOverlap);
  for (const char* words : {"surface smooth"})
    for (const bool sphere : {false, true})
      for (const double ratio : {5.0, 10.0})
        for (const double w : {0.2, 0.33, 0.5})
          for (const double sign : {1.0, -1.0}) {
            const auto f = forces("x", {sphere, ratio * kR}, w * patch, words, sign);
            double lo = 1e9, hi = 0, mean = 0, side = 0;
            for (const auto& one : f) {
              lo = std::min(lo, one[0]);
              hi = std::max(hi, one[0]);
              mean += one[0] / static_cast<double>(f.size());
              side = std::max(side, one[1]);
            }
            std::printf("%s %s ratio %g %s w/patch %.2f: force %.4f to %.4f mean %.4f side %.4f\n", words,
                        sphere ? "sphere" : "cylinder", ratio, sign > 0 ? "outside" : "inside", w, lo, hi, mean, side);
            std::fflush(stdout);
          }
}

}  // namespace
}  // namespace footfall::test
