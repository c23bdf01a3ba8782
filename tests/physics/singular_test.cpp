// Redundant conditions and singular positions.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "coupler/base/errors.h"
#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"
#include "tests/validation/random_mechanism.h"

namespace footfall {
namespace singular {

// Mechanisms with more conditions than they need: energy, reactions and results do not depend on which conditions are
// redundant, on how a joint is written, or on the rows of output.

class Redundant : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, Redundant, ::testing::Values("one_step", "ida"));

// Largest error of the energy with rows every `interval` [s, J].
double worst_energy(const Model& model, const std::string& kind, double rtol, double interval, double t_end) {
  IntegratorOptions options;
  options.rtol = rtol;
  options.atol = 0.1 * rtol;
  options.atol_velocity = 10.0 * rtol;
  test::Run run(model, kind, options);
  double worst = 0.0;
  const int rows = static_cast<int>(std::lround(t_end / interval));
  for (int i = 1; i <= rows; ++i) {
    run.to(i * interval);
    worst = std::max(worst, std::abs(run.imbalance()));
  }
  return worst;
}

TEST_P(Redundant, BennettsMechanismKeepsMovingWithItsEnergy) {
  // Three of its 20 conditions are redundant in every position, and no 17 of them are independent in all positions.
  // It holds some 10 J; the step size decides the error at this tolerance.
  EXPECT_LT(worst_energy(test::bennett(), GetParam(), 1e-6, 0.01, 5.0), 1e-2);
}

TEST(RedundantRows, BricardsMechanismKeepsItsEnergyInEveryFormOfItsJoints) {
  // Axes of the hinges turned about themselves, bodies of the joints exchanged, rods thin and thick: before all
  // conditions were kept, three of sixty such forms lost 0.01 to 0.1 J or stopped.
  for (const unsigned seed : {38u, 46u, 57u}) {
    test::Random random(seed);
    const double diameter = std::pow(10.0, random.number(-3.0, -0.5));
    const Model model = test::bricard(
        diameter, [&] { return random.number(0.0, 6.28); }, [&] { return random.number() < 0.0; });
    EXPECT_LT(worst_energy(model, "one_step", 1e-6, 0.01, 10.0), 3e-3) << "seed " << seed;
  }
}

TEST_P(Redundant, FourBarsPassSingularPositionsAtEveryIntervalOfRows) {
  for (const double interval : {0.01, 0.033})
    EXPECT_LT(worst_energy(test::n_four_bar(2), GetParam(), 1e-6, interval, 3.3), 0.1) << "rows every " << interval;
}

// The same in one window, as a scene without grains runs, its rows read on the way: no row removes the drift. With a hundred
// tolerances of drift IDA turned to another branch where the posts lie flat, 4 to 50 J off, or ended there.
TEST_P(Redundant, FourBarsPassSingularPositionsWithinAWindow) {
  const double t_end = 10.0, interval = 0.033;
  const Model model = test::n_four_bar(2);
  for (const double rtol : {1e-6, 1e-7, 3e-8, 1e-8, 1e-9}) {
    test::Run run(model, GetParam(), test::precise(rtol)), row(model, GetParam(), test::precise(rtol));
    double worst = 0.0, last = 0.0;
    Rows rows;
    rows.next = [&](double time) { return interval * (std::floor(time / interval * (1.0 + 1e-14)) + 1.0); };
    rows.on_row = [&](const State& state, const Eigen::VectorXd&) {
      EXPECT_NEAR(state.time - last, interval, 1e-12);
      last = state.time;
      row.state = state;
      worst = std::max(worst, std::abs(row.imbalance()));
      return true;
    };
    run.integrator->advance(run.state, t_end, run.inputs, rows);
    EXPECT_GT(last, t_end - interval);
    EXPECT_LT(worst, 2e-3) << "rtol " << rtol;  // a fiftieth of the benchmark's 0.1 J
  }
}

// Any number of parallelograms, with the posts flat: with three of them at 1e-7 and below IDA's steps shrank into the position
// and the run ended. The bound is twice the largest error with other last bits at the start (FOOTFALL_LAST_BITS=1..5); a run that
// takes another branch is off by 4 J and more. [J of N x 9.8 J]
TEST_P(Redundant, AnyNumberOfFourBarsPassSingularPositionsAtEveryTolerance) {
  for (const int n : {1, 2, 3, 4})
    for (const double rtol : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      const Model model = test::n_four_bar(n);
      test::Run run(model, GetParam(), test::precise(rtol));
      run.to(10.0, 1);
      EXPECT_LT(std::abs(run.imbalance()), n * 1.6e-5 * std::pow(rtol / 1e-8, 0.9) + 1.2e-5) << n << ", rtol " << rtol;
    }
}

// Its two corners pass through each other twice, about 0.5 and 2 s after the start. Steps that shrank into that position lost
// 4e-4 to 1e-3 J at an rtol of 1e-9, 100 times as much as at 1e-8, with IDA 1e-3 J at 1e-8: the error has to fall with the
// tolerance.
TEST_P(Redundant, PeaucelliersLinkagePassesItsSingularPositionAtEveryTolerance) {
  const double starts[3][2] = {{1.17, -3.0}, {1.0, -2.0}, {1.1, 2.0}};
  for (const auto& start : starts) {
    const Model model = test::peaucellier(start[0], start[1]);
    test::Run reference(model, "one_step", test::precise(1e-10));
    reference.to(3.0);
    for (const double rtol : {1e-5, 1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      test::Run run(model, GetParam(), test::precise(rtol));
      run.to(3.0, start[1] > 0.0 ? 1 : 30);
      EXPECT_LT(std::abs(run.imbalance()), 2e-6 * std::pow(rtol / 1e-10, 0.7))
          << "rtol " << rtol << ", start " << start[0];
      EXPECT_LT((run.state.q - reference.state.q).lpNorm<Eigen::Infinity>(),
                2e-6 * std::pow(std::max(rtol, 1e-8) / 1e-8, 0.75))
          << "rtol " << rtol << ", start " << start[0];
    }
  }
}

TEST(RedundantRows, ASingularPositionThatRoundOffMakesInaccurateIsTold) {
  const Model model = test::peaucellier(1.17, -3.0);
  for (const double rtol : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
    test::Run run(model, "one_step", test::precise(rtol));
    run.to(3.0, 30);
    EXPECT_EQ(run.integrator->warning().empty(), run.integrator->statistics().reported_error == 0.0);
    EXPECT_LE(run.integrator->statistics().reported_error, std::max(1.0, 1e-7 / rtol));
  }
}

// With three stages the run ended at an rtol of 1e-9, near the flat position.
TEST_P(Redundant, ScissorLiftsFallThroughTheirFlatPositionAtEveryTolerance) {
  const double at_1e8 = GetParam() == std::string("ida") ? 6e-5 : 3e-5;  // J
  for (const double rate : {0.0, -2.0}) {
    const Model model = test::scissor_lift(3, 1.0, rate);
    for (const double rtol : {1e-6, 1e-7, 1e-8, 1e-9, 1e-10}) {
      test::Run run(model, GetParam(), test::precise(rtol));
      run.to(1.5);
      EXPECT_LT(run.state.q[1], 0.48);  // the first bar has swung through
      EXPECT_LT(std::abs(run.imbalance()), at_1e8 * std::pow(rtol / 1e-8, 0.75))
          << "rtol " << rtol << ", rate " << rate;
    }
  }
}

TEST(RedundantRows, LeaveTheMatrixAsSparseAsTheMechanismIs) {
  // Four times as many loops, four times as many entries: a column for each redundant condition made them sixteen.
  const auto entries = [](int loops) {
    const Model model = test::n_four_bar(loops);
    const Assembly assembly = assemble(model);
    return static_cast<double>(Equations(model, assembly).jacobian().matrix().nonZeros());
  };
  EXPECT_NEAR(entries(32) / entries(8), 4.0, 0.2);
}

TEST_P(Redundant, RowsOfOutputDoNotChangeTheMotion) {
  const Model model = test::bennett();
  test::Run fine(model, GetParam(), test::tight(1e-7)), coarse(model, GetParam(), test::tight(1e-7));
  fine.to(1.0, 1000);
  coarse.to(1.0, 10);
  // A few hundred steps of 1e-7 each.
  EXPECT_LT((fine.state.q - coarse.state.q).lpNorm<Eigen::Infinity>(), 3e-5);
  EXPECT_LT((fine.state.v - coarse.state.v).lpNorm<Eigen::Infinity>(), 3e-4);
}

TEST(RedundantRows, CrankRockersDoNotMindHowTheirJointsAreWritten) {
  // Four hinges (three conditions too many) against two hinges, a ball and a cylinder (none): the same motion, the
  // same reactions in the plane, and no more than needed out of it.
  for (unsigned seed = 1; seed <= 10; ++seed) {
    const Model hinges = test::crank_rocker(seed, false), free = test::crank_rocker(seed, true);
    test::Run a(hinges, "one_step", test::tight(1e-7)), b(free, "one_step", test::tight(1e-7));
    EXPECT_EQ(a.assembly.rank, 17) << "seed " << seed;
    EXPECT_TRUE(b.assembly.redundant.empty()) << "seed " << seed;
    for (int i = 1; i <= 5; ++i) {
      a.to(0.1 * i);
      b.to(0.1 * i);
      ASSERT_LT((a.state.q - b.state.q).lpNorm<Eigen::Infinity>(), 1e-5) << "seed " << seed;
      Eigen::VectorXd rates_a(a.equations.layout().size()), rates_b(b.equations.layout().size());
      a.equations.saddle().accelerations(a.state, a.inputs, rates_a);
      b.equations.saddle().accelerations(a.state, b.inputs, rates_b);
      const double size = rates_b.tail(b.equations.layout().row_count).lpNorm<Eigen::Infinity>();
      a.equations.load(a.state);
      b.equations.load(a.state);
      for (int joint = 0; joint < 4; ++joint) {
        const Vector6d with =
            a.equations.joint_wrench(joint, a.state.time, rates_a.tail(a.equations.layout().row_count));
        const Vector6d without =
            b.equations.joint_wrench(joint, a.state.time, rates_b.tail(b.equations.layout().row_count));
        // Relative to the largest reaction: drift of 1e-10 and the regularisation of 1e-12.
        EXPECT_LT((with - without).lpNorm<Eigen::Infinity>(), 1e-6 * (1.0 + size))
            << "seed " << seed << " joint " << joint;
      }
    }
  }
}

// Random mechanisms that fall through positions in which their conditions lose rank.

using test::Family;
using test::Plan;

// Sarrus' mechanism and three parallelograms fall through positions in which Phi_v loses two and three ranks at once.
// Beyond them the motion may branch, but no energy may be lost.
const std::pair<Family, unsigned> kSingular[] = {{Family::kOverclosed, 3},     {Family::kOverclosed, 14},
                                                 {Family::kOverclosed, 16},    {Family::kOverclosed, 19},
                                                 {Family::kParallelogram, 15}, {Family::kParallelogram, 21}};

class SingularPositions : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, SingularPositions, ::testing::Values("one_step", "ida"));

TEST_P(SingularPositions, ArePassedWithTheEnergy) {
  for (const auto& [family, seed] : kSingular) {
    const Plan plan = test::random_mechanism(family, seed);
    EXPECT_LT(plan.regular_until, plan.duration) << plan.what;
    const Model model = test::build(plan);
    test::Run run(model, GetParam(), test::as_a_scene(1e-6));
    run.to(plan.duration);
    // They hold some 20 J and more; a thousand tolerances of it.
    EXPECT_LT(std::abs(run.imbalance()), 0.02) << plan.what;
  }
}

TEST(OverSingularPositions, NoEnergyIsLostInSilenceAtAnyTolerance) {
  // Below 1e-8 round-off may stand in the way of a step over the position; then the run ends and says so.
  for (const auto& [family, seed] : kSingular) {
    const Plan plan = test::random_mechanism(family, seed);
    const Model model = test::build(plan);
    for (const double rtol : {1e-4, 1e-5, 1e-7, 1e-8, 1e-9, 1e-10}) {
      test::Run run(model, "one_step", test::as_a_scene(rtol));
      std::string said;
      try {
        run.to(plan.duration);
      } catch (const NumericalError& error) {
        said = error.what();
      }
      if (rtol >= 1e-8) {
        EXPECT_EQ(said, "") << plan.what << ", rtol " << rtol;
      }
      // A thousand tolerances of 20 J and more.
      if (said.empty()) {
        EXPECT_LT(std::abs(run.imbalance()), std::max(0.02e6 * rtol, 1e-4)) << plan.what << ", rtol " << rtol;
      }
    }
  }
}

TEST(OverSingularPositions, StepsDoNotShrink) {
  // Steps do not shrink into the position: the same as on the way there, and a few that fail.
  for (const auto& [family, seed] : kSingular) {
    const Plan plan = test::random_mechanism(family, seed);
    const Model model = test::build(plan);
    test::Run run(model, "one_step", test::as_a_scene(1e-6));
    run.to(plan.duration);
    EXPECT_LT(run.integrator->statistics().steps, 40) << plan.what;
  }
}

}  // namespace singular
}  // namespace footfall
