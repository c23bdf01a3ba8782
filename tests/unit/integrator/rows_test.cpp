// mbd_solver/integrator/integrator.h, Rows. States on the way: what a row costs, how close it is to a step that ends there, and what it keeps.

#include <cmath>
#include <ostream>
#include <vector>

#include "tests/unit/dynamics/run.h"
#include "tests/unit/integrator/smooth_mechanisms.h"

namespace footfall {
namespace {

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
    EXPECT_LT(run.equations.drift(row.state).position, 1e-9);
    EXPECT_LT(run.equations.drift(row.state).velocity, 1e-8);
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
  // And goes on as if nothing had been, within the tolerance.
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

}  // namespace
}  // namespace footfall
