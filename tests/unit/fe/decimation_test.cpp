// Decimated meshes: how many triangles are left, what they enclose, where their rim is, and how far they are from the given ones.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <utility>

#include "mbd_solver/fe/decimation.h"
#include "mbd_solver/fe/mesh_generator.h"

namespace footfall {
namespace {

using Eigen::Vector3d;
using Eigen::Vector3i;

constexpr double kRounding = 1e-10;  // of sums over ten thousands of triangles, relative

// Volume that the triangles enclose [m3]; of a flat sheet 0.
double volume_of(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Vector3i& t : mesh.triangles)
    sum += mesh.vertices[static_cast<std::size_t>(t(0))].dot(
               mesh.vertices[static_cast<std::size_t>(t(1))].cross(mesh.vertices[static_cast<std::size_t>(t(2))])) /
           6.0;
  return sum;
}

Vector3d normal_of(const TriangleMesh& mesh, const Vector3i& t) {
  const Vector3d &a = mesh.vertices[static_cast<std::size_t>(t(0))], &b = mesh.vertices[static_cast<std::size_t>(t(1))],
                 &c = mesh.vertices[static_cast<std::size_t>(t(2))];
  return 0.5 * (b - a).cross(c - a);
}

Vector3d centre_of(const TriangleMesh& mesh, const Vector3i& t) {
  return (mesh.vertices[static_cast<std::size_t>(t(0))] + mesh.vertices[static_cast<std::size_t>(t(1))] +
          mesh.vertices[static_cast<std::size_t>(t(2))]) /
         3.0;
}

std::vector<std::string> findings_of(const TriangleMesh& mesh, bool closed) {
  MeshDemands demands;
  demands.closed = closed;
  demands.connected = demands.oriented = true;
  return mesh_findings(mesh, demands);
}

double rim_length(const TriangleMesh& mesh) {
  std::map<std::pair<int, int>, int> uses;
  for (const Vector3i& t : mesh.triangles)
    for (int i = 0; i < 3; ++i) ++uses[std::minmax(t(i), t((i + 1) % 3))];
  double length = 0.0;
  for (const auto& [edge, count] : uses)
    if (count == 1)
      length +=
          (mesh.vertices[static_cast<std::size_t>(edge.first)] - mesh.vertices[static_cast<std::size_t>(edge.second)])
              .norm();
  return length;
}

double area_of(const TriangleMesh& mesh) {
  double sum = 0.0;
  for (const Vector3i& t : mesh.triangles) sum += normal_of(mesh, t).norm();
  return sum;
}

// A sphere of radius 1 about (3, 0, 0), of 19 200 triangles: a cube's, pushed out.
TriangleMesh fine_sphere() {
  TriangleMesh mesh = box_mesh(Vector3d(2, 2, 2), 0.05);
  for (Vector3d& x : mesh.vertices) x = x.normalized() + Vector3d(3, 0, 0);
  return mesh;
}

TEST(Decimation, OfASphereKeepsItClosedWithItsVolumeAndRoundness) {
  const TriangleMesh given = fine_sphere();
  ASSERT_GT(given.triangles.size(), 15000u);
  const Decimation result = decimated(given, 500);
  EXPECT_LE(result.mesh.triangles.size(), 500u);
  EXPECT_GE(result.mesh.triangles.size(), 498u);  // a collapse takes two
  EXPECT_TRUE(findings_of(result.mesh, true).empty());
  EXPECT_NEAR(volume_of(result.mesh) / volume_of(given), 1.0, kRounding);
  EXPECT_NEAR(result.volume_change, 0.0, kRounding);
  // Edges of n nearly equal triangles on a unit sphere are l = sqrt(16 pi / (sqrt 3 n)) = 0.24; the sagitta of their middle
  // is l^2 / 6 = 0.0097. Twice that bounds triangles that are not equal.
  EXPECT_LT(result.distance, 0.02);
  EXPECT_GT(result.distance, 0.002);
  for (const Vector3d& x : result.mesh.vertices) EXPECT_NEAR((x - Vector3d(3, 0, 0)).norm(), 1.0, 0.02);
  for (const Vector3i& t : result.mesh.triangles)  // none turned over
    EXPECT_GT(normal_of(result.mesh, t).normalized().dot((centre_of(result.mesh, t) - Vector3d(3, 0, 0)).normalized()),
              0.9);
}

TEST(Decimation, OfACubeLeavesItsTwelveTriangles) {
  const TriangleMesh given =
      moved(box_mesh(Vector3d(0.2, 0.1, 0.3), 0.01),
            Eigen::AngleAxisd(0.7, Vector3d(1, 2, 3).normalized()).toRotationMatrix(), Vector3d(5.0, -2.0, 1.0));
  const Decimation result = decimated(given, 12);
  EXPECT_EQ(result.mesh.triangles.size(), 12u);
  EXPECT_EQ(result.mesh.vertices.size(), 8u);
  EXPECT_TRUE(findings_of(result.mesh, true).empty());
  // Coordinates of 5 m have a last bit of 1e-15 m: 1e-14 of the edge of 0.1 m, and some of each collapse.
  EXPECT_NEAR(volume_of(result.mesh), 0.2 * 0.1 * 0.3, 1e-12);
  EXPECT_LT(result.distance, 1e-12);
}

TEST(Decimation, OfAFlatSheetKeepsItsRimAndOfADiscNearly) {
  TriangleMesh square;
  const int n = 30;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) square.vertices.emplace_back(1.0 * i / n, 1.0 * j / n, 0.0);
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const int a = i * (n + 1) + j, b = a + n + 1;
      square.triangles.insert(square.triangles.end(), {{a, b, b + 1}, {a, b + 1, a + 1}});
    }
  const Decimation two = decimated(square, 2);
  EXPECT_EQ(two.mesh.triangles.size(), 2u);
  EXPECT_NEAR(area_of(two.mesh), 1.0, kRounding);
  EXPECT_NEAR(rim_length(two.mesh), 4.0, kRounding);
  EXPECT_EQ(two.volume_change, 0.0);

  const TriangleMesh disc = disc_mesh(1.0, 0.03);
  const Decimation coarse = decimated(disc, 60);
  EXPECT_LE(coarse.mesh.triangles.size(), 60u);
  EXPECT_TRUE(findings_of(coarse.mesh, false).empty());
  // A flat disc of n triangles is a polygon of about n corners at best; of 20 its rim is 0.4 % and its area 1.6 % short.
  EXPECT_NEAR(rim_length(coarse.mesh) / rim_length(disc), 1.0, 0.004);
  EXPECT_NEAR(area_of(coarse.mesh) / area_of(disc), 1.0, 0.016);
}

