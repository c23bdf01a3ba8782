#include "mbd_solver/fe/beam_element.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/fe/element_axes.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Matrix3d;
using Eigen::Vector3d;
using Vector12d = Eigen::Matrix<double, 12, 1>;

// Displacements of the free end of a cantilever (first end held) under forces and moments there.
Eigen::Matrix<double, 6, 1> tip(double length, const BeamSection& section, const Eigen::Matrix<double, 6, 1>& load) {
  const Eigen::Matrix<double, 6, 6> K = beam_stiffness(length, section, kSteel).bottomRightCorner<6, 6>();
  return K.ldlt().solve(load);
}

TEST(BeamElement, CantileverBendsStretchesAndTwistsAsTheTextbookSays) {
  const double L = 0.7, P = 120.0;
  const BeamSection s = rectangle_section(0.02, 0.03);
  const double E = kSteel.young, G = kSteel.shear_modulus();
  for (int axis = 0; axis < 6; ++axis) {
    Eigen::Matrix<double, 6, 1> load = Eigen::Matrix<double, 6, 1>::Zero();
    load(axis) = P;
    const Eigen::Matrix<double, 6, 1> u = tip(L, s, load);
    Eigen::Matrix<double, 6, 1> exact = Eigen::Matrix<double, 6, 1>::Zero();
    if (axis == 0) exact(0) = P * L / (E * s.area);
    if (axis == 1) exact(1) = P * L * L * L / (3.0 * E * s.bending_z), exact(5) = P * L * L / (2.0 * E * s.bending_z);
    if (axis == 2) exact(2) = P * L * L * L / (3.0 * E * s.bending_y), exact(4) = -P * L * L / (2.0 * E * s.bending_y);
    if (axis == 3) exact(3) = P * L / (G * s.torsion);
    if (axis == 4) exact(4) = P * L / (E * s.bending_y), exact(2) = -P * L * L / (2.0 * E * s.bending_y);
    if (axis == 5) exact(5) = P * L / (E * s.bending_z), exact(1) = P * L * L / (2.0 * E * s.bending_z);
    EXPECT_LT((u - exact).norm(), kFeRoundOff * exact.norm()) << "load " << axis;
  }
}

TEST(BeamElement, RigidMotionMeetsNoForceAndNoStressInAnyOrientation) {
  const Vector3d from(0.3, -0.2, 0.5), to(-0.4, 0.6, 0.9);
  const double L = (to - from).norm();
  const BeamSection section = tube_section(0.06, 0.004);
  const Matrix3d R = beam_axes(from, to);
  const Matrix12d K = turned_stiffness(beam_stiffness(L, section, kSteel), R);
  const BeamStressMatrix S = turned_stress(beam_stress(L, section, kSteel), R);
  for (int k = 0; k < 6; ++k) {
    Vector12d u = Vector12d::Zero();
    for (int end = 0; end < 2; ++end) {
      if (k < 3) {
        u(6 * end + k) = 1.0;
      } else {
        u.segment<3>(6 * end) = Vector3d::Unit(k - 3).cross(end == 0 ? from : to);
        u(6 * end + k) = 1.0;
      }
    }
    EXPECT_LT((K * u).norm(), kFeRoundOff * K.norm());
    EXPECT_LT((S * u).norm(), kFeRoundOff * S.norm());
  }
  EXPECT_LT((K - K.transpose()).norm(), kFeRoundOff * K.norm());
}

TEST(BeamElement, AxesAreARightHandedFrameThatFollowsTheHint) {
  for (const Vector3d& to : {Vector3d(1, 0, 0), Vector3d(0, 0, 2), Vector3d(-0.3, 0.4, -0.1)}) {
    const Matrix3d R = beam_axes(Vector3d::Zero(), to);
    EXPECT_LT((R.transpose() * R - Matrix3d::Identity()).norm(), kFeRoundOff);
    EXPECT_NEAR(R.determinant(), 1.0, kFeRoundOff);
    EXPECT_LT((R.col(0) - to.normalized()).norm(), kFeRoundOff);
  }
  const Matrix3d R = beam_axes(Vector3d::Zero(), Vector3d(2, 0, 0), Vector3d(0.7, 1, 0));
  EXPECT_LT((R.col(2) - Vector3d::UnitY()).norm(), kFeRoundOff) << "z goes up as far as x allows";
}

