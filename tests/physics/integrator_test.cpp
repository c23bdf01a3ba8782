// Integrators on whole mechanisms.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

#include "coupler/base/errors.h"
#include "mbd_solver/model/laws/springs.h"
#include "tests/physics/mechanisms.h"
#include "tests/physics/motion_of.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/lander_mechanism.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"
#include "tests/validation/famous_mechanisms.h"

// What IDA says of its own errors: a run that ends off by tens of tolerances does not pass in silence.
namespace footfall {
namespace integrators {

// What the integrators promise: order, drift, restart to the bit, the same motion from both, and words when
// they give up.

// Spatial double pendulum with a damper between its links.
Model double_pendulum() {
  Model model({0.0, 0.0, -9.81});
  BodyState first, second;
  first.r = {0.5, 0.0, 0.0};
  second.r = {1.0, 0.4, 0.0};
  second.w = {0.0, 3.0, 0.0};
  second.dr = second.w.cross(Eigen::Vector3d(0.0, 0.4, 0.0));
  model.add_body(Body("upper", 1.0, Eigen::Vector3d(0.02, 0.1, 0.11).asDiagonal()), first);
  model.add_body(Body("lower", 0.7, Eigen::Vector3d(0.08, 0.02, 0.09).asDiagonal()), second);
  model.add_joint(
      spherical_joint("pivot", ground_marker(Eigen::Vector3d::Zero()), model.marker_at(0, Eigen::Vector3d::Zero())));
  model.add_joint(revolute_joint("elbow", model.marker_at(0, {1.0, 0.0, 0.0}, axes_with_z({0.0, 1.0, 0.0})),
                                 model.marker_at(1, {1.0, 0.0, 0.0}, axes_with_z({0.0, 1.0, 0.0}))));
  LinearSpringDamperParameters damper;
  damper.damping = 0.05;
  model.add_force(torsional_spring("damper", model.joint(1).m1, model.joint(1).m2, damper));
  return model;
}

// Loads that jump from window to window, as in a coupled run.
Inputs load_of_window(int window) {
  Inputs inputs;
  inputs.loads.resize(2);
  inputs.loads[1].F_W = {std::sin(1.0 + window), std::cos(2.0 * window), 0.3 * window};
  inputs.loads[1].T_B = {0.1, -0.05 * window, 0.02};
  return inputs;
}

State end_state(const Model& model, const std::string& kind, const IntegratorOptions& options, int windows,
                bool jumping) {
  test::Run run(model, kind, options);
  for (int i = 0; i < windows; ++i) {
    if (jumping) run.inputs = load_of_window(i);
    run.to(0.4 * (i + 1) / windows);
  }
  return run.state;
}

TEST(OneStep, ObservedOrderIsTwoAlsoWithJumpingLoads) {
  // Fixed steps; the tolerance is used by Newton's iteration alone.
  const Model model = double_pendulum();
  for (bool jumping : {false, true}) {
    const int windows = 8;
    const State exact = end_state(model, "ida", test::tight(1e-11), windows, jumping);
    double last = 0.0;
    for (int steps : {4, 8, 16, 32}) {
      IntegratorOptions options = test::tight(1e-9);
      options.error_control = false;
      options.max_step = 0.4 / windows / steps;
      const State state = end_state(model, "one_step", options, windows, jumping);
      const double error = (state.v - exact.v).norm();
      if (last > 0.0) {
        EXPECT_GT(std::log2(last / error), 1.85) << steps;
        EXPECT_LT(std::log2(last / error), 2.3) << steps;
      }
      last = error;
    }
  }
}

TEST(OneStep, WorkIntegralsAreOfTheSameOrder) {
  const Model model = double_pendulum();
  double last = 0.0;
  for (int steps : {8, 16, 32}) {
    IntegratorOptions options = test::tight(1e-9);
    options.error_control = false;
    options.max_step = 0.05 / steps;
    test::Run run(model, "one_step", options);
    run.to(0.4, 8);
    const double error = std::abs(run.imbalance());
    if (last > 0.0) {
      EXPECT_GT(std::log2(last / error), 1.8) << steps;
    }
    last = error;
  }
}

TEST(Ida, ErrorFallsWithTheStepAtAWideTolerance) {
  // No limit of a step may keep IDA at a low order, and Newton must not leave more than steps err by.
  Model model({0.0, 0.0, -9.81});
  BodyState start;
  start.r = {0.5, 0.0, 0.0};
  model.add_body(Body("rod", 1.0, Eigen::Vector3d(0.02, 0.1, 0.11).asDiagonal()), start);
  model.add_joint(revolute_joint("pivot", ground_marker(Eigen::Vector3d::Zero(), axes_with_z({0.0, 1.0, 0.0})),
                                 model.marker_at(0, Eigen::Vector3d::Zero(), axes_with_z({0.0, 1.0, 0.0}))));
  const auto end = [&](const char* kind, double rtol, double max_step) {
    IntegratorOptions options = test::tight(rtol);
    options.max_step = max_step;
    test::Run run(model, kind, options);
    run.to(3.0);
    return run.state.v;
  };
  const Eigen::VectorXd exact = end("one_step", 1e-11, 0.0);
  double last = std::numeric_limits<double>::infinity();
  for (const double step : {1e-2, 1e-3, 1e-4}) {
    const double error = (end("ida", 1e-4, step) - exact).norm();
    EXPECT_LT(error, last) << step;
    last = error;
  }
}

class Kind : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, Kind, ::testing::Values("one_step", "ida"));

TEST_P(Kind, BothReachTheSameState) {
  const Model model = double_pendulum();
  const State a = end_state(model, GetParam(), test::tight(1e-8), 8, true);
  const State b = end_state(model, "ida", test::tight(1e-11), 8, true);
  EXPECT_LT((a.q - b.q).norm(), 1e-5);
  EXPECT_LT((a.v - b.v).norm(), 1e-4);
  EXPECT_NEAR(a.load_work[1], b.load_work[1], 1e-5);
  EXPECT_NEAR(a.dissipated.total(), b.dissipated.total(), 1e-5);
}

TEST_P(Kind, ProjectionKeepsDriftBelowOneHundredMillionth) {
  // Wide tolerance and long windows: drift within a window is large, what is left after it is round-off.
  const Model model = double_pendulum();
  test::Run run(model, GetParam(), test::tight(1e-4));
  for (int i = 1; i <= 10; ++i) {
    run.to(0.2 * i);
    EXPECT_LT(run.equations.saddle().drift(run.state).position, 1e-8);
    EXPECT_LT(run.equations.saddle().drift(run.state).velocity, 1e-8);
    for (int q : run.equations.layout().body_q) EXPECT_NEAR(run.state.q.segment<4>(q + 3).norm(), 1.0, 1e-8);
  }
  EXPECT_LT(run.integrator->statistics().drift_position, 1e-8);
  EXPECT_LT(run.integrator->statistics().drift_velocity, 1e-8);
  // There was something to remove, and it was reported.
  EXPECT_GT(run.integrator->statistics().removed_position, 1e-8);
}

TEST_P(Kind, BaumgarteBoundsTheDriftThatGrowsWithoutIt) {
  const Model model = double_pendulum();
  IntegratorOptions options = test::tight(1e-5);
  options.projection = false;
  test::Run nothing(model, GetParam(), options), baumgarte(model, GetParam(), options, Baumgarte{20.0, 20.0});
  nothing.to(1.2, 40);
  baumgarte.to(1.2, 40);
  EXPECT_LT(baumgarte.equations.saddle().drift(baumgarte.state).position,
            0.1 * nothing.equations.saddle().drift(nothing.state).position);
  // Beyond 1e-3 m a joint is open, and the run says so.
  options = test::tight(1e-3);
  options.projection = false;
  test::Run open(model, GetParam(), options);
  EXPECT_THROW(open.to(8.0, 80), NumericalError);
}

TEST_P(Kind, ResumesToTheBit) {
  // A checkpoint is the State; forget() makes both sides start from it alone.
  const Model model = test::lander();
  const IntegratorOptions options = test::usual();
  test::Run whole(model, GetParam(), options);
  whole.inputs.values = Eigen::VectorXd::Constant(4, 0.3);
  whole.to(0.004, 8);
  whole.integrator->forget();
  test::Run resumed(model, GetParam(), options);
  resumed.inputs = whole.inputs;
  resumed.state = whole.state;
  resumed.integrator->forget();
  whole.to(0.008, 8);
  resumed.to(0.008, 8);
  EXPECT_TRUE(whole.state.q == resumed.state.q);
  EXPECT_TRUE(whole.state.v == resumed.state.v);
  EXPECT_TRUE(whole.state.z == resumed.state.z);
  EXPECT_EQ(whole.state.dissipated.by_kind, resumed.state.dissipated.by_kind);
  EXPECT_EQ(whole.state.step, resumed.state.step);
}

std::string complaint(test::Run& run, double t) {
  return test::error_of<NumericalError>([&] { run.to(t, 40); });
}

TEST_P(Kind, NotANumberNamesTimeAndBody) {
  const Model model = double_pendulum();
  test::Run run(model, GetParam());
  run.inputs = load_of_window(0);
  run.inputs.loads[1].F_W.x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NE(complaint(run, 0.1), "");
  test::Run state_run(model, GetParam());
  state_run.state.v[8] = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(test::names(complaint(state_run, 0.1), {"lower"}));
}

TEST_P(Kind, LawWithoutAValueIsQuotedWhenNoStepIsSmallEnough) {
  // A heavy body drops on a gas spring and uses up its volume: nothing can save that, and the message says
  // what it was.
  Model model({0.0, 0.0, -1000.0});
  BodyState state;
  state.r = {0.0, 0.0, 1.0};
  const int body = model.add_body(Body("piston", 1e5, Eigen::Matrix3d::Identity()), state);
  model.add_joint(
      prismatic_joint("slide", model.marker_at(kGround, Eigen::Vector3d::Zero()), model.marker_at(body, state.r)));
  std::vector<std::unique_ptr<StrutLaw>> laws;
  GasSpringParameters gas;
  gas.exponent = 1.0;
  gas.initial_pressure = 1.0;
  laws.push_back(std::make_unique<GasSpring>(gas));
  model.add_force(std::make_unique<Strut>("gas", ground_marker(Eigen::Vector3d::Zero()), model.marker_at(body, state.r),
                                          std::move(laws), 1.0));
  test::Run run(model, GetParam());
  EXPECT_TRUE(test::names(complaint(run, 0.04), {"gas"}));  // falls 0.35 m in 0.026 s
}

TEST(Integrator, UnknownKindNamesTheKnownOnes) {
  const Model model = double_pendulum();
  EXPECT_THROW(test::Run(model, "euler"), InputError);
}

TEST(Lander, BalancesItsEnergyAndComesToRest) {
  // 29 bodies with gas, MR, honeycomb, stops, plane contact with friction, in windows of 5e-4 s. Required:
  // 0.1 % of the initial energy.
  const Model model = test::lander();
  const IntegratorOptions options = test::usual();
  test::Run run(model, "one_step", options);
  run.inputs.values = Eigen::VectorXd::Constant(4, 0.5);
  double peak = 0.0;
  for (int i = 1; i <= 800; ++i) {
    run.to(5e-4 * i);
    peak = std::max(peak, run.integrator->end_rates()[run.equations.layout().v0() + 2]);
    ASSERT_LT(std::abs(run.imbalance()), 1e-4 * run.start_energy());
    ASSERT_LT(run.equations.saddle().drift(run.state).position, 1e-8);
  }
  EXPECT_LT(std::abs(run.body(0).dr.z()), 0.2);
  EXPECT_LT(run.body(0).w.norm(), 1e-6);  // four legs alike: it does not tilt
  EXPECT_LT(peak, 8.0 * 9.81);
  for (double part : run.state.dissipated.by_kind) EXPECT_GE(part, -1e-9);
  EXPECT_GT(run.state.dissipated[Dissipation::kMrViscous], 1000.0);
}

std::string warning_after(const Model& model, double t_end, double rtol, double* error = nullptr) {
  test::Run run(model, "ida", test::as_a_scene(rtol));
  const test::Motion start = test::motion_of(run);
  run.to(t_end);
  if (error != nullptr) {
    test::Run reference(model, "one_step", test::as_a_scene(1e-3 * rtol));
    reference.to(t_end);
    const test::Motion end = test::motion_of(reference);
    *error = test::difference(test::motion_of(run), end, test::size_of(start, end)) / rtol;
  }
  return run.integrator->warning();
}

TEST(IdaWarning, ComesWhereTheEndIsOffByTensOfTolerances) {
  double error = 0.0;
  const std::string warning = warning_after(test::bennett(), 10.0, 1e-6, &error);
  EXPECT_GT(error, 30.0);
  EXPECT_NE(warning, "");
}

TEST(IdaWarning, ComesWhereStiffPartsVibrateAtItsTolerance) {
  // Thousands of steps in the first seconds of a spin-up: their errors add up.
  EXPECT_NE(warning_after(test::spin_up_beam(8), 1.5, 1e-6), "");
}

TEST(IdaWarning, StaysAwayWhereTheErrorsAreFew) { EXPECT_EQ(warning_after(test::flyball_governor(), 1e-3, 1e-6), ""); }

}  // namespace integrators
}  // namespace footfall
