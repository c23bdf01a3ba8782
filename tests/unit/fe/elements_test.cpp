// Beam and plate elements and their stresses.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/elements.h"
#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/fe_model.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/fe/modal_basis.h"
#include "mbd_solver/model/modal_body.h"
#include "tests/support/fe_reference.h"
#include "tests/support/linear_algebra.h"
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
  return test::solve(K, load);
}

TEST(BeamElement, CantileverBendsStretchesAndTwistsAsTheTextbookSays) {
  const double L = 0.7, P = 120.0;
  const BeamSection s = general_section(6e-4, 4.5e-8, 2e-8, 4.7e-8, 0.015);
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

TEST(BeamSection, RefusesWhatIsNoSection) {
  EXPECT_THROW(tube_section(0.09, 0.045), InputError);
  EXPECT_THROW(tube_section(0.09, 0.0), InputError);
  EXPECT_THROW(rod_section(-1.0), InputError);
  EXPECT_THROW(rod_section(std::nan("")), InputError);
  EXPECT_THROW(general_section(1e-4, 1e-8, 1e-8, 0.0, 0.01), InputError);
  EXPECT_THROW(check(Material{7850.0, 207e9, 0.5}), InputError);
  EXPECT_THROW(check(Material{0.0, 207e9, 0.3}), InputError);
}

using Eigen::VectorXd;
using Vector18d = Eigen::Matrix<double, 18, 1>;

const Material kAluminium{2700.0, 70e9, 0.33};
constexpr double kThickness = 0.01;

const Vector3d kCorner[3] = {Vector3d(0.1, 0.2, -0.1), Vector3d(0.9, 0.3, 0.3), Vector3d(0.2, 1.1, 0.5)};

TEST(PlateElement, OnlyTheSixRigidMotionsMeetNoForce) {
  const PlateElement element(kCorner[0], kCorner[1], kCorner[2], kThickness, kAluminium);
  const Matrix18d K = element.stiffness();
  EXPECT_LT((K - K.transpose()).norm(), kFeRoundOff * K.norm());
  for (int k = 0; k < 6; ++k) {
    Vector18d u = Vector18d::Zero();
    for (int i = 0; i < 3; ++i) {
      u.segment<3>(6 * i) = k < 3 ? Vector3d(Vector3d::Unit(k)) : Vector3d(Vector3d::Unit(k - 3).cross(kCorner[i]));
      if (k >= 3) u(6 * i + k) = 1.0;
    }
    EXPECT_LT((K * u).norm(), kFeRoundOff * K.norm());
    EXPECT_LT((element.stress() * u).norm(), kFeRoundOff * element.stress().norm());
  }
  const VectorXd values = test::symmetric_modes(K).values;
  EXPECT_LT(values.head<6>().cwiseAbs().maxCoeff(), 1e-11 * values(17));
  EXPECT_GT(values(6), 1e-8 * values(17))
      << "the softest strain is bending, (thickness/size)^2 of the membrane's stiffness";
}

TEST(PlateElement, DoesNotDependOnTheOrderOfItsCorners) {
  const PlateElement a(kCorner[0], kCorner[1], kCorner[2], kThickness, kAluminium);
  const PlateElement b(kCorner[1], kCorner[2], kCorner[0], kThickness, kAluminium);
  Matrix18d P = Matrix18d::Zero();  // corner i of b is corner i + 1 of a
  for (int i = 0; i < 3; ++i) P.block<6, 6>(6 * i, 6 * ((i + 1) % 3)).setIdentity();
  EXPECT_LT((P.transpose() * b.stiffness() * P - a.stiffness()).norm(), kFeRoundOff * a.stiffness().norm());
}

// An irregular patch in the xy plane: four corners and one node off the centre.
TriangleMesh patch() {
  TriangleMesh mesh;
  mesh.vertices = {{0, 0, 0}, {2, 0.1, 0}, {2.2, 1.4, 0}, {-0.1, 1, 0}, {0.8, 0.45, 0}};
  mesh.triangles = {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
  return mesh;
}

// Displacement and rotation (1/2 curl) fields given as functions; the inner node is left free.
VectorXd patch_solution(const FeModel& model,
                        const std::function<Eigen::Matrix<double, 6, 1>(const Vector3d&)>& field) {
  // The held values enter as loads: K_ii u_i = -K_ib u_b.
  VectorXd held = VectorXd::Zero(30);
  std::vector<int> fixed;
  for (int j = 0; j < 4; ++j) {
    held.segment<6>(6 * j) = field(model.nodes.col(j));
    for (int dof : test::node_dofs(j)) fixed.push_back(dof);
  }
  return held + static_solution(model, fixed, -model.stiffness * held);
}

TEST(PlateElement, PassesThePatchTestOfConstantCurvatureAndConstantStrain) {
  const FeModel model = plate_model(patch(), kThickness, kAluminium);
  const double E = kAluminium.young, nu = kAluminium.poisson;
  // w = (a x^2 + b y^2)/2 + c x y with rotations (w_y, -w_x); u = e x + g y, v = f y + g x: no mean rotation.
  const double a = 0.02, b = -0.03, c = 0.01, e = 1e-4, f = -2e-4, g = 3e-4;
  const auto field = [&](const Vector3d& p) {
    Eigen::Matrix<double, 6, 1> u;
    u << e * p.x() + g * p.y(), f * p.y() + g * p.x(),
        0.5 * (a * p.x() * p.x() + b * p.y() * p.y()) + c * p.x() * p.y(), b * p.y() + c * p.x(),
        -(a * p.x() + c * p.y()), 0.0;
    return u;
  };
  const VectorXd u = patch_solution(model, field);
  EXPECT_LT((u.segment<6>(24) - field(model.nodes.col(4))).norm(), kFeRoundOff * u.norm());

  // Stress in the elements' own axes, turned back into x and y; strain of the surface z = +-t/2 is -z w'' +
  // membrane.
  const VectorXd sigma = model.stress * u;
  for (int point = 0; point < 8; ++point) {
    const double z = (point % 2 == 0 ? 0.5 : -0.5) * kThickness;
    Eigen::Matrix2d strain, exact;
    strain << e - z * a, g - z * c, g - z * c, f - z * b;
    exact = E / (1.0 - nu * nu) * ((1.0 - nu) * strain + nu * strain.trace() * Eigen::Matrix2d::Identity());
    const Eigen::Vector3i corner = model.triangles[static_cast<std::size_t>(point / 2)];
    const PlateElement element(model.nodes.col(corner(0)), model.nodes.col(corner(1)), model.nodes.col(corner(2)),
                               kThickness, kAluminium);
    const Eigen::VectorXd s = sigma.segment(6 * point, 6);
    Matrix3d own;
    own << s(0), s(3), s(5), s(3), s(1), s(4), s(5), s(4), s(2);
    const Matrix3d turned = element.axes() * own * element.axes().transpose();
    EXPECT_LT((turned.topLeftCorner<2, 2>() - exact).norm(), 1e-11 * exact.norm());
  }
}

// Constant curvature, w = 1/2 (k_x x^2 + k_y y^2) + k_xy x y, stores 1/2 A E t^3 / (12 (1 - nu^2)) (k_x^2 + k_y^2 + 2 nu k_x k_y + 2 (1 - nu) k_xy^2).
TEST(PlateElement, StoresTheExactEnergyOfConstantCurvature) {
  const double t = 0.01, area = 0.5 * (1.3 * 0.8 - 0.2 * 0.1);
  const Vector3d corners[3] = {{0, 0, 0}, {1.3, 0.1, 0}, {0.2, 0.8, 0}};
  for (const double nu : {0.0, 0.33}) {
    const Material material{1.0, 1e9, nu};
    const Matrix18d K = PlateElement(corners[0], corners[1], corners[2], t, material).stiffness();
    for (const Vector3d& k : {Vector3d(1e-3, 0, 0), Vector3d(0, 1e-3, 0), Vector3d(2e-3, 1e-3, -1e-3)}) {
      Vector18d u = Vector18d::Zero();
      for (int i = 0; i < 3; ++i) {
        const double x = corners[i].x(), y = corners[i].y();
        u(6 * i + 2) = 0.5 * (k[0] * x * x + k[1] * y * y) + k[2] * x * y;
        u(6 * i + 3) = k[1] * y + k[2] * x;     // dw/dy
        u(6 * i + 4) = -(k[0] * x + k[2] * y);  // -dw/dx
      }
      const double squares = k[0] * k[0] + k[1] * k[1] + 2.0 * nu * k[0] * k[1] + 2.0 * (1.0 - nu) * k[2] * k[2];
      const double exact = 0.5 * area * material.young * t * t * t / (12.0 * (1.0 - nu * nu)) * squares;
      EXPECT_NEAR(0.5 * u.dot(K * u), exact, 1e-11 * exact) << "nu " << nu << " curvature " << k.transpose();
    }
  }
}

// Felippa's optimality: a rectangle of any side ratio, made of two overlaid pairs of half-thickness
// triangles, stores exactly the energy of in-plane bending, 1/2 E kappa^2 I a.
TEST(PlateElement, MembraneStoresTheExactEnergyOfInPlaneBendingAtAnySideRatio) {
  const double kappa = 1e-3, t = 0.01;
  const int pairs[4][3] = {{0, 1, 2}, {0, 2, 3}, {0, 1, 3}, {1, 2, 3}};
  for (const double nu : {0.0, 0.1, 0.33})
    for (const double ratio : {0.1, 1.0, 10.0}) {
      const Material material{1.0, 1e9, nu};
      const double a = ratio, b = 1.0;
      const Vector3d p[4] = {{-a / 2, -b / 2, 0}, {a / 2, -b / 2, 0}, {a / 2, b / 2, 0}, {-a / 2, b / 2, 0}};
      double energy = 0.0;
      for (const auto& corner : pairs) {
        const PlateElement element(p[corner[0]], p[corner[1]], p[corner[2]], 0.5 * t, material);
        Vector18d u = Vector18d::Zero();
        for (int i = 0; i < 3; ++i) {
          const double x = p[corner[i]].x(), y = p[corner[i]].y();
          u(6 * i) = kappa * x * y;
          u(6 * i + 1) = -0.5 * kappa * (x * x + nu * y * y);
          u(6 * i + 5) = -kappa * x;
        }
        energy += 0.5 * u.dot(element.stiffness() * u);
      }
      const double exact = 0.5 * material.young * kappa * kappa * t * b * b * b / 12.0 * a;
      EXPECT_NEAR(energy, exact, 1e-11 * exact) << "nu " << nu << " ratio " << ratio;
    }
}

using Eigen::MatrixXd;

// A beam pulled at three points, P/2 up at the ends and P down in the middle: four sections, moment P L / 4
// in the middle, W = pi d^3/32.
TEST(VonMises, OfABeamInThreePointBendingIsMomentOverSectionModulus) {
  const double L = 1.0, d = 0.02, P = 100.0;
  const FeModel model = test::straight_beam({0, 0, 0}, {L, 0, 0}, 4, rod_section(d), kSteel);
  BasisOptions options;
  options.interface_nodes = {0, 2, 4};
  options.max_frequency = 1.0;  // the static shapes of three nodes alone
  const ModalBody body = reduce(model, options, "beam").body;
  const VectorXd Q = P * (0.5 * body.Phi.row(2) - body.Phi.row(3 * 2 + 2) + 0.5 * body.Phi.row(3 * 4 + 2)).transpose();
  const VectorXd a = Q.cwiseQuotient(body.stiffness);
  const double exact = P * L / 4.0 / (kPi * d * d * d / 32.0);
  const double round_off = 1e-7;  // of stiffness; the static shapes are exact
  EXPECT_NEAR(LargestStress(body).at(a), exact, round_off * exact);
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

TEST(VonMises, LargestIsTheLargestOfAllPoints) {
  ModalBody body;
  body.stiffness = VectorXd::Ones(5);
  body.stress_modes = MatrixXd::Random(6 * 40, 5);
  LargestStress largest(body);
  for (int i = 0; i < 200; ++i) {
    const VectorXd a = VectorXd::Random(5);
    const double exact = von_mises_of_points(body, a).maxCoeff();
    ASSERT_NEAR(largest.at(a), exact, 1e-14 * exact) << i;
  }
  EXPECT_EQ(largest.at(VectorXd::Zero(5)), 0.0);
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
  EXPECT_EQ(LargestStress(body).at(VectorXd::Ones(1)), 0.0);
}

// Clamped round plate under pressure: at the rim the radial stress is 3 p R^2 / (4 t^2), at the centre 3 (1 +
// nu) p R^2 / (8 t^2) in both directions (so von Mises is the same).
TEST(PlateStress, UnderPressureIsThatOfTheClampedPlate) {
  const double R = 0.2, t = 0.004, p = 1e4, nu = kSteel.poisson;
  const int n = 16;
  const FeModel model = plate_model(disc_mesh(R, R / n), t, kSteel);
  std::vector<int> rim;
  for (int j = model.node_count() - 6 * n; j < model.node_count(); ++j)
    for (int dof : test::node_dofs(j)) rim.push_back(dof);
  const VectorXd sigma = model.stress * static_solution(model, rim, test::pressure_load(model, p));
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
