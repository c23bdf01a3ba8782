#include "liggghts_fix/round_surface.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

// A triangle on the unit sphere, about w [rad] wide.
Matrix3d on_sphere(double w) {
  Matrix3d x;
  x.col(0) = Vector3d(0.4 * w, -0.5 * w, 1.0).normalized();
  x.col(1) = Vector3d(0.3 * w, 0.5 * w, 1.0).normalized();
  x.col(2) = Vector3d(-0.6 * w, 0.1 * w, 1.0).normalized();
  return x;
}

// Largest distance from the sphere over the facet [m].
double error(double w) {
  const RoundFacet facet(on_sphere(w), on_sphere(w));
  double worst = 0.0;
  for (int i = 0; i <= 20; ++i)
    for (int j = 0; i + j <= 20; ++j) worst = std::max(worst, std::abs(facet.at(i / 20.0, j / 20.0).norm() - 1.0));
  return worst;
}

TEST(RoundFacet, IsASphereToFourthOrder) {
  const double coarse = error(0.4), fine = error(0.2);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.3);
  EXPECT_LT(coarse, std::pow(0.4, 4) / 64.0);
}

TEST(RoundFacet, NoPointIsNearerThanTheNearestInsideAndOutsideOfTheBall) {
  const RoundFacet facet(on_sphere(0.5), on_sphere(0.5));
  for (const double height : {0.2, 0.7, 1.2, 3.0}) {
    const Vector3d inner = height * Vector3d(0.03, 0.02, 1.0).normalized();
    const RoundFacet::Nearest found = facet.nearest(inner);
    // No point of a fine grid is closer.
    double least = 1e300;
    for (int i = 0; i <= 200; ++i)
      for (int j = 0; i + j <= 200; ++j) least = std::min(least, (facet.at(i / 200.0, j / 200.0) - inner).norm());
    EXPECT_LE((found.point - inner).norm(), least + 1e-12) << height;
  }
  const Vector3d aside(2.0, 0.1, 1.0);
  double least = 1e300;
  for (int i = 0; i <= 200; ++i)
    for (int j = 0; i + j <= 200; ++j) least = std::min(least, (facet.at(i / 200.0, j / 200.0) - aside).norm());
  EXPECT_LE((facet.nearest(aside).point - aside).norm(), least + 1e-12);
}

// A plate 10 m long whose end is rounded by facets of 0.1 m.
TEST(RoundSurface, ALargeFlatFaceStaysFlatBesideANarrowRounding) {
  Eigen::Matrix3Xd nodes(3, 6);
  nodes << 0, 10, 10.099, 0, 10, 10.099,  //
      0, 0, 0, 10, 10, 10,                //
      0, 0, -0.02, 0, 0, -0.02;
  const SurfacePieces pieces(nodes, {{0, 1, 4}, {0, 4, 3}, {1, 2, 5}, {1, 5, 4}}, 0.5);
  const RoundSurface surface(pieces, nodes);
  Matrix3d corners;
  corners << nodes.col(0), nodes.col(1), nodes.col(4);
  EXPECT_LT(surface.facet(0, corners).largest_bulge(), 0.1 * 0.2);
  EXPECT_TRUE(surface.is_flat(1) || surface.facet(1, corners).largest_bulge() < 0.02);
}

}  // namespace
}  // namespace footfall
