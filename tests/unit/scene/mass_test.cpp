// mbd_solver/scene/resolve.h: mass, centre and inertia of bodies given by shapes.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/pi.h"
#include "mbd_solver/scene/boundary_surface.h"
#include "mbd_solver/scene/resolve.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

constexpr double kRoundOff = 1e-12;  // relative

BodySpec body_of(const std::string& entry) {
  const SceneText text;
  return text.read("end_time = 1\n[materials.steel]\ndensity = 7850\n[[bodies]]\nname = \"b\"\n" + entry).bodies[0];
}

TEST(SceneMasses, TubeOfAMaterialWeighsItsVolume) {
  const BodySpec b = body_of(
      "material = \"steel\"\nshape = { kind = \"tube\", from = [1, 0, 1], to = [1, 0, 3], diameter = 0.1, wall = 0.01 "
      "}\n");
  const double area = kPi / 4 * (0.1 * 0.1 - 0.08 * 0.08);
  EXPECT_NEAR(b.mass, 7850 * area * 2, kRoundOff * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(1, 0, 2)).norm(), 0.0, kRoundOff);
  const double r2 = 0.05 * 0.05 + 0.04 * 0.04;
  EXPECT_NEAR(b.inertia(2, 2), b.mass * r2 / 2, kRoundOff * b.mass);
  EXPECT_NEAR(b.inertia(0, 0), b.mass * (r2 / 4 + 4.0 / 12), kRoundOff * b.mass);
}

TEST(SceneMasses, BoxTurnsWithItsBodyAndKeepsItsInertiaThere) {
  const BodySpec b = body_of(
      "mass = 12\nshape = { kind = \"box\", size = [1, 2, 3], centre = [0, 0, 5] }\norientation = { rpy_deg = [90, 0, "
      "0] }\n");
  EXPECT_NEAR((b.inertia - Eigen::Matrix3d(Eigen::Vector3d(13, 10, 5).asDiagonal())).norm(), 0.0, 1e-10);
  EXPECT_NEAR((b.orientation * Eigen::Vector3d::UnitY() - Eigen::Vector3d::UnitZ()).norm(), 0.0, kRoundOff);
}

TEST(SceneMasses, CylinderLiesAlongItsAxis) {
  const BodySpec b = body_of(
      "material = \"steel\"\nshape = { kind = \"cylinder\", centre = [1, 2, 3], axis = \"y\", radius = 0.1, length = "
      "0.3 }\n");
  EXPECT_NEAR(b.mass, 7850 * kPi * 0.01 * 0.3, kRoundOff * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(1, 2, 3)).norm(), 0.0, kRoundOff);
  EXPECT_NEAR(b.inertia(1, 1), b.mass * 0.01 / 2, kRoundOff * b.mass);
  EXPECT_NEAR(b.inertia(0, 0), b.mass * (0.01 / 4 + 0.09 / 12), kRoundOff * b.mass);
}

// m_c = rho pi r^2 L, m_b = rho 4/3 pi r^3, h = L/2: across m_c (r^2/4 + L^2/12) + m_b (2/5 r^2 + h^2 + 3/4 h r).
TEST(SceneMasses, CapsuleIsACylinderAndABall) {
  const BodySpec b = body_of(
      "material = \"steel\"\nshape = { kind = \"capsule\", from = [0, 0, 1], to = [0.4, 0, 1], diameter = 0.2 }\n");
  const double r = 0.1, L = 0.4, h = 0.2, m_c = 7850 * kPi * r * r * L, m_b = 7850 * 4.0 / 3.0 * kPi * r * r * r;
  EXPECT_NEAR(b.mass, m_c + m_b, kRoundOff * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(0.2, 0, 1)).norm(), 0.0, kRoundOff);
  EXPECT_NEAR(b.inertia(0, 0), m_c * r * r / 2 + m_b * 0.4 * r * r, kRoundOff * b.mass);
  EXPECT_NEAR(b.inertia(2, 2), m_c * (r * r / 4 + L * L / 12) + m_b * (0.4 * r * r + h * h + 0.75 * h * r),
              kRoundOff * b.mass);
}

// The file is scaled, then turned about its origin, then moved; the body's own axes are another matter. The box of
// rock.stl is 100 x 60 x 40 mm from its origin on.
TEST(SceneMasses, SolidOfAFileIsScaledTurnedAndMoved) {
  const std::string file = FOOTFALL_SOURCE_DIR "/inputs/reference/rock.stl";
  const BodySpec b =
      body_of("material = \"steel\"\nshape = { kind = \"mesh\", file = \"" + file +
              "\", scale = 0.001, orientation = { axis = \"z\", angle_deg = 90 }, position = [1, 0, 0] }\n"
              "orientation = { rpy_deg = [0, 0, 90] }\n");
  constexpr double kSingle = 1e-6;  // STL is read in single precision
  EXPECT_NEAR(b.mass, 7850 * 0.1 * 0.06 * 0.04, kSingle * b.mass);
  EXPECT_NEAR((b.position - Eigen::Vector3d(1 - 0.03, 0.05, 0.02)).norm(), 0.0, kSingle);
  // Body axes along the file's.
  EXPECT_NEAR(b.inertia(0, 0), b.mass / 12 * (0.06 * 0.06 + 0.04 * 0.04), kSingle * b.mass);
  EXPECT_NEAR(b.inertia(1, 1), b.mass / 12 * (0.1 * 0.1 + 0.04 * 0.04), kSingle * b.mass);
}

