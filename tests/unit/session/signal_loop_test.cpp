// Signals, states and events in runs whose motion is known in closed form.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "mbd_solver/base/pi.h"
#include "tests/support/linear_algebra.h"
#include "tests/support/refused.h"
#include "tests/unit/session/recorded.h"

namespace footfall {
namespace {

// A wheel of 0.5 kg m2 on a hinge, without gravity.
const std::string kWheel = R"(end_time = 1.0
gravity = [0, 0, 0]
[[bodies]]
name = "wheel"
mass = 1.0
inertia = [0.2, 0.3, 0.5]
position = [0, 0, 0]
[[joints]]
name = "axle"
kind = "revolute"
bodies = ["ground", "wheel"]
point = [0, 0, 0]
axis = "z"
[[drives]]
name = "motor"
kind = "torque"
joint = "axle"
command = { signal = "torque" }
[solver]
rtol = 1e-10
atol = 1e-11
[output]
interval = 0.05
)";

// A ball that falls from 3 m at 1.5 m/s2 and at first 1 m/s.
const std::string kFallingBall = R"(end_time = 1.0
gravity = [0, 0, -1.5]
[[bodies]]
name = "ball"
mass = 2.0
inertia = [0.1, 0.1, 0.1]
position = [0, 0, 3]
[initial]
velocity = [0, 0, -1.0]
[output]
interval = 0.01
)";

using test::Record;

// x' = A x from x0.
Eigen::VectorXd linear(const Eigen::MatrixXd& A, const Eigen::VectorXd& x0, double t) {
  return test::exponential(A * t) * x0;
}

class SignalRuns : public ::testing::TestWithParam<std::string> {
 protected:
  std::vector<std::string> settings(std::vector<std::string> more = {}) const {
    more.push_back("solver.integrator=" + GetParam());
    return more;
  }
};

// J q'' = kp e + ki I - kd q', e = 1 - q, I' = e: linear, so known at any time.
TEST_P(SignalRuns, PidHoldsAnAngleAsItsEquationSays) {
  const Scene scene = SceneText().read(kWheel + R"(
[[signals]]
name = "error"
kind = "expression"
input = "1 - axle.angle"
[[signals]]
name = "torque"
kind = "pid"
input = "signal.error"
rate = "-axle.angle_rate"
kp = 20
ki = 15
kd = 2
)",
                                       settings());
  Record record(scene);
  record.run();
  Eigen::MatrixXd A(4, 4);  // q, q', I, 1
  A << 0, 1, 0, 0, -20 / 0.5, -2 / 0.5, 15 / 0.5, 20 / 0.5, -1, 0, 0, 1, 0, 0, 0, 0;
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const double t = record.rows[row][0];
    const Eigen::VectorXd x = linear(A, Eigen::Vector4d(0, 0, 0, 1), t);
    EXPECT_NEAR(record.value(row, "axle.angle"), x[0], 1e-7) << t;
    EXPECT_NEAR(record.value(row, "axle.angle_rate"), x[1], 1e-6) << t;
    EXPECT_NEAR(record.value(row, "signal.torque"), 20 * (1 - x[0]) + 15 * x[2] - 2 * x[1], 1e-6) << t;
    EXPECT_NEAR(record.value(row, "motor.joint_torque"), record.value(row, "signal.torque"), 1e-12) << t;
  }
  EXPECT_LT(record.metrics.energy_balance, 1e-7);  // of some 10 J: of the integration
}

// Filters of a step, integrated with the mechanism: their step answers.
TEST_P(SignalRuns, ContinuousFiltersAnswerAStepAsTheirEquationSays) {
  const Scene scene = SceneText().read(kWheel + R"(
[[signals]]
name = "torque"
kind = "lowpass"
input = "2"
initial = 0
frequency = 3
[[signals]]
name = "second"
kind = "lowpass2"
input = "2"
initial = 0
frequency = 3
damping = 0.4
[[signals]]
name = "notch"
kind = "notch"
input = "sin(2 * pi * 3 * time) "
frequency = 3
damping = 0.4
)",
                                       settings());
  Record record(scene);
  record.run();
  const double w = 2.0 * kPi * 3.0, d = 0.4, wd = w * std::sqrt(1 - d * d);
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const double t = record.rows[row][0];
    EXPECT_NEAR(record.value(row, "signal.torque"), -2.0 * std::expm1(-w * t), 1e-8) << t;
    const double decay = std::exp(-d * w * t);
    EXPECT_NEAR(record.value(row, "signal.second"),
                2.0 * (1.0 - decay * (std::cos(wd * t) + d * w / wd * std::sin(wd * t))), 1e-8)
        << t;
    // At its own frequency a notch leaves only what dies away: w/wd e^(-d w t) (wd/w cos - d sin) .. = L^-1[w/(s2+2dws+w2)]
    EXPECT_NEAR(record.value(row, "signal.notch"), w / wd * decay * std::sin(wd * t), 1e-8) << t;
    // The wheel under 2 (1 - e^-wt): w_z = 2 (t - (1 - e^-wt)/w) / J
    EXPECT_NEAR(record.value(row, "axle.angle_rate"), 2.0 * (t + std::expm1(-w * t) / w) / 0.5, 1e-8) << t;
  }
}

