#include "coupler/modal_boundary.h"

#include <gtest/gtest.h>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

using test::Random;

class ModalBoundaryOf : public testing::TestWithParam<int> {};  // number of modes
INSTANTIATE_TEST_SUITE_P(Modes, ModalBoundaryOf, testing::Values(0, 1, 7));

TEST_P(ModalBoundaryOf, ConservesVirtualWork) {
  Random random(11);
  const ModalBoundary boundary = random.boundary(12, GetParam());
  for (int trial = 0; trial < 20; ++trial) {
    const BodyMotion motion = random.motion(GetParam());
    GeneralizedForce Q(GetParam());
    double contact_power = 0.0, scale = 0.0;
    for (int c = 0; c < 30; ++c) {
      const Eigen::Vector3d f = 1000.0 * random.vector(), m = 10.0 * random.vector();
      const BoundaryPoint point = c % 2 == 0 ? boundary.triangle_point(random.below(10), random.weights())
                                             : boundary.segment_point(random.below(11), random.share());
      boundary.add_point_force(motion, point, f, Q);
      boundary.add_point_moment(motion, point, m, Q);
      const double p = f.dot(boundary.velocity(motion, point)) + m.dot(boundary.angular_velocity(motion, point));
      contact_power += p;
      scale += std::abs(p);
    }
    EXPECT_NEAR(power(Q, motion), contact_power, 1e-12 * scale);  // round-off of 60 sums
  }
}

TEST_P(ModalBoundaryOf, VelocitiesAreTheRatesOfPositions) {
  Random random(12);
  const ModalBoundary boundary = random.boundary(9, GetParam());
  const BodyMotion motion = random.motion(GetParam());
  Eigen::Matrix3Xd v(3, 9), before(3, 9), after(3, 9);
  boundary.node_velocities(motion, v);
  const double h = 1e-5;  // central difference: error h^2 w^3 = 1e-9 plus round-off 1e-16 / h = 1e-11
  const auto at = [&](double tau, Eigen::Matrix3Xd& x) {
    BodyMotion moved = motion;
    moved.r += tau * motion.dr;
    moved.L = turned(motion.L, tau * motion.w);
    moved.a += tau * motion.da;
    boundary.node_positions(moved, x);
  };
  at(-h, before);
  at(h, after);
  EXPECT_LT(((after - before) / (2.0 * h) - v).cwiseAbs().maxCoeff(), 1e-8);
}

TEST_P(ModalBoundaryOf, PointsAreWeightedMeansOfTheirNodes) {
  Random random(13);
  const ModalBoundary boundary = random.boundary(8, GetParam());
  const BodyMotion motion = random.motion(GetParam());
  Eigen::Matrix3Xd x(3, 8), v(3, 8);
  boundary.node_positions(motion, x);
  boundary.node_velocities(motion, v);
  const Eigen::Vector3d w = random.weights();
  const BoundaryPoint point = boundary.triangle_point(3, w);
  EXPECT_LT((boundary.position(motion, point) - (x.middleCols<3>(3) * w)).norm(), 1e-14);
  EXPECT_LT((boundary.velocity(motion, point) - (v.middleCols<3>(3) * w)).norm(), 1e-14 * 10.0);
}

TEST(ModalBoundary, RigidBodyTurnsAboutItsOrigin) {
  Eigen::Matrix3Xd rho0(3, 3);
  rho0 << 1, 0, 0, 0, 1, 0, 0, 0, 1;
  const ModalBoundary boundary("unit", rho0, {{0, 1, 2}});
  BodyMotion motion;
  motion.r = {10, 20, 30};
  motion.L = turned(motion.L, Eigen::Vector3d(0, 0, kPi / 2));
  motion.w = {0, 0, 3};
  Eigen::Matrix3Xd x(3, 3), v(3, 3);
  boundary.node_positions(motion, x);
  boundary.node_velocities(motion, v);
  EXPECT_LT((x.col(0) - Eigen::Vector3d(10, 21, 30)).norm(), 1e-14);
  EXPECT_LT((v.col(0) - Eigen::Vector3d(-3, 0, 0)).norm(), 1e-14);
  GeneralizedForce Q;
  boundary.add_point_force(motion, boundary.triangle_point(0, {1, 0, 0}), {5, 0, 7}, Q);
  EXPECT_EQ(Q.F_W, Eigen::Vector3d(5, 0, 7));
  EXPECT_LT((Q.T_W - Eigen::Vector3d(0, 1, 0).cross(Eigen::Vector3d(5, 0, 7))).norm(), 1e-14);
}

TEST(ModalBoundary, BarycentricWeightsGiveThePointBack) {
  Random random(14);
  for (int trial = 0; trial < 100; ++trial) {
    const Eigen::Vector3d x0 = random.vector(), x1 = random.vector(), x2 = random.vector(), w = random.weights();
    const Eigen::Vector3d c = w[0] * x0 + w[1] * x1 + w[2] * x2;
    const Eigen::Vector3d normal = (x1 - x0).cross(x2 - x0);
    const Eigen::Vector3d found = barycentric_weights(x0, x1, x2, c + 0.3 * normal);
    EXPECT_NEAR(found.sum(), 1.0, 1e-13);
    // random slivers: condition 1e4
    EXPECT_LT((found[0] * x0 + found[1] * x1 + found[2] * x2 - c).norm(), 1e-10);
  }
}

TEST(ModalBoundary, BarycentricWeightsOfATriangleWithoutAreaLieOnItsLongerEdge) {
  const Eigen::Vector3d x0(0, 0, 0), x1(1, 0, 0), x2(4, 0, 0);
  EXPECT_LT((barycentric_weights(x0, x1, x2, {3, 1, 0}) - Eigen::Vector3d(0.25, 0, 0.75)).norm(), 1e-15);
  EXPECT_LT((barycentric_weights(x0, x2, x1, {3, 1, 0}) - Eigen::Vector3d(0.25, 0.75, 0)).norm(), 1e-15);
}

TEST(ModalBoundary, RefusesWhatIsNoBoundary) {
  Eigen::Matrix3Xd two(3, 2);
  two << 0, 1, 0, 0, 0, 0;
  EXPECT_THROW(ModalBoundary("b", Eigen::Matrix3Xd(3, 0), {}), InputError);
  EXPECT_THROW(ModalBoundary("b", two, {{0, 1, 2}}), InputError);
  EXPECT_THROW(ModalBoundary("b", two, {}, {{0, 0, 0.1, 0}}), InputError);
  EXPECT_THROW(ModalBoundary("b", two, {}, {{0, 1, 0.0, 0}}), InputError);
  EXPECT_THROW(ModalBoundary("b", two, {}, {}, Eigen::MatrixXd::Zero(5, 1)), InputError);
  EXPECT_THROW(ModalBoundary("b", two, {}, {}, Eigen::MatrixXd::Zero(6, 1), Eigen::MatrixXd::Zero(6, 2)), InputError);
  two(1, 1) = std::numeric_limits<double>::infinity();
  EXPECT_THROW(ModalBoundary("b", two, {}), InputError);
}

TEST(BodyMotion, RotationVectorUndoesTurning) {
  Random random(15);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector4d L = random.motion(0).L;
    Eigen::Vector3d theta = random.vector();
    theta *= (trial % 3 == 0 ? 1e-9 : 3.0) / theta.norm();
    EXPECT_LT((rotation_vector(L, turned(L, theta)) - theta).norm(), 1e-14);
  }
}

}  // namespace
}  // namespace footfall
