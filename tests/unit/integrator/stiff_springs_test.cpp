// Stiff forces whose direction turns within a step.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "mbd_solver/model/elements/strut.h"
#include "mbd_solver/model/laws/springs.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

// Angle below the horizontal of a pendulum of 1 m that is let go at rest: q'' = g cos q, by Runge and Kutta's fourth order.
double pendulum(double t_end) {
  const int steps = 20000;
  const double h = t_end / steps, g = 9.81;
  double q = 0.0, w = 0.0;
  for (int i = 0; i < steps; ++i) {
    const double k1 = g * std::cos(q), k2 = g * std::cos(q + 0.5 * h * w);
    const double k3 = g * std::cos(q + 0.5 * h * w + 0.25 * h * h * k1);
    const double k4 = g * std::cos(q + h * w + 0.5 * h * h * k2);
    q += h * w + h * h * (k1 + k2 + k3) / 6.0;
    w += h * (k1 + 2.0 * k2 + 2.0 * k3 + k4) / 6.0;
  }
  return q;
}

class StiffSpring : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Stiffness, StiffSpring, ::testing::Values(1e8, 1e9, 1e10, 1e11, 1e12, 1e14));  // [N/m]

// A point mass on the spring swings as a pendulum, to some ten tolerances, in steps that the motion alone requires.
TEST_P(StiffSpring, SwingsAsAPendulum) {
  Model model(Eigen::Vector3d(0.0, 0.0, -9.81));
  BodyState out;
  out.r = Eigen::Vector3d::UnitX();
  model.add_body(Body("bob", 1.0, 0.01 * Eigen::Matrix3d::Identity()), out);
  LinearSpringDamperParameters spring;
  spring.stiffness = GetParam();
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(spring));
  model.add_force(std::make_unique<Strut>("spring", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                          model.marker_at(0, out.r), std::move(laws), 1.0));
  IntegratorOptions options;  // as a scene has them
  options.order = 3;
  options.window_order = 5;
  options.rtol = options.atol_velocity = 1e-6;
  options.atol = 1e-8;
  options.max_step = 1e-3;
  test::Run run(model, "one_step", options);
  const double tolerance = 50.0 * options.rtol + 100.0 / GetParam();  // and the spring's stretch
  Rows rows;
  rows.next = [](double time) { return 0.05 * (std::floor(time / 0.05 + 1e-9) + 1.0); };
  rows.on_row = [&](const State& state, const Eigen::VectorXd&) {
    const double q = pendulum(state.time);
    EXPECT_NEAR(state.q[0], std::cos(q), tolerance) << state.time;
    EXPECT_NEAR(state.q[2], -std::sin(q), tolerance) << state.time;
    return true;
  };
  run.integrator->advance(run.state, 2.0, run.inputs, rows);
  EXPECT_LT(run.integrator->statistics().steps, 3000);
}

}  // namespace
}  // namespace footfall
