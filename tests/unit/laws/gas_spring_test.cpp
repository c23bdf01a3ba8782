#include "mbd_solver/model/laws/gas_spring.h"

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

using namespace law_checks;

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
  const std::string text = message_of<NumericalError>([&] { force(law, 0.36); });
  expect_contains(text, "0.36 m");
  expect_contains(text, "0.347704 m");
  EXPECT_THROW(force(law, law.stroke_limit()), NumericalError);
  EXPECT_THROW(force(law, std::nan("")), NumericalError);
  EXPECT_THROW(law.stored_energy({0.36, 0.0, 0.0, law_checks::kNoState}), NumericalError);
}

TEST(GasSpring, RefusesNonsense) {
  GasSpringParameters p;
  p.initial_volume = -1.0;
  expect_contains(message_of<InputError>([&] { GasSpring{p}; }),
                  "gas_spring: initial_volume is -1 m3; expected a number above 0");
  p = {};
  p.exponent = 0.9;
  expect_contains(message_of<InputError>([&] { GasSpring{p}; }), "exponent is 0.9; expected a number from 1 to 2");
  p = {};
  p.piston_diameter = std::nan("");
  EXPECT_THROW(GasSpring{p}, InputError);
  p = {};
  p.largest_stroke = 0.36;
  expect_contains(message_of<InputError>([&] { GasSpring{p}; }), "a stroke of 0.36 m uses up the gas volume");
  p.largest_stroke = 0.32;
  EXPECT_NO_THROW(GasSpring{p});
}

}  // namespace
}  // namespace footfall
