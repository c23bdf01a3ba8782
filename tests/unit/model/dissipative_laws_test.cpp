// Laws with a state or a yield force: MR damper and honeycomb.

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/laws/honeycomb.h"
#include "mbd_solver/model/laws/mr_damper.h"
#include "tests/unit/model/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;

MrGeometry geometry() {
  MrGeometry g;
  g.D1 = 0.040, g.d1 = 0.037, g.D2 = 0.015, g.D3 = 0.060, g.L1 = 0.20, g.L2 = 0.05, g.L3 = 0.40, g.L4 = 0.05,
  g.eta = 0.8;
  g.tau_y = {{0.0, 500.0}, {0.3, 12000.0}, {0.7, 30000.0}, {1.0, 36000.0}};
  return g;
}

TEST(MrDamper, ForceVelocityCurveIsYieldPlusViscous) {
  const MrDamper law({});
  for (double u : {0.0, 0.25, 1.0})
    for (double v : {-3.8, -0.02, 0.0, 0.01, 0.5, 3.8})
      EXPECT_NEAR(force(law, 0.1, v, u), u * 8278.72 * std::tanh(v / 0.02) + 3651.19 * v, 1e-9);
  // At landing speed the regularisation is invisible: the force agrees with Table 3 [Lin25].
  EXPECT_NEAR(force(law, 0.0, 3.8, 1.0), 8278.72 + 3651.19 * 3.8, 1e-9);
}

TEST(MrDamper, VoltageSaturates) {
  const MrDamper law({});
  EXPECT_EQ(force(law, 0.0, 1.0, 1.7), force(law, 0.0, 1.0, 1.0));
  EXPECT_EQ(force(law, 0.0, 1.0, -0.4), force(law, 0.0, 1.0, 0.0));
}

// Sine of amplitude A: the viscous loop is an ellipse of area pi c omega A^2. The yield loop tends to the
// rectangle 4 A F_y as v_s
// -> 0; its deficit, 4 times (two reversals, two sides) F_y v_s^2 / (A omega^2) * integral_0^inf (1 - tanh q)
// q dq = pi^2 / 24, has relative corrections of order (v_s / (A omega))^2 = 4e-4.
TEST(MrDamper, SineLoopHasTheAreaOfEllipseAndRectangle) {
  const double A = 0.1, omega = 10.0;
  const Motion motion{[&](double t) { return A * std::sin(omega * t); },
                      [&](double t) { return A * omega * std::cos(omega * t); }};
  const double period = 2.0 * kPi / omega;
  const MrDamper law({});
  const double ellipse = kPi * 3651.19 * omega * A * A;
  const Along viscous = drive(law, motion, 0.0, period, 4000, 0.0, law_checks::kNoState);
  EXPECT_NEAR(viscous.work, ellipse, 1e-8 * ellipse);
  const Along both = drive(law, motion, 0.0, period, 4000, 1.0, law_checks::kNoState);
  const double deficit = 4.0 * 8278.72 * 0.02 * 0.02 / (A * omega * omega) * kPi * kPi / 24.0;
  EXPECT_NEAR(both.work - viscous.work, 4.0 * A * 8278.72 - deficit, 0.01 * deficit);
}

TEST(MrDamper, DissipatesWhatItTakesAndNeverGivesBack) {
  for (double lag : {0.0, 0.004}) {
    MrDamperParameters p;
    p.coil_lag = lag;
    const MrDamper law(p);
    for (unsigned seed : {1u, 2u}) {
      for (double u : {0.3, 1.0}) {
        double last = 0.0;
        const Along run = drive(law, random_motion(seed, 0.1, 0.1), 0.0, 1.0, 10000, u, law.initial_state(),
                                [&](double, const Eigen::VectorXd&, double work) {
                                  EXPECT_GE(work, last);  // power in is never negative
                                  last = work;
                                });
        EXPECT_NEAR(run.work, run.dissipated, 1e-8 * run.work) << "seed " << seed << " U " << u;
      }
    }
  }
}

TEST(MrDamper, DerivativesAreThoseOfTheForce) {
  MrDamperParameters lagged = mr_damper_from_geometry(geometry());
  lagged.coil_lag = 0.002;
  MrDamperParameters linear;
  linear.coil_lag = 0.002;
  for (const MrDamperParameters& p : {MrDamperParameters{}, linear, lagged}) {
    const MrDamper law(p);
    for (double v : {-2.0, -0.03, -0.001, 0.002, 0.015, 1.0})
      for (double u : {0.05, 0.31, 0.65, 0.95}) {
        const Eigen::VectorXd z = Eigen::VectorXd::Constant(law.state_count(), u);
        expect_derivatives(law, 0.1, v, 0.8, z, 0.1, 0.01);
        expect_power_identity(law, 0.1, v, 0.8, z);
      }
  }
}

