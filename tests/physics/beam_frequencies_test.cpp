// Beams of the finite-element model against Euler and Bernoulli: frequencies, order of convergence, static
// deflection.

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "coupler/base/pi.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/modal_basis.h"

namespace footfall {
namespace {

using Eigen::Vector3d;
using Eigen::VectorXd;

const Material kSteel{7850.0, 207e9, 0.3};
constexpr double kLength = 1.0;  // [m]
// slender: rotary inertia, which the model has and the theory has not, is below 0.01 %
constexpr double kDiameter = 0.002;

// Roots beta L of the frequency equations, by bisection near (k + 1/2) pi or (k - 1/2) pi.
double root(const std::function<double(double)>& f, double low, double high) {
  for (int i = 0; i < 200; ++i) {
    const double middle = 0.5 * (low + high);
    (f(low) * f(middle) <= 0.0 ? high : low) = middle;
  }
  return 0.5 * (low + high);
}

double free_free_root(int k) {  // cos x cosh x = 1
  return root([](double x) { return std::cos(x) - 1.0 / std::cosh(x); }, (k + 0.5) * kPi - 0.5, (k + 0.5) * kPi + 0.5);
}
double cantilever_root(int k) {  // cos x cosh x = -1
  return root([](double x) { return std::cos(x) + 1.0 / std::cosh(x); }, (k - 0.5) * kPi - 0.5, (k - 0.5) * kPi + 0.5);
}
double pinned_root(int k) { return k * kPi; }

enum class Support { kFree, kCantilever, kPinned };

double exact_frequency(Support support, int k, const BeamSection& s) {
  const double x = support == Support::kFree         ? free_free_root(k)
                   : support == Support::kCantilever ? cantilever_root(k)
                                                     : pinned_root(k);
  return x * x / (2.0 * kPi * kLength * kLength) * std::sqrt(kSteel.young * s.bending_y / (kSteel.density * s.area));
}

// The first five bending frequencies; every one comes twice, for y and z.
VectorXd computed(Support support, int elements, const BeamSection& section) {
  const Vector3d end = kLength * Vector3d(2.0, -1.0, 2.0) / 3.0;  // any direction
  const FeModel model = straight_beam(Vector3d::Zero(), end, elements, section, kSteel);
  std::vector<int> fixed;
  if (support == Support::kCantilever) fixed = node_dofs(0);
  if (support == Support::kPinned) {
    fixed = node_dofs(0, {0, 1, 2});
    for (int dof : node_dofs(elements, {0, 1, 2})) fixed.push_back(dof);
  }
  // What these supports leave free besides bending: six rigid motions, or the turn about the axis.
  const int rigid = support == Support::kFree ? 6 : support == Support::kPinned ? 1 : 0;
  const VectorXd f = natural_frequencies(model, fixed, rigid + 10);
  VectorXd result(5);
  for (int k = 0; k < 5; ++k) result(k) = f(rigid + 2 * k);
  return result;
}

TEST(BeamFrequencies, OfFreeCantileverAndPinnedBeamsAreEulerBernoullis) {
  const double tolerance = 1e-3;  // asked for: 0.1 %
  const BeamSection section = rod_section(kDiameter);
  for (Support support : {Support::kFree, Support::kCantilever, Support::kPinned}) {
    const VectorXd f = computed(support, 12, section);
    for (int k = 1; k <= 5; ++k) {
      const double exact = exact_frequency(support, k, section);
      EXPECT_NEAR(f(k - 1), exact, tolerance * exact) << "support " << static_cast<int>(support) << " mode " << k;
      std::printf("  support %d mode %d: %.6g Hz, relative error %+.2e\n", static_cast<int>(support), k, f(k - 1),
                  f(k - 1) / exact - 1.0);
    }
  }
}

TEST(BeamFrequencies, OfAFlexibleBodyWithFreeModesAreEulerBernoullis) {
  const BeamSection section = rod_section(kDiameter);
  BasisOptions options;
  options.kind = BasisKind::kFreeFree;
  options.mode_count = 10;
  const FeModel model = straight_beam(Vector3d::Zero(), Vector3d(0, 0, kLength), 12, section, kSteel);
  const VectorXd f = frequencies(reduce(model, options, "beam").body);
  for (int k = 1; k <= 5; ++k) {
    const double exact = exact_frequency(Support::kFree, k, section);
    EXPECT_NEAR(f(2 * k - 2), exact, 1e-3 * exact);
    EXPECT_NEAR(f(2 * k - 1), exact, 1e-3 * exact) << "the same in the other plane";
  }
}

// Simpson's lumping: error ~ h^4. From the differences of three meshes, so that rotary inertia, the same in
// all, does not matter.
TEST(BeamFrequencies, ConvergeWithTheFourthPowerOfTheElementLength) {
  const BeamSection section = rod_section(0.01);
  for (Support support : {Support::kFree, Support::kCantilever, Support::kPinned})
    for (int mode : {1, 2}) {
      const double f12 = computed(support, 12, section)(mode);
      const double f24 = computed(support, 24, section)(mode);
      const double f48 = computed(support, 48, section)(mode);
      const double order = std::log2((f12 - f24) / (f24 - f48));
      std::printf("  support %d mode %d: order %.2f\n", static_cast<int>(support), mode + 1, order);
      EXPECT_GT(order, 3.5);
      EXPECT_LT(order, 4.5);
    }
}

TEST(BeamFrequencies, OfAxialAndTorsionalVibrationAreThoseOfTheRod) {
  const FeModel model = straight_beam(Vector3d::Zero(), Vector3d(kLength, 0, 0), 16, rod_section(0.02), kSteel);
  std::vector<int> bending;  // held, so that only stretch and twist are left
  for (int j = 0; j < model.node_count(); ++j)
    for (int dof : node_dofs(j, {1, 2, 4, 5})) bending.push_back(dof);
  const VectorXd f = natural_frequencies(model, bending, 4);
  const double torsion = std::sqrt(kSteel.shear_modulus() / kSteel.density) / (2.0 * kLength);
  const double axial = std::sqrt(kSteel.young / kSteel.density) / (2.0 * kLength);
  const double lumping = 2e-3;  // (k h)^2 / 12 of two-node elements
  EXPECT_NEAR(f(2), torsion, lumping * torsion);
  EXPECT_NEAR(f(3), axial, lumping * axial);
}

TEST(BeamDeflection, UnderPointLoadsIsExactAtTheNodes) {
  const BeamSection s = rod_section(0.01);
  const double P = 10.0, EI = kSteel.young * s.bending_y, L = kLength;
  const double round_off = 1e-8;  // the stiffness of short elements is 1e6 times that of the beam
  const int n = 10;
  const FeModel model = straight_beam(Vector3d::Zero(), Vector3d(L, 0, 0), n, s, kSteel);
  VectorXd load = VectorXd::Zero(6 * model.node_count());
  load(6 * n + 2) = P;
  const VectorXd cantilever = static_solution(model, node_dofs(0), load);
  EXPECT_NEAR(cantilever(6 * n + 2), P * L * L * L / (3.0 * EI), round_off * P / EI);
  EXPECT_NEAR(cantilever(6 * (n / 2) + 2), 5.0 * P * L * L * L / (48.0 * EI), round_off * P / EI);

  std::vector<int> pins = node_dofs(0, {0, 1, 2, 3});
  for (int dof : node_dofs(n, {1, 2})) pins.push_back(dof);
  load.setZero();
  load(6 * (n / 2) + 2) = P;
  EXPECT_NEAR(static_solution(model, pins, load)(6 * (n / 2) + 2), P * L * L * L / (48.0 * EI), round_off * P / EI);
}

// The load per length of its own weight, lumped at the nodes as the mass is: q L^4 / (8 EI) and 5 q L^4 /
// (384 EI).
TEST(BeamDeflection, UnderItsWeightConvergesToTheDistributedLoad) {
  const BeamSection s = rod_section(0.01);
  const double g = 9.81, L = kLength, q = kSteel.density * s.area * g, EI = kSteel.young * s.bending_y;
  const int n = 8;
  const FeModel model = straight_beam(Vector3d::Zero(), Vector3d(L, 0, 0), n, s, kSteel);
  VectorXd load = VectorXd::Zero(6 * model.node_count());
  for (int j = 0; j < model.node_count(); ++j) load(6 * j + 2) = g * model.node_mass(j);
  const double simpson = 1e-4;  // error h^4 / 2880 times a fourth derivative of order one
  const double cantilever = q * std::pow(L, 4) / (8.0 * EI);
  EXPECT_NEAR(static_solution(model, node_dofs(0), load)(6 * n + 2), cantilever, simpson * cantilever);
  std::vector<int> pins = node_dofs(0, {0, 1, 2, 3});
  for (int dof : node_dofs(n, {1, 2})) pins.push_back(dof);
  const double pinned = 5.0 * q * std::pow(L, 4) / (384.0 * EI);
  EXPECT_NEAR(static_solution(model, pins, load)(6 * (n / 2) + 2), pinned, simpson * pinned);
}

}  // namespace
}  // namespace footfall
