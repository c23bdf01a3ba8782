#include "mbd_solver/model/laws/end_stop.h"

#include "coupler/base/errors.h"
#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;

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

// A mass between the stops, no other force: it must bounce slower after each impact and its kinetic energy
// must be what is left.
TEST(EndStop, MassLosesWhatTheStopDissipates) {
  const EndStop law(both());
  const double mass = 300.0;
  double x = 0.16, v = 1.0, lost = 0.0, last_speed = v;
  const double h = 2e-5;
  StrutOutput out(0);
  const auto acceleration = [&](double xx, double vv) {
    law.evaluate({xx, vv, 0.0, law_checks::kNoState}, out);
    return -out.force / mass;
  };
  int bounces = 0;
  bool inside = true;
  for (int i = 0; i < 100000; ++i) {  // 2 s, classical Runge-Kutta; lost power by Simpson's rule of the same stages
    const double k1x = v, k1v = acceleration(x, v), p1 = dissipated(law, {x, v, 0.0, law_checks::kNoState});
    const double x2 = x + h / 2 * k1x, v2 = v + h / 2 * k1v, k2v = acceleration(x2, v2),
                 p2 = dissipated(law, {x2, v2, 0.0, law_checks::kNoState});
    const double x3 = x + h / 2 * v2, v3 = v + h / 2 * k2v, k3v = acceleration(x3, v3),
                 p3 = dissipated(law, {x3, v3, 0.0, law_checks::kNoState});
    const double x4 = x + h * v3, v4 = v + h * k3v, k4v = acceleration(x4, v4),
                 p4 = dissipated(law, {x4, v4, 0.0, law_checks::kNoState});
    x += h / 6 * (k1x + 2 * v2 + 2 * v3 + v4);
    v += h / 6 * (k1v + 2 * k2v + 2 * k3v + k4v);
    lost += h / 6 * (p1 + 2 * p2 + 2 * p3 + p4);
    const bool now_inside = x > 0.0 && x < 0.32;
    if (now_inside && !inside) {
      ++bounces;
      EXPECT_LT(std::abs(v), last_speed);
      last_speed = std::abs(v);
    }
    inside = now_inside;
  }
  EXPECT_GE(bounces, 3);
  const double energy = 0.5 * mass * v * v + law.stored_energy({x, v, 0.0, law_checks::kNoState});
  EXPECT_NEAR(energy + lost, 0.5 * mass, 1e-6 * 0.5 * mass);
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
  for (unsigned seed : {1u, 2u, 3u}) {
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
  const auto message = [](const EndStopParameters& p) { return message_of<InputError>([&] { EndStop{p}; }); };
  expect_contains(message({}), "neither smallest_stroke nor largest_stroke");
  EndStopParameters p = both();
  p.largest_stroke = -0.1;
  expect_contains(message(p), "smallest_stroke 0 m is not below largest_stroke -0.1 m");
  p = both();
  p.dissipation = -1.0;
  expect_contains(message(p), "dissipation is -1 s/m");
  p = both();
  p.stiffness = 0.0;
  expect_contains(message(p), "stiffness is 0 N/m");
}

}  // namespace
}  // namespace footfall
