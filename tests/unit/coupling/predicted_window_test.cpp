// The path of the grains, walked on the body's side.

#include "mbd_solver/coupling/predicted_window.h"

#include <gtest/gtest.h>

#include "coupler/schemes/registry.h"

namespace footfall {
namespace {

TEST(PredictedWindow, MeansAreThoseOfThePathOfTheGrains) {
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  BodyMotion start;
  start.dr = {0.0, 0.0, -1.0};
  start.w = {0.0, 0.5, 0.0};
  PredictedWindow predicted(*scheme, start);
  predicted.begin(start, 10, 1e-3);
  EXPECT_NEAR(predicted.path().r_mean[2], -0.005, 1e-15);
  EXPECT_NEAR(predicted.path().v_mean[2], -1.0, 1e-12);
  EXPECT_NEAR(rotation_vector(start.L, predicted.path().L_mean)[1], 0.0025, 1e-12);
  // The body came 1 mm less far: the next path closes that gap, and goes 1 mm less in the mean of its velocity.
  BodyMotion computed = start;
  computed.r[2] = -0.009;
  EXPECT_NEAR(predicted.path().gap(computed)[2], 0.001, 1e-15);
  predicted.begin(computed, 10, 1e-3);
  EXPECT_NEAR(predicted.path().v_mean[2], -1.0 + 0.001 / 0.01, 0.02);  // 10 substeps sample the closing roughly
}

}  // namespace
}  // namespace footfall
