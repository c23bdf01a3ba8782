// The coefficients: conditions of order, stiff accuracy, L-stability.

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <complex>

#include "mbd_solver/integrator/dense_step.h"
#include "mbd_solver/integrator/tableau.h"

namespace footfall {
namespace {

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
    const Eigen::MatrixXcd system = Eigen::MatrixXcd::Identity(s, s) - z * m.A.cast<std::complex<double>>();
    return std::abs(Eigen::VectorXcd(system.partialPivLu().solve(Eigen::VectorXcd::Ones(s)))(s - 1));
  };
  for (double y = 1e-2; y < 1e4; y *= 1.2) EXPECT_LT(growth({0.0, y}), 1.0 + 1e-12) << y;
  EXPECT_LT(growth({-1e8, 0.0}), 1e-6);
}

}  // namespace
}  // namespace footfall