TEST(BeamElement, StressOfTheOuterFibreIsMomentOverSectionModulus) {
  const double L = 0.5, P = 300.0, T = 40.0, N = 2000.0;
  const double d = 0.03;
  const BeamSection s = rod_section(d);
  Vector12d u = Vector12d::Zero();
  Eigen::Matrix<double, 6, 1> load;
  load << N, P, 0.0, T, 0.0, 0.0;
  u.tail<6>() = tip(L, s, load);
  const Eigen::VectorXd sigma = beam_stress(L, s, kSteel) * u;
  const double W = kPi * d * d * d / 32.0;
  const double axial = N / s.area;
  // At the root the load along +y stretches the fibre at -y (point 2) and compresses the one at +y (point 0).
  EXPECT_NEAR(sigma(0), axial - P * L / W, kFeRoundOff * P * L / W);
  EXPECT_NEAR(sigma(6 * 2), axial + P * L / W, kFeRoundOff * P * L / W);
  for (int point = 0; point < kBeamStressPoints; ++point) {
    const double shear = std::hypot(sigma(6 * point + 3), sigma(6 * point + 5));
    EXPECT_NEAR(shear, T / (2.0 * W), kFeRoundOff * T / W);
  }
  for (int point = 4; point < 8; ++point) EXPECT_NEAR(sigma(6 * point), axial, kFeRoundOff * P * L / W) << "free end";
  // Torsion about +x moves material at +y towards +z.
  EXPECT_GT(sigma(5), 0.0);
}

TEST(BeamSection, TubesAndRodsHaveTheClosedFormConstants) {
  const BeamSection tube = tube_section(0.09, 0.005);
  EXPECT_NEAR(tube.area, kPi / 4.0 * (0.09 * 0.09 - 0.08 * 0.08), kFeRoundOff);
  EXPECT_NEAR(tube.bending_y, kPi / 64.0 * (std::pow(0.09, 4) - std::pow(0.08, 4)), kFeRoundOff);
  EXPECT_NEAR(tube.torsion, tube.bending_y + tube.bending_z, kFeRoundOff);
  EXPECT_NEAR(rod_section(0.05).area, kPi / 4.0 * 0.05 * 0.05, kFeRoundOff);
}

TEST(BeamSection, RectangularTorsionMatchesTheTable) {
  // Timoshenko's table: side ratio 1 (0.1406, 0.208), 2 (0.229, 0.246), 10 (0.312, 0.312)
  const double four_digits = 5e-4;
  const double b = 0.02;
  for (const auto& [ratio, alpha, beta] :
       {std::tuple{1.0, 0.1406, 0.208}, std::tuple{2.0, 0.229, 0.246}, std::tuple{10.0, 0.312, 0.312}})
    for (bool wide : {true, false}) {
      const BeamSection s = wide ? rectangle_section(ratio * b, b) : rectangle_section(b, ratio * b);
      EXPECT_NEAR(s.torsion / (ratio * b * b * b * b), alpha, four_digits);
      EXPECT_NEAR(s.torsion_modulus / (ratio * b * b * b), beta, four_digits);
    }
  EXPECT_TRUE(std::isfinite(rectangle_section(10.0, 0.001).torsion)) << "very flat";
}

TEST(BeamSection, RefusesWhatIsNoSection) {
  EXPECT_THROW(tube_section(0.09, 0.045), InputError);
  EXPECT_THROW(tube_section(0.09, 0.0), InputError);
  EXPECT_THROW(rod_section(-1.0), InputError);
  EXPECT_THROW(rectangle_section(0.1, std::nan("")), InputError);
  EXPECT_THROW(general_section(1e-4, 1e-8, 1e-8, 0.0, 0.01), InputError);
  EXPECT_THROW(check(Material{7850.0, 207e9, 0.5}), InputError);
  EXPECT_THROW(check(Material{0.0, 207e9, 0.3}), InputError);
}

}  // namespace
}  // namespace footfall
