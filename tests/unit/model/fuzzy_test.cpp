// The fuzzy controller, its table and its files.
#include <fl/Headers.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/clock.h"
#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/control/fuzzy.h"
#include "mbd_solver/model/control/fuzzy_controller.h"
#include "mbd_solver/model/control/fuzzy_table.h"
#include "tests/support/refused.h"
#include "tests/unit/model/fuzzy_files.h"

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

// The four outputs of the file take nearly all of the time of an evaluation.
TEST(Fuzzy, ASignalOfOneOutputDoesNotComputeTheOthers) {
  const FuzzyFunction one(read_fll(lander_file()), 4, "U1");
  Eigen::Vector4d u(2.0, 1.0, 0.7, -1.1);
  const auto shortest = [](const auto& work) {
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 50; ++i) {
      const double begun = wall_clock();
      work();
      least = std::min(least, wall_clock() - begun);
    }
    return least;
  };
  const double of_one = shortest([&] {
    u[0] += 1e-6;  // the last value is known
    one.value(u);
  });
  EXPECT_LT(of_one, 0.6 * shortest([&] { voltages(lander(), {u[0], u[1], u[2], u[3]}); }));
}

TEST(Fuzzy, ACopyOfASignalHasAnEngineOfItsOwn) {
  const FuzzyFunction one(read_fll(lander_file()), 4, "U1"), two(one);
  std::mt19937_64 generator(5);
  for (int k = 0; k < 20; ++k) {
    const FuzzyInput x = random_input(lander(), generator), y = random_input(lander(), generator);
    const Eigen::Vector4d here(x[0], x[1], x[2], x[3]), there(y[0], y[1], y[2], y[3]);
    const double value = one.value(here);
    EXPECT_EQ(value, voltages(lander(), x)[0]);
    two.value(there);
    EXPECT_EQ(two.value(here), value);
    EXPECT_EQ(one.value(there), two.value(there));
  }
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
  const FuzzySystem system(read_fll(file.path));
  EXPECT_EQ(voltages(system, {1.0, 0.0, -2.15, 0.0}), Eigen::Vector4d::Constant(kNoRuleVoltage));
  EXPECT_NE(voltages(system, {1.0, 0.0, -1.5, 0.0}), Eigen::Vector4d::Constant(kNoRuleVoltage));
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
  expect_grid_equals_points(FuzzySystem(read_fll(weighted.path)));
  const TemporaryFll any(
      replaced(lander_text(), "alpha is P and beta is P then U1 is M ", "alpha is any and beta is P then U1 is M "));
  expect_grid_equals_points(FuzzySystem(read_fll(any.path)));
  const TemporaryFll product(replaced(lander_text(), "conjunction: Minimum", "conjunction: AlgebraicProduct"));
  expect_grid_equals_points(FuzzySystem(read_fll(product.path)));
}

TEST(Fuzzy, BreakpointsAreTheCornersOfTheTerms) {
  const std::vector<double> a = lander().breakpoints(0), da = lander().breakpoints(1), alpha = lander().breakpoints(2);
  ASSERT_EQ(a.size(), 4u);
  EXPECT_NEAR(a[1], 5.0 / 3.0, 1e-4);
  EXPECT_EQ(da, (std::vector<double>{-10.0, 10.0}));
  EXPECT_EQ(alpha, (std::vector<double>{-4.0, 0.0, 4.0}));
}

Eigen::VectorXd from_table(const FuzzyTable& of, const FuzzyInput& x) {
  Eigen::VectorXd u(of.output_count());
  of.evaluate(x, u);
  return u;
}

TEST(FuzzyTable, IsWithinAHundredthOfTheExactController) {
  EXPECT_LT(FuzzyTable(lander(), kDefaultFuzzyGrid).largest_difference(lander(), 2000), 0.01);
}

TEST(FuzzyTable, IsExactAtTheCornersOfTheTerms) {
  const FuzzyTable small(lander(), {13, 5, 9, 9});
  for (double a : lander().breakpoints(0))
    for (double da : lander().breakpoints(1))
      for (double alpha : lander().breakpoints(2))
        for (double beta : lander().breakpoints(3))
          EXPECT_LT((from_table(small, {a, da, alpha, beta}) - voltages(lander(), {a, da, alpha, beta}))
                        .cwiseAbs()
                        .maxCoeff(),
                    1e-12);
}

TEST(FuzzyTable, SaturatesAndNeverAnswersNaN) {
  const FuzzyTable small(lander(), {7, 5, 5, 5});
  EXPECT_EQ(from_table(small, {9.0, 90.0, -9.0, 9.0}), from_table(small, {5.0, 10.0, -4.0, 4.0}));
  EXPECT_EQ(from_table(small, {1.0, std::nan(""), 0.0, 0.0}), Eigen::Vector4d::Constant(kNoRuleVoltage));
  std::mt19937_64 generator(3);
  for (int n = 0; n < 1000; ++n) {
    const Eigen::VectorXd u = from_table(small, random_input(lander(), generator));
    EXPECT_TRUE((u.array() >= 0.0).all() && (u.array() <= 1.0).all());
  }
}

