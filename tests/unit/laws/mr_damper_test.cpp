#include "mbd_solver/model/laws/mr_damper.h"

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/model/laws/mr_geometry.h"
#include "tests/unit/laws/law_checks.h"

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
  // At landing speed the regularisation is invisible: the force is that of Table 3 [Lin25].
  EXPECT_NEAR(force(law, 0.0, 3.8, 1.0), 8278.72 + 3651.19 * 3.8, 1e-9);
}

TEST(MrDamper, VoltageSaturates) {
  const MrDamper law({});
  EXPECT_EQ(force(law, 0.0, 1.0, 1.7), force(law, 0.0, 1.0, 1.0));
  EXPECT_EQ(force(law, 0.0, 1.0, -0.4), force(law, 0.0, 1.0, 0.0));
}

// Saw-tooth of constant rate v0 between -A and A: the loop is a rectangle of area 4 A (U F_y tanh(v0/v_s) + c
// v0).
TEST(MrDamper, SawToothLoopHasTheAreaOfItsRectangle) {
  const MrDamper law({});
  const double A = 0.1, v0 = 0.7;
  for (double u : {0.0, 0.4, 1.0}) {
    const Motion up{[&](double t) { return -A + v0 * t; }, [&](double) { return v0; }};
    const Motion down{[&](double t) { return A - v0 * t; }, [&](double) { return -v0; }};
    const double T = 2.0 * A / v0;
    const Along first = drive(law, up, 0.0, T, 50, u, law_checks::kNoState),
                second = drive(law, down, 0.0, T, 50, u, law_checks::kNoState);
    const double area = 4.0 * A * (u * 8278.72 * std::tanh(v0 / 0.02) + 3651.19 * v0);
    EXPECT_NEAR(first.work + second.work, area, 1e-8 * area);
    EXPECT_NEAR(first.dissipated + second.dissipated, area, 1e-8 * area);
  }
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
    for (unsigned seed : {1u, 2u, 3u}) {
      for (double u : {0.0, 0.3, 1.0}) {
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

// A ramp sampled every T and held (first-order hold theory of sampled control): the staircase follows the
// ramp by T/2 in the mean, the coil adds tau. So the mean over one period of r(t) - U(t) tends to slope *
// (T/2 + tau).
TEST(MrDamper, SampledRampThroughTheCoilLagsByHalfAPeriodPlusTau) {
  MrDamperParameters p;
  p.coil_lag = 0.002;
  const MrDamper law(p);
  const double slope = 10.0;  // [1/s]: U reaches 0.9 in 0.09 s, 45 time constants
  const Motion rest{[](double) { return 0.0; }, [](double) { return 0.0; }};
  for (double T : {0.001, 0.002, 0.005}) {
    Eigen::VectorXd z = law.initial_state();
    const int samples = static_cast<int>(std::lround(0.08 / T)), steps = 200;
    double lag = 0.0;
    for (int k = 0; k < samples; ++k) {
      lag = 0.0;
      double before = slope * k * T - z[0];
      z = drive(law, rest, 0.0, T, steps, slope * k * T, z, [&](double t, const Eigen::VectorXd& at, double) {
            const double now = slope * (k * T + t) - at[0];
            lag += 0.5 * (before + now) / steps / slope;
            before = now;
          }).z;
    }
    EXPECT_NEAR(lag, T / 2.0 + 0.002, 1e-4 * T) << "period " << T;  // trapezoidal mean over 200 steps
  }
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

TEST(MrDamper, BothWaysOfGivingParametersAgree) {
  MrGeometry g = geometry();
  g.tau_y = {{0.0, 0.0}, {0.25, 9000.0}, {1.0, 36000.0}};  // proportional to U: the table is then U yield_force
  const MrDamperParameters from_geometry = mr_damper_from_geometry(g);
  MrDamperParameters direct;
  direct.yield_force = from_geometry.yield_force;
  direct.viscous_coefficient = from_geometry.viscous_coefficient;
  const MrDamper a(from_geometry), b(direct);
  for (double u : {0.0, 0.1, 0.5, 0.9, 1.0})
    for (double v : {-1.0, 0.01, 2.0})
      EXPECT_NEAR(force(a, 0.0, v, u), force(b, 0.0, v, u), 1e-9 * std::abs(force(b, 0.0, v, 1.0)));
}

TEST(MrDamper, YieldForceRisesWithVoltageBetweenTheTablesPoints) {
  const MrDamper law(mr_damper_from_geometry(geometry()));
  for (int i = 0; i < 1000; ++i) EXPECT_LE(law.yield_force(i / 1000.0), law.yield_force((i + 1) / 1000.0));
}

TEST(MrDamper, RefusesNonsense) {
  const auto message = [](const MrDamperParameters& p) { return message_of<InputError>([&] { MrDamper{p}; }); };
  MrDamperParameters p;
  p.yield_table = {{0.0, 0.0}, {0.5, 5000.0}, {1.0, 4000.0}};
  expect_contains(message(p), "yield_table falls from 5000 N at U = 0.5 to 4000 N at U = 1");
  p.yield_table = {{0.0, 0.0}, {0.5, 3000.0}, {0.5, 4000.0}, {1.0, 5000.0}};
  expect_contains(message(p), "abscissa 0.5 follows 0.5; expected strictly rising");
  p.yield_table = {{0.0, 0.0}, {0.9, 5000.0}};
  expect_contains(message(p), "covers U from 0 to 0.9; expected from 0 to 1");
  p.yield_table = {{0.0, -10.0}, {1.0, 5000.0}};
  EXPECT_THROW(MrDamper{p}, InputError);
  p = {};
  p.viscous_coefficient = -1.0;
  expect_contains(message(p), "viscous_coefficient is -1 N s/m");
  p = {};
  p.regularisation_speed = 0.0;
  expect_contains(message(p), "regularisation_speed is 0 m/s; expected a number above 0");
  p = {};
  p.initial_voltage = 2.0;
  expect_contains(message(p), "initial_voltage is 2; expected a number from 0 to 1");
  MrGeometry g = geometry();
  g.d1 = 0.05;
  expect_contains(message_of<InputError>([&] { mr_damper_from_geometry(g); }), "does not fit into the bypass cylinder");
  g = geometry();
  g.tau_y[2].stress = 100.0;
  expect_contains(message_of<InputError>([&] { mr_damper_from_geometry(g); }), "never falls with U");
  g = geometry();
  g.tau_y.clear();
  expect_contains(message_of<InputError>([&] { mr_damper_from_geometry(g); }), "tau_y is empty");
}

}  // namespace
}  // namespace footfall
