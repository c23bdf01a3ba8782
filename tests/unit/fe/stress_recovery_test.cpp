#include "mbd_solver/model/stress_recovery.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/pi.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/modal_basis.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::MatrixXd;
using Eigen::Vector3d;
using Eigen::VectorXd;

// A beam pulled at three points, P/2 up at the ends and P down in the middle: four sections, moment P L / 4
// in the middle, W = pi d^3/32.
TEST(VonMises, OfABeamInThreePointBendingIsMomentOverSectionModulus) {
  const double L = 1.0, d = 0.02, P = 100.0;
  const FeModel model = straight_beam({0, 0, 0}, {L, 0, 0}, 4, rod_section(d), kSteel);
  BasisOptions options;
  options.interface_nodes = {0, 2, 4};
  options.max_frequency = 1.0;  // the static shapes of three nodes alone
  const ModalBody body = reduce(model, options, "beam").body;
  const VectorXd Q = P * (0.5 * body.Phi.row(2) - body.Phi.row(3 * 2 + 2) + 0.5 * body.Phi.row(3 * 4 + 2)).transpose();
  const VectorXd a = Q.cwiseQuotient(body.stiffness);
  const double exact = P * L / 4.0 / (kPi * d * d * d / 32.0);
  const double round_off = 1e-7;  // of stiffness; the static shapes are exact
  EXPECT_NEAR(von_mises(body, a), exact, round_off * exact);
  const VectorXd cells = von_mises_of_cells(body, a);
  ASSERT_EQ(cells.size(), 8);
  EXPECT_NEAR(cells(3), exact, round_off * exact) << "left of the middle";
  EXPECT_NEAR(cells(0), 0.25 * exact, round_off * exact) << "moment grows linearly from the end";
  // Middle against ends: P L^3 / (48 EI); the largest deflection in mean axes is a part of it.
  const double sag = P * L * L * L / (48.0 * kSteel.young * kPi * std::pow(d, 4) / 64.0);
  const VectorXd u = body.Phi * a;
  EXPECT_NEAR(u(2) - u(3 * 2 + 2), sag, round_off * sag);
  EXPECT_NEAR(largest_deflection(body, a), std::max(std::abs(u(2)), std::abs(u(3 * 2 + 2))), round_off * sag);
}

TEST(VonMises, CombinesBendingAndTorsionShear) {
  ModalBody body;
  body.rho0 = Eigen::Matrix3Xd::Zero(3, 1);
  body.Phi = MatrixXd::Zero(3, 1);
  body.Phi(1, 0) = 0.5;
  body.stiffness = VectorXd::Ones(1);
  body.stress_modes.resize(12, 1);
  body.stress_modes << 3.0, 0.0, 0.0, 2.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0;
  const VectorXd points = von_mises_of_points(body, VectorXd::Constant(1, 2.0));
  EXPECT_DOUBLE_EQ(points(0), 2.0 * std::sqrt(9.0 + 3.0 * 4.0));
  EXPECT_NEAR(points(1), 0.0, 1e-15) << "hydrostatic stress does not count";
  EXPECT_DOUBLE_EQ(largest_deflection(body, VectorXd::Constant(1, -2.0)), 1.0);
  EXPECT_EQ(von_mises_of_cells(body, VectorXd::Ones(1)).size(), 0) << "points that belong to no cell";
  body.stress_modes.resize(0, 1);
  EXPECT_EQ(von_mises(body, VectorXd::Ones(1)), 0.0);
}

// Clamped round plate under pressure: at the rim the radial stress is 3 p R^2 / (4 t^2), at the centre 3 (1 +
// nu) p R^2 / (8 t^2) in both directions (so von Mises is the same).
TEST(PlateStress, UnderPressureIsThatOfTheClampedPlate) {
  const double R = 0.2, t = 0.004, p = 1e4, nu = kSteel.poisson;
  const int n = 16;
  const FeModel model = plate_model(disc_mesh(R, R / n), t, kSteel);
  std::vector<int> rim;
  for (int j = model.node_count() - 6 * n; j < model.node_count(); ++j)
    for (int dof : node_dofs(j)) rim.push_back(dof);
  const VectorXd sigma = model.stress * static_solution(model, rim, pressure_load(model, p));
  const double centre = 3.0 * (1.0 + nu) * p * R * R / (8.0 * t * t);
  // The centroids of the six triangles at the centre, top (compressed: the pressure pushes down) and bottom.
  const double discretisation = 0.02;
  for (int triangle = 0; triangle < 6; ++triangle) {
    EXPECT_NEAR(sigma(12 * triangle), -centre, discretisation * centre);
    EXPECT_NEAR(sigma(12 * triangle + 1), -centre, discretisation * centre);
    EXPECT_NEAR(sigma(12 * triangle + 6), centre, discretisation * centre);
  }
}

}  // namespace
}  // namespace footfall
