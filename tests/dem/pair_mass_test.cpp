// A grain strikes a light free body: restitution against that of two bodies.

#include <gtest/gtest.h>

#include <cmath>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

constexpr double kRestitution = 0.4;  // of soil on steel in script_head
constexpr double kSpeed = 0.2;        // of the grain [m/s]

double grain_mass() { return 2600.0 * 4.0 / 3.0 * M_PI * std::pow(0.02, 3); }

// Of a Hertz contact whose damping takes `larger` times the effective mass: beta grows by the root,
//   beta = ln e / sqrt(ln^2 e + pi^2),   e = exp(pi beta / sqrt(1 - beta^2)).
double restitution(double larger) {
  const double log_e = std::log(kRestitution);
  const double beta = log_e / std::sqrt(log_e * log_e + M_PI * M_PI) * std::sqrt(larger);
  return std::exp(M_PI * beta / std::sqrt(1.0 - beta * beta));
}

// The grain flies up against a plate of `masses` grains, in windows of one step. Relative speed after over before.
double found(const std::string& name, double masses, const std::string& words) {
  const RunFolder folder("pair_mass_" + name + "_" + std::to_string(static_cast<int>(masses)));
  write_stl((folder.path() / "body.stl").string(), box({0.1, 0.1, 0.05}, 1));
  const double dt = 5e-6, gap = 1e-5;
  const int steps = 2600;  // the contact lasts 8 ms
  std::ostringstream in;
  in.precision(17);
  in << script_head("-0.2 0.2 -0.2 0.2 -0.2 0.2", "* * *", dt) << "create_atoms 1 single 0.011 -0.007 " << -0.02 - gap
     << " units box\nset group all diameter 0.04 density 2600\nvelocity all set 0 0 " << kSpeed
     << "\nfix integr all nve/sphere\nfix geo all couple/mbd/geometry body pad\nfix m all mesh/surface fix geo type 2\n"
     << "fix wm all wall/gran model hertz tangential history mesh n_meshes 1 meshes m\n"
     << "fix mbd all couple/mbd every 1 " << words << " mesh m pad\n"
     << dump_every(steps, "grains") << "thermo 1000\nrun " << steps << "\n";
  folder.write("in", in.str());
  std::ostringstream partner;
  partner.precision(17);
  partner << "until " << steps * dt << " out table.csv body pad body.stl 0 0 0.025 free " << masses * grain_mass()
          << " 0 0 0 0 0 0 0";
  const Outcome outcome = folder.coupled(1, "-in in", partner.str());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  const Table table(folder.path() / "table.csv");
  EXPECT_EQ(table["contacts"].back(), 0.0) << "the contact goes on";
  const double grain = read_dump(folder.read("grains." + std::to_string(steps))).at(0)[6];
  return (table["vz"].back() - grain) / kSpeed;
}

class Masses : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(OfTheBody, Masses, testing::Values(1.0, 2.0, 5.0, 10.0));

// LIGGGHTS' damping gives the restitution of the script within 3e-3 (docs/wall_tests.md, test 3); the windows of one
// step are of the same order.
constexpr double kSteps = 5e-3;

TEST_P(Masses, OfThePairGiveTheRestitutionOfTheScript) {
  const double e = found("pair", GetParam(), "damping_mass pair");
  std::printf("body of %g grains: restitution %.4f, given %.4f\n", GetParam(), e, kRestitution);
  EXPECT_NEAR(e, kRestitution, kSteps);
}

TEST_P(Masses, OfTheGrainAloneDampAsStockDoes) {
  const double larger = 1.0 + 1.0 / GetParam();
  const double e = found("grain", GetParam(), "");
  std::printf("body of %g grains: restitution %.4f, by closed form %.4f\n", GetParam(), e, restitution(larger));
  EXPECT_NEAR(e, restitution(larger), kSteps);
}

}  // namespace
}  // namespace footfall::test
