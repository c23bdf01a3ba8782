// Laws of struts and joints: force, derivatives, energy, limits.
#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/assemble/law_files.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/laws/curves.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/springs.h"
#include "mbd_solver/model/laws/table_law.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/model/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;
const LinearSpringDamperParameters kLaw{1000.0, 20.0, 0.1, 50.0};

TEST(LinearSpringDamper, IsLinear) {
  const LinearSpringDamper law(kLaw);
  EXPECT_DOUBLE_EQ(force(law, 0.1), 50.0);
  EXPECT_DOUBLE_EQ(force(law, 0.3, -2.0), 50.0 + 200.0 - 40.0);
}

TEST(LinearSpringDamper, SineLoopIsAnEllipse) {
  const LinearSpringDamper law(kLaw);
  const double A = 0.2, omega = 5.0, area = kPi * 20.0 * omega * A * A;
  const Motion motion{[&](double t) { return A * std::sin(omega * t); },
                      [&](double t) { return A * omega * std::cos(omega * t); }};
  const Along run = drive(law, motion, 0.0, 2.0 * kPi / omega, 2000, 0.0, law_checks::kNoState);
  EXPECT_NEAR(run.work, area, 1e-8 * area);
  EXPECT_NEAR(run.dissipated, area, 1e-8 * area);
}

TEST(LinearSpringDamper, DissipatesWhatItTakes) {
  const LinearSpringDamper law(kLaw);
  const Along run = drive(law, random_motion(7, 0.0, 0.3), 0.0, 1.3, 4000, 0.0, law_checks::kNoState);
  EXPECT_NEAR(run.work, run.dissipated + run.stored - run.stored_start, 1e-8 * run.dissipated);
  expect_derivatives(law, 0.2, -1.0, 0.0, law_checks::kNoState, 0.1, 1.0);
  expect_power_identity(law, 0.2, -1.0, 0.0, law_checks::kNoState);
}

TEST(LinearSpringDamper, RefusesNonsense) {
  EXPECT_THROW(LinearSpringDamper{LinearSpringDamperParameters{}}, InputError);
  EXPECT_THROW(LinearSpringDamper(LinearSpringDamperParameters{-1.0, 0.0, 0.0, 0.0}), InputError);
  EXPECT_THROW(LinearSpringDamper(LinearSpringDamperParameters{1.0, -2.0, 0.0, 0.0}), InputError);
}

TEST(GasSpring, FollowsEquation13) {
  const GasSpring law({});
  const double area = kPi * 0.045 * 0.045 / 4.0;
  EXPECT_DOUBLE_EQ(law.piston_area(), area);
  EXPECT_DOUBLE_EQ(force(law, 0.0), area * 1.0e6);
  for (double x : {-0.1, 0.05, 0.2, 0.32})
    EXPECT_NEAR(force(law, x) / (area * 1.0e6 * std::pow(5.53e-4 / (5.53e-4 - area * x), 1.1)), 1.0, 1e-14);
  EXPECT_NEAR(law.stroke_limit(), 0.3477, 1e-4);  // the figure of the scene page: 0.348 m
}

TEST(GasSpring, IsothermalForceTimesVolumeIsConstant) {
  GasSpringParameters p;
  p.exponent = 1.0;
  const GasSpring law(p);
  for (double x : {-0.2, 0.1, 0.3})
    EXPECT_NEAR(force(law, x) * (p.initial_volume - law.piston_area() * x),
                law.piston_area() * p.initial_pressure * p.initial_volume, 1e-12);
}

TEST(GasSpring, StoredEnergyIsTheWorkOfItsForce) {
  for (double exponent : {1.0, 1.0 + 1e-9, 1.1, 1.4}) {
    GasSpringParameters p;
    p.exponent = exponent;
    const GasSpring law(p);
    // Out and back over 0.3 m at changing speed: Runge-Kutta with 4000 steps integrates this smooth force to
    // 1e-10 of the work.
    const Motion motion{[](double t) { return 0.15 * (1.0 - std::cos(t)); },
                        [](double t) { return 0.15 * std::sin(t); }};
    const Along in = drive(law, motion, 0.0, kPi, 4000, 0.0, law_checks::kNoState);
    EXPECT_NEAR(in.work, in.stored - in.stored_start, 1e-8 * in.work) << "exponent " << exponent;
    EXPECT_EQ(in.dissipated, 0.0);
    const Along cycle = drive(law, motion, 0.0, 2.0 * kPi, 8000, 0.0, law_checks::kNoState);
    EXPECT_NEAR(cycle.work, 0.0, 1e-8 * in.work) << "the gas gives back what it took";
  }
}

