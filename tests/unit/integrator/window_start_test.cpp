// Windows that go on where the last one ended start from its rates. mbd_solver/integrator/one_step.h, start_window.

#include "tests/unit/dynamics/run.h"
#include "tests/unit/integrator/smooth_mechanisms.h"

namespace footfall {
namespace {

constexpr int kWindowCount = 50;
// Rates at a start are right to 1e-4 of the tolerance in a step; Newton and the drift that is removed leave more.
constexpr double kFewTolerances = 3.0;

IntegratorOptions fifth_order() {
  IntegratorOptions options = test::usual();
  options.order = 5;
  return options;
}

TEST(WindowStart, NeedsNoFactorsOfItsOwn) {
  const Model model = test::smooth_loop(3);
  test::Run run(model, "one_step", fifth_order());
  run.to(0.1, kWindowCount);
  const IntegratorStatistics& statistics = run.integrator->statistics();
  EXPECT_EQ(statistics.windows, kWindowCount);
  EXPECT_LE(statistics.factorizations - statistics.jacobians, 2);  // of the first window
}

TEST(WindowStart, ChangesTheMotionByNoMoreThanTheTolerance) {
  for (unsigned seed = 0; seed < 6; ++seed) {
    const Model model = test::smooth_loop(seed);
    const IntegratorOptions options = fifth_order();
    test::Run followed(model, "one_step", options), anew(model, "one_step", options);
    followed.to(0.1, kWindowCount);
    for (int i = 1; i <= kWindowCount; ++i) {
      anew.integrator->forget();
      anew.to(0.1 * i / kWindowCount);
    }
    const Eigen::VectorXd v = anew.state.v;
    const Eigen::VectorXd allowed =
        kFewTolerances * (options.rtol * v.cwiseAbs().array() + options.atol_velocity).matrix();
    EXPECT_TRUE(((followed.state.v - v).cwiseAbs().array() <= allowed.array()).all())
        << seed << ": " << (followed.state.v - v).lpNorm<Eigen::Infinity>();
  }
}

// What was changed from outside is not what the rates belong to.
TEST(WindowStart, OfAnotherStateIsComputedAnew) {
  const Model model = test::smooth_loop(3);
  test::Run run(model, "one_step", fifth_order()), other(model, "one_step", fifth_order());
  run.to(0.05, 5);
  run.state.v *= 0.5;
  other.state = run.state;
  run.to(0.06);
  other.to(0.06);
  EXPECT_LT((run.state.v - other.state.v).lpNorm<Eigen::Infinity>(), 1e-4);
}

}  // namespace
}  // namespace footfall
