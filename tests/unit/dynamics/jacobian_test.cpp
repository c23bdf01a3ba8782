// mbd_solver/dynamics/jacobian.cpp: the analytic Jacobian of the whole system against differences of its residual.

#include "mbd_solver/dynamics/equations.h"
#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall {
namespace {

class JacobianOfRandomModel : public ::testing::TestWithParam<unsigned> {};

TEST_P(JacobianOfRandomModel, EqualsDifferencesOfTheResidual) {
  test::Random random(GetParam());
  const Model model = test::everything(random);
  for (const Baumgarte& baumgarte : {Baumgarte{}, Baumgarte{3.0, 4.0}}) {
    Equations equations(model, test::as_given(model), baumgarte);
    const Layout& layout = equations.layout();
    const Inputs inputs = test::random_inputs(random, model);
    Eigen::VectorXd y(layout.size());
    equations.pack(test::as_given(model).state, random.vector_x(layout.row_count, 5.0), y);
    // Quaternions off unit length too: derivatives along L must vanish there as well.
    for (int q : layout.body_q) y.segment<4>(q + 3) *= random.number(0.8, 1.2);
    const Eigen::VectorXd ydot = random.vector_x(layout.size(), 3.0);
    std::string where;
    EXPECT_LT(test::jacobian_error(equations, y, ydot, 7.0, inputs, &where), 2e-9) << where;
  }
}

INSTANTIATE_TEST_SUITE_P(Seeds, JacobianOfRandomModel, ::testing::Values(1u, 2u, 3u));

TEST(Jacobian, KeepsItsPatternAndItsPlace) {
  test::Random random(4);
  const Model model = test::everything(random);
  Equations equations(model, test::as_given(model));
  Eigen::VectorXd y(equations.layout().size());
  equations.pack(test::as_given(model).state, Eigen::VectorXd::Zero(equations.layout().row_count), y);
  const Inputs inputs = test::random_inputs(random, model);
  const double* values = equations.jacobian_pattern().valuePtr();
  const Eigen::Index entries = equations.jacobian_pattern().nonZeros();
  equations.jacobian(0.0, y, Eigen::VectorXd::Zero(y.size()), 10.0, inputs);
  EXPECT_EQ(equations.jacobian_pattern().valuePtr(), values);
  EXPECT_EQ(equations.jacobian_pattern().nonZeros(), entries);
}

TEST(Jacobian, MassTimesVectorIsItsDerivativeByRates) {
  test::Random random(5);
  const Model model = test::everything(random);
  Equations equations(model, test::as_given(model));
  const int n = equations.layout().size();
  const Inputs inputs = test::random_inputs(random, model);
  Eigen::VectorXd y(n), F0(n), F1(n), product(n);
  equations.pack(test::as_given(model).state, random.vector_x(equations.layout().row_count), y);
  Eigen::VectorXd x = random.vector_x(n), ydot = random.vector_x(n);
  x.tail(equations.layout().row_count).setZero();
  equations.residual(0.3, y, ydot, inputs, F0);
  equations.residual(0.3, y, ydot + x, inputs, F1);  // the residual is linear in ydot
  equations.apply_mass(y, x, 0.3, product);
  EXPECT_LT((F1 - F0 - product).norm(), 1e-11 * F1.norm());  // round-off of the difference
}

}  // namespace
}  // namespace footfall
