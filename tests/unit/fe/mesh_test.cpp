// mbd_solver/fe/mesh_generator.h and mesh_check.h.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/fe/mesh_check.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Vector3d;

Vector3d area_vector(const TriangleMesh& mesh, const Eigen::Vector3i& t) {
  const Vector3d& p = mesh.vertices[static_cast<std::size_t>(t(0))];
  return 0.5 *
         (mesh.vertices[static_cast<std::size_t>(t(1))] - p).cross(mesh.vertices[static_cast<std::size_t>(t(2))] - p);
}

double area(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) sum += area_vector(mesh, t).norm();
  return sum;
}

MeshDemands demands(bool closed, bool connected, bool oriented) {
  MeshDemands result;
  result.closed = closed;
  result.connected = connected;
  result.oriented = oriented;
  return result;
}

// The one finding of a damaged mesh.
std::string finding(const TriangleMesh& mesh, const MeshDemands& wanted) {
  const std::vector<std::string> findings = mesh_findings(mesh, wanted);
  EXPECT_EQ(findings.size(), 1u);
  return findings.empty() ? "" : findings[0];
}

TEST(DiscMesh, HasSymmetricRingsOfNearUniformTriangles) {
  const double R = 0.2;
  const int n = 7;
  const TriangleMesh mesh = disc_mesh(R, R / n);
  EXPECT_EQ(mesh.vertices.size(), 1u + 3 * n * (n + 1));
  EXPECT_EQ(mesh.triangles.size(), 6u * n * n);
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, true)).empty());
  EXPECT_EQ(mesh.vertices[0], Vector3d::Zero());
  double shortest = R, longest = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    EXPECT_GT(area_vector(mesh, t).z(), 0.0) << "normals along z";
    for (int i = 0; i < 3; ++i) {
      const double edge =
          (mesh.vertices[static_cast<std::size_t>(t(i))] - mesh.vertices[static_cast<std::size_t>(t((i + 1) % 3))])
              .norm();
      shortest = std::min(shortest, edge);
      longest = std::max(longest, edge);
    }
  }
  EXPECT_GT(shortest, 0.99 * R / n);
  EXPECT_LT(longest, 1.45 * R / n) << "a diagonal from a spoke: sqrt(1 + (pi/3)^2)";
  // Area of the inscribed polygon of 6 n sides.
  EXPECT_NEAR(area(mesh), 3.0 * n * R * R * std::sin(2.0 * kPi / (6 * n)), kFeRoundOff);
  // Turned by 60 degrees the vertices fall on themselves.
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(kPi / 3.0, Vector3d::UnitZ()).toRotationMatrix();
  for (const Vector3d& p : mesh.vertices) {
    double nearest = R;
    for (const Vector3d& q : mesh.vertices) nearest = std::min(nearest, (turn * p - q).norm());
    EXPECT_LT(nearest, kFeRoundOff);
  }
}

TEST(DishMesh, LiesOnItsSphereAndOpensUpwards) {
  const double a = 0.2, d = 0.05;
  const TriangleMesh mesh = dish_mesh(a, d, 0.02);
  const double sphere = (a * a + d * d) / (2.0 * d);
  double highest = 0.0;
  for (const Vector3d& p : mesh.vertices) {
    EXPECT_NEAR((p - Vector3d(0, 0, sphere)).norm(), sphere, kFeRoundOff);
    highest = std::max(highest, p.z());
  }
  EXPECT_NEAR(highest, d, kFeRoundOff);
  EXPECT_NEAR(mesh.vertices.back().head<2>().norm(), a, kFeRoundOff) << "the last ring is the rim";
  for (const Eigen::Vector3i& t : mesh.triangles) EXPECT_GT(area_vector(mesh, t).z(), 0.0);
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, true)).empty());
  EXPECT_NEAR(area(mesh), kPi * (a * a + d * d), 0.01 * kPi * a * a) << "cap area pi (a^2 + d^2), less the facets'";
  EXPECT_NEAR(dish_mesh(a, a, 0.02).vertices.back().z(), a, kFeRoundOff) << "a half sphere";
}

// The volume within the polygon of its rim, 6 n corners of n rings.
TEST(ThickDiscMesh, IsClosedAndHoldsItsVolume) {
  for (const double thickness : {0.004, 0.1}) {  // thinner and thicker than the edges
    const TriangleMesh mesh = thick_disc_mesh(0.2, thickness, 0.05);
    EXPECT_TRUE(mesh_findings(mesh, demands(true, true, true)).empty());
    double volume = 0.0;
    for (const Eigen::Vector3i& t : mesh.triangles)
      volume += area_vector(mesh, t).dot(mesh.vertices[static_cast<std::size_t>(t(0))]) / 3.0;
    const double corners = 24.0;
    EXPECT_NEAR(volume, thickness * 0.5 * corners * 0.04 * std::sin(2.0 * kPi / corners), kFeRoundOff)
        << "positive: normals outward";
  }
}

TEST(BoxMesh, IsClosedAndFacesOutward) {
  const Vector3d size(0.3, 0.2, 0.5);
  const TriangleMesh mesh = box_mesh(size, 0.06);
  EXPECT_TRUE(mesh_findings(mesh, demands(true, true, true)).empty());
  double volume = 0.0;
  for (const Eigen::Vector3i& t : mesh.triangles)
    volume += area_vector(mesh, t).dot(mesh.vertices[static_cast<std::size_t>(t(0))]) / 3.0;
  EXPECT_NEAR(volume, size.prod(), kFeRoundOff) << "positive: normals outward";
  EXPECT_NEAR(area(mesh), 2.0 * (0.06 + 0.1 + 0.15), kFeRoundOff);
}

