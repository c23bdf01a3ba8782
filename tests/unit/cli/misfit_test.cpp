#include "mbd_solver/cli/calibrate/misfit.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

TargetSpec target(double least, double most) {
  TargetSpec t;
  t.least = least;
  t.most = most;
  t.tolerance = 0.5;
  return t;
}

TEST(Misfit, OfABandIsTheDistanceToIt) {
  const TargetSpec t = target(1.0, 2.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 1.0), 0.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 2.0), 0.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 3.0), 2.0);
  EXPECT_DOUBLE_EQ(residual_of(t, 0.75), -0.5);
  TargetSpec value = t;
  value.value = 1.5;
  EXPECT_DOUBLE_EQ(residual_of(value, 1.0), -1.0);
}

TEST(Misfit, ReadsACurveWhereXIsReachedFirst) {
  const std::vector<double> x = {0, 1, 2, 3, 2, 1}, y = {0, 10, 20, 30, -1, -2};  // there and back
  EXPECT_EQ(first_crossings(x, y, {0.5, 2.0, 3.0}), (std::vector<double>{5, 20, 30}));
  EXPECT_EQ(first_crossings(x, y, {-1.0, 9.0}), (std::vector<double>{0, 30}));  // the nearest row
}

class MisfitOfRuns : public ::testing::Test {
 protected:
  MisfitOfRuns() {
    for (const char* name : {"a", "b"}) {
      CalibrationScene scene;
      scene.name = name;
      spec.scenes.push_back(scene);
    }
    FigureSpec figure;
    figure.name = "height";
    spec.figures = {figure};
    TargetSpec ratio = target(1.5, 2.5);
    ratio.figure = "height";
    ratio.scene = "a";
    ratio.against = "b";
    spec.targets = {ratio};
  }
  static RunNumbers run(double figure) { return {{figure}, {{}}}; }

  CalibrationSpec spec;
};

TEST_F(MisfitOfRuns, TakesARatioOfMeans) {
  const TargetResult r = result_of(spec, 0, {{run(2), run(4)}, {run(1), run(1)}});
  EXPECT_DOUBLE_EQ(r.values.front(), 3.0);
  EXPECT_DOUBLE_EQ(r.residuals.front(), 1.0);
  EXPECT_NEAR(r.spread.front(), std::sqrt(2.0), 1e-12);
  EXPECT_EQ(r.of_seed.size(), 2u);
  spec.targets[0].weight = 4.0;
  EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0]), 4.0);
  EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0], 2.0), 4.0) << "not as far off as the cap";
  EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0], 0.5), 1.0);
  EXPECT_EQ(capped(-7.0, 3.0), -3.0);
  EXPECT_EQ(capped(-7.0, 0.0), -7.0) << "no cap";
}

TEST_F(MisfitOfRuns, ABandIsMetWithinItsBoundsAndANumberWithinATolerance) {
  EXPECT_TRUE(result_of(spec, 0, {{run(2.5)}, {run(1)}}).is_met());
  EXPECT_FALSE(result_of(spec, 0, {{run(2.6)}, {run(1)}}).is_met()) << "a fifth of a tolerance beyond";
  spec.targets[0].value = 2.0;
  EXPECT_TRUE(result_of(spec, 0, {{run(2.4)}, {run(1)}}).is_met());
  EXPECT_FALSE(result_of(spec, 0, {{run(2.6)}, {run(1)}}).is_met());
}

TEST_F(MisfitOfRuns, IsThatOfFailureWhereARunOrANumberIsMissing) {
  spec.failed = 7.0;
  for (const auto& runs : {std::vector<std::vector<RunNumbers>>{{run(2)}, {}},
                           {{}, {run(1)}},
                           {{run(1)}, {run(0)}},
                           {{run(std::nan(""))}, {run(1)}}}) {
    const TargetResult r = result_of(spec, 0, runs);
    EXPECT_TRUE(r.failed);
    EXPECT_FALSE(r.is_met());
    EXPECT_DOUBLE_EQ(r.misfit(spec.targets[0]), 49.0);
  }
}

}  // namespace
}  // namespace footfall
