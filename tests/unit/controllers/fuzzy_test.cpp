#include "mbd_solver/model/controllers/fuzzy.h"

#include <fl/Headers.h>
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/unit/controllers/fuzzy_files.h"

namespace footfall {
namespace {

TEST(Fuzzy, EqualsFuzzyLitesOwnEvaluationOfTheFile) {
  const std::unique_ptr<fl::Engine> engine(fl::FllImporter().fromFile(lander_file().string()));
  std::mt19937_64 generator(1);
  for (int n = 0; n < 1000; ++n) {
    const FuzzyInput x = random_input(lander(), generator);
    for (std::size_t i = 0; i < kFuzzyInputs; ++i) engine->setInputValue(kFuzzyInputNames[i], x[i]);
    engine->process();
    const Eigen::VectorXd u = voltages(lander(), x);
    for (int i = 0; i < 4; ++i) EXPECT_EQ(u[i], engine->getOutputValue("U" + std::to_string(i + 1)));
  }
}

TEST(Fuzzy, HasAllSeventyTwoRulesOnce) {
  std::istringstream text(lander_text());
  std::set<std::string> conditions;
  int rules = 0;
  for (std::string line; std::getline(text, line);) {
    const auto at = line.find("rule: if ");
    if (at == std::string::npos) continue;
    ++rules;
    conditions.insert(line.substr(at, line.find(" then ") - at));
  }
  EXPECT_EQ(rules, 72);
  EXPECT_EQ(conditions.size(), 72u);
}

TEST(Fuzzy, InputsSaturateAtTheirRanges) {
  for (std::size_t i = 0; i < kFuzzyInputs; ++i) {
    FuzzyInput x = {2.0, 1.0, 0.7, -1.1}, edge = x;
    x[i] = 1e6, edge[i] = lander().upper()[i];
    EXPECT_EQ(voltages(lander(), x), voltages(lander(), edge));
    x[i] = -1e6, edge[i] = lander().lower()[i];
    EXPECT_EQ(voltages(lander(), x), voltages(lander(), edge));
  }
}

TEST(Fuzzy, NoRuleGivesTheStatedVoltageNotNaN) {
  EXPECT_EQ(voltages(lander(), {std::nan(""), 0.0, 0.0, 0.0}), Eigen::Vector4d::Constant(kNoRuleVoltage));
  // A gap from -2.2 to -2.1 degrees that the check when loading cannot see, because these shapes have no
  // corners.
  const std::string gap = replaced(replaced(lander_text(), "term: N Ramp 0 -4", "term: N ZShape -3.2 -2.2"),
                                   "term: Z Triangle -4 0 4", "term: Z PiShape -2.1 -0.1 0.1 4");
  const TemporaryFll file(gap);
  const FuzzySystem system(file.path);
  EXPECT_EQ(voltages(system, {1.0, 0.0, -2.15, 0.0}), Eigen::Vector4d::Constant(kNoRuleVoltage));
  EXPECT_NE(voltages(system, {1.0, 0.0, -1.5, 0.0}), Eigen::Vector4d::Constant(kNoRuleVoltage));
}

TEST(Fuzzy, ZeroAttitudeGivesEqualVoltages) {
  for (double a : {0.0, 0.8, 2.1, 3.9, 5.0})
    for (double da : {-10.0, -2.0, 0.0, 3.0, 10.0}) {
      const Eigen::VectorXd u = voltages(lander(), {a, da, 0.0, 0.0});
      EXPECT_EQ(u, Eigen::VectorXd::Constant(4, u[0]));
    }
}

// Round-off: mirrored memberships such as (x + 4) / 4 and (4 - x) / 4 may differ in the last place.
TEST(Fuzzy, MirroredAttitudeGivesMirroredVoltages) {
  std::mt19937_64 generator(2);
  for (int n = 0; n < 300; ++n) {
    const FuzzyInput x = random_input(lander(), generator);
    const Eigen::VectorXd u = voltages(lander(), x);
    const auto mirrored = [&](double pitch_sign, double roll_sign) {
      return voltages(lander(), {x[0], x[1], pitch_sign * x[2], roll_sign * x[3]});
    };
    // 1 <-> 3, 2 <-> 4
    EXPECT_LT((mirrored(-1, -1) - Eigen::Vector4d(u[2], u[3], u[0], u[1])).cwiseAbs().maxCoeff(), 1e-12);
    // 1 <-> 2, 3 <-> 4
    EXPECT_LT((mirrored(-1, 1) - Eigen::Vector4d(u[1], u[0], u[3], u[2])).cwiseAbs().maxCoeff(), 1e-12);
    // 1 <-> 4, 2 <-> 3
    EXPECT_LT((mirrored(1, -1) - Eigen::Vector4d(u[3], u[2], u[1], u[0])).cwiseAbs().maxCoeff(), 1e-12);
  }
}

// Principle 1 on the surfaces of [Lin25 Figure 4]: over (a, da) at level attitude, and over (a, alpha)
// without jerk.
TEST(Fuzzy, VoltageFallsWithAccelerationOnTheSurfacesOfFigure4) {
  for (int j = 0; j <= 20; ++j)
    for (const FuzzyInput& held : {FuzzyInput{0.0, -10.0 + j, 0.0, 0.0}, FuzzyInput{0.0, 0.0, -4.0 + 0.4 * j, 0.0}}) {
      Eigen::VectorXd last = Eigen::VectorXd::Ones(4);
      for (int i = 0; i <= 100; ++i) {
        const Eigen::VectorXd u = voltages(lander(), {0.05 * i, held[1], held[2], held[3]});
        // A centroid of min/max inference may rise by the order of its sampling (1/140 of the range) on the
        // way down.
        EXPECT_LE((u - last).maxCoeff(), 0.01) << "a " << 0.05 * i << " da " << held[1] << " alpha " << held[2];
        last = u;
      }
      EXPECT_LE(last.maxCoeff(), voltages(lander(), held).minCoeff());
    }
}

TEST(Fuzzy, RisingAccelerationAsksForALargerReduction) {
  for (int i = 0; i <= 50; ++i) {
    double last = 1.0;
    for (int j = 0; j <= 20; ++j) {
      const double u = voltages(lander(), {0.1 * i, -10.0 + j, 0.0, 0.0})[0];
      EXPECT_LE(u, last + 1e-3) << "a " << 0.1 * i << " da " << -10.0 + j;
      last = u;
    }
    EXPECT_LT(last, voltages(lander(), {0.1 * i, -10.0, 0.0, 0.0})[0] - 0.1);
  }
}

TEST(Fuzzy, LegOnTheSideThatSinksGetsMoreForce) {
  for (double a : {0.0, 1.5, 3.0, 5.0})
    for (double da : {-8.0, 0.0, 5.0}) {
      const Eigen::VectorXd pitched = voltages(lander(), {a, da, 3.0, 0.0});  // +x sinks: legs 1 and 4
      EXPECT_GT(std::min(pitched[0], pitched[3]), std::max(pitched[1], pitched[2]) + 0.03);
      const Eigen::VectorXd rolled = voltages(lander(), {a, da, 0.0, 3.0});  // +y sinks: legs 1 and 2
      EXPECT_GT(std::min(rolled[0], rolled[1]), std::max(rolled[2], rolled[3]) + 0.03);
    }
}

std::array<Eigen::VectorXd, kFuzzyInputs> coarse_nodes() {
  return {Eigen::VectorXd::LinSpaced(5, -0.3, 5.2), Eigen::VectorXd::LinSpaced(4, -9.0, 10.0),
          Eigen::VectorXd::LinSpaced(4, -4.0, 3.1), Eigen::VectorXd::LinSpaced(3, -2.2, 4.0)};
}

// Round-off of the order of summation.
void expect_grid_equals_points(const FuzzySystem& system) {
  const auto nodes = coarse_nodes();
  const std::vector<double> grid = system.evaluate_on_grid(nodes);
  std::size_t at = 0;
  for (double a : nodes[0])
    for (double da : nodes[1])
      for (double alpha : nodes[2])
        for (double beta : nodes[3]) {
          const Eigen::VectorXd u = voltages(system, {a, da, alpha, beta});
          for (int i = 0; i < 4; ++i)
            ASSERT_NEAR(grid[at++], u[i], 1e-12) << "a " << a << " da " << da << " alpha " << alpha << " beta " << beta;
        }
  EXPECT_EQ(at, grid.size());
}

TEST(Fuzzy, GridEqualsPointByPointEvaluation) {
  expect_grid_equals_points(lander());
  // Weights and rules that leave inputs out are plain too; other operators are not, and take the general way.
  const TemporaryFll weighted(replaced(lander_text(), "U4 is SB\n", "U4 is SB with 0.3\n"));
  expect_grid_equals_points(FuzzySystem(weighted.path));
  const TemporaryFll any(
      replaced(lander_text(), "alpha is P and beta is P then U1 is M ", "alpha is any and beta is P then U1 is M "));
  expect_grid_equals_points(FuzzySystem(any.path));
  const TemporaryFll product(replaced(lander_text(), "conjunction: Minimum", "conjunction: AlgebraicProduct"));
  expect_grid_equals_points(FuzzySystem(product.path));
}

TEST(Fuzzy, BreakpointsAreTheCornersOfTheTerms) {
  const std::vector<double> a = lander().breakpoints(0), da = lander().breakpoints(1), alpha = lander().breakpoints(2);
  ASSERT_EQ(a.size(), 4u);
  EXPECT_NEAR(a[1], 5.0 / 3.0, 1e-4);
  EXPECT_EQ(da, (std::vector<double>{-10.0, 10.0}));
  EXPECT_EQ(alpha, (std::vector<double>{-4.0, 0.0, 4.0}));
}

}  // namespace
}  // namespace footfall
