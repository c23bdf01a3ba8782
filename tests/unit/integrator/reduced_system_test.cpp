#include "mbd_solver/integrator/reduced_system.h"

#include <gtest/gtest.h>

#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall {
namespace {

// With right-hand sides in all rows, dq - N v too, at positions that turn fast: r = J x, with J from jacobian_check.h.
TEST(ReducedSystem, SolvesTheWholeSystem) {
  test::Random random(1);
  const Model model = test::everything(random);
  Equations equations(model, test::as_given(model));
  const Layout& layout = equations.layout();
  const Inputs inputs = test::random_inputs(random, model);
  Eigen::VectorXd y(layout.size());
  equations.layout().pack(test::as_given(model).state, random.vector_x(layout.row_count, 5.0), y);
  y.segment(layout.v0(), layout.v_size) = random.vector_x(layout.v_size, 3.0);
  const Eigen::VectorXd ydot = random.vector_x(layout.size(), 3.0), x = random.vector_x(layout.size());
  const double c = 5.0;
  const Eigen::MatrixXd J = test::whole_jacobian(equations, 0.3, y, ydot, c, inputs);
  ReducedSystem system(equations, Eigen::VectorXd::Zero(layout.v_size));
  system.evaluate(0.3, y, ydot, c, inputs);
  ASSERT_TRUE(system.factor());
  Eigen::VectorXd r = J * x;
  system.solve_whole(r);
  EXPECT_LT((J * (r - x)).norm() / (J * x).norm(), 1e-9);
  EXPECT_LT((r - x).head(layout.q_size).norm() / x.head(layout.q_size).norm(), 1e-6);
}

}  // namespace
}  // namespace footfall