TEST(GasSpring, DerivativesAreThoseOfTheForce) {
  const GasSpring law({});
  for (double x = -0.3; x < 0.34; x += 0.02) {
    expect_derivatives(law, x, 1.0, 0.5, law_checks::kNoState, 0.1, 1.0);
    expect_power_identity(law, x, -2.0, 0.5, law_checks::kNoState);
  }
}

TEST(GasSpring, HasNoValueOnceItsVolumeIsUsedUp) {
  const GasSpring law({});
  EXPECT_TRUE(test::names(test::error_of<NumericalError>([&] { force(law, 0.36); }), {"0.36 m", "0.347704 m"}));
  EXPECT_THROW(force(law, law.stroke_limit()), NumericalError);
  EXPECT_THROW(force(law, std::nan("")), NumericalError);
  EXPECT_THROW(law.stored_energy({0.36, 0.0, 0.0, law_checks::kNoState}), NumericalError);
}

TEST(GasSpring, RefusesNonsense) {
  expect_refused<GasSpring, GasSpringParameters>({}, {{"initial_volume", [](auto& p) { p.initial_volume = -1.0; }},
                                                      {"exponent", [](auto& p) { p.exponent = 0.9; }},
                                                      {"piston_diameter", [](auto& p) { p.piston_diameter = NAN; }},
                                                      {"0.36 m", [](auto& p) { p.largest_stroke = 0.36; }}});
}

EndStopParameters both() {
  EndStopParameters p;
  p.smallest_stroke = 0.0;
  p.largest_stroke = 0.32;
  return p;
}

TEST(EndStop, IsAbsentBetweenItsLimitsAndStiffBeyond) {
  const EndStop law(both());
  for (double x : {0.0, 0.1, 0.32}) EXPECT_EQ(force(law, x, 2.0), 0.0);
  EXPECT_NEAR(force(law, 0.33), 5.0e6 * (0.01 - 0.00025), 1e-6);
  EXPECT_NEAR(force(law, -0.01), -5.0e6 * (0.01 - 0.00025), 1e-6);
  EXPECT_NEAR(force(law, 0.33, 2.0), 3.0 * force(law, 0.33), 1e-6);  // 1 + chi v
}

TEST(EndStop, NeverPulls) {
  const EndStop law(both());
  for (double depth : {1e-5, 3e-4, 0.01})
    for (double speed : {0.1, 1.0, 10.0, 100.0}) {
      EXPECT_GT(force(law, 0.32 + depth, -speed), 0.0);
      EXPECT_LT(force(law, -depth, speed), 0.0);
    }
}

TEST(EndStop, DerivativesAreThoseOfTheForce) {
  const EndStop law(both());
  for (double x : {-0.01, -0.0003, 0.1, 0.3203, 0.33})
    for (double v : {-3.0, -0.1, 0.2, 4.0}) {
      expect_derivatives(law, x, v, 0.0, law_checks::kNoState, 1e-2, 1.0);
      expect_power_identity(law, x, v, 0.0, law_checks::kNoState);
    }
}

TEST(EndStop, DissipatesWhatItTakes) {
  const EndStop law(both());
  for (unsigned seed : {1u}) {
    // The kinks of the second derivative at limit and toe leave Runge-Kutta second-order jumps: 1e5 steps
    // bring them below 1e-8.
    const Along run = drive(law, random_motion(seed, 0.16, 0.35), 0.0, 1.0, 100000, 0.0, law_checks::kNoState);
    EXPECT_GT(run.work, 1.0) << "seed " << seed << " does not reach the stop";
    EXPECT_NEAR(run.work, run.dissipated + run.stored - run.stored_start, 1e-8 * run.work);
  }
}

TEST(EndStop, YieldsByItsPenetrationUnderAStaticForce) {
  const EndStop law(both());
  for (double f : {100.0, 1250.0, 1590.0, 50000.0}) EXPECT_NEAR(force(law, 0.32 + law.penetration(f)), f, 1e-9 * f);
}

TEST(EndStop, RefusesNonsense) {
  EXPECT_THROW(EndStop{EndStopParameters{}}, InputError);
  expect_refused<EndStop, EndStopParameters>(both(), {{"largest_stroke", [](auto& p) { p.largest_stroke = -0.1; }},
                                                      {"dissipation", [](auto& p) { p.dissipation = -1.0; }},
                                                      {"stiffness", [](auto& p) { p.stiffness = 0.0; }}});
}

