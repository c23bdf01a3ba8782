// What the grains lose the body gets: linear and angular momentum, window by window, in real LIGGGHTS.

#include <gtest/gtest.h>

#include "tests/dem/coupled_run.h"

namespace footfall::test {
namespace {

constexpr double kDt = 5e-5;
constexpr int kEvery = 10;
constexpr double kMass = 2600.0 * 4.0 / 3.0 * M_PI * 8e-6;  // of a grain of radius 2 cm [kg]

// rolling: words of the pair style and the wall, or none.
constexpr const char* kRolling[] = {"", " rolling_friction cdt", " rolling_friction epsd", " rolling_friction epsd2"};

// 100 grains without gravity and floor fly spinning at a plate; some touch it from the start.
std::string cloud(const std::string& processors, const std::string& rolling) {
  std::string s = script_head("-0.3 0.3 -0.3 0.3 -0.3 0.3", processors, kDt) +
                  "lattice sc 0.041\nregion grains block -0.1 0.1 -0.1 0.1 0.0 0.15 units box\ncreate_atoms 1 region "
                  "grains\n"
                  "set group all diameter 0.04 density 2600\nvelocity all set 0.3 -0.2 -1.5\n"
                  "displace_atoms all random 0.0004 0.0004 0.0004 15485863 units box\nfix integr all nve/sphere\n";
  s += "fix m6 all property/global coefficientRollingViscousDamping peratomtypepair 2 0.3 0.3 0.3 0.3\n";  // of epsd
  const std::string cdt = " rolling_friction cdt";
  return s.replace(s.find(cdt), cdt.size(), rolling);
}

struct Momentum {
  Eigen::Vector3d linear = Eigen::Vector3d::Zero();   // [N s]
  Eigen::Vector3d angular = Eigen::Vector3d::Zero();  // about the origin of W [N m s]
};

Momentum momentum(const RunFolder& folder, int step) {
  Momentum sum;
  for (const std::vector<double>& row : read_dump(folder.read("grains." + std::to_string(step)))) {
    const Eigen::Vector3d x(row[1], row[2], row[3]), v(row[4], row[5], row[6]), omega(row[7], row[8], row[9]);
    sum.linear += kMass * v;
    sum.angular += kMass * x.cross(v) + 0.4 * kMass * 4e-4 * omega;
  }
  return sum;
}

class OnRanks : public testing::TestWithParam<int> {};
class Rolling : public testing::TestWithParam<std::tuple<int, int>> {};  // ranks, number in kRolling
INSTANTIATE_TEST_SUITE_P(Models, Rolling, testing::Combine(testing::Values(1, 2), testing::Values(0, 1, 2, 3)));
INSTANTIATE_TEST_SUITE_P(Ranks, OnRanks, testing::Values(1, 2), testing::PrintToStringParamName());

Table fly(const RunFolder& folder, int ranks, const std::string& motion, const std::string& mesh_style, int steps,
          const std::string& rolling = kRolling[1]) {
  write_stl((folder.path() / "plate.stl").string(), box({0.4, 0.4, 0.02}, 2));
  folder.write("in", cloud(ranks == 1 ? "1 1 1" : "2 1 1", rolling) + "fix m all " + mesh_style +
                         " file plate.stl type 2 move 0 0 -0.0295\n"
                         "fix wm all wall/gran model hertz tangential history" +
                         rolling +
                         " mesh n_meshes 1 meshes m\n"
                         "fix mbd all couple/mbd every 10 mesh m plate\n" +
                         dump_every(kEvery, "grains") + "thermo 1000\nrun 105\nrun " + std::to_string(steps - 105) +
                         "\n");
  std::ostringstream partner;
  partner << "until " << steps * kDt << " out table.csv body plate plate.stl 0 0 -0.0295 prescribed " << motion;
  const Outcome outcome = folder.coupled(ranks, "-in in", partner.str());
  EXPECT_EQ(outcome.exit_code, 0) << outcome.text;
  return Table(folder.path() / "table.csv");
}

TEST_P(OnRanks, ImpulseOnTheGrainsIsTheImpulseOnAMovingPlateInEveryWindow) {
  const RunFolder folder("momentum_linear_" + std::to_string(GetParam()));
  const Table table = fly(folder, GetParam(), "0.1 0.2 0.3 0.5 -1.0 2.0", "mesh/surface", 400);
  ASSERT_EQ(table.rows(), 40U);
  double worst = 0.0;
  int loaded = 0;
  for (int k = 0; k < 40; ++k) {
    const auto row = static_cast<std::size_t>(k);
    const Eigen::Vector3d lost = momentum(folder, kEvery * k).linear - momentum(folder, kEvery * (k + 1)).linear;
    const Eigen::Vector3d impulse = kEvery * kDt * table.vector(row, "fx", "fy", "fz");
    EXPECT_LT((impulse - table.vector(row, "ix", "iy", "iz")).norm(), 1e-12 * impulse.norm() + 1e-300);
    // Round-off of the sums over 100 grains: 1e-15 of their momentum of 14 N s.
    EXPECT_LT((lost - impulse).norm(), 1e-10 * impulse.norm() + 1e-14) << "window " << k;
    if (impulse.norm() > 1e-3) {
      worst = std::max(worst, (lost - impulse).norm() / impulse.norm());
      ++loaded;
    }
  }
  std::printf("largest relative error of the impulse: %.2g in %d loaded windows\n", worst, loaded);
  EXPECT_GT(loaded, 10);
  EXPECT_GT(table["contacts"][0], 0.0);  // the first window starts in contact: its first half step counts
}

TEST_P(Rolling, AngularMomentumOfTheGrainsIsTheMomentOnAFixedPlateInEveryWindow) {
  // On a fixed plate the mean moment about Bo and the mean force give the angular impulse about any point
  // exactly. Rolling resistance is a couple: the plate feels it too.
  const auto [ranks, model] = GetParam();
  const RunFolder folder("momentum_angular_" + std::to_string(ranks) + "_" + std::to_string(model));
  const Table table = fly(folder, ranks, "0 0 0 0 0 0", "mesh/surface/stress", 400, kRolling[model]);
  int loaded = 0;
  double worst = 0.0;
  for (int k = 0; k < 40; ++k) {
    const auto row = static_cast<std::size_t>(k);
    const Eigen::Vector3d lost = momentum(folder, kEvery * k).angular - momentum(folder, kEvery * (k + 1)).angular;
    const Eigen::Vector3d r(0, 0, -0.0295);
    const Eigen::Vector3d F = table.vector(row, "fx", "fy", "fz"), T = table.vector(row, "mx", "my", "mz");
    const Eigen::Vector3d impulse = kEvery * kDt * (r.cross(F) + T);
    const double scale = kEvery * kDt * (0.1 * F.norm() + T.norm());  // single contacts nearly cancel in the sum
    EXPECT_LT((lost - impulse).norm(), 1e-10 * scale + 1e-15) << "window " << k;
    if (scale <= 1e-4) continue;
    worst = std::max(worst, (lost - impulse).norm() / scale);
    ++loaded;
  }
  std::printf("largest relative error of the angular impulse: %.2g in %d loaded windows\n", worst, loaded);
  EXPECT_GT(loaded, 10);
}

}  // namespace
}  // namespace footfall::test
