// Curved surfaces among grains.
#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/coupling/codes.h"
#include "tests/coupled/coupled_run.h"
#include "tests/support/refused.h"

namespace footfall::test {
namespace surfaces {

// One grain pressed into a curved mesh: what it feels, against the exact surface.

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
          shape.radius * (shape.sphere
                              ? Eigen::Vector3d(std::sin(u) * std::cos(v), std::sin(v), std::cos(u) * std::cos(v))
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

// Grains that stand still over the top, at random places of one facet's size: force of each over the flat wall's force
// at the overlap with the exact surface.
std::vector<Eigen::Vector2d> forces(const std::string& name, const Shape& shape, double w, const std::string& words,
                                    double sign = 1.0) {
  const RunFolder folder("curved_" + name);
  const double patch = std::sqrt(2.0 * kR * kOverlap);
  write_stl((folder.path() / "body.stl").string(), tessellated(shape, w, (patch + 3.0 * w) / shape.radius));
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
    const Eigen::Vector3d at = (shape.radius + sign * (kR - kOverlap)) * n +
                               (shape.sphere ? 0.0 : shape.radius * v) * Eigen::Vector3d::UnitY();
    in << "create_atoms 1 single " << at.x() << " " << at.y() << " " << at.z() << " units box\n";
  }
  in << "set group all diameter " << 2 * kR
     << " density 2600\nfix geo all couple/mbd/geometry body cap\nfix m all mesh/surface fix geo type 2 curvature "
        "1e-6\n"
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

// Of the contact [m]: beyond it the two surfaces are apart.
const double kPatch = std::sqrt(2.0 * kR * kOverlap);

struct Case {
  bool sphere;
  double radius, width;  // of the surface over the grain's, of its facets over the patch [-]
  double sign;           // 1: the grain is outside, -1: inside

  // Share of the overlap that a chord of the mesh takes or gives, at most: w^2 / (8 R_s) on a cylinder, and with the
  // diagonals of the cells on a sphere.
  double sagitta() const { return std::pow(width * kPatch, 2) * (sphere ? 2.0 : 1.0) / (8.0 * radius * kR) / kOverlap; }
};

std::vector<Case> cases(const std::vector<double>& widths) {
  std::vector<Case> all;
  for (const bool sphere : {false, true})
    for (const double radius : {5.0, 10.0})
      for (const double width : widths)
        for (const double sign : {1.0, -1.0}) all.push_back({sphere, radius, width, sign});
  return all;
}

struct Range {
  double least = 1e300, largest = 0.0, aside = 0.0;
};

Range range(const Case& c, const std::string& words, const std::string& name) {
  Range range;
  for (const Eigen::Vector2d& f : forces(name, {c.sphere, c.radius * kR}, c.width * kPatch, words, c.sign)) {
    range.least = std::min(range.least, f[0]);
    range.largest = std::max(range.largest, f[0]);
    range.aside = std::max(range.aside, f[1]);
  }
  std::printf("%s, %s of %g grain radii, %s, facets of %.2f patches: %.4f to %.4f of one contact, %.4f aside\n",
              words.c_str(), c.sphere ? "sphere" : "cylinder", c.radius, c.sign > 0.0 ? "outside" : "inside", c.width,
              range.least, range.largest, range.aside);
  return range;
}

// Angles of the facets against the plane of the mean one, and what Hertz' power makes of them.
constexpr double kSecondOrder = 0.1;  // of the sagitta

TEST(CurvedSurface, IsTouchedOnceWhateverTheWidthOfItsFacets) {
  for (const Case& c : cases({0.2, 0.5, 1.0})) {
    const Range found = range(c, "surface smooth", "once");
    const double most = 1.0 + kSecondOrder;
    if (c.sign > 0.0) {
      EXPECT_GT(found.least, std::pow(1.0 - most * c.sagitta(), 1.5));
      EXPECT_LT(found.largest, 1.0 + 1e-6);
    } else {
      EXPECT_LT(found.largest, std::pow(1.0 + most * c.sagitta(), 1.5));
      EXPECT_GT(found.least, 1.0 - 1e-6);
    }
  }
}

TEST(CurvedSurface, ThatIsRoundIsTheExactOneWithinTwoPercent) {
  for (const Case& c : cases({0.2, 1.0, 2.0, 5.0})) {
    const Range found = range(c, "surface round", "round");
    EXPECT_GT(found.least, 0.98);
    EXPECT_LT(found.largest, 1.02);
    EXPECT_LT(found.aside, 0.02);
  }
}

// A grain that is held in place over a turning cylinder: friction is at its limit from the moment when the contact
// slides. Each facet that began anew would let it drop to nothing, and build up again over a twelfth of its width.
TEST(CurvedSurface, HandsFrictionOnFromFacetToFacet) {
  const RunFolder folder("curved_friction");
  const double radius = 5.0 * kR, width = 0.5 * kPatch, dt = 1e-5;
  const int steps = 400;
  write_stl((folder.path() / "body.stl").string(), tessellated({false, radius}, width, 4.0 * kPatch / radius));
  std::ostringstream in;
  in.precision(17);
  const double a = -1.5 * kPatch / radius;
  in << script_head("-0.6 0.6 -0.6 0.6 -0.6 0.6", "* * *", dt) << "create_atoms 1 single "
     << (radius + kR - kOverlap) * std::sin(a) << " 0.0003 " << (radius + kR - kOverlap) * std::cos(a)
     << " units box\nset group all diameter " << 2 * kR
     << " density 2600\nfix geo all couple/mbd/geometry body drum\nfix m all mesh/surface fix geo type 2 curvature "
        "1e-6\n"
     << mesh_wall() << "fix mbd all couple/mbd every 1 surface smooth mesh m drum\n"
     << "dump d all custom 1 forces.* id fx fy fz\ndump_modify d format \"%d %.17g %.17g %.17g\"\nthermo 100\nrun "
     << steps << "\n";
  folder.write("in", in.str());
  std::ostringstream partner;
  const double speed = 1.25 * kPatch / (steps * dt);  // of the surface: two and a half facets
  partner << "until " << steps * dt << " body drum body.stl 0 0 0 prescribed 0 0 0 0 " << speed / radius << " 0";
  const Outcome outcome = folder.coupled(1, "-in in", partner.str());
  ASSERT_EQ(outcome.exit_code, 0) << outcome.text;
  double least = 1e300;
  for (int step = steps / 4; step <= steps; ++step) {
    const std::vector<double> row = read_dump(folder.read("forces." + std::to_string(step))).at(0);
    const Eigen::Vector3d f(row[1], row[2], row[3]), along(std::cos(a), 0.0, -std::sin(a)),
        up(std::sin(a), 0.0, std::cos(a));
    least = std::min(least, std::abs(f.dot(along)) / f.dot(up));
  }
  std::printf("least friction over pressure: %.4f\n", least);
  EXPECT_NEAR(least, 0.3, 0.02);  // normals of the facets stray by a quarter of a degree
}

// What `surface facets` leaves as in stock LIGGGHTS: these are the factors of docs/fixes/couple_mbd.md.
TEST(CurvedSurface, OfManyFacetsAddsUpInStockContacts) {
  EXPECT_GT(range({false, 10.0, 0.2, 1.0}, "surface facets", "facets").least, 3.0);
  EXPECT_GT(range({true, 10.0, 0.2, 1.0}, "surface facets", "facets").least, 12.0);
}

// A fine ball strikes a fixed grain: what mbd_solver says of it.
std::string said_of(const std::string& words) {
  const RunFolder folder("curved_warning");
  folder.write("scene.toml", R"(title = "fine ball on a fixed grain"
end_time = 0.004
gravity = [0, 0, 0]
[materials.ball]
density = 2800
[[bodies]]
name = "ball"
material = "ball"
shape = { kind = "sphere", radius = 0.03, centre = [0, 0, 0.0301] }
[[boundaries]]
body = "ball"
surface = { element_size = 0.002, closed = true }
[ground]
kind = "particles"
[initial]
velocity = [0, 0, -0.2]
[particles]
script = "in"
ranks = 1
[output]
plots = false
)");
  folder.write("in",
               script_head("-0.1 0.1 -0.1 0.1 -0.1 0.1", "* * *", 1e-5) +
                   "create_atoms 1 single 0.0003 0.0001 -0.02 units box\nset group all diameter 0.04 density 2600\n"
                   "neigh_modify one 10000 page 200000\nfix geo all couple/mbd/geometry body ball\n"
                   "fix m all mesh/surface fix geo type 2\n" +
                   mesh_wall() + "fix mbd all couple/mbd every 2 " + words + " mesh m ball\nthermo 1000\nrun 100000\n");
  const Outcome outcome = folder.mpirun("-np 1 " + RunFolder::program("liggghts_mbd") + " -in in : -np 1 " +
                                            RunFolder::program("mbd_solver") + " scene.toml --out out",
                                        60);
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  return outcome.text + folder.read("out/summary.json");
}

TEST(CurvedSurface, OfManyFacetsIsWarnedOf) {
  const std::string facets = said_of("surface facets"), smooth = said_of("");
  EXPECT_TRUE(names(facets, {code::kFacetsTooSmall.number}));
  EXPECT_EQ(smooth.find(code::kFacetsTooSmall.number), std::string::npos) << smooth;
}

}  // namespace surfaces
}  // namespace footfall::test
