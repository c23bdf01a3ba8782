// mbd_solver/integrator/one_step.h. What a smaller step and a smaller tolerance buy, on mechanisms whose motion is smooth.

#include <algorithm>
#include <cmath>
#include <memory>

#include "mbd_solver/integrator/method_choice.h"
#include "tests/unit/dynamics/lander_mechanism.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/integrator/smooth_mechanisms.h"

namespace footfall {
namespace {

constexpr unsigned kMechanisms = 20;
constexpr double kEnd = 0.25;    // [s]
constexpr double kEnough = 0.1;  // errors below this share of the tolerance need not fall any more

IntegratorOptions options_of(int order, double rtol) {
  IntegratorOptions options;
  options.order = order;
  options.rtol = rtol;
  options.atol = 1e-2 * rtol;
  options.atol_velocity = rtol;
  return options;
}

Eigen::VectorXd end_of(const Model& model, const IntegratorOptions& options, double t_end = kEnd,
                       const std::string& kind = "one_step") {
  test::Run run(model, kind, options);
  run.to(t_end);
  return run.state.q;
}

// By the fifth order, a hundred times closer than what is looked at; IDA agrees (below).
Eigen::VectorXd exact(const Model& model, double t_end = kEnd) {
  IntegratorOptions options = test::tight(1e-10);
  options.order = 5;
  return end_of(model, options, t_end);
}

class Order : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(OneStep, Order, ::testing::Values(2, 3, 5));

TEST(OneStep, AgreesWithIdaOnSmoothLoops) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Model model = test::smooth_loop(seed);
    EXPECT_LT((exact(model) - end_of(model, test::tight(1e-11), kEnd, "ida")).norm(), 1e-7) << seed;
  }
}

// The errors at the end of all loops, for each of `values` of what `options` takes: none may pass `least` times the one
// before it, but for what `rtol` leaves. Returns the geometric mean of what is left from one value to the next.
template <class OptionsOf>
double mean_fall(const std::vector<double>& values, double least, const OptionsOf& options_for) {
  double mean = 0.0;
  int count = 0;
  for (unsigned seed = 1; seed <= kMechanisms; ++seed) {
    const Model model = test::smooth_loop(seed);
    const Eigen::VectorXd reference = exact(model);
    double last = 0.0;
    for (const double value : values) {
      const IntegratorOptions options = options_for(value);
      const double error = (end_of(model, options) - reference).norm();
      if (last > 0.0) {
        EXPECT_LT(error, least * last + kEnough * options.rtol) << "seed " << seed << ", at " << value;
        mean += std::log(error / last);
        ++count;
      }
      last = error;
    }
  }
  return std::exp(mean / count);
}

TEST(OneStep, ErrorFallsWithTheStep) {
  // At a tolerance that lets Newton leave more than the step itself does: the sum over many steps must not be seen.
  // Each halving of the step takes three quarters of the error; a half must go, and on the mean of all more.
  constexpr double kLeast = 0.6, kMean = 0.35;
  const auto with_step = [](double step) {
    IntegratorOptions options = options_of(2, 1e-6);
    options.max_step = step;
    return options;
  };
  EXPECT_LT(mean_fall({1.6e-3, 8e-4, 4e-4, 2e-4, 1e-4}, kLeast, with_step), kMean);
}

TEST_P(Order, ErrorFallsWithTheTolerance) {
  // A tenth of the tolerance: the error falls at least to its square root (second order: local error h^3, of all h^2).
  constexpr double kLeast = 0.7, kMean = 0.33;
  const auto with_tolerance = [](double rtol) { return options_of(GetParam(), rtol); };
  EXPECT_LT(mean_fall({1e-4, 1e-5, 1e-6, 1e-7}, kLeast, with_tolerance), kMean);
}

// Windows in which TR-BDF2 takes several steps go by the method of third order, whose steps are longer; windows that one
// of its steps fills do not.
TEST(OneStep, WindowsThatOneStepDoesNotFillTakeAHigherOrder) {
  for (unsigned seed : {1u, 3u, 4u}) {
    const Model model = test::smooth_loop(seed);
    const Eigen::VectorXd reference = exact(model);
    const auto run_in = [&](int windows, int window_order) {
      IntegratorOptions options = options_of(2, 1e-7);
      options.window_order = window_order;
      auto run = std::make_unique<test::Run>(model, "one_step", options);
      run->to(kEnd, windows);
      return run;
    };
    const auto lower = run_in(20, 0), chosen = run_in(20, 3);
    const long most = lower->integrator->statistics().steps;
    EXPECT_GT(most, 100) << seed;
    EXPECT_LT(10 * chosen->integrator->statistics().steps, 8 * most) << seed;
    EXPECT_LT((chosen->state.q - reference).norm(), 1.5 * (lower->state.q - reference).norm()) << seed;
    const auto short_windows = run_in(5000, 0), not_needed = run_in(5000, 3);
    EXPECT_EQ(short_windows->integrator->statistics().residuals, not_needed->integrator->statistics().residuals)
        << seed;
  }
}