JointFrictionParameters friction() {
  JointFrictionParameters p;
  p.coulomb = 2.0;
  p.breakaway = 3.0;
  p.stribeck_speed = 0.1;
  p.viscous = 0.5;
  p.stick_displacement = 1e-3;
  return p;
}

Eigen::Vector2d state(double z, double mode) { return {z, mode}; }

TEST(JointFriction, SlidesAtItsStribeckCurve) {
  const JointFriction law(friction());
  for (const double v : {0.02, 0.1, 0.5, -0.3}) {
    const double g = 2.0 + std::exp(-v * v / 0.01), s = v > 0.0 ? 1.0 : -1.0;
    EXPECT_NEAR(force(law, 0.0, v, 0.0, state(0.0, s)), s * g + 0.5 * v, 1e-12) << v;  // whatever the bristle does
  }
}

TEST(JointFriction, WithoutAStribeckSpeedSlidesAtCoulombAtOnce) {
  JointFrictionParameters p = friction();
  p.stribeck_speed.reset();
  const JointFriction law(p);
  for (const double v : {1e-9, 0.5}) EXPECT_NEAR(force(law, 0.0, v, 0.0, state(0.0, 1.0)), 2.0 + 0.5 * v, 1e-12);
}

TEST(JointFriction, IsASpringWhileItSticks) {
  const JointFriction law(friction());
  EXPECT_DOUBLE_EQ(force(law, 0.0, 0.0, 0.0, state(5e-4, 0.0)), 1.0);
  StrutOutput out(2);
  law.evaluate({0.0, 0.01, 0.0, state(5e-4, 0.0)}, out);
  EXPECT_DOUBLE_EQ(out.dz[0], 0.01);  // nothing slides
}

// Under a load that is there at once the bristle of a mass that is 16 times as large as expected takes it up without overshoot:
// stick is k z + d v with d >= 2 sqrt(16 k m).
TEST(JointFriction, IsDampedBeyondOvershoot) {
  JointFrictionParameters p = friction();
  p.mass = 3.0;
  StrutOutput out(2);
  JointFriction(p).evaluate({0.0, 0.0, 0.0, state(0.0, 0.0)}, out);
  const double k = out.dforce_dz[0], d = out.dforce_drate - p.viscous;
  EXPECT_DOUBLE_EQ(k, p.coulomb / p.stick_displacement);
  EXPECT_GE(d, 2.0 * std::sqrt(16.0 * k * p.mass) * (1.0 - 1e-12));
}

// Slip begins at the breakaway force, ends where the trial force of stick falls below the force of sliding, and turns at once where
// the other direction is beyond its limit.
TEST(JointFriction, ChangesItsModeWhereItNoLongerFits) {
  const JointFriction law(friction());
  const double z_b = 3.0 / 2000.0, z_s = 3.0 / 2000.0;  // F_b / k; at rest g = F_b
  struct Case {
    double z, v, mode, next;
  };
  for (const Case& c : {Case{0.999 * z_b, 0.0, 0.0, 0.0}, Case{1.001 * z_b, 0.0, 0.0, 1.0},
                        Case{-1.001 * z_b, 0.0, 0.0, -1.0}, Case{1.001 * z_s, 0.0, 1.0, 1.0},
                        Case{0.99 * z_s, 0.0, 1.0, 0.0}, Case{0.0, 0.5, 0.0, 1.0}, Case{1e-3, -0.5, 1.0, -1.0}}) {
    Eigen::VectorXd z = state(c.z, c.mode);
    const StrutInput in{0.0, c.v, 0.0, z};
    const bool fits = law.switch_value(in) >= 0.0;
    EXPECT_EQ(fits, c.mode == c.next) << c.z << " " << c.v << " " << c.mode;
    Eigen::VectorXd after = z;
    if (!fits) law.switch_state(in, after);
    EXPECT_EQ(after[1], c.next) << c.z << " " << c.v << " " << c.mode;
    EXPECT_EQ(after[0], c.z);
  }
}

