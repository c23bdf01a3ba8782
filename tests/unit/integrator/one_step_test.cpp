// One-step methods: order, rows of output, windows.
#include <gtest/gtest.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <memory>
#include <ostream>
#include <string>
#include <vector>

#include "mbd_solver/integrator/step_control.h"
#include "mbd_solver/integrator/tableau.h"
#include "tests/support/heap_requests.h"
#include "tests/support/linear_algebra.h"
#include "tests/support/refused.h"
#include "tests/unit/dynamics/lander_mechanism.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/integrator/smooth_mechanisms.h"

namespace footfall {
namespace {

// The coefficients: conditions of order, stiff accuracy, L-stability.

constexpr double kDigits = 1e-14;  // the coefficients have 16 digits

struct Matrices {
  explicit Matrices(const Tableau& t) : A(t.stages, t.stages), b(t.stages), embedded(t.stages), c(t.stages) {
    for (int i = 0; i < t.stages; ++i) {
      const auto at = static_cast<std::size_t>(i);
      for (int j = 0; j < t.stages; ++j) A(i, j) = t.a[at][static_cast<std::size_t>(j)];
      if (i > 0) A(i, i) += t.gamma;
      c(i) = t.c[at];
    }
    b = A.row(t.last()).transpose();
    for (int i = 0; i < t.stages; ++i) embedded(i) = b(i) - t.error[static_cast<std::size_t>(i)];
  }
  Eigen::MatrixXd A;
  Eigen::VectorXd b, embedded, c;
};

// Largest amount by which weights w miss the conditions of `order` (Hairer, Norsett and Wanner II.2).
double miss(const Matrices& m, const Eigen::VectorXd& w, int order) {
  const Eigen::MatrixXd& A = m.A;
  const Eigen::ArrayXd c = m.c.array();
  const Eigen::VectorXd Ac = A * m.c, Ac2 = A * (c * c).matrix(), AAc = A * Ac;
  const auto of = [&](const Eigen::ArrayXd& tree) { return w.dot(tree.matrix()); };
  double worst = std::abs(w.sum() - 1.0);
  const auto take = [&](int of_order, double value, double wanted) {
    if (of_order <= order) worst = std::max(worst, std::abs(value - wanted));
  };
  take(2, of(c), 1.0 / 2.0);
  take(3, of(c * c), 1.0 / 3.0);
  take(3, of(Ac), 1.0 / 6.0);
  take(4, of(c * c * c), 1.0 / 4.0);
  take(4, of(c * Ac.array()), 1.0 / 8.0);
  take(4, of(Ac2), 1.0 / 12.0);
  take(4, of(AAc), 1.0 / 24.0);
  take(5, of(c * c * c * c), 1.0 / 5.0);
  take(5, of(c * c * Ac.array()), 1.0 / 10.0);
  take(5, of(Ac.array() * Ac.array()), 1.0 / 20.0);
  take(5, of(c * Ac2.array()), 1.0 / 15.0);
  take(5, of(c * AAc.array()), 1.0 / 30.0);
  take(5, of((A * (c * c * c).matrix())), 1.0 / 20.0);
  take(5, of((A * (c * Ac.array()).matrix())), 1.0 / 40.0);
  take(5, of((A * Ac2)), 1.0 / 60.0);
  take(5, of((A * AAc)), 1.0 / 120.0);
  return worst;
}

class Method : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Tableau, Method, ::testing::Values(2, 3, 5));

TEST_P(Method, HasTheOrderItSays) {
  const Tableau& tableau = tableau_of_order(GetParam());
  const Matrices m(tableau);
  EXPECT_EQ(tableau.order, GetParam());
  EXPECT_LT((m.A.rowwise().sum() - m.c).cwiseAbs().maxCoeff(), kDigits);
  EXPECT_LT(miss(m, m.b, tableau.order), kDigits);
  EXPECT_GT(miss(m, m.b, tableau.order + (tableau.order < 5 ? 1 : 0)), tableau.order < 5 ? 1e-3 : 0.0);
}

TEST_P(Method, EstimatesItsErrorWithAnotherOrder) {
  // The difference of the two is what the lower order leaves out.
  const Tableau& tableau = tableau_of_order(GetParam());
  const Matrices m(tableau);
  EXPECT_LT(miss(m, m.embedded, tableau.estimated_order), kDigits);
  EXPECT_GT(std::max(miss(m, m.b, tableau.estimated_order + 1), miss(m, m.embedded, tableau.estimated_order + 1)),
            1e-4);
}

TEST_P(Method, IsContinuousFromStepToStepWithTheOrderOfItsEstimate) {
  // b_i(theta) / theta of the method whose step is theta h: c and A grow by 1 / theta.
  const Tableau& tableau = tableau_of_order(GetParam());
  const auto at = [&](double theta, const std::array<double, kMostStages> DenseWeights::*part) {
    const DenseWeights weights(tableau, theta);
    return Eigen::VectorXd(Eigen::Map<const Eigen::VectorXd>((weights.*part).data(), tableau.stages));
  };
  const auto b = [&](double theta) { return at(theta, &DenseWeights::b); };
  const auto slope = [&](double theta) { return at(theta, &DenseWeights::slope); };
  const Matrices m(tableau);
  for (double theta : {0.1, 0.3, 0.5, 0.9, 1.0}) {
    Matrices part = m;
    part.A /= theta;
    part.c /= theta;
    EXPECT_LT(miss(part, b(theta) / theta, tableau.estimated_order), 10.0 * kDigits / std::pow(theta, 4)) << theta;
    constexpr double kStep = 1e-5;
    if (theta == 1.0) continue;
    EXPECT_LT((slope(theta) - (b(theta + kStep) - b(theta - kStep)) / (2.0 * kStep)).norm(), 1e-8) << theta;
  }
  const Eigen::VectorXd first = Eigen::VectorXd::Unit(tableau.stages, 0);
  const Eigen::VectorXd last = Eigen::VectorXd::Unit(tableau.stages, tableau.last());
  EXPECT_LT(b(0.0).norm(), kDigits);
  EXPECT_LT((b(1.0) - m.b).norm(), kDigits);
  EXPECT_LT((slope(0.0) - first).norm(), kDigits);
  EXPECT_LT((slope(1.0) - last).norm(), kDigits);
}

TEST_P(Method, IsStableOnTheWholeLeftHalfAndForgetsWhatIsStiff) {
  // R(z) = last entry of (1 - z A)^-1 1, as the last stage is the new state.
  const Matrices m(tableau_of_order(GetParam()));
  const Eigen::Index s = m.b.size();
  const auto growth = [&](std::complex<double> z) {
    Eigen::MatrixXd system = Eigen::MatrixXd::Identity(2 * s, 2 * s);  // real and imaginary part
    system.topLeftCorner(s, s) -= z.real() * m.A;
    system.bottomRightCorner(s, s) -= z.real() * m.A;
    system.topRightCorner(s, s) = z.imag() * m.A;
    system.bottomLeftCorner(s, s) = -z.imag() * m.A;
    Eigen::VectorXd ones = Eigen::VectorXd::Zero(2 * s);
    ones.head(s).setOnes();
    const Eigen::VectorXd x = test::solve(system, ones);
    return std::hypot(x(s - 1), x(2 * s - 1));
  };
  for (double y = 1e-2; y < 1e4; y *= 1.2) EXPECT_LT(growth({0.0, y}), 1.0 + 1e-12) << y;
  EXPECT_LT(growth({-1e8, 0.0}), 1e-6);
}

// mbd_solver/integrator/one_step.h. What a smaller step and a smaller tolerance buy, on mechanisms whose motion is smooth.

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

// Steps follow their error: on smooth motions few are tried in vain (measured: 0.2, 0.7 and 7 %).
TEST_P(Order, FewStepsAreTooLong) {
  long steps = 0, rejected = 0;
  for (unsigned seed = 1; seed <= kMechanisms; ++seed) {
    const Model model = test::smooth_loop(seed);
    test::Run run(model, "one_step", options_of(GetParam(), 1e-6));
    run.to(kEnd);
    steps += run.integrator->statistics().steps;
    rejected += run.integrator->statistics().rejected;
  }
  EXPECT_LT(5 * rejected, steps);
}

// Windows in which TR-BDF2 takes several steps go by the method of third order, whose steps are longer; windows that one
// of its steps fills do not.
TEST(OneStep, WindowsThatOneStepDoesNotFillTakeAHigherOrder) {
  for (unsigned seed : {1u, 3u, 4u}) {
    const Model model = test::smooth_loop(seed);
    const Eigen::VectorXd reference = exact(model);
    const State start = test::Run(model, "one_step", options_of(2, 1e-7)).state;  // whatever its last bits
    const auto run_in = [&](int windows, int window_order) {
      IntegratorOptions options = options_of(2, 1e-7);
      options.window_order = window_order;
      auto run = std::make_unique<test::Run>(model, "one_step", options);
      run->state = start;
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

// mbd_solver/integrator/integrator.h, Rows. States on the way: what a row costs, how close it is to a step that ends there, and what it keeps.

constexpr double kLast = 0.5, kInterval = 0.001;  // [s]

struct Row {
  State state;
  Eigen::VectorXd rates;
};

Rows every_interval(std::vector<Row>& out, double stop_at = 1e9) {
  Rows rows;
  rows.next = [](double t) { return (std::floor(t / kInterval + 1e-6) + 1.0) * kInterval; };
  rows.on_row = [&out, stop_at](const State& state, const Eigen::VectorXd& rates) {
    out.push_back({state, rates});
    return state.time < stop_at;
  };
  return rows;
}

struct Case {
  const char* kind;
  int order;
};
void PrintTo(const Case& way, std::ostream* out) { *out << way.kind << ", order " << way.order; }

class Way : public ::testing::TestWithParam<Case> {
 protected:
  IntegratorOptions options() const {
    IntegratorOptions options;
    options.order = GetParam().order;
    options.rtol = 1e-6;
    options.atol = 1e-8;
    options.atol_velocity = 1e-6;
    return options;
  }
};
INSTANTIATE_TEST_SUITE_P(Integrators, Way,
                         ::testing::Values(Case{"one_step", 2}, Case{"one_step", 3}, Case{"one_step", 5},
                                           Case{"ida", 0}));

TEST_P(Way, RowsCostNoStepAndChangeNothing) {
  const Model model = test::smooth_loop(3);
  test::Run plain(model, GetParam().kind, options()), with_rows(model, GetParam().kind, options());
  with_rows.state = plain.state;  // whatever its last bits (FOOTFALL_LAST_BITS)
  std::vector<Row> rows;
  plain.to(kLast);
  with_rows.integrator->advance(with_rows.state, kLast, with_rows.inputs, every_interval(rows));
  EXPECT_EQ(rows.size(), 499u);
  EXPECT_EQ(plain.integrator->statistics().steps, with_rows.integrator->statistics().steps);
  EXPECT_LT(plain.integrator->statistics().steps, 300);
  EXPECT_TRUE(plain.state.q == with_rows.state.q);
  EXPECT_TRUE(plain.state.v == with_rows.state.v);
}

TEST_P(Way, RowsAreWhereStepsThatEndThereWouldBe) {
  // Positions and velocities within a few hundred tolerances (errors at the end are, too); accelerations and multipliers
  // are one order lower and of size 100.
  constexpr double kPosition = 3e-4, kVelocity = 3e-3, kRate = 0.01, kWork = 3e-4;
  for (unsigned seed : {1u, 3u, 4u}) {
    const Model model = test::smooth_loop(seed);
    test::Run run(model, GetParam().kind, options());
    std::vector<Row> rows;
    run.integrator->advance(run.state, kLast, run.inputs, every_interval(rows));
    IntegratorOptions tight = options();
    tight.order = 5;
    tight.rtol = tight.atol = tight.atol_velocity = 1e-10;
    test::Run reference(model, "one_step", tight);
    const int lower = run.equations.layout().size() - run.equations.layout().q_size;
    for (std::size_t i = 36; i < rows.size(); i += 37) {
      const State& state = rows[i].state;
      reference.to(state.time);
      EXPECT_LT((state.q - reference.state.q).norm(), kPosition) << seed << " " << state.time;
      EXPECT_LT((state.v - reference.state.v).norm(), kVelocity) << seed << " " << state.time;
      EXPECT_NEAR(state.dissipated.total(), reference.state.dissipated.total(), kWork);
      const Eigen::VectorXd exact = reference.integrator->end_rates().tail(lower);
      EXPECT_LT((rows[i].rates.tail(lower) - exact).norm(), kRate * (10.0 + exact.norm())) << seed << " " << state.time;
    }
  }
}

TEST_P(Way, RowsKeepTheConditionsOfTheJoints) {
  const Model model = test::smooth_loop(4);
  test::Run run(model, GetParam().kind, options());
  std::vector<Row> rows;
  run.integrator->advance(run.state, kLast, run.inputs, every_interval(rows));
  for (const Row& row : rows) {
    EXPECT_LT(run.equations.saddle().drift(row.state).position, 1e-9);
    EXPECT_LT(run.equations.saddle().drift(row.state).velocity, 1e-8);
    for (int q : run.equations.layout().body_q) EXPECT_NEAR(row.state.q.segment<4>(q + 3).norm(), 1.0, 1e-12);
  }
  EXPECT_LT(run.integrator->statistics().drift_position, 1e-8);
}

TEST_P(Way, RowThatSaysNoEndsTheWindowThere) {
  const Model model = test::smooth_loop(5);
  test::Run run(model, GetParam().kind, options()), whole(model, GetParam().kind, options());
  std::vector<Row> rows;
  run.integrator->advance(run.state, kLast, run.inputs, every_interval(rows, 0.1234));
  EXPECT_NEAR(run.state.time, 0.124, 1e-12);
  EXPECT_EQ(rows.back().state.time, run.state.time);
  EXPECT_TRUE(rows.back().state.q.isApprox(run.state.q, 1e-12));
  EXPECT_TRUE(rows.back().rates == run.integrator->end_rates());
  // And continues as if nothing had been, within the tolerance.
  run.to(kLast);
  whole.to(kLast);
  EXPECT_LT((run.state.q - whole.state.q).norm(), 3e-4);
}

TEST(Rows, AreAsCloseAsStepsThatEndThereAtATightTolerance) {
  // Steps as long as the tolerance lets them be, against steps that end at each of these rows. A metre and a hundred
  // steps: a row may add a hundred tolerances to what the steps themselves are off by.
  constexpr double kTolerance = 1e-10, kPosition = 100.0 * kTolerance, kVelocity = 10.0 * kPosition;
  for (unsigned seed : {1u, 3u, 4u}) {
    const Model model = test::smooth_loop(seed);
    IntegratorOptions options = test::tight(kTolerance);
    options.order = 5;
    test::Run run(model, "one_step", options), ends(model, "one_step", options);
    std::vector<Row> rows;
    run.integrator->advance(run.state, kLast, run.inputs, every_interval(rows));
    for (std::size_t i = 36; i < rows.size(); i += 37) {
      const State& state = rows[i].state;
      ends.to(state.time);
      EXPECT_LT((state.q - ends.state.q).norm(), kPosition) << seed << " " << state.time;
      EXPECT_LT((state.v - ends.state.v).norm(), kVelocity) << seed << " " << state.time;
      EXPECT_NEAR(state.dissipated.total(), ends.state.dissipated.total(), kVelocity);
    }
  }
}

TEST(Rows, ErrorIsOfFifthOrder) {
  // Fixed steps of the fifth-order method, rows in the middle of steps: the continuous extension is what is seen.
  double order = 0.0;
  // Seeds whose Newton needs no shorter steps and whose error is far from the reference's own, as in one_step_test.cpp.
  constexpr double kCount = 3.0;
  for (unsigned seed : {1u, 4u, 5u}) {
    const Model model = test::smooth_loop(seed);
    IntegratorOptions tight;
    tight.order = 5;
    tight.rtol = tight.atol = tight.atol_velocity = 1e-10;
    test::Run reference(model, "one_step", tight);
    const double at = 0.1;
    reference.to(at);
    double errors[2] = {0.0, 0.0};
    for (int k = 0; k < 2; ++k) {
      IntegratorOptions options = tight;
      options.error_control = false;
      options.max_step = 0.2 / (k == 0 ? 7 : 15);  // 0.1 is the middle of a step
      options.rtol = options.atol = options.atol_velocity = 1e-9;
      test::Run run(model, "one_step", options);
      Rows rows;
      rows.next = [at](double t) { return t < at ? at : 1e9; };
      rows.on_row = [&](const State& state, const Eigen::VectorXd&) {
        errors[k] = (state.v - reference.state.v).norm();
        return true;
      };
      run.state.step = options.max_step;
      run.integrator->advance(run.state, 0.2, run.inputs, rows);
    }
    order += std::log(errors[0] / errors[1]) / std::log(15.0 / 7.0) / kCount;
  }
  EXPECT_GT(order, 4.5);
}

// Windows that go on where the last one ended start from its rates. mbd_solver/integrator/one_step.h, start_window.

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

// A step takes no memory: twice as many steps ask malloc as often as half of them. mbd_solver/integrator/one_step.h.

TEST(OneStep, TakesNoMemoryInAStep) {
  SKIP_WHERE_MEMORY_IS_NOT_COUNTED();
  const Model model = test::smooth_loop(3);
  for (int order : {2, 3, 5}) {
    IntegratorOptions options = test::usual();
    options.order = order;
    options.max_step = 1e-3;
    test::Run run(model, "one_step", options);
    run.to(0.01);  // what is sized at its first use
    const auto count = [&](double t_end) {
      const long before = test::heap_requests;
      run.integrator->advance(run.state, t_end, run.inputs);
      return test::heap_requests - before;
    };
    const long few = count(0.02), many = count(0.12);
    EXPECT_GT(test::heap_requests, 0);
    EXPECT_LE(many, few) << order;
  }
}

// mbd_solver/integrator/step_control.h: windows that do not end.

TEST(ProgressWatch, ComplainsOfStepsThatNeverEndAndBearsAHardMoment) {
  ProgressWatch never(0.0, 1.0), moment(0.0, 1.0);
  double t = 0.0;
  std::string complaint;
  for (int i = 0; i < 4000 && complaint.empty(); ++i) complaint = never.check(t += 1e-10);
  EXPECT_TRUE(test::names(complaint, {"2000"}));
  t = 0.0;
  for (int i = 0; i < 10000; ++i) EXPECT_TRUE(moment.check(t += i % 2000 < 1900 ? 1e-12 : 1e-5).empty()) << i;
}

}  // namespace
}  // namespace footfall