// The first step of all is short, and max_step is no longer than a window: the third order takes over all the same once its
// steps fill them.
TEST(OneStep, WindowsThatOneStepFillsGoBackToTheLowerOrder) {
  constexpr int kWindows = 250;
  for (unsigned seed : {1u, 3u, 4u}) {
    const Model model = test::smooth_loop(seed);
    const auto residuals = [&](int order, int window_order) {
      IntegratorOptions options = options_of(order, 1e-4);
      options.window_order = window_order;
      options.max_step = kEnd / kWindows;
      test::Run run(model, "one_step", options);
      run.to(kEnd, kWindows);
      return run.integrator->statistics().residuals;
    };
    const long third = residuals(3, 0), fifth = residuals(5, 0), chosen = residuals(3, 5);
    EXPECT_LT(10 * third, 9 * fifth) << seed;
    EXPECT_LT(chosen, third + (fifth - third) / 5) << seed;
  }
}

// Newton fails where pads touch the plane. Each factorization beyond the Jacobians' would be one of the saddle matrix, which
// steps near a singular position ask for.
TEST(OneStep, StepsThatFailAtAContactAreNotTakenForSingularPositions) {
  IntegratorOptions options = options_of(5, 1e-3);
  const Model model = test::lander();
  test::Run run(model, "one_step", options);
  run.to(0.2);
  const IntegratorStatistics& done = run.integrator->statistics();
  EXPECT_GT(done.newton_failures, 3);
  EXPECT_LE(done.factorizations, done.jacobians + 1);
}

TEST(MethodChoice, GoesUpWhereAStepDoesNotFillAWindowAndDownWhereItFillsSeveral) {
  MethodChoice choice;
  EXPECT_EQ(choice.begin(1.0, 1.0), 1.0);
  EXPECT_FALSE(choice.high());
  EXPECT_EQ(choice.begin(1.0, 0.5), 0.9);
  EXPECT_TRUE(choice.high());
  EXPECT_EQ(choice.begin(1.0, 2.0), 2.0);
  EXPECT_TRUE(choice.high());
  EXPECT_EQ(choice.begin(1.0, 3.0), 3.0);
  EXPECT_FALSE(choice.high());
}

TEST(MethodChoice, StretchesNoStepThatIsAGuess) {
  MethodChoice choice;
  EXPECT_EQ(choice.begin(1.0, 0.5), 0.5);
  EXPECT_TRUE(choice.high());
}

TEST(OneStep, FifthOrderEndsWithinAHundredTolerances) {
  // What one takes a tolerance for: the error at the end of a second, in lengths of one metre.
  constexpr double kTolerances = 100.0, kSecond = 1.0;
  for (unsigned seed = 1; seed <= kMechanisms; ++seed) {
    const Model model = test::smooth_loop(seed);
    const Eigen::VectorXd reference = exact(model, kSecond);
    for (double rtol : {1e-5, 1e-6})
      EXPECT_LT((end_of(model, options_of(5, rtol), kSecond) - reference).norm(), kTolerances * rtol)
          << "seed " << seed << ", rtol " << rtol;
  }
}

TEST(OneStep, ObservedOrderIsFive) {
  // Fixed steps: the mean over mechanisms of log2 of the ratio, and multipliers as well as positions.
  double positions = 0.0, multipliers = 0.0;
  // Seeds whose error at these steps is far from the reference's own and whose Newton needs no shorter steps.
  constexpr double kCount = 3.0;
  for (unsigned seed : {1u, 4u, 5u}) {
    const Model model = test::smooth_loop(seed);
    const auto ends = [&](double step, double rtol) {
      IntegratorOptions options = options_of(5, rtol);
      options.error_control = step == 0.0;
      options.max_step = step;
      test::Run run(model, "one_step", options);
      run.to(kEnd);
      return std::make_pair(run.state.q,
                            Eigen::VectorXd(run.integrator->end_rates().tail(run.equations.layout().row_count)));
    };
    const auto reference = ends(0.0, 1e-10), coarse = ends(kEnd / 10, 1e-9), fine = ends(kEnd / 20, 1e-9);
    positions += std::log2((coarse.first - reference.first).norm() / (fine.first - reference.first).norm()) / kCount;
    multipliers +=
        std::log2((coarse.second - reference.second).norm() / (fine.second - reference.second).norm()) / kCount;
  }
  EXPECT_GT(positions, 4.5);
  EXPECT_GT(multipliers, 3.8);
}

}  // namespace
}  // namespace footfall