TEST(JointFriction, HasTheDerivativesOfItsForceAndRates) {
  const JointFriction law(friction());
  for (const double mode : {-1.0, 0.0, 1.0})
    for (const double z : {-1.2e-3, -3e-4, 9e-4, 2e-3})
      for (const double v : {-0.5, -0.08, 0.02, 0.7}) expect_derivatives(law, 0.0, v, 0.0, state(z, mode), 1e-3, 0.1);
}

TEST(JointFriction, StoresOrDissipatesWhatItTakes) {
  const JointFriction law(friction());
  for (const double z : {-1.4e-3, -3e-4, 2e-4, 9e-4, 1.4e-3}) {
    for (const double v : {-1e-4, 1e-4, 2e-3}) expect_power_identity(law, 0.0, v, 0.0, state(z, 0.0));
    for (const double v : {0.02, 0.7}) {
      expect_power_identity(law, 0.0, v, 0.0, state(z, 1.0));
      expect_power_identity(law, 0.0, -v, 0.0, state(z, -1.0));
    }
  }
}

TEST(JointFriction, RefusesABreakawayBelowCoulomb) {
  JointFrictionParameters p = friction();
  p.breakaway = 1.0;
  EXPECT_TRUE(test::names(test::error_of([&] { JointFriction law(p); }), {"breakaway"}));
}

// The brake: it holds, slides, lets go, and keeps its account.

Brake brake() {
  BrakeParameters p;
  p.command = polynomial({0.5});
  p.largest_force = 10.0;
  p.lag = 0.01;
  return Brake(p);
}

TEST(Brake, SlidesAtItsForceTimesItsPressure) {
  const Brake law = brake();
  StrutOutput out(2);
  // A bristle bent by F_c / k = 1e-5 m is all that sliding leaves.
  const Eigen::Vector2d z(0.5, 1e-5);
  law.evaluate({0.0, 3.0, 0.0, z, 0.0}, out);
  EXPECT_NEAR(out.force, 0.5 * 10.0, 1e-9);
  EXPECT_NEAR(out.dz[0], 0.0, 1e-12);
  EXPECT_NEAR(out.dz[1], 0.0, 1e-9);
}

TEST(Brake, IsPressedByItsCommandAndASignalWithinItsLimits) {
  const Brake law = brake();
  StrutOutput out(2);
  const Eigen::Vector2d z(0.25, 0.0);
  const auto rate_of_pressure = [&](double command) {
    StrutInput in{0.0, 0.0, 0.0, z, 0.0};
    in.command = command;
    law.evaluate(in, out);
    return out.dz[0];
  };
  EXPECT_NEAR(rate_of_pressure(0.0), (0.5 - 0.25) / 0.01, 1e-12);
  EXPECT_NEAR(rate_of_pressure(9.0), (1.0 - 0.25) / 0.01, 1e-12);
  EXPECT_NEAR(rate_of_pressure(-9.0), -0.25 / 0.01, 1e-12);
}

TEST(Brake, LetsItsBristleGo) {
  const Brake law = brake();
  StrutOutput out(2);
  const Eigen::Vector2d z(0.3, 5e-6);
  StrutInput in{0.0, 0.0, 0.0, z, 0.0};
  in.command = -1.0;
  law.evaluate(in, out);
  EXPECT_NEAR(out.dz[1], -5e-6 / 0.01, 1e-12);
  EXPECT_NEAR(out.ddz_dz(1, 1), -1.0 / 0.01, 1e-9);
}

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
  EXPECT_TRUE(test::names(test::error_of([&] { Motor law(p); }), {"max_torque"}));
}

TableLawParameters example() {
  TableLawParameters p;
  p.stroke = {0.0, 0.1, 0.3};
  p.rate = {-1.0, -0.1, 0.0, 0.1, 2.0};
  p.force.resize(3, 5);
  p.force << -900, -400, 0, 600, 2000,  //
      -500, 0, 400, 1000, 2400,         //
      600, 1100, 1500, 2100, 3000;
  return p;
}

TEST(TableLaw, IsExactAtItsEntriesAndLinearBetween) {
  const TableLaw law(example());
  const TableLawParameters p = example();
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 5; ++j)
      EXPECT_NEAR(force(law, p.stroke[static_cast<std::size_t>(i)], p.rate[static_cast<std::size_t>(j)]), p.force(i, j),
                  1e-9);
  EXPECT_NEAR(force(law, 0.05, 0.05), 0.25 * (0 + 600 + 400 + 1000), 1e-9);
}

