// The three coordinates of a planar joint (mbd_solver/model/joints/joint_coordinate.h) with springs and dampers on each,
// against exact motions.

#include <gtest/gtest.h>

#include <cmath>
#include <unsupported/Eigen/MatrixFunctions>

#include "mbd_solver/model/elements/joint_force.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

constexpr double kPlanarTolerance = 1e-7;              // rtol of the runs is 1e-10, over some hundred steps
constexpr double kPuckMass = 2.0, kPuckInertia = 0.1;  // [kg], [kg m2]

void add_spring(Model& model, int joint, Coordinate coordinate, double stiffness, double damping) {
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(LinearSpringDamperParameters{stiffness, damping, 0.0, 0.0}));
  model.add_force(std::make_unique<JointForce>("spring_" + std::to_string(model.force_count()), model.joint(joint).m1,
                                               model.joint(joint).m2, coordinate, std::move(laws)));
}

Body puck() { return Body("puck", kPuckMass, kPuckInertia * Eigen::Matrix3d::Identity()); }

double planar_value(test::Run& run, const Model& model, int force) {
  run.equations.load(run.state);
  return static_cast<const JointForce&>(model.force(force))
      .sample(run.equations.element_input(force, run.state, run.inputs))
      .q;
}

class PlanarJoint : public ::testing::TestWithParam<const char*> {};

// On a ground that stands, at an oblique attitude: q = q'_0 / w sin(w t) in each coordinate, the angle over more than a turn.
TEST_P(PlanarJoint, SwingsInItsThreeCoordinatesApart) {
  test::Random random(5);
  const Eigen::Matrix3d axes = random.axes();
  const double k[3] = {0.4, 50.0, 18.0}, rate[3] = {20.0, 0.7, -1.3};
  const double inertia[3] = {kPuckInertia, kPuckMass, kPuckMass};
  BodyState state;
  state.w = rate[0] * axes.col(2);
  state.dr = rate[1] * axes.col(0) + rate[2] * axes.col(1);
  Model model;
  model.add_body(puck(), state);
  model.add_joint(planar_joint("table", ground_marker(Eigen::Vector3d::Zero(), axes),
                               model.marker_at(0, Eigen::Vector3d::Zero(), axes)));
  add_spring(model, 0, Coordinate::kAngle, k[0], 0.0);
  add_spring(model, 0, Coordinate::kDisplacementX, k[1], 0.0);
  add_spring(model, 0, Coordinate::kDisplacementY, k[2], 0.0);
  test::Run run(model, GetParam(), test::precise(1e-10));
  for (int i = 1; i <= 20; ++i) {
    run.to(0.17 * i);
    for (int c = 0; c < 3; ++c) {
      const double w = std::sqrt(k[c] / inertia[c]);
      EXPECT_NEAR(planar_value(run, model, c), rate[c] / w * std::sin(w * run.state.time),
                  kPlanarTolerance * (1.0 + std::abs(rate[c] / w)) * 10.0)
          << "coordinate " << c << " at " << run.state.time;
    }
    EXPECT_LT(std::abs(run.imbalance()), 1e-6) << run.state.time;
  }
}

// On a table that turns evenly, whose axes x and y the springs follow. With v = (x, y) on the table, J = [0, -1; 1, 0]:
//   v'' = -diag(k) v / m - diag(c) v' / m + W^2 v - 2 W J v'
// The angle of the puck against the table is a third oscillator.
TEST_P(PlanarJoint, CarriesItsAxesWithTheFirstBody) {
  const double W = 3.0, k[2] = {60.0, 90.0}, c[2] = {0.8, 0.3}, k_turn = 1.5;
  const Eigen::Vector4d start(0.0, 0.0, 0.9, -0.4);  // x, y, x', y'
  Model model;
  BodyState turning, thrown;
  turning.w = W * Eigen::Vector3d::UnitZ();
  thrown.dr << start[2], start[3], 0.0;
  thrown.w = (W + 2.0) * Eigen::Vector3d::UnitZ();
  model.add_body(Body("table", 5.0, Eigen::Matrix3d::Identity()), turning);
  model.add_body(puck(), thrown);
  PrescribedMotion motion;
  motion.rotation = polynomial({0.0, W});
  motion.hold_other_rotations = true;
  motion.translation = {polynomial({0.0}), polynomial({0.0}), polynomial({0.0})};
  model.add_joint(prescribed_joint("drive", ground_marker(Eigen::Vector3d::Zero()),
                                   model.marker_at(0, Eigen::Vector3d::Zero()), motion));
  model.add_joint(
      planar_joint("top", model.marker_at(0, Eigen::Vector3d::Zero()), model.marker_at(1, Eigen::Vector3d::Zero())));
  add_spring(model, 1, Coordinate::kDisplacementX, k[0], c[0]);
  add_spring(model, 1, Coordinate::kDisplacementY, k[1], c[1]);
  add_spring(model, 1, Coordinate::kAngle, k_turn, 0.0);
  Eigen::Matrix4d A = Eigen::Matrix4d::Zero();
  A.topRightCorner<2, 2>().setIdentity();
  for (int i = 0; i < 2; ++i) {
    A(2 + i, i) = W * W - k[i] / kPuckMass;
    A(2 + i, 2 + i) = -c[i] / kPuckMass;
  }
  A(2, 3) = 2.0 * W;
  A(3, 2) = -2.0 * W;
  test::Run run(model, GetParam(), test::precise(1e-10));
  for (int i = 1; i <= 10; ++i) {
    run.to(0.2 * i);
    const Eigen::Vector4d exact = (A * run.state.time).exp() * start;
    EXPECT_NEAR(planar_value(run, model, 0), exact[0], kPlanarTolerance) << run.state.time;
    EXPECT_NEAR(planar_value(run, model, 1), exact[1], kPlanarTolerance) << run.state.time;
    const double w = std::sqrt(k_turn / kPuckInertia);
    EXPECT_NEAR(planar_value(run, model, 2), 2.0 / w * std::sin(w * run.state.time), kPlanarTolerance);
    EXPECT_LT(std::abs(run.imbalance()), 1e-6) << run.state.time;
  }
}

INSTANTIATE_TEST_SUITE_P(Integrators, PlanarJoint, ::testing::Values("one_step", "ida"),
                         [](const auto& each) { return std::string(each.param); });

}  // namespace
}  // namespace footfall
