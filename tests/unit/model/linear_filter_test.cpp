// Filters against their transfer functions and step answers.

#include "mbd_solver/model/signals/linear_filter.h"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"

namespace footfall {
namespace {

using Complex = std::complex<double>;

constexpr double kFrequency = 5.0, kDamping = 0.3;  // [Hz], [-]
constexpr double kOmega = 2.0 * kPi * kFrequency;

// c (s - A)^-1 b + d, with A, b, c, d found by asking for unit inputs and states.
Complex response(const LinearFilter& filter, const Complex& s) {
  const int n = filter.state_count();
  const Eigen::VectorXd no_input = Eigen::VectorXd::Zero(1), unit_input = Eigen::VectorXd::Ones(1);
  const Eigen::VectorXd no_state = Eigen::VectorXd::Zero(n);
  Eigen::VectorXd rates(n), b(n), c(n);
  Eigen::MatrixXd A(n, n);
  filter.rates(unit_input, no_state, b);
  for (int j = 0; j < n; ++j) {
    filter.rates(no_input, Eigen::VectorXd::Unit(n, j), rates);
    A.col(j) = rates;
    c[j] = filter.value(no_input, Eigen::VectorXd::Unit(n, j));
  }
  const double d = filter.value(unit_input, no_state);
  const Eigen::MatrixXcd M = s * Eigen::MatrixXcd::Identity(n, n) - A.cast<Complex>();
  return (c.cast<Complex>().transpose() * M.partialPivLu().solve(b.cast<Complex>()))(0) + d;
}

constexpr double kRoundOff = 1e-12;

TEST(LinearFilter, HasItsTransferFunction) {
  const LinearFilter first = LinearFilter::low_pass(kFrequency, 0.0),
                     second = LinearFilter::low_pass_2(kFrequency, kDamping, 0.0),
                     notch = LinearFilter::notch(kFrequency, kDamping, 0.0);
  const double w = kOmega;
  for (const double f : {0.1, 1.0, 4.0, 5.0, 6.0, 50.0}) {
    const Complex s(0.0, 2.0 * kPi * f), below = s * s + 2.0 * kDamping * w * s + w * w;
    EXPECT_LT(std::abs(response(first, s) - 1.0 / (1.0 + s / w)), kRoundOff) << f;
    EXPECT_LT(std::abs(response(second, s) - w * w / below), kRoundOff) << f;
    EXPECT_LT(std::abs(response(notch, s) - (s * s + w * w) / below), kRoundOff) << f;
  }
}

// The step answer of a filter of second order, from the roots of its polynomial.
double step_2(double t) {
  const double sigma = kDamping * kOmega, wd = kOmega * std::sqrt(1.0 - kDamping * kDamping);
  return 1.0 - std::exp(-sigma * t) * (std::cos(wd * t) + sigma / wd * std::sin(wd * t));
}
double bump_2(double t) {  // of w s / (s^2 + 2 D w s + w^2)
  const double sigma = kDamping * kOmega, wd = kOmega * std::sqrt(1.0 - kDamping * kDamping);
  return kOmega / wd * std::exp(-sigma * t) * std::sin(wd * t);
}

TEST(LinearFilter, SampledAnswersAStepExactly) {
  const double T = 0.013;  // [s]: coarse on purpose
  const LinearFilter first = LinearFilter::low_pass(kFrequency, T),
                     second = LinearFilter::low_pass_2(kFrequency, kDamping, T),
                     notch = LinearFilter::notch(kFrequency, kDamping, T);
  const Eigen::VectorXd one = Eigen::VectorXd::Ones(1);
  Eigen::VectorXd z1 = Eigen::VectorXd::Zero(1), z2 = Eigen::VectorXd::Zero(2), z3 = z2;
  for (int k = 0; k < 100; ++k) {
    const double t = k * T;
    EXPECT_NEAR(first.sample(one, T, z1), -std::expm1(-kOmega * t), kRoundOff);
    EXPECT_NEAR(second.sample(one, T, z2), step_2(t), kRoundOff);
    EXPECT_NEAR(notch.sample(one, T, z3), 1.0 - 2.0 * kDamping * bump_2(t), kRoundOff);
  }
}

TEST(LinearFilter, SettledAnswersItsInput) {
  for (const LinearFilter& filter :
       {LinearFilter::low_pass(kFrequency, 0.0), LinearFilter::low_pass_2(kFrequency, kDamping, 0.0),
        LinearFilter::notch(kFrequency, kDamping, 0.0)}) {
    const Eigen::VectorXd u = Eigen::VectorXd::Constant(1, 3.5);
    Eigen::VectorXd z(filter.state_count()), dz(filter.state_count());
    filter.settle(u, z);
    filter.rates(u, z, dz);
    EXPECT_DOUBLE_EQ(filter.value(u, z), 3.5);
    EXPECT_LT(dz.norm(), kRoundOff);
  }
}

TEST(LinearFilter, RefusesWhatIsNoFilter) {
  EXPECT_THROW(LinearFilter::low_pass(0.0, 0.0), InputError);
  EXPECT_THROW(LinearFilter::notch(1.0, -1.0, 0.0), InputError);
}

}  // namespace
}  // namespace footfall