TEST(MrDamper, CoilLagIsFirstOrder) {
  MrDamperParameters p;
  p.coil_lag = 0.002;
  p.initial_voltage = 0.1;
  const MrDamper law(p);
  const Motion rest{[](double) { return 0.0; }, [](double) { return 0.0; }};
  // Step from 0.1 to 0.9: U(t) = 0.9 - 0.8 exp(-t / tau). Runge-Kutta with h = tau / 200 is exact to 1e-11.
  drive(law, rest, 0.0, 0.01, 1000, 0.9, law.initial_state(),
        [](double t, const Eigen::VectorXd& z, double) { EXPECT_NEAR(z[0], 0.9 - 0.8 * std::exp(-t / 0.002), 1e-9); });
}

TEST(MrDamper, GeometryGivesEquations14And15) {
  const MrGeometry g = geometry();
  const MrDamperParameters p = mr_damper_from_geometry(g);
  const MrDamper law(p);
  EXPECT_NEAR(law.yield_force(1.0), 3.0 * kPi * 0.20 * 36000.0 * (0.040 + 0.037) / 2.0, 1e-9);
  EXPECT_NEAR(law.yield_force(0.3), 3.0 * kPi * 0.20 * 12000.0 * (0.040 + 0.037) / 2.0, 1e-9);
  EXPECT_NEAR(law.yield_force(0.0), 3.0 * kPi * 0.20 * 500.0 * (0.040 + 0.037) / 2.0, 1e-9);
  const double gap = 0.0015;
  const double c = (12.0 * 0.8 * 0.20 / (gap * gap) +
                    32.0 * 0.8 * (0.05 / (0.015 * 0.015) + 0.40 / (0.060 * 0.060) + 0.05 / (0.015 * 0.015))) *
                   kPi * 0.060 * 0.060 / 4.0;
  EXPECT_NEAR(p.viscous_coefficient, c, 1e-9 * c);
}

TEST(MrDamper, RefusesNonsense) {
  using P = MrDamperParameters;
  expect_refused<MrDamper, P>({}, {{"yield_table",
                                    [](P& p) {
                                      p.yield_table = {{0.0, 0.0}, {0.5, 5000.0}, {1.0, 4000.0}};
                                    }},
                                   {"0.5",
                                    [](P& p) {
                                      p.yield_table = {{0.0, 0.0}, {0.5, 3000.0}, {0.5, 4000.0}, {1.0, 5000.0}};
                                    }},
                                   {"0.9",
                                    [](P& p) {
                                      p.yield_table = {{0.0, 0.0}, {0.9, 5000.0}};
                                    }},
                                   {"",
                                    [](P& p) {
                                      p.yield_table = {{0.0, -10.0}, {1.0, 5000.0}};
                                    }},
                                   {"viscous_coefficient", [](P& p) { p.viscous_coefficient = -1.0; }},
                                   {"regularisation_speed", [](P& p) { p.regularisation_speed = 0.0; }},
                                   {"initial_voltage", [](P& p) { p.initial_voltage = 2.0; }}});
  MrGeometry g = geometry();
  g.d1 = 0.05;
  EXPECT_THROW(mr_damper_from_geometry(g), InputError);
  g = geometry();
  g.tau_y[2][1] = 100.0;
  EXPECT_THROW(mr_damper_from_geometry(g), InputError);
  g = geometry();
  g.tau_y.clear();
  EXPECT_TRUE(test::names(test::error_of([&] { mr_damper_from_geometry(g); }), {"tau_y"}));
}

// Monotone motion at constant rate from x0 to x1.
Motion ramp(double x0, double rate) {
  return {[=](double t) { return x0 + rate * t; }, [=](double) { return rate; }};
}
Along crush(const Honeycomb& law, double x0, double x1, const Eigen::VectorXd& z, double speed = 1.0) {
  const double rate = x1 > x0 ? speed : -speed, time = std::abs(x1 - x0) / speed;
  // Steps of 5 um: 1/12 of the 60 um (0.05 F1 / k_e and more) over which the crush rate responds.
  const int steps = std::max(1, static_cast<int>(std::ceil(std::abs(x1 - x0) / 5e-6)));
  return drive(law, ramp(x0, rate), 0.0, time, steps, 0.0, z);
}
double force_at(const Honeycomb& law, double x, const Eigen::VectorXd& z) { return force(law, x, 0.0, 0.0, z); }