TEST(FuzzyTable, RefusesGridsThatMakeNoSense) {
  EXPECT_THROW(FuzzyTable(lander(), {3, 5, 5, 5}), InputError);  // four corners along a
  EXPECT_THROW(FuzzyTable(lander(), {7, 1, 5, 5}), InputError);
  EXPECT_THROW(FuzzyTable(lander(), {1000, 1000, 1000, 1000}), InputError);
}

ControllerMeasurement measurement(double acceleration, double pitch = 0.0, double roll = 0.0) {
  ControllerMeasurement m;
  m.acceleration = acceleration;
  m.pitch = pitch;
  m.roll = roll;
  return m;
}

FuzzyControllerParameters parameters() {
  FuzzyControllerParameters p;
  p.rules = read_fll(lander_file());
  return p;
}

TEST(FuzzyController, FeedsTheUnitsOfTheFile) {
  FuzzyControllerParameters p = parameters();
  p.filter_frequency = 0.0;  // no filter: the jerk is the plain difference
  FuzzyController controller(p);
  Eigen::VectorXd u(4);
  const double degree = kPi / 180.0;
  controller.sample(measurement(2.0 * 9.80665, 1.5 * degree, -0.5 * degree), u);
  EXPECT_LT((u - voltages(controller.system(), {2.0, 0.0, 1.5, -0.5})).cwiseAbs().maxCoeff(), 1e-12);
  // 0.04 g more after 1 ms: 4 g per 0.1 s.
  controller.sample(measurement(2.04 * 9.80665, 1.5 * degree, -0.5 * degree), u);
  EXPECT_LT((u - voltages(controller.system(), {2.04, 4.0, 1.5, -0.5})).cwiseAbs().maxCoeff(), 1e-9);
}

TEST(FuzzyController, FreeFallCountsAsNoAcceleration) {
  FuzzyController controller(parameters());
  Eigen::VectorXd u(4);
  controller.sample(measurement(-1.63), u);
  EXPECT_EQ(u, voltages(controller.system(), {0.0, 0.0, 0.0, 0.0}));
}

TEST(FuzzyController, ResumesToTheBit) {
  FuzzyController one(parameters()), two(parameters());
  Eigen::VectorXd u(4), v(4);
  for (int k = 0; k < 50; ++k) one.sample(measurement(30.0 * std::sin(0.05 * k), 0.02, -0.01), u);
  two.restore(one.memory());
  for (int k = 50; k < 80; ++k) {
    one.sample(measurement(30.0 * std::sin(0.05 * k), 0.02, -0.01), u);
    two.sample(measurement(30.0 * std::sin(0.05 * k), 0.02, -0.01), v);
    EXPECT_EQ(u, v);
  }
}

TEST(FuzzyController, TabulatedStaysCloseAndSaysHowClose) {
  FuzzyControllerParameters p = parameters();
  FuzzyController exact(p);
  EXPECT_FALSE(exact.table_difference());
  p.tabulated = true;
  p.grid = {25, 9, 17, 17};  // coarse: this test is about the statement
  FuzzyController tabulated(p);
  ASSERT_TRUE(tabulated.table_difference());
  const double stated = *tabulated.table_difference();
  EXPECT_GT(stated, 0.0);
  Eigen::VectorXd u(4), v(4);
  for (int k = 0; k < 200; ++k) {
    const ControllerMeasurement m = measurement(25.0 * (1.0 - std::cos(0.03 * k)), 0.03 * std::sin(0.1 * k), 0.02);
    exact.sample(m, u);
    tabulated.sample(m, v);
    // the stated value is the largest of a random sample, not a bound
    EXPECT_LE((u - v).cwiseAbs().maxCoeff(), 1.5 * stated);
  }
}

TEST(FuzzyController, RefusesNonsense) {
  FuzzyControllerParameters p = parameters();
  p.period = 0.0;
  EXPECT_THROW(FuzzyController{p}, InputError);
  EXPECT_THROW(read_fll("missing.fll"), InputError);
}

// Loads the lander's file with `what` replaced by `with`: the refusal names the file and the line of the change.
std::string refusal_of(const std::string& what, const std::string& with) {
  const TemporaryFll file(replaced(lander_text(), what, with));
  const std::string said = test::error_of([&] { FuzzySystem system(read_fll(file.path)); });
  EXPECT_TRUE(test::names(said, {file.path.string()}));
  return said;
}

