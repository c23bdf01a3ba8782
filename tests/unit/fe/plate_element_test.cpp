#include "mbd_solver/fe/plate_element.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <functional>
#include <vector>

#include "mbd_solver/fe/fe_analysis.h"
#include "mbd_solver/fe/fe_model.h"
#include "tests/unit/fe/steel_frame.h"

namespace footfall {
namespace {

using namespace test;

using Eigen::Matrix3d;
using Eigen::Vector3d;
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
  const VectorXd values = Eigen::SelfAdjointEigenSolver<Matrix18d>(K).eigenvalues();
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
    for (int dof : node_dofs(j)) fixed.push_back(dof);
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

}  // namespace
}  // namespace footfall
