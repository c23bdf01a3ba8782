// `digits fast` of fix couple/mbd: pair forces in single precision.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "coupler/codes.h"
#include "tests/coupled/coupled_run.h"

namespace footfall::test {
namespace {

// A small plate far above the grains, so that the script is coupled.
std::string coupled_plate(const RunFolder& folder, const std::string& digits) {
  write_stl((folder.path() / "plate.stl").string(), box(Eigen::Vector3d(0.05, 0.05, 0.02), 1));
  return "fix m all mesh/surface file plate.stl type 2 move 0 0 0.5\n" + mesh_wall() +
         "fix mbd all couple/mbd every 5 " + digits + " mesh m plate\n";
}

constexpr const char* kPlateAtRest = " body plate plate.stl 0 0 0.5 prescribed 0 0 0 0 0 0";

// All grains of the last step of a run with these digits; the script writes it.
Rows grains_of(const RunFolder& folder, int ranks, const std::string& head, const std::string& digits, int steps) {
  const std::string name = digits.empty() ? "stock" : "fast";
  folder.write("in." + name, head + coupled_plate(folder, digits) + dump_every(steps, name) + "run 1000000\n");
  std::ostringstream partner;
  partner << "until " << 5e-5 * steps << kPlateAtRest;
  const Outcome outcome = folder.coupled(ranks, "-in in." + name + " -log log." + name, partner.str());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  return read_dump(folder.read(name + "." + std::to_string(steps)));
}

// Two grains of different size and type that meet off centre, with spin, far from walls: columns of dump_every.
std::string collision() {
  return script_head("-0.3 0.3 -0.3 0.3 -0.05 0.6", "1 1 1") +
         "create_atoms 1 single -0.0201 0 0.2 units box\ncreate_atoms 2 single 0.0301 0.008 0.205 units box\n"
         "set atom 1 diameter 0.04 density 2600\nset atom 2 diameter 0.06 density 2600\n"
         "set atom 1 vx 0.8 vy -0.1 omegaz 20\nset atom 2 vx -0.4 vz 0.2 omegay -15\nfix integr all nve/sphere\n";
}
constexpr std::array<double, 2> kRadius = {0.02, 0.03};
double mass(int grain) { return 2600.0 * 4.0 / 3.0 * M_PI * std::pow(kRadius[grain], 3); }
enum Column { kX = 1, kV = 4, kOmega = 7 };

Eigen::Vector3d part(const std::vector<double>& grain, int column) {
  return {grain[column], grain[column + 1], grain[column + 2]};
}

struct Balance {
  Eigen::Vector3d momentum = Eigen::Vector3d::Zero(), spin = Eigen::Vector3d::Zero();  // [kg m/s], [kg m2/s]
  double energy = 0.0;                                                                 // kinetic [J]
};
Balance balance_of(const Rows& grains) {
  Balance sum;
  for (int i = 0; i < 2; ++i) {
    const double m = mass(i), inertia = 0.4 * m * kRadius[i] * kRadius[i];
    const Eigen::Vector3d v = part(grains[i], kV), w = part(grains[i], kOmega);
    sum.momentum += m * v;
    sum.spin += m * part(grains[i], kX).cross(v) + inertia * w;
    sum.energy += 0.5 * m * v.squaredNorm() + 0.5 * inertia * w.squaredNorm();
  }
  return sum;
}

// A whole collision: momentum as before to the rounding of single precision, and velocities as in stock digits to 1e-6 of
// the speed of impact (forces err by 1e-7, in some hundred steps at random).
TEST(FastDigits, ACollisionConservesMomentumAndIsThatOfStockDigits) {
  const RunFolder folder("fast_collision");
  const Rows stock = grains_of(folder, 1, collision(), "", 400),
             fast = grains_of(folder, 1, collision(), "digits fast", 400);
  ASSERT_EQ(stock.size(), 2U);
  ASSERT_EQ(fast.size(), 2U);
  constexpr double kSpeed = 1.2, kSmall = 1e-6;  // [m/s], relative
  double difference = 0.0;
  for (int i = 0; i < 2; ++i) {
    EXPECT_LT((part(fast[i], kV) - part(stock[i], kV)).norm(), kSmall * kSpeed);
    EXPECT_LT((part(fast[i], kOmega) - part(stock[i], kOmega)).norm() * kRadius[i], kSmall * kSpeed);
    EXPECT_LT((part(fast[i], kX) - part(stock[i], kX)).norm(), kSmall * kRadius[i]);
    difference += (part(fast[i], kV) - part(stock[i], kV)).norm();
  }
  EXPECT_GT(difference, 0.0) << "fast digits were not used";
  const Rows start = read_dump(folder.read("fast.0"));
  const Balance before = balance_of(start), after = balance_of(fast), expected = balance_of(stock);
  const double scale = mass(0) * kSpeed;
  EXPECT_LT((after.momentum - before.momentum).norm(), kSmall * scale);
  EXPECT_LT((after.spin - expected.spin).norm(), kSmall * scale * kRadius[1]);
  EXPECT_NEAR(after.energy, expected.energy, kSmall * before.energy);
  EXPECT_LT(after.energy, 0.9 * before.energy) << "the grains have not met";
}

// A bed on one and two ranks: as in stock digits to the rounding of single precision over 400 steps,
// before chaos multiplies it.
TEST(FastDigits, ABedIsThatOfStockDigitsBeforeChaosSetsIn) {
  for (const int ranks : {1, 2}) {
    SCOPED_TRACE(ranks);
    const RunFolder folder("fast_bed_" + std::to_string(ranks));
    const std::string head = small_bed(ranks == 1 ? "1 1 1" : "2 1 1") + "velocity all set 0.3 0 -2\n";
    const Rows stock = grains_of(folder, ranks, head, "", 400),
               fast = grains_of(folder, ranks, head, "digits fast", 400);
    ASSERT_EQ(stock.size(), fast.size());
    double difference = 0.0;
    for (std::size_t i = 0; i < stock.size(); ++i)
      difference = std::max(difference, (part(fast[i], kV) - part(stock[i], kV)).norm());
    std::printf("largest difference of velocity after 400 steps: %.2g m/s\n", difference);
    EXPECT_GT(difference, 0.0);
    EXPECT_LT(difference, 2e-5);  // of 2 m/s
  }
}

TEST(FastDigits, UnknownModelsAreRefused) {
  for (const std::string model : {"hertz tangential history rolling_friction epsd2", "hertz tangential off",
                                  "hertz tangential history cohesion sjkr2"}) {
    SCOPED_TRACE(model);
    const RunFolder folder("fast_refused");
    std::string script = small_bed("1 1 1");
    const std::string usual = "pair_style gran model hertz tangential history rolling_friction cdt";
    script.replace(
        script.find(usual), usual.size(),
        "fix m6 all property/global cohesionEnergyDensity peratomtypepair 2 0 0 0 0\npair_style gran model " + model);
    folder.write("in", script + coupled_plate(folder, "digits fast") + "run 10\n");
    const Outcome outcome = folder.coupled(1, "-in in -log log", std::string("until 0.001") + kPlateAtRest);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.text;
    EXPECT_NE(outcome.text.find(std::string(code::kFastDigitsUnsupported.number)), std::string::npos) << outcome.text;
  }
}

}  // namespace
}  // namespace footfall::test