TEST(TableLaw, ContinuesItsElasticPartLinearlyAndHoldsTheRest) {
  const TableLaw law(example());
  EXPECT_NEAR(force(law, 0.4, 0.0), 1500.0 + 0.1 * 5500.0, 1e-9);
  EXPECT_NEAR(force(law, 0.4, 0.1), 1500.0 + 0.1 * 5500.0 + 600.0, 1e-9);
  EXPECT_NEAR(force(law, 0.1, 9.0), 2400.0, 1e-9);
  EXPECT_NEAR(force(law, -0.1, -5.0), -400.0 - 900.0, 1e-9);
}

TEST(TableLaw, DissipatesWhatItTakesAlsoOutsideTheTable) {
  const TableLaw law(example());
  for (unsigned seed : {1u}) {
    const Motion motion = random_motion(seed, 0.15, 0.4);
    const Along run = drive(law, motion, 0.0, 1.0, 50000, 0.0, law_checks::kNoState);
    // Kinks of the force at the table's lines: second-order jumps in each of the few hundred crossings.
    EXPECT_NEAR(run.work, run.dissipated + run.stored - run.stored_start, 1e-8 * run.dissipated);
  }
}

TEST(TableLaw, DerivativesAreThoseOfTheForce) {
  const TableLaw law(example());
  for (double x : {-0.2, 0.03, 0.22, 0.5})
    for (double v : {-4.0, -0.4, -0.03, 0.06, 1.0, 5.0}) {
      expect_derivatives(law, x, v, 0.0, law_checks::kNoState, 0.01, 0.01);
      expect_power_identity(law, x, v, 0.0, law_checks::kNoState);
    }
}

class TableLawFile : public ::testing::Test, protected TemporaryFolder {};

TEST_F(TableLawFile, IsRead) {
  const std::string path = write("table.csv",
                                 "# a passive strut\n"
                                 "stroke, -1.0, -0.1, 0, +0.1, 2.0\n"
                                 "0.00, -900, -400, 0, 600, 2000\n"
                                 "\n"
                                 "0.10, -500, 0, 400, 1000, 24e2  # a comment\n"
                                 "0.30, 600, 1100, 1500, 2100, 3000\r\n");
  const TableLawParameters p = read_table_law(path), expected = example();
  EXPECT_EQ(p.stroke, expected.stroke);
  EXPECT_EQ(p.rate, expected.rate);
  EXPECT_EQ(p.force, expected.force);
  EXPECT_EQ(p.lines, (std::vector<int>{3, 5, 6}));
}

TEST_F(TableLawFile, IsNamedWithTheLineThatIsWrong) {
  const std::string head = "stroke, -1, 0, 1\n";
  const std::pair<std::string, const char*> wrong[] = {{head + "0, -1, 0, x\n", ":2:"},
                                                       {head + "0, -1, 0\n", ":2:"},
                                                       {head + "0, -1, 0, nan\n", ":2:"},
                                                       {head + "0, -1, 0, 1\n0, -1, 0, 1\n", ":3:"},
                                                       {head + "0, -1, 0, 1\n# end\n0.1, -1, 0, -5\n", ":4:"},
                                                       {head + "0, 7, 0, 1\n0.1, -1, 0, 5\n", ":2:"},
                                                       {head + "0, -1, 0, 1\n", ""},
                                                       {"stroke, 1, 2\n0, 1, 2\n1, 1, 2\n", ""},
                                                       {"stroke, 0, 2, 1\n0, 1, 2, 3\n1, 1, 2, 3\n", ""},
                                                       {"stroke, 1\n", ":1:"}};
  for (const auto& row : wrong) {
    const std::string path = write("table.csv", row.first);
    EXPECT_TRUE(test::names(test::error_of([&] { TableLaw{read_table_law(path)}; }), {"table.csv", row.second}))
        << row.first;
  }
  EXPECT_THROW(read_table_law("no_such_file.csv"), InputError);
}

// mbd_solver/model/laws/curves.h

CubicSpline spline_of_cosine(int pieces) {
  std::vector<double> x, y;
  for (int i = 0; i <= pieces; ++i) {
    x.push_back(0.3 + 2.0 * kPi * i / pieces);
    y.push_back(i == pieces ? y.front() : std::cos(x.back()));
  }
  return CubicSpline("cosine", x, y, CubicSpline::Ends::kClosed);
}

double largest_error(const CubicSpline& spline) {
  double worst = 0.0;
  for (double x = -20.0; x < 20.0; x += 0.0137) worst = std::max(worst, std::abs(spline.at(x).value - std::cos(x)));
  return worst;
}

