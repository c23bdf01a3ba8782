// Cohesion and capillary bridges between grains and beams.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <sstream>

#include "liggghts_fix/link/codes.h"
#include "tests/coupled/coupled_run.h"
#include "tests/coupled/stl.h"

namespace footfall::test {
namespace cohesion {

// Cohesion through the mesh and the beam of a body: the force on one grain from which the body is drawn away follows the
// closed form, at every step.
//
// LIGGGHTS' wall is flat and of infinite mass. A grain of radius R, pressed in by d, feels Hertz' force less k A:
//   F = 4/3 E* sqrt(R) d^(3/2) - k A,      A = pi (R^2 - (R - d)^2) (sjkr, Johnson, Kendall and Roberts simplified) or 2 pi R d (sjkr2)
// For sjkr2 it pulls hardest, with F = -2/3 pi k R d, at d = (pi k sqrt(R) / E*)^2.

constexpr double kR = 0.02, kDensityOfCohesion = 1e5;          // [m], [J/m3]
constexpr double kE = 35e6 / (2.0 * (1.0 - 0.25 * 0.25));      // E* of two materials of coupled_run.h [Pa]
constexpr double kPressed = 2e-5, kSpeed = 0.1, kStep = 1e-6;  // at the start [m], [m/s], [s]
constexpr int kSteps = 300;

double closed_form(const std::string& model, double d) {
  if (d <= 0.0) return 0.0;
  const double area = model == "sjkr" ? M_PI * (kR * kR - (kR - d) * (kR - d)) : 2.0 * M_PI * kR * d;
  return 4.0 / 3.0 * kE * std::sqrt(kR) * std::pow(d, 1.5) - kDensityOfCohesion * area;
}

// Force along z on a grain that nobody moves, after every step; the body under it goes down.
std::vector<double> forces(const std::string& model, const std::string& touch) {
  const BeamRun folder("cohesion_" + model + "_" + touch);
  const std::string words = "model hertz tangential history cohesion " + model;
  std::string script = preamble("-0.3 0.3 -0.3 0.3 -0.3 0.3", {1.0, 0.3, 0.0});
  // That of coupled_run.h is too weak to tell.
  const std::string weak = "20000.000000", strong = "100000";
  for (std::size_t at; (at = script.find(weak)) != std::string::npos;) script.replace(at, weak.size(), strong);
  script += "timestep 1e-6\n";
  script += "pair_style gran " + words + "\npair_coeff * *\ncreate_atoms 1 single 0.013 0.0 " +
            std::to_string(kR - kPressed) + "\nset group all diameter 0.04 density 2600\n";
  const std::string end = "thermo 1000\n" + dump_command("grain.txt", 1, "fz") + "run " + std::to_string(kSteps) + "\n";
  Outcome outcome;
  if (touch == "beam") {
    script += "fix w all wall/gran/beam " + words + " type 2 body tine\nfix mbd all couple/mbd every 5\n" + end;
    outcome = folder.coupled(
        script, "end 3e-4\nbody tine\n" + chain({"-0.1 0 -0.01", "0.1 0 -0.01"}, 0.01) + "velocity 0 0 -0.1\n");
  } else {
    write_stl((folder.path() / "plate.stl").string(), box({0.2, 0.2, 0.02}, 1));
    script += "fix m all mesh/surface file plate.stl type 2 move 0 0 -0.01\nfix w all wall/gran " + words +
              " mesh n_meshes 1 meshes m\nfix mbd all couple/mbd every 5 mesh m plate\n" + end;
    folder.write("in.coupled", script);
    outcome = folder.RunFolder::coupled(1, "-in in.coupled -log log",
                                        "until 3e-4 body plate plate.stl 0 0 -0.01 prescribed 0 0 -0.1 0 0 0");
  }
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  std::vector<double> force;
  for (const auto& [step, rows] : folder.dump("grain.txt")) force.push_back(rows.at(0).at(1));
  return force;
}

class Cohesion : public testing::TestWithParam<std::tuple<std::string, std::string>> {};
INSTANTIATE_TEST_SUITE_P(OfAGrain, Cohesion,
                         testing::Combine(testing::Values("sjkr", "sjkr2"), testing::Values("mesh", "beam")));

TEST_P(Cohesion, PullsAsItsLawSaysUntilTheyPart) {
  const auto [model, touch] = GetParam();
  const std::vector<double> force = forces(model, touch);
  ASSERT_EQ(force.size(), static_cast<std::size_t>(kSteps) + 1);
  const double at = std::pow(M_PI * kDensityOfCohesion * std::sqrt(kR) / kE, 2),
               most = 2.0 / 3.0 * M_PI * kDensityOfCohesion * kR * at;
  double pull = 0.0, off = 0.0;
  for (std::size_t k = 0; k < force.size(); ++k) {
    const double d = kPressed - kSpeed * kStep * static_cast<double>(k);
    if (std::abs(d) < 1e-9) continue;  // where round-off says whether they touch
    off = std::max(off, std::abs(force[k] - closed_form(model, d)));
    pull = std::max(pull, -force[k]);
  }
  std::printf("%s through a %s: pulls with up to %.5g N, closed form of sjkr2 %.5g N; off by %.1e N\n", model.c_str(),
              touch.c_str(), pull, most, off);
  EXPECT_LT(off, 1e-8 * most + 1e-9 * closed_form(model, kPressed));  // round-off of positions of 0.02 m
  EXPECT_NEAR(pull, most, 2e-3 * most);  // sjkr differs by d / 2 R, and steps are a hundredth of that depth
  EXPECT_EQ(force.back(), 0.0);
}

// Liquid bridges to the mesh and the beam of a body. A bridge pulls at a distance: a body feels grains that it does not touch.
// One grain of radius R is drawn away from a body until the bridge breaks; force on it and impulse on the body against the
// closed forms of LIGGGHTS, here with a contact angle of 0. The bridge to a wall has the volume V of
// what is on one grain, and a wall counts as a grain of the same size (R* = R / 2). At the distance d:
//   easo (Soulie et al. 2006)        F = -pi gamma R (exp(A d / R + B) + C),  A, B, C of V / R^3, V half of the grain's liquid
//   washino (Rabinovich et al. 2005) F = -2 pi gamma R* (1 / (1 + d / 2 s) + sin^2 alpha),  s = d p / 2,  sin alpha of
//                                    sqrt(d p / R*),  p = sqrt(1 + 2 V / (pi R* d^2)) - 1,  V a twentieth of the grain's
// With viscosity mu, of easo, as far as d < R* (Nase et al.):  F = -6 pi mu R* v / 1.01, v the speed at which they part.
// Both break at d = V^(1/3). While they touch, easo pulls with F(0) besides Hertz' force. Washino's radius of a wall is 0
// there: LIGGGHTS' walls of any kind then pull with nothing.

namespace capillary {

constexpr double kR = 0.02, kTension = 0.073, kLiquid = 0.01;   // [m], [N/m], of the grain's volume
constexpr double kE = 35e6 / (2.0 * (1.0 - 0.25 * 0.25));       // E* of two materials of coupled_run.h [Pa]
constexpr double kPressed = 5e-5, kSpeed = 10.0, kStep = 1e-6;  // at the start [m], [m/s], [s]
constexpr double kLeastDistance = 1.01;                         // of R*: nearer, viscosity acts as there
constexpr int kSteps = 700, kEvery = 5;

double bridge_volume(const std::string& model) {
  const double on_grain = 4.0 / 3.0 * M_PI * kR * kR * kR * kLiquid;
  return model == "easo" ? 0.5 * on_grain : 0.05 * on_grain;
}

// On the grain, towards the body < 0; d < 0: pressed in.
double closed_form(const std::string& model, double d, double viscosity = 0.0) {
  const double V = bridge_volume(model), scaled = std::log(V / (kR * kR * kR));
  double force = d < 0.0 ? 4.0 / 3.0 * kE * std::sqrt(kR) * std::pow(-d, 1.5) : 0.0;
  if (d > std::cbrt(V)) return force;
  if (model == "easo") {
    const double A = -1.1 * std::exp(-0.53 * scaled), B = -0.0082 * scaled + 0.48, C = 0.0018 * scaled + 0.078;
    return force - M_PI * kTension * kR * (std::exp(A * std::max(d, 0.0) / kR + B) + C) -
           6.0 * M_PI * viscosity * 0.5 * kR * kSpeed / kLeastDistance;
  }
  if (d <= 0.0) return force;
  const double half = 0.5 * kR, p = std::sqrt(1.0 + 2.0 * V / (M_PI * half * d * d)) - 1.0, s = 0.5 * d * p;
  const double sine = std::sin(std::sqrt(d / half * p));
  return -2.0 * M_PI * half * kTension * (1.0 / (1.0 + d / (2.0 * s)) + sine * sine);
}

struct Drawn {
  std::vector<double> force;  // along z on the grain after every step [N]
  std::vector<double> load;   // along z on the body, mean of every window [N]
  bool warned = false;        // that liquid does not pull on what touches
  bool as_atom = false;       // warned that an atom's velocity is read for a wall's
};

Drawn drawn_away(const std::string& model, const std::string& touch, double viscosity = 0.0) {
  const BeamRun folder("capillary_" + model + "_" + touch + (viscosity > 0.0 ? "_viscous" : ""));
  const std::string words = "model hertz tangential history cohesion " + model + "/capillary/viscous";
  std::string script = preamble("-0.3 0.3 -0.3 0.3 -0.3 0.3", {1.0, 0.3, 0.0});
  const auto of_all = [&](const std::string& name, double value) {
    script += "fix c_" + name + " all property/global " + name + " scalar " + std::to_string(value) + "\n";
  };
  of_all("surfaceLiquidContentInitial", kLiquid);
  of_all("surfaceTension", kTension);
  of_all("fluidViscosity", viscosity);
  of_all("minSeparationDistanceRatio", kLeastDistance);
  of_all("maxSeparationDistanceRatio", 1.2);
  script += "fix c_angle all property/global contactAngle peratomtype 0 0\ntimestep 1e-6\n";
  script += "pair_style gran " + words + "\npair_coeff * *\ncreate_atoms 1 single 0.013 0.0 " +
            std::to_string(kR - kPressed) + "\nset group all diameter 0.04 density 2600\n";
  const std::string end = "thermo 1000\n" + dump_command("grain.txt", 1, "fz") + "run " + std::to_string(kSteps) + "\n";
  Outcome outcome;
  Drawn drawn;
  if (touch == "beam") {
    script += "fix w all wall/gran/beam " + words + " type 2 body tine\nfix mbd all couple/mbd every 5\n" + end;
    outcome = folder.coupled(
        script, "end 7e-4\nbody tine\n" + chain({"-0.1 0 -0.01", "0.1 0 -0.01"}, 0.01) + "velocity 0 0 -10\n");
  } else {
    write_stl((folder.path() / "plate.stl").string(), box({0.2, 0.2, 0.02}, 1));
    script += "fix m all mesh/surface file plate.stl type 2 move 0 0 -0.01\nfix w all wall/gran " + words +
              " mesh n_meshes 1 meshes m\nfix mbd all couple/mbd every 5 mesh m plate\n" + end;
    folder.write("in.coupled", script);
    outcome =
        folder.RunFolder::coupled(1, "-in in.coupled -log log",
                                  "until 7e-4 out loads.csv body plate plate.stl 0 0 -0.01 prescribed 0 0 -10 0 0 0");
  }
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  drawn.warned = outcome.text.find(code::kLiquidOnlyApart.number) != std::string::npos;
  drawn.as_atom = outcome.text.find(code::kLiquidWallVelocity.number) != std::string::npos;
  for (const auto& [step, rows] : folder.dump("grain.txt")) drawn.force.push_back(rows.at(0).at(1));
  drawn.load = Table(folder.path() / "loads.csv")["fz"];
  return drawn;
}

class Capillary : public testing::TestWithParam<std::tuple<std::string, std::string>> {};
INSTANTIATE_TEST_SUITE_P(OfAGrain, Capillary,
                         testing::Combine(testing::Values("easo", "washino"), testing::Values("mesh", "beam")));

TEST_P(Capillary, PullsAsItsLawSaysUntilItBreaks) {
  const auto [model, touch] = GetParam();
  const Drawn drawn = drawn_away(model, touch);
  ASSERT_EQ(drawn.force.size(), static_cast<std::size_t>(kSteps) + 1);
  EXPECT_EQ(drawn.warned, model == "washino");
  EXPECT_EQ(drawn.as_atom, model == "easo" && touch == "mesh");  // beams have a velocity of their own
  double off = 0.0, pull = 0.0;
  int apart = 0;
  for (std::size_t k = 0; k < drawn.force.size(); ++k) {
    const double d = kSpeed * kStep * static_cast<double>(k) - kPressed;
    if (std::abs(d) < 1e-9 || std::abs(d - std::cbrt(bridge_volume(model))) < 1e-9)
      continue;  // round-off decides there
    off = std::max(off, std::abs(drawn.force[k] - closed_form(model, d)));
    pull = std::max(pull, -drawn.force[k]);
    apart += d > 0.0 && drawn.force[k] < 0.0 ? 1 : 0;
  }
  std::printf("%s through a %s: pulls with up to %.5g N, apart in %d steps; off by %.1e N\n", model.c_str(),
              touch.c_str(), pull, apart, off);
  EXPECT_LT(off, 1e-9 * pull + 1e-9 * closed_form(model, -kPressed));
  EXPECT_GT(apart, 200);

  // The body feels the mean over its window, both ends by half, at a distance as well.
  ASSERT_EQ(drawn.load.size(), drawn.force.size() / kEvery);
  for (std::size_t window = 0; window < drawn.load.size(); ++window) {
    const std::vector<double>::const_iterator first =
        drawn.force.begin() + static_cast<std::ptrdiff_t>(window * kEvery);
    const double mean = (0.5 * *first + std::accumulate(first + 1, first + kEvery, 0.0) + 0.5 * first[kEvery]) / kEvery;
    EXPECT_NEAR(drawn.load[window], -mean, 1e-12 * closed_form(model, -kPressed)) << "window " << window;
  }
}

// LIGGGHTS' easo reads the velocity of a wall at the place of an atom's velocity (wall_as_atom.h).
TEST(Capillary, ViscousPullTakesTheVelocityOfTheBeam) {
  const double viscosity = 0.01;
  const Drawn drawn = drawn_away("easo", "beam", viscosity);
  ASSERT_EQ(drawn.force.size(), static_cast<std::size_t>(kSteps) + 1);
  for (std::size_t k = 0; k < drawn.force.size(); ++k) {
    const double d = kSpeed * kStep * static_cast<double>(k) - kPressed;
    if (std::abs(d) < 1e-9 || std::abs(d - std::cbrt(bridge_volume("easo"))) < 1e-9) continue;
    ASSERT_NEAR(drawn.force[k], closed_form("easo", d, viscosity), 1e-9 * closed_form("easo", -kPressed))
        << "d = " << d;
  }
}

}  // namespace capillary
}  // namespace cohesion
}  // namespace footfall::test