TEST(MeshGenerators, RefuseWhatIsNoShape) {
  EXPECT_THROW(disc_mesh(0.0, 0.1), InputError);
  EXPECT_THROW(disc_mesh(1.0, -0.1), InputError);
  EXPECT_THROW(disc_mesh(200.0, 0.02), InputError) << "millions of triangles: millimetres taken for metres";
  EXPECT_THROW(dish_mesh(0.1, 0.2, 0.01), InputError);
  EXPECT_THROW(box_mesh(Vector3d(1, 0, 1), 0.1), InputError);
}

TEST(WeldedMesh, JoinsTheLooseTrianglesOfAnStlFile) {
  const TriangleMesh box = box_mesh(Vector3d(1, 1, 1), 0.25);
  TriangleMesh loose;  // three vertices of its own per triangle, with noise
  for (const Eigen::Vector3i& t : box.triangles) {
    const int first = static_cast<int>(loose.vertices.size());
    for (int i = 0; i < 3; ++i)
      loose.vertices.push_back(box.vertices[static_cast<std::size_t>(t(i))] + 1e-8 * Vector3d::Random());
    loose.triangles.emplace_back(first, first + 1, first + 2);
  }
  EXPECT_FALSE(mesh_findings(loose, demands(true, true, true)).empty());
  const TriangleMesh mesh = welded(loose, 1e-6);
  EXPECT_EQ(mesh.vertices.size(), box.vertices.size());
  EXPECT_TRUE(mesh_findings(mesh, demands(true, true, true)).empty());
}

TEST(MovedMesh, KeepsItsShape) {
  const TriangleMesh disc = disc_mesh(1.0, 0.5);
  const Eigen::Matrix3d R = Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  const TriangleMesh mesh = moved(disc, R, Vector3d(1, 2, 3));
  EXPECT_NEAR(area(mesh), area(disc), kFeRoundOff);
  EXPECT_LT((mesh.vertices[0] - Vector3d(1, 2, 3)).norm(), kFeRoundOff);
}

TEST(MeshCheck, NamesTheTrianglesOfEveryDefect) {
  const TriangleMesh good = box_mesh(Vector3d(1, 1, 1), 1.0);  // 12 triangles

  TriangleMesh mesh = good;
  mesh.triangles.erase(mesh.triangles.begin() + 5);
  std::string text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(has(text, "not closed") && has(text, "triangles ")) << text;
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, true)).empty()) << "not closed matters only where asked";

  mesh = good;
  mesh.triangles.push_back(Eigen::Vector3i(mesh.triangles[3](1), mesh.triangles[3](0), mesh.triangles[3](2)));
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(has(text, "triangle 12:") && has(text, "duplicate")) << text;

  mesh = good;
  mesh.triangles.emplace_back(0, 0, 1);
  text = finding(mesh, demands(false, true, false));
  EXPECT_TRUE(has(text, "triangle 12:") && has(text, "degenerate")) << text;

  mesh = good;
  mesh.vertices.push_back(0.5 * (mesh.vertices[0] + mesh.vertices[1]));
  mesh.triangles.emplace_back(0, 1, static_cast<int>(mesh.vertices.size()) - 1);
  text = finding(mesh, demands(false, true, false));
  EXPECT_TRUE(has(text, "triangle 12:") && has(text, "degenerate")) << "three corners in line: " << text;

  mesh = good;
  std::swap(mesh.triangles[4](0), mesh.triangles[4](1));
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(has(text, "which side is outside") && has(text, "4")) << text;

  mesh = good;
  const int offset = static_cast<int>(good.vertices.size());
  for (const Vector3d& p : good.vertices) mesh.vertices.push_back(p + Vector3d(3, 0, 0));
  for (const Eigen::Vector3i& t : good.triangles) mesh.triangles.push_back(t.array() + offset);
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(has(text, "2 disconnected pieces") && has(text, "12, 13")) << text;
  EXPECT_TRUE(mesh_findings(mesh, demands(true, false, true)).empty());

  mesh = good;
  mesh.triangles[2](0) = 99;
  text = finding(mesh, demands(true, true, true));
  EXPECT_TRUE(has(text, "triangle 2:") && has(text, "not valid")) << text;

  mesh = good;  // a fin on an edge
  mesh.vertices.push_back(Vector3d(2, 2, 2));
  mesh.triangles.emplace_back(mesh.triangles[0](0), mesh.triangles[0](1), static_cast<int>(mesh.vertices.size()) - 1);
  EXPECT_GE(mesh_findings(mesh, demands(true, false, false)).size(), 1u);
  EXPECT_TRUE(mesh_findings(mesh, demands(false, true, false)).empty());

  EXPECT_FALSE(mesh_findings(TriangleMesh{}, demands(false, false, false)).empty());
}

TEST(MeshCheck, ThrowsWithTheNameOfTheFile) {
  TriangleMesh mesh = disc_mesh(1.0, 0.5);
  mesh.triangles.push_back(mesh.triangles[0]);
  mesh.triangles.emplace_back(1, 1, 2);
  try {
    check_mesh(mesh, demands(false, true, false), "pad.stl");
    FAIL() << "accepted";
  } catch (const InputError& error) {
    const std::string text = error.what();
    EXPECT_TRUE(has(text, "pad.stl: triangle 24:") && has(text, "pad.stl: triangle 25:")) << "all at once: " << text;
  }
}

}  // namespace
}  // namespace footfall
