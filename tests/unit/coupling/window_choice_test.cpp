// `every auto`: how many substeps a window takes.

#include "mbd_solver/coupling/window_choice.h"

#include <gtest/gtest.h>

#include <limits>

namespace footfall {
namespace {

constexpr double kSubstep = 1e-4;  // [s]

CouplingSpec spec() {
  CouplingSpec spec;
  spec.tolerance = 0.01;
  spec.max_substeps = 100;
  spec.warn_omega_h = 0.5;
  return spec;
}

// 10 kg on 1e5 N/m: omega = 100 1/s, so omega H = 0.5 is a window of 50 substeps.
WindowChoice::Body pressed(double gap) { return {10.0, 1e5, gap, 0.0, {0.0, 0.0, 100.0}}; }

TEST(WindowChoice, FliesInTheLongestWindowsAndLandsBeforeItsTime) {
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({{10.0, 0.0, 0.0, std::numeric_limits<double>::infinity()}});
  EXPECT_EQ(choice.substeps(), 100);
  choice.observe(100, {{10.0, 0.0, 0.0, 20.5 * kSubstep}});
  EXPECT_LE(choice.substeps(), 20);
  EXPECT_GE(choice.substeps(), 10);
}

// Grains may stand higher than was told, by `risen` of the time that the way to them takes: the window in which they are met is
// no longer than that.
TEST(WindowChoice, MeetsGrainsThatHaveRisenInAShortWindow) {
  const double risen = 3.0;  // substeps
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({{10.0, 0.0, 0.0, 200.0 * kSubstep}});
  double left = 200.0;
  for (int k = 0; k < 100 && left - choice.substeps() > risen; ++k) {
    left -= choice.substeps();
    choice.observe(choice.substeps(), {{10.0, 0.0, 0.0, left * kSubstep}});
  }
  EXPECT_LE(choice.substeps(), risen);
}

TEST(WindowChoice, AmongGrainsWithoutAFirstContactTakesSingleSubsteps) {
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({{10.0}});
  EXPECT_EQ(choice.substeps(), 1);
  choice.observe(1, {{10.0}});
  EXPECT_EQ(choice.substeps(), 1);
}

TEST(WindowChoice, NeverPassesTheLimitOfOmegaH) {
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({pressed(0.0)});
  for (int k = 0; k < 20; ++k) choice.observe(choice.substeps(), {pressed(0.0)});
  EXPECT_LE(choice.substeps(), 50);
  EXPECT_GE(choice.substeps(), 49);
}

TEST(WindowChoice, SettlesWhereTheEstimateMeetsTheTolerance) {
  // A gap of 1/2 a H^2 with a = F / m, and F the force scale: eta = (omega H)^2 / 2 = 0.9 tolerance at omega H = 0.134.
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({pressed(0.0)});
  for (int k = 0; k < 20; ++k) {
    const double H = choice.substeps() * kSubstep;
    choice.observe(choice.substeps(), {pressed(0.5 * 100.0 / 10.0 * H * H)});
  }
  EXPECT_GE(choice.substeps(), 12);
  EXPECT_LE(choice.substeps(), 13);
  EXPECT_LE(choice.estimate(), 0.01);
}

TEST(WindowChoice, ShrinksAtOnceAndGrowsByTwoAtMost) {
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({pressed(0.0)});
  choice.observe(40, {pressed(1e-4)});  // eta = 0.1
  EXPECT_EQ(choice.substeps(), 12);     // 40 sqrt(0.09)
  choice.observe(12, {pressed(0.0)});
  EXPECT_EQ(choice.substeps(), 24);
}

TEST(WindowChoice, TheStiffestBodyDecides) {
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({pressed(0.0), {10.0, 0.0, 0.0, 1.0}});
  WindowChoice::Body stiff = pressed(0.0);
  stiff.stiffness = 1e7;
  choice.observe(40, {pressed(0.0), stiff});
  EXPECT_EQ(choice.substeps(), 5);
}

// A body that sinks by 1 cm per window while its force rises by 1 N: K_s = 3 x 100 N/m, where the contacts have 1e5
// N/m.
WindowChoice::Body sinking(int window, double gap) {
  WindowChoice::Body body = pressed(gap);
  body.force.z() += window;
  body.place.z() -= 0.01 * window;
  return body;
}

TEST(WindowChoice, GrainsThatGiveWayAreSofterThanTheirContacts) {
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({pressed(0.0)});
  choice.observe(40, {sinking(0, 1e-4)});
  EXPECT_NEAR(choice.estimate(), 1e5 * 1e-4 / 100.0, 1e-12);
  choice.observe(40, {sinking(1, 1e-4)});
  EXPECT_NEAR(choice.estimate(), 300.0 * 1e-4 / 101.0, 1e-12);
  // A way shorter than the gap says nothing.
  WindowChoice::Body body = sinking(1, 1e-4);
  body.place.z() -= 5e-5;
  choice.observe(40, {body});
  EXPECT_NEAR(choice.estimate(), 1e5 * 1e-4 / 101.0, 1e-12);
}

TEST(WindowChoice, OnGrainsThatGiveWayOmegaHMayBeLargerWhileContactsStand) {
  CouplingSpec long_windows = spec();
  long_windows.max_substeps = 1000;
  WindowChoice choice(long_windows, kSubstep, 1.0);
  choice.start({pressed(0.0)});
  int k = 0;
  for (; k < 20; ++k) choice.observe(choice.substeps(), {sinking(k, 0.0)});
  EXPECT_GE(choice.substeps(), 119);  // omega H = 1.2
  EXPECT_LE(choice.substeps(), 120);
  WindowChoice::Body opening = sinking(k, 0.0);
  opening.stiffness = 5e4;
  choice.observe(choice.substeps(), {opening});
  EXPECT_LE(choice.substeps(), 52);  // omega H = 0.5 of the contacts that it had, less what is forgotten in one window
}

TEST(WindowChoice, BeforeItsFirstContactABodyTakesTheStiffnessThatOthersHaveMet) {
  WindowChoice choice(spec(), kSubstep, 1.0);
  choice.start({{10.0}, {10.0}});
  WindowChoice::Body stiff = pressed(0.0);
  stiff.stiffness = 1e7;
  for (int k = 0; k < 5; ++k) choice.observe(choice.substeps(), {stiff, {10.0}});
  EXPECT_EQ(choice.substeps(), 5);  // omega H = 0.5
}

}  // namespace
}  // namespace footfall
