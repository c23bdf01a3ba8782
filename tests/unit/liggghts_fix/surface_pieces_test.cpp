#include "liggghts_fix/surface_pieces.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

constexpr double kEdge = 30.0 * M_PI / 180.0;

// A strip of squares of 1 m along y, each of two triangles (2 i and 2 i + 1), that turns by an angle at each of its lines.
SurfacePieces strip(const std::vector<double>& turns) {
  const std::size_t squares = turns.size() + 1;
  Eigen::Matrix3Xd nodes(3, 2 * static_cast<Eigen::Index>(squares) + 2);
  Eigen::Vector3d at = Eigen::Vector3d::Zero();
  double angle = 0.0;
  std::vector<CornerNodes> corners;
  for (std::size_t i = 0; i <= squares; ++i) {
    const int a = 2 * static_cast<int>(i);
    nodes.col(a) = at;
    nodes.col(a + 1) = at + Eigen::Vector3d::UnitY();
    if (i == squares) break;
    corners.push_back({a, a + 2, a + 3});
    corners.push_back({a, a + 3, a + 1});
    at += Eigen::Vector3d(std::cos(angle), 0.0, std::sin(angle));
    if (i < turns.size()) angle += turns[i];
  }
  return {nodes, corners, kEdge};
}

TEST(SurfacePieces, EndAtSharpEdges) {
  const SurfacePieces pieces = strip({0.2, 0.9, -0.4});
  EXPECT_TRUE(pieces.curved());
  EXPECT_EQ(pieces.piece(0), pieces.piece(3));
  EXPECT_NE(pieces.piece(3), pieces.piece(4));
  EXPECT_EQ(pieces.piece(4), pieces.piece(7));
  EXPECT_TRUE(pieces.are_neighbours(0, 2));
  EXPECT_FALSE(pieces.are_neighbours(0, 4)) << "two squares on";
  EXPECT_FALSE(pieces.are_neighbours(2, 4)) << "across the sharp edge";
}

TEST(SurfacePieces, OfFlatFacesAreNotCurved) {
  EXPECT_FALSE(strip({0.0, 0.5 * M_PI, 0.0}).curved());
  EXPECT_FALSE(strip({M_PI}).curved()) << "folded back on itself";
  EXPECT_TRUE(strip({1e-3}).curved()) << "fine facets turn by little";
}

TEST(SurfacePieces, KnowTheirBorders) {
  const SurfacePieces pieces = strip({0.2, 0.9});
  EXPECT_TRUE(pieces.inside_piece(0, {0.2, 0.3, 0.5}));
  EXPECT_TRUE(pieces.inside_piece(0, {0.0, 0.5, 0.5})) << "a smooth edge";
  EXPECT_TRUE(pieces.inside_piece(0, {0.5, 0.0, 0.5})) << "the diagonal";
  EXPECT_FALSE(pieces.inside_piece(0, {0.5, 0.5, 0.0})) << "the border of the mesh";
  EXPECT_FALSE(pieces.inside_piece(0, {0.0, 1.0, 0.0})) << "a corner on the border";
  EXPECT_FALSE(pieces.inside_piece(2, {0.0, 0.5, 0.5})) << "the sharp edge";
}

FacetTouch touch(int facet, double gap) {
  FacetTouch touch;
  touch.facet = facet;
  touch.gap = gap;
  return touch;
}

TEST(SurfacePieces, TheNearestOfNeighboursIsTouched) {
  const SurfacePieces pieces = strip({0.2, 0.9});
  const FacetTouch near = touch(0, -2e-3), far = touch(2, -1e-3), beyond = touch(4, -3e-3);
  EXPECT_TRUE(yields(far, near, pieces));
  EXPECT_FALSE(yields(near, far, pieces));
  EXPECT_FALSE(yields(far, beyond, pieces)) << "another piece";
  const FacetTouch same = touch(2, near.gap);
  EXPECT_TRUE(yields(same, near, pieces)) << "the smaller number of two";
  EXPECT_FALSE(yields(near, same, pieces));
  FacetTouch silent = near;
  silent.acts = false;
  EXPECT_TRUE(yields(silent, same, pieces)) << "of two that are equally close, the one that LIGGGHTS lets act";
}

TEST(SurfacePieces, OfFlatFacesLeaveSharpEdgesToLiggghts) {
  FacetTouch near = touch(0, -2e-3);
  const FacetTouch far = touch(2, -1e-3);
  near.on_border = true;
  EXPECT_TRUE(yields(far, near, strip({0.2})));
  EXPECT_FALSE(yields(far, near, strip({0.0})));
  near.on_border = false;
  EXPECT_TRUE(yields(far, near, strip({0.0}))) << "a crease may open";
}

}  // namespace
}  // namespace footfall