TEST(Decimation, LeavesWhatIsCoarseEnoughAndStopsWhereNothingSoundIsLeft) {
  const TriangleMesh box = box_mesh(Vector3d(1, 1, 1), 2.0);
  const Decimation same = decimated(box, box.triangles.size());
  EXPECT_EQ(same.mesh.triangles, box.triangles);
  EXPECT_EQ(same.distance, 0.0);
  // A closed surface has four triangles at least.
  const Decimation least = decimated(fine_sphere(), 1);
  EXPECT_GE(least.mesh.triangles.size(), 4u);
  EXPECT_TRUE(findings_of(least.mesh, true).empty());
}

TEST(Decimation, KeepsHolesAndPiecesAndEdgesOfThreeTriangles) {
  // Two balls and three sheets at one edge stay what they are.
  TriangleMesh pair = fine_sphere();
  const TriangleMesh other = moved(pair, Eigen::Matrix3d::Identity(), Vector3d(5, 0, 0));
  const Vector3i shift = Vector3i::Constant(static_cast<int>(pair.vertices.size()));
  for (const Vector3i& t : other.triangles) pair.triangles.push_back(t + shift);
  pair.vertices.insert(pair.vertices.end(), other.vertices.begin(), other.vertices.end());
  const Decimation both = decimated(pair, 400);
  EXPECT_NEAR(volume_of(both.mesh) / volume_of(pair), 1.0, kRounding);
  MeshDemands closed;
  closed.closed = closed.oriented = true;
  EXPECT_TRUE(mesh_findings(both.mesh, closed).empty());

  TriangleMesh book;
  book.vertices = {{0, 0, 0}, {0, 0, 1}, {1, 0, 0}, {-1, 1, 0}, {-1, -1, 0}};
  book.triangles = {{0, 1, 2}, {0, 1, 3}, {0, 1, 4}};
  EXPECT_EQ(decimated(book, 1).mesh.triangles.size(), 3u);
}

}  // namespace
}  // namespace footfall