TEST(Honeycomb, PlateausAreTheStagesCrushForces) {
  const Honeycomb law({});
  const Eigen::VectorXd z0 = law.initial_state();
  // In the middle of each stage, far from the transitions; f is drawn to P exponentially, so only integration
  // error is left.
  const Along first = crush(law, 0.0, 0.05, z0);
  EXPECT_NEAR(force_at(law, 0.05, first.z), 3000.0, 1e-3);
  const Along second = crush(law, 0.05, 0.14, first.z);
  EXPECT_NEAR(force_at(law, 0.14, second.z), 6000.0, 1e-3);
  const Along pulled = crush(law, 0.0, -0.05, z0);
  EXPECT_NEAR(force_at(law, -0.05, pulled.z), -3000.0, 1e-3);
  EXPECT_EQ(pulled.z[0], 0.0);
  EXPECT_NEAR(pulled.z[1], 0.05, 1e-3);
}

// Work to crush all = sum of F_i L_i, plus what the elastic spring holds: the smooth transitions change
// nothing.
TEST(Honeycomb, DissipatesCrushForceTimesCrushLength) {
  const Honeycomb law({});
  const double x_end = 0.1794;  // short of the bottom-out
  const Along run = crush(law, 0.0, x_end, law.initial_state());
  const double crushed = run.z[0];
  const double expected = 3000.0 * 0.10 + 6000.0 * (crushed - 0.10);
  // Onset at 95 % of P and the lag of f behind a rising P cost 0.05 F / k_e of crush each: below 1e-3 of the
  // energy.
  EXPECT_NEAR(run.dissipated, expected, 1e-3 * expected);
  EXPECT_NEAR(run.work, run.dissipated + run.stored - run.stored_start, 1e-8 * run.work);
}

TEST(Honeycomb, CrushDoesNotDependOnSpeed) {
  const Honeycomb law({});
  const Along slow = crush(law, 0.0, 0.12, law.initial_state(), 0.01),
              fast = crush(law, 0.0, 0.12, law.initial_state(), 5.0);
  EXPECT_NEAR(slow.z[0], fast.z[0], 1e-12);
  EXPECT_NEAR(slow.work, fast.work, 1e-9 * slow.work);
}

TEST(Honeycomb, UnloadsElasticallyAndReloadsToThePointReached) {
  const Honeycomb law({});
  const Along loaded = crush(law, 0.0, 0.06, law.initial_state());
  const double f = force_at(law, 0.06, loaded.z);
  const Along unloaded = crush(law, 0.06, 0.05, loaded.z);
  EXPECT_EQ(unloaded.z[0], loaded.z[0]);  // no crush on the way back
  // and all the elastic energy comes back, no more
  EXPECT_NEAR(-unloaded.work, loaded.stored, 1e-6 * loaded.stored);
  EXPECT_EQ(force_at(law, 0.05, unloaded.z), 0.0);  // free play
  const Along reloaded = crush(law, 0.05, 0.06, unloaded.z);
  // Crushing sets in again at 95 % of the crush force: at the point reached before, the force is between that
  // and P, and the cycle has cost less than 0.05 F / k_e = 30 um of crush.
  EXPECT_GT(force_at(law, 0.06, reloaded.z), 0.95 * f);
  EXPECT_GE(reloaded.z[0], loaded.z[0]);
  EXPECT_LT(reloaded.z[0] - loaded.z[0], 0.05 * 3000.0 / 5e6);
  const Along onward = crush(law, 0.06, 0.07, reloaded.z);
  EXPECT_NEAR(force_at(law, 0.07, onward.z), f, 1e-6 * f);
}

TEST(Honeycomb, LoadingHistoryIsRightUnderReversal) {
  const Honeycomb law({});
  Along run = crush(law, 0.0, 0.04, law.initial_state());
  run = crush(law, 0.04, -0.03, run.z);
  EXPECT_NEAR(run.z[0], 0.04 - 3000.0 / 5e6, 1e-4);
  EXPECT_NEAR(run.z[1], 0.03 - 3000.0 / 5e6, 1e-4);
  EXPECT_NEAR(force_at(law, -0.03, run.z), -3000.0, 1.0);
  EXPECT_EQ(force_at(law, 0.0, run.z), 0.0);  // loose between the two points reached
  const Eigen::VectorXd before = run.z;
  run = crush(law, -0.03, 0.03, run.z);
  EXPECT_EQ(run.z, before);  // within the free play nothing happens
  run = crush(law, 0.03, 0.07, run.z);
  EXPECT_NEAR(run.z[0], 0.07 - 3000.0 / 5e6, 1e-4);
}

TEST(Honeycomb, BottomsOutWithItsStatedSlope) {
  const Honeycomb law({});
  const Along run = crush(law, 0.0, 0.19, law.initial_state());
  const Along more = crush(law, 0.19, 0.191, run.z);
  const double slope = (force_at(law, 0.191, more.z) - force_at(law, 0.19, run.z)) / 0.001;
  // A moving P is followed at a small constant distance (quadratic S: f/P = const), which shifts the slope by
  // less than 1 %.
  EXPECT_NEAR(slope, 2.5e6, 0.01 * 2.5e6);
  EXPECT_GT(force_at(law, 0.191, more.z), 6000.0 + 0.8 * 2.5e6 * 0.005);
}

