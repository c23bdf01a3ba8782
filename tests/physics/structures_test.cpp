// Beams and plates: frequencies and deflections of theory.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <vector>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/modal_basis.h"
#include "tests/support/fe_reference.h"

namespace footfall {
namespace structures {

// Beams of the finite-element model against Euler and Bernoulli: frequencies, order of convergence, static
// deflection.

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
  const FeModel model = test::straight_beam(Vector3d::Zero(), end, elements, section, kSteel);
  std::vector<int> fixed;
  if (support == Support::kCantilever) fixed = test::node_dofs(0);
  if (support == Support::kPinned) {
    fixed = test::node_dofs(0, {0, 1, 2});
    for (int dof : test::node_dofs(elements, {0, 1, 2})) fixed.push_back(dof);
  }
  // What these supports leave free besides bending: six rigid motions, or the turn about the axis.
  const int rigid = support == Support::kFree ? 6 : support == Support::kPinned ? 1 : 0;
  const VectorXd f = test::natural_frequencies(model, fixed, rigid + 10);
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
  const FeModel model = test::straight_beam(Vector3d::Zero(), Vector3d(0, 0, kLength), 12, section, kSteel);
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
  const FeModel model = test::straight_beam(Vector3d::Zero(), Vector3d(kLength, 0, 0), 16, rod_section(0.02), kSteel);
  std::vector<int> bending;  // held, so that only stretch and twist are left
  for (int j = 0; j < model.node_count(); ++j)
    for (int dof : test::node_dofs(j, {1, 2, 4, 5})) bending.push_back(dof);
  const VectorXd f = test::natural_frequencies(model, bending, 4);
  const double torsion = std::sqrt(kSteel.shear_modulus() / kSteel.density) / (2.0 * kLength);
  const double axial = std::sqrt(kSteel.young / kSteel.density) / (2.0 * kLength);
  const double lumping = 2e-3;  // (k h)^2 / 12 of two-node elements
  EXPECT_NEAR(f(2), torsion, lumping * torsion);
  EXPECT_NEAR(f(3), axial, lumping * axial);
}

TEST(BeamDeflection, UnderPointLoadsIsExactAtTheNodes) {
  const BeamSection s = rod_section(0.01);
  const double P = 10.0, EI = kSteel.young * s.bending_y, L = kLength;
  const double round_off = 1e-8;  // short elements are 1e6 times as stiff as the beam
  const int n = 10;
  const FeModel model = test::straight_beam(Vector3d::Zero(), Vector3d(L, 0, 0), n, s, kSteel);
  VectorXd load = VectorXd::Zero(6 * model.node_count());
  load(6 * n + 2) = P;
  const VectorXd cantilever = static_solution(model, test::node_dofs(0), load);
  EXPECT_NEAR(cantilever(6 * n + 2), P * L * L * L / (3.0 * EI), round_off * P / EI);
  EXPECT_NEAR(cantilever(6 * (n / 2) + 2), 5.0 * P * L * L * L / (48.0 * EI), round_off * P / EI);

  std::vector<int> pins = test::node_dofs(0, {0, 1, 2, 3});
  for (int dof : test::node_dofs(n, {1, 2})) pins.push_back(dof);
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
  const FeModel model = test::straight_beam(Vector3d::Zero(), Vector3d(L, 0, 0), n, s, kSteel);
  VectorXd load = VectorXd::Zero(6 * model.node_count());
  for (int j = 0; j < model.node_count(); ++j) load(6 * j + 2) = g * model.node_mass(j);
  const double simpson = 1e-4;  // error h^4 / 2880 times a fourth derivative of order one
  const double cantilever = q * std::pow(L, 4) / (8.0 * EI);
  EXPECT_NEAR(static_solution(model, test::node_dofs(0), load)(6 * n + 2), cantilever, simpson * cantilever);
  std::vector<int> pins = test::node_dofs(0, {0, 1, 2, 3});
  for (int dof : test::node_dofs(n, {1, 2})) pins.push_back(dof);
  const double pinned = 5.0 * q * std::pow(L, 4) / (384.0 * EI);
  EXPECT_NEAR(static_solution(model, pins, load)(6 * (n / 2) + 2), pinned, simpson * pinned);
}

// Round plates of the finite-element model against Kirchhoff theory (Leissa, Vibration of Plates):
// frequencies, order of convergence, deflection under pressure and a point load.

const Material kAluminium{2700.0, 70e9, 0.33};
constexpr double kRadius = 0.2;       // [m]
constexpr double kThickness = 0.002;  // [m]

double rigidity() {
  return kAluminium.young * std::pow(kThickness, 3) / (12.0 * (1.0 - kAluminium.poisson * kAluminium.poisson));
}
// Frequency [Hz] of the parameter lambda^2 = omega R^2 sqrt(rho t / D).
double hertz(double lambda2) {
  return lambda2 / (2.0 * kPi * kRadius * kRadius) * std::sqrt(rigidity() / (kAluminium.density * kThickness));
}

// Bessel functions J_n and I_n with their derivatives.
struct Bessel {
  double value, slope;
};
Bessel bessel_j(int n, double x) {
  const double v = std::cyl_bessel_j(n, x);
  return {v, n == 0 ? -std::cyl_bessel_j(1, x) : std::cyl_bessel_j(n - 1, x) - n / x * v};
}
Bessel bessel_i(int n, double x) {
  const double v = std::cyl_bessel_i(n, x);
  return {v, n == 0 ? std::cyl_bessel_i(1, x) : std::cyl_bessel_i(n - 1, x) - n / x * v};
}

// w = (A J_n(lambda r) + B I_n(lambda r)) cos n phi. Clamped: w = dw/dr = 0.
double clamped_equation(int n, double x) {
  const Bessel J = bessel_j(n, x), I = bessel_i(n, x);
  return (J.value * I.slope - I.value * J.slope) / I.value;
}
// Free: bending moment M_r = 0 and edge force V_r = Q_r + dM_rt/(r dphi) = 0, each written for J (sign +1)
// and I (sign -1).
double free_equation(int n, double x) {
  const double nu = kAluminium.poisson;
  const auto moment = [&](const Bessel& Z, double sign) {
    return sign * x * x * Z.value + (1.0 - nu) * (x * Z.slope - n * n * Z.value);
  };
  const auto force = [&](const Bessel& Z, double sign) {
    return sign * x * x * x * Z.slope + (1.0 - nu) * n * n * (x * Z.slope - Z.value);
  };
  const Bessel J = bessel_j(n, x), I = bessel_i(n, x);
  return (moment(J, 1.0) * force(I, -1.0) - moment(I, -1.0) * force(J, 1.0)) / (I.value * x * x * x);
}

// The lowest `count` distinct lambda^2 over all numbers n of nodal diameters.
std::vector<double> exact_parameters(const std::function<double(int, double)>& equation, int count) {
  std::vector<double> result;
  for (int n = 0; n < 8; ++n) {
    const double step = 0.01;
    for (double x = 0.5; x < 9.0; x += step) {
      double low = x, high = x + step;
      if (equation(n, low) * equation(n, high) > 0.0) continue;
      for (int i = 0; i < 60; ++i) {
        const double middle = 0.5 * (low + high);
        (equation(n, low) * equation(n, middle) <= 0.0 ? high : low) = middle;
      }
      result.push_back(low * low);
    }
  }
  std::sort(result.begin(), result.end());
  result.resize(static_cast<std::size_t>(count));
  return result;
}

FeModel plate(int rings) { return plate_model(disc_mesh(kRadius, kRadius / rings), kThickness, kAluminium); }

std::vector<int> clamped_rim(const FeModel& model, int rings) {
  std::vector<int> fixed;
  for (int j = model.node_count() - 6 * rings; j < model.node_count(); ++j)
    for (int dof : test::node_dofs(j)) fixed.push_back(dof);
  return fixed;
}

// Of a list with pairs: the mean of those nearest to each wanted value, so that a split pair counts once.
VectorXd distinct(const VectorXd& f, const std::vector<int>& multiplicity) {
  VectorXd result(static_cast<Eigen::Index>(multiplicity.size()));
  Eigen::Index at = 0;
  for (std::size_t k = 0; k < multiplicity.size(); ++k) {
    result(static_cast<Eigen::Index>(k)) = f.segment(at, multiplicity[k]).mean();
    at += multiplicity[k];
  }
  return result;
}

// Nodal diameters 0, 1, 2, 0, 3 (clamped) and 2, 0, 3, 1, 4 (free): diameters make pairs.
const std::vector<int> kClampedPairs = {1, 2, 2, 1, 2};
const std::vector<int> kFreePairs = {2, 1, 2, 2, 2};

TEST(PlateTheory, ReproducesLeissasTables) {
  const std::vector<double> clamped = exact_parameters(clamped_equation, 5);
  const double four_digits = 6e-4;
  const double table[5] = {10.2158, 21.26, 34.88, 39.771, 51.04};
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(clamped[k] / table[k], 1.0, four_digits);
  const std::vector<double> free = exact_parameters(free_equation, 5);
  const double free_table[5] = {5.253, 9.084, 12.23, 20.52, 21.6};  // for nu = 0.33
  for (std::size_t k = 0; k < 5; ++k) EXPECT_NEAR(free[k] / free_table[k], 1.0, 4e-3) << "printed in mixed precision";
}

TEST(PlateFrequencies, OfTheClampedAndTheFreeRoundPlateAreWithinOnePercent) {
  const int rings = 14;
  const FeModel model = plate(rings);
  const double tolerance = 0.01;
  const std::vector<double> clamped = exact_parameters(clamped_equation, 5);
  const VectorXd fc = distinct(test::natural_frequencies(model, clamped_rim(model, rings), 8), kClampedPairs);
  // Free, as a flexible body is made.
  BasisOptions options;
  options.kind = BasisKind::kFreeFree;
  options.mode_count = 9;
  const std::vector<double> free = exact_parameters(free_equation, 5);
  const VectorXd ff = distinct(frequencies(reduce(model, options, "plate").body), kFreePairs);
  for (int k = 0; k < 5; ++k) {
    const double exact_c = hertz(clamped[static_cast<std::size_t>(k)]),
                 exact_f = hertz(free[static_cast<std::size_t>(k)]);
    std::printf("  mode %d: clamped %.5g Hz (%+.2e), free %.5g Hz (%+.2e)\n", k + 1, fc(k), fc(k) / exact_c - 1.0,
                ff(k), ff(k) / exact_f - 1.0);
    EXPECT_NEAR(fc(k), exact_c, tolerance * exact_c);
    EXPECT_NEAR(ff(k), exact_f, tolerance * exact_f);
  }
}

TEST(PlateFrequencies, ConvergeWithTheSquareOfTheEdgeLength) {
  const double clamped = hertz(exact_parameters(clamped_equation, 1)[0]);
  const double free = hertz(exact_parameters(free_equation, 1)[0]);
  const auto errors = [&](int rings) {
    const FeModel model = plate(rings);
    return std::pair{std::abs(test::natural_frequencies(model, clamped_rim(model, rings), 1)(0) / clamped - 1.0),
                     std::abs(test::natural_frequencies(model, {}, 7)(6) / free - 1.0)};
  };
  const auto [clamped_coarse, free_coarse] = errors(6);
  const auto [clamped_fine, free_fine] = errors(12);
  const double clamped_order = std::log2(clamped_coarse / clamped_fine),
               free_order = std::log2(free_coarse / free_fine);
  std::printf("  order: clamped %.2f, free %.2f\n", clamped_order, free_order);
  for (double order : {clamped_order, free_order}) {
    EXPECT_GT(order, 1.7);
    EXPECT_LT(order, 2.4);
  }
}

// Clamped: p R^4 / (64 D) under pressure, P R^2 / (16 pi D) under a load at the centre.
TEST(PlateDeflection, UnderPressureAndPointLoadIsThatOfTheClampedPlate) {
  const int rings = 14;
  const FeModel model = plate(rings);
  const std::vector<int> rim = clamped_rim(model, rings);
  const double p = 1000.0, P = 10.0, D = rigidity();
  const double pressed = -static_solution(model, rim, test::pressure_load(model, p))(2);
  VectorXd load = VectorXd::Zero(6 * model.node_count());
  load(2) = P;
  const double pushed = static_solution(model, rim, load)(2);
  const double exact_pressed = p * std::pow(kRadius, 4) / (64.0 * D),
               exact_pushed = P * kRadius * kRadius / (16.0 * kPi * D);
  std::printf("  pressure %+.2e, point load %+.2e\n", pressed / exact_pressed - 1.0, pushed / exact_pushed - 1.0);
  const double discretisation = 0.01;
  EXPECT_NEAR(pressed, exact_pressed, discretisation * exact_pressed);
  EXPECT_NEAR(pushed, exact_pushed, discretisation * exact_pushed);
}

}  // namespace structures
}  // namespace footfall
