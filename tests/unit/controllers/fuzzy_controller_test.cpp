#include "mbd_solver/model/controllers/fuzzy_controller.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "tests/unit/controllers/fuzzy_files.h"

namespace footfall {
namespace {

ControllerMeasurement measurement(double acceleration, double pitch = 0.0, double roll = 0.0) {
  ControllerMeasurement m;
  m.acceleration = acceleration;
  m.pitch = pitch;
  m.roll = roll;
  return m;
}

FuzzyControllerParameters parameters() {
  FuzzyControllerParameters p;
  p.file = lander_file();
  return p;
}

TEST(FuzzyController, FeedsTheUnitsOfTheFile) {
  FuzzyControllerParameters p = parameters();
  p.filter_frequency = 0.0;  // no filter: the jerk is the plain difference
  FuzzyController controller(p);
  Eigen::VectorXd u(4);
  const double degree = kPi / 180.0;
  controller.sample(measurement(2.0 * 9.80665, 1.5 * degree, -0.5 * degree), u);
  EXPECT_LT((u - voltages(controller.system(), {2.0, 0.0, 1.5, -0.5})).cwiseAbs().maxCoeff(), 1e-12);
  // 0.04 g more after 1 ms: 4 g per 0.1 s.
  controller.sample(measurement(2.04 * 9.80665, 1.5 * degree, -0.5 * degree), u);
  EXPECT_LT((u - voltages(controller.system(), {2.04, 4.0, 1.5, -0.5})).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(FuzzyController, FreeFallCountsAsNoAcceleration) {
  FuzzyController controller(parameters());
  Eigen::VectorXd u(4);
  controller.sample(measurement(-1.63), u);
  EXPECT_EQ(u, voltages(controller.system(), {0.0, 0.0, 0.0, 0.0}));
}

TEST(FuzzyController, ResumesToTheBit) {
  FuzzyController one(parameters()), two(parameters());
  Eigen::VectorXd u(4), v(4);
  for (int k = 0; k < 50; ++k) one.sample(measurement(30.0 * std::sin(0.05 * k), 0.02, -0.01), u);
  two.restore(one.memory());
  for (int k = 50; k < 80; ++k) {
    one.sample(measurement(30.0 * std::sin(0.05 * k), 0.02, -0.01), u);
    two.sample(measurement(30.0 * std::sin(0.05 * k), 0.02, -0.01), v);
    EXPECT_EQ(u, v);
  }
}

TEST(FuzzyController, TabulatedStaysCloseAndSaysHowClose) {
  FuzzyControllerParameters p = parameters();
  FuzzyController exact(p);
  EXPECT_FALSE(exact.table_difference());
  p.tabulated = true;
  p.grid = {25, 9, 17, 17};  // coarse: this test is about the statement
  FuzzyController tabulated(p);
  ASSERT_TRUE(tabulated.table_difference());
  const double stated = *tabulated.table_difference();
  EXPECT_GT(stated, 0.0);
  Eigen::VectorXd u(4), v(4);
  for (int k = 0; k < 200; ++k) {
    const ControllerMeasurement m = measurement(25.0 * (1.0 - std::cos(0.03 * k)), 0.03 * std::sin(0.1 * k), 0.02);
    exact.sample(m, u);
    tabulated.sample(m, v);
    // the stated value is the largest of a random sample, not a bound
    EXPECT_LE((u - v).cwiseAbs().maxCoeff(), 1.5 * stated);
  }
}

TEST(FuzzyController, RefusesNonsense) {
  FuzzyControllerParameters p = parameters();
  p.period = 0.0;
  EXPECT_THROW(FuzzyController{p}, InputError);
  p = parameters();
  p.file = "missing.fll";
  EXPECT_THROW(FuzzyController{p}, InputError);
}

}  // namespace
}  // namespace footfall