const std::string kThrust = R"(
[[signals]]
name = "thrust"
kind = "expression"
input = "state.falling * 1.0"
[[forces]]
name = "engine"
body = "ball"
frame = "inertial"
direction = "z"
force = { signal = "thrust" }
[[states]]
name = "falling"
[[states]]
name = "landed"
[[events]]
name = "low"
when = "ball.z < 2"
to = "landed"
)";

// z = 3 - t - t^2 / 2 until it is 2; then without thrust.
void expect_fall(const Record& record, double cut, double tolerance) {
  for (std::size_t row = 0; row < record.rows.size(); ++row) {
    const double t = record.rows[row][0], before = std::min(t, cut), after = t - before;
    const double v = -1.0 - before, z = 3.0 - before - 0.5 * before * before;
    EXPECT_NEAR(record.value(row, "ball.z"), z + v * after - 0.75 * after * after, tolerance) << t;
    EXPECT_NEAR(record.value(row, "ball.vz"), v - 1.5 * after, tolerance) << t;
    if (std::abs(t - cut) > 1e-6) {
      EXPECT_EQ(record.value(row, "state.landed"), t > cut ? 1.0 : 0.0) << t;
      EXPECT_EQ(record.value(row, "signal.thrust"), t > cut ? 0.0 : 1.0) << t;
    }
  }
}

TEST_P(SignalRuns, AnEventWithoutPeriodHappensAtItsInstant) {
  const Scene scene = SceneText().read(kFallingBall + kThrust, settings());
  Record record(scene);
  record.run();
  const double instant = std::sqrt(3.0) - 1.0;
  const double tolerance = GetParam() == "ida" ? 1e-6 : 1e-9;  // of the integration; kEventTime is less
  EXPECT_NEAR(record.last("time") - record.last("state.since"), instant, tolerance);
  expect_fall(record, instant, tolerance);
}

TEST_P(SignalRuns, AnEventWithPeriodHappensAtItsSample) {
  const Scene scene = SceneText().read(kFallingBall + kThrust, settings({"events.low.period=0.1"}));
  Record record(scene);
  record.run();
  EXPECT_NEAR(record.last("time") - record.last("state.since"), 0.8, 1e-12);
  expect_fall(record, 0.8, GetParam() == "ida" ? 1e-6 : 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Integrators, SignalRuns, ::testing::Values("one_step", "ida"));

// A condition that is true from the start, then another that is true in the state it leads to.
TEST(SignalEvents, HappenOneAfterTheOther) {
  const Scene scene = SceneText().read(kFallingBall + kThrust + R"(
[[states]]
name = "done"
[[events]]
name = "at_once"
from = ["falling"]
when = "time >= 0"
to = "landed"
[[events]]
name = "later"
from = ["landed"]
when = "state.since > 0.25"
to = "done"
)",
                                       {"events.low.from=[\"falling\"]"});
  Record record(scene);
  record.run();
  EXPECT_EQ(record.value(0, "state.landed"), 1.0);
  EXPECT_EQ(record.last("state.done"), 1.0);
  EXPECT_NEAR(record.last("time") - record.last("state.since"), 0.25, 1e-9);
}

TEST(SignalEvents, InACircleEndTheRun) {
  const Scene scene = SceneText().read(kFallingBall + kThrust + R"(
[[events]]
name = "back"
from = ["landed"]
when = "ball.z < 2"
to = "falling"
)");
  Record record(scene);
  EXPECT_TRUE(test::names(test::error_of<NumericalError>([&] { record.run(); }), {"0.73", "low", "back"}));
}