// The closed form of the thin cap against the same surface cut into triangles: second order in their size.
TEST(SceneMasses, DishAgreesWithItsOwnSurface) {
  const std::string entry =
      "mass = 3\nshape = { kind = \"dish\", centre = [0, 0, 1], radius = 0.3, depth = 0.2, thickness = 0.01 }\n";
  const BodySpec b = body_of(entry);
  const SceneText text;
  Scene scene = text.read("end_time = 1\n[[bodies]]\nname = \"b\"\n" + entry +
                          "[[boundaries]]\nbody = \"b\"\nsurface = { element_size = 0.01 }\n");
  const TriangleMesh mesh = boundary_surface(scene, scene.boundaries[0]);
  double area = 0.0;
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  Eigen::Matrix3d second = Eigen::Matrix3d::Zero();  // integral of x x^T, exact for each triangle by its edge middles
  for (const Eigen::Vector3i& t : mesh.triangles) {
    Eigen::Vector3d p[3];
    for (int i = 0; i < 3; ++i) p[i] = mesh.vertices[static_cast<std::size_t>(t[i])];
    const double a = 0.5 * (p[1] - p[0]).cross(p[2] - p[0]).norm();
    area += a;
    for (int i = 0; i < 3; ++i) {
      const Eigen::Vector3d middle = 0.5 * (p[i] + p[(i + 1) % 3]);
      moment += a / 3 * middle;
      second += a / 3 * middle * middle.transpose();
    }
  }
  const Eigen::Vector3d centre = moment / area;
  second = second / area - centre * centre.transpose();
  const Eigen::Matrix3d inertia = b.mass * (second.trace() * Eigen::Matrix3d::Identity() - second);
  constexpr double kFacets = 1e-3;  // triangles of 0.01 m on a sphere of 0.325 m radius: (0.01 / 0.325)^2
  EXPECT_NEAR((b.position - centre).norm(), 0.0, kFacets * 0.3);
  EXPECT_NEAR((b.inertia - inertia).norm(), 0.0, kFacets * b.inertia.norm());
}

TEST(SceneMasses, RemainderTakesWhatTheOthersLeave) {
  const SceneText text;
  const std::string toml = R"(end_time = 1
total_mass = 10
[[bodies]]
name = "cabin"
mass = "remainder"
shape = { kind = "box", size = [1, 1, 1] }
[[bodies]]
name = "pad"
mass = 4
shape = { kind = "sphere", radius = 0.5, centre = [0, 0, 5] }
)";
  const Scene scene = text.read(toml);
  EXPECT_NEAR(scene.bodies[0].mass, 6.0, kRoundOff);
  EXPECT_NEAR(scene.bodies[0].inertia(0, 0), 1.0, kRoundOff);  // 6 (1 + 1) / 12
  EXPECT_NEAR(mass_centre(scene).z(), 2.0, kRoundOff);
  EXPECT_THAT(text.findings(toml, {"bodies.pad.mass=11"}), HasSubstr("the other bodies already weigh 11 kg"));
  EXPECT_THAT(text.findings(toml, {"bodies.cabin.mass=5"}),
              HasSubstr("total_mass: is 10 kg, but the bodies weigh 9 kg"));
}

TEST(SceneMasses, InertiaMustBelongToARealBody) {
  const SceneText text;
  std::string toml = kPendulum;
  toml.replace(toml.find("[0.1, 0.1, 0.2]"), 15, "[0.1, 0.1, 0.3]");
  EXPECT_THAT(text.findings(toml), HasSubstr("bodies.bob.inertia: belongs to no real body"));
  toml.replace(toml.find("[0.1, 0.1, 0.3]"), 15, "[0.1, 0.1, 0.1, 0.2, 0, 0]");
  EXPECT_THAT(text.findings(toml), HasSubstr("bodies.bob.inertia: is not positive definite"));
}

TEST(SceneMasses, AShapeSaysWhatItNeedsAndWhatMeansNothing) {
  const SceneText text;
  const std::string toml =
      "end_time = 1\n[[bodies]]\nname = \"b\"\nmass = 1\nshape = { kind = \"rod\", from = [0, 0, 0], to = [0, 0, 1], "
      "radius = 0.1 }\n";
  EXPECT_THAT(text.findings(toml), HasSubstr("bodies.b.shape.diameter: is missing; a rod needs it"));
  EXPECT_THAT(text.findings(toml), HasSubstr("bodies.b.shape.radius: means nothing for a rod"));
}

}  // namespace
}  // namespace footfall