TEST(CubicSpline, ThatIsClosedIsOfFourthOrderOverAllTurns) {
  const double coarse = largest_error(spline_of_cosine(20)), fine = largest_error(spline_of_cosine(40));
  EXPECT_LT(fine, 1e-5);
  EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.2);
}

TEST(CubicSpline, HasTheDerivativesOfItsValueAndGoesOnThroughTheSeam) {
  const CubicSpline closed = spline_of_cosine(12);
  const CubicSpline natural("n", {-1.0, 0.2, 0.5, 2.0}, {0.3, -1.0, 0.4, 0.1});
  const double h = 1e-5;
  for (const CubicSpline* spline : {&closed, &natural})
    for (double x = -3.01; x < 9.0; x += 0.0731) {
      const CubicSpline::Value before = spline->at(x - h), at = spline->at(x), after = spline->at(x + h);
      EXPECT_NEAR((after.value - before.value) / (2.0 * h), at.slope, 1e-8) << x;
      EXPECT_NEAR((after.slope - before.slope) / (2.0 * h), at.curvature, 2e-4) << x;
      if (before.third == after.third) {
        EXPECT_NEAR((after.curvature - before.curvature) / (2.0 * h), at.third, 1e-5) << x;
      }
    }
  const CubicSpline::Value left = closed.at(0.3 - 1e-9), right = closed.at(0.3 + 1e-9);
  EXPECT_NEAR(left.slope, right.slope, 1e-8);
  EXPECT_NEAR(left.curvature, right.curvature, 1e-7);
}

TEST(CubicSpline, RefusesPlacesThatDoNotRise) {
  EXPECT_THROW(CubicSpline("c", {0.0, 1.0, 1.0}, {0.0, 1.0, 2.0}), InputError);
  EXPECT_THROW(CubicSpline("c", {0.0}, {0.0}), InputError);
}

TEST(MonotoneCurve, PassesThroughItsPointsAndNeverTurnsBetweenThem) {
  const std::vector<double> x{0.0, 0.1, 0.5, 0.55, 1.0}, y{0.0, 0.0, 10.0, 10.1, 10.1};
  const MonotoneCurve curve("test", x, y);
  for (std::size_t i = 0; i < x.size(); ++i) EXPECT_NEAR(curve.value(x[i]), y[i], 1e-14);
  for (int i = 0; i < 2000; ++i) EXPECT_LE(curve.value(i / 2000.0), curve.value((i + 1) / 2000.0) + 1e-14);
  EXPECT_EQ(curve.value(-1.0), 0.0);
  EXPECT_EQ(curve.value(2.0), 10.1);
}

TEST(MonotoneCurve, SlopeIsContinuousAndThatOfTheValue) {
  const MonotoneCurve curve("test", {0.0, 0.2, 0.5, 1.0}, {1.0, 2.0, 2.5, 7.0});
  for (double x : {0.05, 0.19, 0.3, 0.7, 0.99}) {
    const double h = 1e-6;  // the difference is exact to h^2
    EXPECT_NEAR(curve.slope(x), (curve.value(x + h) - curve.value(x - h)) / (2 * h), 1e-8);
  }
  for (double node : {0.2, 0.5}) EXPECT_NEAR(curve.slope(node - 1e-9), curve.slope(node + 1e-9), 1e-6);
  EXPECT_GT(curve.slope(0.0), 0.0);
  EXPECT_GT(curve.slope(1.0), 0.0);
}

TEST(MonotoneCurve, IsExactOnAStraightLine) {
  const MonotoneCurve curve("test", {0.0, 0.3, 1.0}, {2.0, 2.9, 5.0});
  for (double x : {0.1, 0.3, 0.77}) EXPECT_NEAR(curve.value(x), 2.0 + 3.0 * x, 1e-14);
}

TEST(MonotoneCurve, RefusesTablesThatDoNotRise) {
  EXPECT_THROW(MonotoneCurve("t", {0.0, 0.0}, {1.0, 2.0}), InputError);
  EXPECT_THROW(MonotoneCurve("t", {0.0}, {1.0}), InputError);
  EXPECT_THROW(MonotoneCurve("t", {0.0, 1.0}, {1.0}), InputError);
  EXPECT_THROW(MonotoneCurve("t", {0.0, 1.0}, {1.0, std::nan("")}), InputError);
}

}  // namespace
}  // namespace footfall
