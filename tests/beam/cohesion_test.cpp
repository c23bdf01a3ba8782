// Cohesion through the mesh and the beam of a body: the force on one grain from which the body is drawn away is that of the
// closed form, at every step.
//
// LIGGGHTS' wall is flat and of infinite mass. A grain of radius R, pressed in by d, feels Hertz' force less k A:
//   F = 4/3 E* sqrt(R) d^(3/2) - k A,      A = pi (R^2 - (R - d)^2) (sjkr, Johnson, Kendall and Roberts simplified) or 2 pi R d (sjkr2)
// For sjkr2 it pulls hardest, with F = -2/3 pi k R d, at d = (pi k sqrt(R) / E*)^2.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/beam/beam_run.h"
#include "tests/dem/stl.h"

namespace footfall::test {
namespace {

constexpr double kR = 0.02, kDensityOfCohesion = 1e5;          // [m], [J/m3]
constexpr double kE = 35e6 / (2.0 * (1.0 - 0.25 * 0.25));      // E* of two materials of beam_run.h [Pa]
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
  // That of beam_run.h is too weak to tell.
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

}  // namespace
}  // namespace footfall::test
