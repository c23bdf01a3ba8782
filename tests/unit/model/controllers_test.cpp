// Controllers and the filter of their accelerations.
#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/model/control/controllers.h"
#include "tests/support/refused.h"

namespace footfall {
namespace {

// mbd_solver/model/control/controllers.h, pid_controller.h and skyhook_controller.h.

ControllerMeasurement measured(double acceleration, double velocity = 0.0, double rate = 0.0) {
  ControllerMeasurement m;
  m.acceleration = acceleration;
  m.velocity = velocity;
  m.strut_rate = Eigen::VectorXd::Constant(4, rate);
  return m;
}

Eigen::VectorXd sample(Controller& controller, const ControllerMeasurement& m) {
  Eigen::VectorXd u = Eigen::VectorXd::Constant(controller.output_count(), std::nan(""));
  controller.sample(m, u);
  return u;
}

TEST(ConstantController, AnswersItsVoltages) {
  ConstantControllerParameters p;
  p.voltages = Eigen::Vector3d(0.0, 0.5, 1.0);
  ConstantController controller(p);
  EXPECT_EQ(sample(controller, measured(30.0)), p.voltages);
  EXPECT_EQ(controller.memory().size(), 0);
}

TEST(ConstantController, RefusesVoltagesOutsideZeroToOne) {
  ConstantControllerParameters p;
  EXPECT_THROW(ConstantController{p}, InputError);
  p.voltages = Eigen::Vector2d(0.5, 1.2);
  EXPECT_TRUE(test::names(test::error_of([&] { ConstantController{p}; }), {"voltage 2", "1.2"}));
}

TEST(SkyhookController, IsOnWhileTheStrutOpposesTheBody) {
  SkyhookController controller({});
  EXPECT_EQ(sample(controller, measured(0.0, -3.0, 2.0))[0], 1.0);  // sinks, strut compresses: it brakes
  // rises, strut compresses: it would push on
  EXPECT_EQ(sample(controller, measured(0.0, 1.0, 2.0))[0], 0.0);
  EXPECT_EQ(sample(controller, measured(0.0, 1.0, -2.0))[0], 1.0);   // rises, strut extends: it holds back
  EXPECT_EQ(sample(controller, measured(0.0, -1.0, -2.0))[0], 0.0);  // sinks, strut extends
}

TEST(SkyhookController, KeepsItsValueInsideTheDeadband) {
  SkyhookController controller({});
  EXPECT_EQ(sample(controller, measured(0.0, -3.0, 0.001))[0], 0.0);  // nothing decided yet: off
  sample(controller, measured(0.0, -3.0, 2.0));
  EXPECT_EQ(sample(controller, measured(0.0, 3.0, 0.001))[0], 1.0);
  EXPECT_EQ(sample(controller, measured(0.0, 0.001, 2.0))[0], 1.0);
}

TEST(SkyhookController, DecidesEachStrutAloneAndResumes) {
  SkyhookController one({}), two({});
  ControllerMeasurement m = measured(0.0, -3.0);
  m.strut_rate << 1.0, -1.0, 0.0, 2.0;
  EXPECT_EQ(sample(one, m), Eigen::Vector4d(1.0, 0.0, 0.0, 1.0));
  two.restore(one.memory());
  EXPECT_EQ(sample(two, measured(0.0)), Eigen::Vector4d(1.0, 0.0, 0.0, 1.0));
}

TEST(PidController, IsProportionalToTheFilteredError) {
  PidControllerParameters p;
  p.ki = 0.0;
  p.bias = 0.2;
  PidController controller(p);
  // the first sample passes the filter
  EXPECT_NEAR(sample(controller, measured(20.0))[0], 0.2 + 0.03 * (29.4 - 20.0), 1e-12);
}

TEST(PidController, IntegralRemovesTheErrorOfALinearPlant) {
  // Plant: the acceleration answers a = 20 + 15 U at once; the set point 29.4 needs U = 0.62667.
  PidControllerParameters p;
  p.ki = 2.0;
  PidController controller(p);
  double u = 0.0;
  for (int k = 0; k < 2000; ++k) u = sample(controller, measured(20.0 + 15.0 * u))[2];
  EXPECT_NEAR(u, 9.4 / 15.0, 1e-6);
}

TEST(PidController, DoesNotWindUpInFreeFallOrSaturation) {
  PidController controller({});
  for (int k = 0; k < 5000; ++k) sample(controller, measured(-1.63));
  EXPECT_EQ(controller.memory()[AccelerationFilter::kMemory], 0.0);
  for (int k = 0; k < 20; ++k) sample(controller, measured(60.0));  // until the filter has left free fall
  for (int k = 0; k < 5000; ++k) EXPECT_EQ(sample(controller, measured(60.0))[0], 0.0);
  const double integral = controller.memory()[AccelerationFilter::kMemory];
  EXPECT_GE(integral, -0.1);  // held since U reached 0
}

TEST(PidController, VoltagesStayInRangeAndResumeToTheBit) {
  PidControllerParameters p;
  p.kd = 1e-3;
  PidController one(p), two(p);
  for (int k = 0; k < 200; ++k) {
    const Eigen::VectorXd u = sample(one, measured(40.0 * std::sin(0.1 * k)));
    EXPECT_TRUE((u.array() >= 0.0).all() && (u.array() <= 1.0).all());
  }
  two.restore(one.memory());
  for (int k = 200; k < 260; ++k)
    EXPECT_EQ(sample(one, measured(40.0 * std::sin(0.1 * k))), sample(two, measured(40.0 * std::sin(0.1 * k))));
}

TEST(SimpleControllers, RefuseNonsense) {
  SkyhookControllerParameters s;
  s.off = 0.6, s.on = 0.5;
  EXPECT_THROW(SkyhookController{s}, InputError);
  s = {};
  s.outputs = 0;
  EXPECT_THROW(SkyhookController{s}, InputError);
  PidControllerParameters p;
  p.kp = -1.0;
  EXPECT_THROW(PidController{p}, InputError);
  p = {};
  p.period = 0.0;
  EXPECT_THROW(PidController{p}, InputError);
}

constexpr double kTwoPi = 6.28318530717958647692;

TEST(AccelerationFilter, StepResponseIsThatOfTheAnalogueFilter) {
  const double f = 50.0, T = 1e-3;
  AccelerationFilter filter("test", f, T);
  filter.sample(0.0);
  for (int k = 1; k <= 40; ++k) {
    filter.sample(10.0);
    EXPECT_NEAR(filter.acceleration(), 10.0 * (1.0 - std::exp(-kTwoPi * f * T * k)), 1e-12);
  }
}

TEST(AccelerationFilter, StartsAtTheFirstSampleWithoutJerk) {
  AccelerationFilter filter("test", 50.0, 1e-3);
  filter.sample(-1.63);
  EXPECT_EQ(filter.acceleration(), -1.63);
  EXPECT_EQ(filter.jerk(), 0.0);
}

// A ramp of slope s: y lags by the constant s T (1 - g) / g, g = 1 - exp(-2 pi f T), and the jerk is s. For T
// -> 0 the lag time is the 1 / (2 pi f) of the analogue filter.
TEST(AccelerationFilter, FollowsARampWithItsLagAndGivesItsSlope) {
  const double slope = 400.0, f = 50.0;
  for (double T : {1e-3, 1e-4}) {
    AccelerationFilter filter("test", f, T);
    double a = 0.0;
    for (int k = 0; k * T < 0.2; ++k) filter.sample(a = slope * k * T);
    const double g = 1.0 - std::exp(-kTwoPi * f * T);
    EXPECT_NEAR(a - filter.acceleration(), slope * T * (1.0 - g) / g, 1e-9);
    EXPECT_NEAR((a - filter.acceleration()) / slope, 1.0 / (kTwoPi * f), 0.5 * T + 1e-5);
    EXPECT_NEAR(filter.jerk(), slope, 1e-9);
  }
}

TEST(AccelerationFilter, FrequencyZeroPassesEverything) {
  AccelerationFilter filter("test", 0.0, 1e-3);
  filter.sample(1.0);
  filter.sample(3.0);
  EXPECT_EQ(filter.acceleration(), 3.0);
  EXPECT_EQ(filter.jerk(), 2000.0);
}

TEST(AccelerationFilter, ContinuesToTheBitAfterRestore) {
  AccelerationFilter one("test", 50.0, 1e-3), two("test", 50.0, 1e-3);
  one.sample(3.0);
  one.sample(7.0);
  Eigen::VectorXd memory(AccelerationFilter::kMemory);
  one.save(memory);
  two.restore(memory);
  EXPECT_EQ(two.jerk(), one.jerk());
  one.sample(-2.0);
  two.sample(-2.0);
  EXPECT_EQ(one.acceleration(), two.acceleration());
  EXPECT_EQ(one.jerk(), two.jerk());
}

TEST(AccelerationFilter, RefusesNonsense) {
  EXPECT_THROW(AccelerationFilter("test", -1.0, 1e-3), InputError);
  EXPECT_THROW(AccelerationFilter("test", 50.0, 0.0), InputError);
}

}  // namespace
}  // namespace footfall
