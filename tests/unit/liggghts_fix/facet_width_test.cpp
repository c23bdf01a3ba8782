#include "liggghts_fix/facet_width.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

// Two right triangles with a common edge of 2 m on the y axis, 1 m wide; the second one folded up by an angle.
std::vector<double> widths(double angle) {
  Eigen::Matrix3Xd nodes(3, 4);
  nodes << 0.0, 0.0, -1.0, std::cos(angle),  //
      0.0, 2.0, 0.0, 0.0,                    //
      0.0, 0.0, 0.0, std::sin(angle);
  return curved_facet_widths(nodes, {{0, 1, 2}, {0, 3, 1}});
}

TEST(FacetWidth, IsTheSmallestHeightWhereTheSurfaceIsCurved) {
  for (const double angle : {0.01, 0.1, -0.3, 1.0})
    for (const double width : widths(angle)) EXPECT_NEAR(width, 2.0 / std::sqrt(5.0), 1e-15);  // 2 area / longest edge
}

TEST(FacetWidth, OfFlatFacetsAndOfSharpEdgesDoesNotMatter) {
  for (const double angle : {0.0, 0.004, 0.5 * M_PI})
    for (const double width : widths(angle)) EXPECT_TRUE(std::isinf(width)) << angle;
}

}  // namespace
}  // namespace footfall