// Held between samples: x_(k+1) = x_k + v_k T + (F_k - m g) T^2 / 2m.
TEST(SampledSignals, AreHeldBetweenTheirSamples) {
  const Scene scene = SceneText().read(kFallingBall + R"(
[[signals]]
name = "thrust"
kind = "pid"
input = "2.5 - ball.z"
kp = 8
ki = 3
kd = 4
min = 0
max = 6
period = 0.05
[[forces]]
name = "engine"
body = "ball"
frame = "inertial"
direction = "z"
force = { signal = "thrust" }
)");
  Record record(scene);
  record.run();
  double z = 3.0, v = -1.0, integral = 0.0, before = 2.5 - z;
  const double T = 0.05;
  for (int k = 0; k < 20; ++k) {
    const double e = 2.5 - z, asked = 8 * e + 3 * integral + 4 * (e - before) / T, F = std::clamp(asked, 0.0, 6.0);
    EXPECT_NEAR(record.value(static_cast<std::size_t>(5 * k + (k > 0 ? 1 : 0)), "signal.thrust"), F, 1e-9) << k;
    integral += T * (e + (F - asked) / 8);
    before = e;
    const double a = F / 2.0 - 1.5;
    z += v * T + 0.5 * a * T * T;
    v += a * T;
  }
  EXPECT_NEAR(record.last("ball.z"), z, 1e-9);
  EXPECT_NEAR(record.last("ball.vz"), v, 1e-9);
  EXPECT_LT(record.metrics.energy_balance, 1e-9);
}

// Accelerations and forces are known at samples.
TEST(SampledSignals, ReadAnyColumn) {
  const Scene scene = SceneText().read(kWheel + R"(
[[signals]]
name = "torque"
kind = "expression"
input = "wheel.wz * 0 + 2"
period = 0.01
[[signals]]
name = "seen"
kind = "expression"
input = "motor.joint_torque + 10 * axle.fz + energy.kinetic + wheel.az"
period = 0.01
)",
                                       {"output.joints=false", "output.bodies=[]"});
  Record record(scene);
  record.run();
  // The torque is there from the first sample on: the speed is 4 t. The last sample is at 0.99 s.
  EXPECT_NEAR(record.last("signal.seen"), 2.0 + 0.25 * std::pow(4.0 * 0.99, 2), 1e-6);
}

// A filter that works in one state starts anew there.
TEST(SampledSignals, StartAnewWhereTheirStateBegins) {
  for (const char* period : {"", "period = 0.01\n"}) {
    const Scene scene = SceneText().read(kFallingBall + kThrust + R"(
[[signals]]
name = "mean"
kind = "lowpass"
input = "ball.z"
frequency = 1
initial = 0
states = ["landed"]
)" + period);
    Record record(scene);
    record.run();
    for (std::size_t row = 0; row < record.rows.size(); ++row) {
      const double since = record.value(row, "state.since");
      const double mean = record.value(row, "signal.mean");
      const bool landed = record.value(row, "state.landed") == 1.0;
      EXPECT_LT(mean, landed ? 2.0 * 2.0 * kPi * since + 1e-9 : 1e-12) << row;
    }
    EXPECT_GT(record.last("signal.mean"), 1.0);
  }
}

// What is kept at a checkpoint and gone on with is the run that was not stopped, to the bit.
TEST(SignalMemory, ResumesToTheBit) {
  const Scene scene = SceneText().read(kFallingBall + kThrust + R"(
[[signals]]
name = "hold"
kind = "pid"
input = "2.5 - ball.z"
kp = 8
ki = 3
kd = 4
min = 0
period = 0.007
[[signals]]
name = "smooth"
kind = "lowpass2"
input = "signal.hold + ball.vz"
frequency = 4
[[forces]]
name = "second"
body = "ball"
frame = "inertial"
direction = "z"
force = { signal = "smooth" }
)",
                                       {"output.checkpoint_interval=0.3"});
  EXPECT_EQ(test::expect_resumed_to_the_bit(scene)->last("state.landed"), 1.0);
}

// A plate that has pressed a print into a soil and slides in it: what the ground remembers is in the checkpoint.
TEST(SoilMemory, ResumesToTheBit) {
  for (const char* law :
       {"{ density = 1500, friction = 0.5, rebound = 2e-3 }",
        "{ kind = \"pressure_sinkage\", frictional_modulus = 2e5, exponent = 0.9, shear_length = 0.02 }"}) {
    const Scene scene = SceneText().read(R"(end_time = 0.03
gravity = [0, 0, -1.62]
[[bodies]]
name = "ball"
mass = 4.0
inertia = [0.1, 0.1, 0.1]
shape = { kind = "box", size = [0.3, 0.3, 0.1], centre = [0, 0, 0.05] }
position = [0, 0, 0.05]
[[boundaries]]
body = "ball"
surface = { element_size = 0.3, closed = true }
[ground]
kind = "soil"
[initial]
velocity = [0.5, 0, -1.0]
clearance = 0.002
[solver]
rtol = 1e-4
atol = 1e-6
[output]
interval = 0.002
)",
                                         {std::string("ground.law=") + law, "output.checkpoint_interval=0.01"});
    SCOPED_TRACE(law);
    EXPECT_GT(test::expect_resumed_to_the_bit(scene)->last("dissipated.soil"), 0.1);
  }
}

}  // namespace
}  // namespace footfall
