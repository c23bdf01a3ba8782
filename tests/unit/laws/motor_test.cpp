#include "mbd_solver/model/laws/motor.h"

#include "coupler/base/errors.h"
#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;

MotorParameters parameters(MotorKind kind) {
  MotorParameters p;
  p.kind = kind;
  p.command = polynomial({0.4});
  p.largest_torque = 2.0;
  p.no_load_speed = 30.0;
  p.gear_ratio = 10.0;
  p.efficiency = 0.8;
  if (kind == MotorKind::kTorque) return p;
  p.kp = 3.0;
  p.ki = 0.7;
  if (kind == MotorKind::kPosition) p.kd = 0.2;
  return p;
}

TEST(Motor, TorqueFallsWithSpeedAndBrakesBeyond) {
  MotorParameters p = parameters(MotorKind::kTorque);
  p.command = polynomial({100.0});
  p.efficiency = 1.0;
  const Motor law(p);
  EXPECT_DOUBLE_EQ(-force(law, 0.0, 0.0), 20.0);
  EXPECT_DOUBLE_EQ(-force(law, 0.0, 1.5), 10.0);   // half the speed without load
  EXPECT_NEAR(-force(law, 0.0, 3.0), 0.0, 1e-14);  // round-off
  EXPECT_DOUBLE_EQ(-force(law, 0.0, 4.5), -10.0);  // faster than that it brakes
  EXPECT_DOUBLE_EQ(-force(law, 0.0, -5.0), 20.0);  // braking has the whole torque
}

TEST(Motor, GearTakesItsShareBothWays) {
  const Motor law(parameters(MotorKind::kTorque));
  EXPECT_NEAR(-force(law, 0.0, 1.0), 0.8 * 4.0, 1e-12);   // drives
  EXPECT_NEAR(-force(law, 0.0, -1.0), 4.0 / 0.8, 1e-12);  // is driven: the load must overcome the gear, too
  EXPECT_DOUBLE_EQ(-force(law, 0.0, 0.0), 4.0);
}

TEST(Motor, HasTheDerivativesOfItsForceAndRates) {
  for (const MotorKind kind : every<MotorKind>()) {
    if (kind == MotorKind::kBrake) continue;  // a law of its own, brake_test.cpp
    const Motor law(parameters(kind));
    for (const double x : {-0.5, 0.3, 0.45, 2.0})
      for (const double v : {-2.0, -0.0005, 0.0004, 0.11, 1.3, 4.0})
        expect_derivatives(law, x, v, 0.0, Eigen::VectorXd::Constant(law.state_count(), 0.1), 1.0, 1e-3);
  }
}

TEST(Motor, GivesWhatTheJointAndTheGearTake) {
  for (const MotorKind kind : every<MotorKind>()) {
    if (kind == MotorKind::kBrake) continue;  // a law of its own, brake_test.cpp
    const Motor law(parameters(kind));
    const Eigen::VectorXd z = Eigen::VectorXd::Constant(law.state_count(), 0.1);
    for (const double v : {-2.0, -0.0005, 0.0004, 0.11, 1.3}) {
      const StrutInput in{0.3, v, 0.0, z};
      EXPECT_NEAR(law.supplied_power(in), -force(law, 0.3, v, 0.0, z) * v + dissipated(law, in), 1e-12);
    }
  }
}

TEST(Motor, RefusesASpeedWithoutATorque) {
  MotorParameters p = parameters(MotorKind::kTorque);
  p.largest_torque.reset();
  expect_contains(message_of<InputError>([&] { Motor law(p); }), "max_torque");
}

}  // namespace
}  // namespace footfall
