// The set next to one that was run whole: mbd_solver/cli/calibrate/adjustment.h.
#include "mbd_solver/cli/calibrate/adjustment.h"

#include <gtest/gtest.h>

namespace footfall {
namespace {

// Two parameters with a range of 1; target 0 feels the first, target 1 both, target 2 the second.
struct WholeRun {
  CalibrationSpec spec;
  Evaluation whole;
  Eigen::MatrixXd sensitivity = Eigen::MatrixXd::Zero(3, 2);

  WholeRun() {
    spec.parameters.resize(2);
    spec.step = 0.3;
    for (SoughtParameter& p : spec.parameters) p.most = 1.0;
    spec.targets.resize(3);
    for (TargetSpec& target : spec.targets) target.least = 0.0, target.most = 4.0, target.tolerance = 1.0;
    whole.shares = {0.5, 0.5};
    sensitivity.row(0) << 10.0, 0.0;
    sensitivity.row(1) << 2.0, -4.0;
    sensitivity.row(2) << 0.0, 20.0;
  }
  void says(const std::vector<double>& values) {
    whole.targets.resize(values.size());
    for (std::size_t t = 0; t < values.size(); ++t) whole.targets[t].values = {values[t]};
  }
};

TEST(Adjusted, StaysWhereAllIsMetWithinTheBounds) {
  WholeRun run;
  run.says({2.0, 1.0, 3.0});
  EXPECT_EQ(adjusted(run.spec, run.whole, run.sensitivity), run.whole.shares);
}

TEST(Adjusted, GoesWithinTheBoundsOfWhatWasLostAndKeepsTheRest) {
  WholeRun run;
  run.says({-1.0, 1.0, 3.0});
  const Shares u = adjusted(run.spec, run.whole, run.sensitivity);
  const double a = u[0] - 0.5, b = u[1] - 0.5;
  for (const double y : {-1.0 + 10.0 * a, 1.0 + 2.0 * a - 4.0 * b, 3.0 + 20.0 * b})
    EXPECT_TRUE(y > 0.3 && y < 3.7) << y;
  EXPECT_NEAR(u[0], 0.65, 0.03);  // half a tolerance within the bound
  EXPECT_NEAR(u[1], 0.5, 0.02);
}

TEST(Adjusted, TakesNoLongWayForWhatIsOutOfReach) {
  WholeRun run;
  run.spec.cap = 3.0;
  run.says({2.0, 1.0, 300.0});
  EXPECT_EQ(adjusted(run.spec, run.whole, run.sensitivity), run.whole.shares);
}

TEST(Adjusted, GoesNoFurtherThanTheDifferencesReach) {
  WholeRun run;
  run.spec.step = 0.05;
  run.says({-3.0, 1.0, 3.0});
  EXPECT_NEAR(adjusted(run.spec, run.whole, run.sensitivity)[0], 0.55, 1e-12);
}

TEST(Adjusted, KeepsConstraintsAndRanges) {
  WholeRun run;
  run.spec.parameters[0].name = "a";
  run.spec.constraints.resize(1);
  run.spec.constraints[0].formula = "a";
  run.spec.constraints[0].most = 0.55;
  run.says({-1.0, 1.0, 3.0});
  const Shares u = adjusted(run.spec, run.whole, run.sensitivity);
  EXPECT_LE(u[0], 0.55);
  EXPECT_GT(u[0], 0.5);
}

}  // namespace
}  // namespace footfall