TEST(Honeycomb, NeverGivesBackMoreThanItsElasticEnergyAndCrushNeverShrinks) {
  const Honeycomb law({});
  for (unsigned seed : {4u}) {
    const Motion motion = random_motion(seed, 0.02, 0.2);
    // 150 000 steps of at most 20 um: a third of the crush rate's response length
    const double t0 = 0.0, t1 = 0.6;
    Eigen::VectorXd last = law.initial_state();
    double most_work = 0.0, stored_then = 0.0;
    const double start = law.stored_energy({motion.stroke(t0), 0.0, 0.0, last});
    const Along run =
        drive(law, motion, t0, t1, 150000, 0.0, last, [&](double t, const Eigen::VectorXd& z, double work) {
          ASSERT_GE(z[0], last[0]);
          ASSERT_GE(z[1], last[1]);
          last = z;
          const double stored = law.stored_energy({motion.stroke(t), 0.0, 0.0, z});
          if (work > most_work) most_work = work, stored_then = stored;
          // What has come back since the largest work taken is at most what was elastic then (1e-6:
          // integration).
          ASSERT_LE(most_work - work, stored_then + start + 1e-6 * (1.0 + most_work));
        });
    // 1e-5: every passage of toe, onset and reversal is a kink that lowers the order of Runge-Kutta for one
    // step.
    EXPECT_NEAR(run.work, run.dissipated + run.stored - run.stored_start, 1e-5 * (run.work + run.stored_start))
        << "seed " << seed;
    EXPECT_GT(run.z.sum(), 0.01) << "seed " << seed << " does not crush, the test says nothing";
  }
}

TEST(Honeycomb, DerivativesAreThoseOfForceAndCrushRate) {
  const Honeycomb law({});
  // Penetrations from free play over toe and elastic branch into crushing, at crushes within stages, in
  // transitions, past the end.
  for (double c : {0.0, 0.05, 0.099, 0.101, 0.15, 0.182, 0.2})
    for (double d : {-0.01, 0.00004, 0.0003, 0.000623, 0.00064, 0.00066, 0.00121, 0.00124, 0.00127})
      for (double v : {-1.3, 0.4}) {
        Eigen::VectorXd z(2);
        z << c, 0.03;
        expect_derivatives(law, c + d, v, 0.0, z, 1e-2, 1.0);
        expect_power_identity(law, c + d, v, 0.0, z);
        z << 0.03, c;
        expect_derivatives(law, -c - d, v, 0.0, z, 1e-2, 1.0);
        expect_power_identity(law, -c - d, v, 0.0, z);
      }
}

TEST(Honeycomb, OneCartridgeAloneLeavesTheOtherSideLoose) {
  HoneycombParameters p;
  p.tension.reset();
  const Honeycomb law(p);
  EXPECT_EQ(law.state_count(), 1);
  EXPECT_EQ(force_at(law, -0.1, law.initial_state()), 0.0);
  EXPECT_GT(force_at(law, 0.01, law.initial_state()), 0.0);
}

TEST(Honeycomb, ReportsCrushPerStage) {
  const Honeycomb law({});
  Eigen::VectorXd z(2);
  z << 0.13, 0.2;
  const std::vector<Honeycomb::Report> reports = law.report(z);
  ASSERT_EQ(reports.size(), 2u);
  EXPECT_FALSE(reports[0].tension);
  EXPECT_NEAR(reports[0].stage_crush[0], 0.10, 1e-15);
  EXPECT_NEAR(reports[0].stage_crush[1], 0.03, 1e-15);
  EXPECT_EQ(reports[0].bottom_out, 0.0);
  EXPECT_TRUE(reports[1].tension);
  EXPECT_NEAR(reports[1].stage_crush[1], 0.08, 1e-15);
  EXPECT_NEAR(reports[1].bottom_out, 0.02, 1e-15);
}

TEST(Honeycomb, RefusesNonsense) {
  using P = HoneycombParameters;
  expect_refused<Honeycomb, P>({}, {{"compression",
                                     [](P& p) {
                                       p.compression->stages = {{6000.0, 0.1}, {3000.0, 0.1}};
                                     }},
                                    {"tension", [](P& p) { p.tension->stages.clear(); }},
                                    {"crush_length", [](P& p) { p.tension->stages[1].crush_length = 0.0; }},
                                    {"bottom_out", [](P& p) { p.compression->bottom_out_stiffness = 6e6; }},
                                    {"", [](P& p) { p.compression->transition_length = 0.2; }},
                                    {"honeycomb", [](P& p) { p.compression.reset(), p.tension.reset(); }}});
}

}  // namespace
}  // namespace footfall