TEST(FuzzyBadFile, IsNamedWithTheLineThatIsWrong) {
  const std::string rule = "  rule: if a is S and da is B and alpha is Z and beta is Z then", range = "  range: 0 5\n",
                    term = "  term: S Triangle 0 1.6667 3.3333\n", samples = "  defuzzifier: Centroid 140\n";
  const std::pair<std::string, std::string> changes[] = {
      {range, "  range 0 5\n"},
      {range, "  rnage: 0 5\n"},
      {range, "  range: 0 five\n"},
      {term, "  term: S Trinagle 0 1.6667 3.3333\n"},
      {term, "  term: Z Triangle 0 1.6667 3.3333\n"},
      {samples, "  defuzzifier: Centre 140\n"},
      {"Engine: lander\n", "name: lander\n"},
      {"InputVariable: a\n", "InputVariable: speed\n  range: 0 1\n  term: Z Ramp 0 1\nInputVariable: a\n"},
      {"InputVariable: beta\n", "InputVariable: alpha\n"},
      {rule, "  rule: if a is S and da is B and alpha is Z and beta is Q then"},
      {rule, "  rule: if a is S and da is B and gamma is Z and beta is Z then"},
      {rule, "  rule: if a is S and da is B and alpha is Z or then"},
      {rule, "  rule: a is S and da is B and alpha is Z and beta is Z then"},
      {range, "  range: 1 5\n"},
      {range, "  range: 0 -5\n"},
      {"  range: -10 10\n", "  range: -10 20\n"},
      {"  range: -4 4\n", "  range: 0 4\n"},
      {"  range: 0 1\n", "  range: 0 2\n"},
      {samples, "  defuzzifier: Centroid 0\n"},
      {samples, "  defuzzifier: Centroid -3\n"},
      {samples, "  defuzzifier: Centroid 100001\n"},
      {samples, "  defuzzifier: Centroid 28888888888888888888\n"},
      {samples, "  defuzzifier: Bisector -1\n"},
      {"  lock-previous: false\n", "  lock-previous: true\n"}};
  const std::string text = lander_text();
  for (const auto& [what, with] : changes) {
    const auto line = 1 + std::count(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(text.find(what)), '\n');
    EXPECT_TRUE(test::names(refusal_of(what, with), {".fll:" + std::to_string(line) + ": "})) << with;
  }
}

// Before, the mark that some editors write was part of the first key, which then was unknown.
TEST(FuzzyFile, MayBeginWithAByteOrderMark) {
  const TemporaryFll file("\xEF\xBB\xBF" + lander_text());
  EXPECT_EQ(test::refusal([&] { FuzzySystem system(read_fll(file.path)); }), "");
}

// Each line is compiled alone.
TEST(FuzzyBadFile, HasTwentyThousandLinesAtMost) {
  std::string many = "Engine: e\n";
  for (int k = 0; k < 20000; ++k) many += "\n";
  const TemporaryFll file(many);
  EXPECT_TRUE(test::names(test::error_of([&] { FuzzySystem(read_fll(file.path)); }), {".fll", "20000 lines", "E0437"}));
}

TEST(FuzzyBadFile, LeavesOutNoVariableAndNoRegion) {
  const TemporaryFll pitch(
      replaced(replaced(lander_text(), "InputVariable: alpha", "InputVariable: pitch"), "alpha is", "pitch is", true));
  EXPECT_TRUE(test::names(test::error_of([&] { FuzzySystem{read_fll(pitch.path)}; }), {"alpha", "a, da, pitch, beta"}));
  const TemporaryFll v2(
      replaced(replaced(lander_text(), "OutputVariable: U2", "OutputVariable: V2"), "U2 is", "V2 is", true));
  EXPECT_TRUE(test::names(test::error_of([&] { FuzzySystem{read_fll(v2.path)}; }), {"V2"}));
  refusal_of("  implication: Minimum\n", "  implication: none\n");
  EXPECT_TRUE(test::names(refusal_of("  rule: if a is B and da is B and alpha is P and beta is P then", "  #"),
                          {"a = 5, da = 10, alpha = 4, beta = 4"}));
  EXPECT_TRUE(test::names(refusal_of("  term: Z Triangle -4 0 4\n", "  term: Z Triangle 1 2 3\n"), {"alpha = 0"}));
  // A gap of a hundredth of a degree.
  EXPECT_TRUE(test::names(refusal_of("  term: N Ramp 0 -4\n  term: Z Triangle -4 0 4\n",
                                     "  term: N Ramp -1.01 -4\n  term: Z Triangle -1 0 4\n"),
                          {"alpha = -1.01"}));
  const TemporaryFll empty("Engine: nothing\n");
  EXPECT_THROW(FuzzySystem{read_fll(empty.path)}, InputError);
  EXPECT_THROW(FuzzySystem{read_fll("no_such_file.fll")}, InputError);
}

TEST(ControlSurface, IsTheControllerOverTwoInputs) {
  const ControlSurface s = control_surface(lander(), 2, "a", "alpha", 9, {0.0, 3.0, 0.0, 1.0});
  ASSERT_EQ(s.first.size(), 9);
  EXPECT_EQ(s.first[8], 5.0);
  EXPECT_EQ(s.second[0], -4.0);
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) EXPECT_EQ(s.voltage(i, j), voltages(lander(), {s.first[i], 3.0, s.second[j], 1.0})[2]);
}

TEST(ControlSurface, RefusesUnknownAxesAndOutputs) {
  EXPECT_THROW(control_surface(lander(), 0, "a", "speed"), InputError);
  EXPECT_THROW(control_surface(lander(), 0, "a", "a"), InputError);
  EXPECT_THROW(control_surface(lander(), 4, "a", "da"), InputError);
  EXPECT_THROW(control_surface(lander(), 0, "a", "da", 1), InputError);
}

}  // namespace
}  // namespace footfall
