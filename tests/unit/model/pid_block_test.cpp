// The PID of signals: its terms, its limits, and what its integral does at them.

#include "mbd_solver/model/signals/pid_block.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"

namespace footfall {
namespace {

Eigen::VectorXd error(double e) { return Eigen::VectorXd::Constant(1, e); }

TEST(PidBlock, SampledAddsItsThreeTerms) {
  PidBlockParameters p;
  p.kp = 2.0;
  p.ki = 5.0;
  p.kd = 0.1;
  p.bias = 0.5;
  p.period = 0.01;
  const PidBlock pid(p);
  Eigen::VectorXd z(2);
  pid.settle(error(1.0), z);
  double integral = 0.0, before = 1.0;
  for (int k = 0; k < 20; ++k) {
    const double e = std::cos(0.3 * k);
    const double expected = 0.5 + 2.0 * e + 5.0 * integral + 0.1 * (e - before) / 0.01;
    EXPECT_NEAR(pid.sample(error(e), 0.01, z), expected, 1e-13);  // round-off
    integral += 0.01 * e;
    before = e;
  }
}

TEST(PidBlock, TakesTheRateThatIsGiven) {
  PidBlockParameters p;
  p.kp = 2.0;
  p.kd = 3.0;
  p.rate_is_given = true;
  const PidBlock pid(p);
  EXPECT_EQ(pid.state_count(), 0);
  EXPECT_DOUBLE_EQ(pid.value(Eigen::Vector2d(0.5, -0.1), Eigen::VectorXd()), 2.0 * 0.5 - 3.0 * 0.1);
}

// A long time at the limit, then the error changes its sign: without anti-windup it would take as long to come back.
TEST(PidBlock, ComesOffItsLimitAtOnce) {
  PidBlockParameters p;
  p.kp = 1.0;
  p.ki = 10.0;
  p.max = 1.0;
  p.min = -1.0;
  p.period = 0.001;
  const PidBlock pid(p);
  Eigen::VectorXd z = Eigen::VectorXd::Zero(1);
  for (int k = 0; k < 100000; ++k) EXPECT_EQ(pid.sample(error(1.0), p.period, z), 1.0);
  // The integral rests where kp e + ki I is 1 + kp e: one more error's worth.
  EXPECT_NEAR(p.ki * z[0], 1.0, 1e-6);
  int samples = 0;
  while (pid.sample(error(-0.1), p.period, z) > 0.5) ++samples;
  EXPECT_LT(samples, 600);  // 0.4 / (ki 0.1) = 0.4 s; wound up it would take 1000 s
}

TEST(PidBlock, ContinuousIntegralIsHeldBackAtALimit) {
  PidBlockParameters p;
  p.kp = 2.0;
  p.ki = 1.0;
  p.max = 1.0;
  const PidBlock pid(p);
  Eigen::VectorXd z = Eigen::VectorXd::Constant(1, 1.0), dz(1);
  pid.rates(error(3.0), z, dz);  // v = 7, y = 1
  EXPECT_DOUBLE_EQ(dz[0], 3.0 + (1.0 - 7.0) / 2.0);
  EXPECT_DOUBLE_EQ(pid.value(error(3.0), z), 1.0);
}

TEST(PidBlock, FilteredRateSettlesToTheSlope) {
  PidBlockParameters p;
  p.kd = 1.0;
  p.derivative_frequency = 10.0;
  const PidBlock pid(p);
  // e = 2 t: z = 2 t - 2 / w once settled, D = w (e - z) = 2
  const double w = 2.0 * kPi * 10.0;
  const Eigen::VectorXd z = Eigen::VectorXd::Constant(1, 2.0 * 7.0 - 2.0 / w);
  Eigen::VectorXd dz(1);
  pid.rates(error(2.0 * 7.0), z, dz);
  EXPECT_NEAR(dz[0], 2.0, 1e-12);
  EXPECT_NEAR(pid.value(error(2.0 * 7.0), z), 2.0, 1e-12);
}

TEST(PidBlock, RefusesWhatCannotWork) {
  PidBlockParameters p;
  p.ki = 1.0;
  p.max = 1.0;
  EXPECT_THROW(PidBlock{p}, InputError);  // nothing holds the integral back
  p = {};
  p.kd = 1.0;
  EXPECT_THROW(PidBlock{p}, InputError);  // continuous, and no rate
  p = {};
  p.kp = 1.0;
  p.min = 2.0;
  p.max = 1.0;
  EXPECT_THROW(PidBlock{p}, InputError);
}

}  // namespace
}  // namespace footfall
