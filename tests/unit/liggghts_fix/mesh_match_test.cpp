#include "liggghts_fix/mesh_match.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "coupler/base/errors.h"
#include "tests/dem/stl.h"

namespace footfall {
namespace {

struct Mesh {
  Mesh() : surface(test::box({0.4, 0.3, 0.1}, 6)), boundary("pad", surface.nodes, surface.triangles) {
    pose.r = {1.0, -2.0, 0.5};
    pose.L = turned(pose.L, {0.3, -0.7, 1.1});
    x.resize(3, surface.nodes.cols());
    boundary.node_positions(pose, x);
    std::vector<int> order(surface.triangles.size());
    for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
    std::mt19937 random(51);
    std::shuffle(order.begin(), order.end(), random);
    for (const int t : order) {
      MeshTriangle one;
      one.id = t;
      const auto shift = static_cast<int>(random() % 3);
      for (int k = 0; k < 3; ++k) {
        const int node = surface.triangles[static_cast<std::size_t>(t)][(k + shift) % 3];
        one.corners[static_cast<std::size_t>(k)] = x.col(node);
        expected.push_back(node);
      }
      triangles.push_back(one);
    }
  }
  test::Surface surface;
  ModalBoundary boundary;
  BodyMotion pose;
  Eigen::Matrix3Xd x;
  std::vector<MeshTriangle> triangles;
  std::vector<int> expected;
};

TEST(MeshMatch, FindsEveryCornerWhateverTheOrder) {
  Mesh mesh;
  const std::vector<CornerNodes> found = match_mesh("m", mesh.boundary, mesh.pose, mesh.triangles);
  ASSERT_EQ(found.size(), mesh.triangles.size());
  for (std::size_t i = 0; i < found.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(found[i][k], mesh.expected[3 * i + k]);
}

TEST(MeshMatch, AllowsTheRoundingOfAFileWithSixDigits) {
  Mesh mesh;
  for (MeshTriangle& t : mesh.triangles)
    for (Eigen::Vector3d& c : t.corners) c = (c * 1e6).array().round() / 1e6;
  EXPECT_NO_THROW(match_mesh("m", mesh.boundary, mesh.pose, mesh.triangles));
}

TEST(MeshMatch, NamesTheCornerThatIsElsewhere) {
  Mesh mesh;
  mesh.triangles[3].corners[1] += Eigen::Vector3d(0, 0, 1e-4);
  try {
    match_mesh("pad1", mesh.boundary, mesh.pose, mesh.triangles);
    FAIL();
  } catch (const InputError& error) {
    const std::string said = error.what();
    EXPECT_NE(said.find("mesh pad1: corner ("), std::string::npos);
    EXPECT_NE(said.find("of triangle " + std::to_string(mesh.triangles[3].id) + " is no node of body \"pad\""),
              std::string::npos);
  }
}

TEST(MeshMatch, RefusesATriangleThatTheBodyDoesNotHave) {
  Mesh mesh;
  mesh.triangles[0].corners = {mesh.x.col(0), mesh.x.col(1), mesh.x.col(mesh.x.cols() - 1)};
  EXPECT_THROW(match_mesh("m", mesh.boundary, mesh.pose, mesh.triangles), InputError);
}

TEST(MeshMatch, TrianglesThatShareAPlaceButNoNodeKeepTheirOwnNodes) {
  // Every triangle with nodes of its own, as in an STL file that nobody has welded.
  const test::Surface welded = test::box({0.2, 0.2, 0.2}, 2);
  Eigen::Matrix3Xd nodes(3, static_cast<Eigen::Index>(3 * welded.triangles.size()));
  std::vector<Eigen::Vector3i> triangles;
  std::vector<MeshTriangle> mesh;
  for (std::size_t t = 0; t < welded.triangles.size(); ++t) {
    const int first = static_cast<int>(3 * t);
    triangles.emplace_back(first, first + 1, first + 2);
    MeshTriangle one;
    one.id = static_cast<int>(t);
    for (int k = 0; k < 3; ++k) {
      nodes.col(first + k) = welded.nodes.col(welded.triangles[t][k]);
      one.corners[static_cast<std::size_t>(k)] = nodes.col(first + k);
    }
    mesh.push_back(one);
  }
  const ModalBoundary boundary("pad", nodes, triangles);
  const std::vector<CornerNodes> found = match_mesh("m", boundary, BodyMotion(), mesh);
  for (std::size_t t = 0; t < found.size(); ++t)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(found[t][static_cast<std::size_t>(k)], static_cast<int>(3 * t) + k);
}

TEST(MeshMatch, RefusesABodyWithoutTriangles) {
  Eigen::Matrix3Xd rho0(3, 2);
  rho0 << 0, 1, 0, 0, 0, 0;
  const ModalBoundary boundary("rod", rho0, {}, {{0, 1, 0.1, 0}});
  EXPECT_THROW(match_mesh("m", boundary, BodyMotion(), {}), InputError);
}

}  // namespace
}  // namespace footfall
