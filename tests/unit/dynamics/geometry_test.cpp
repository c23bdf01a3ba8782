// mbd_solver/model/rotation.h, mass_properties.h, laws/time_function.h, dynamics/body_force.h: small parts against
// their definitions.

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/model/mass_properties.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall {
namespace {

constexpr double kRoundOff = 1e-14;

TEST(Rotation, IsProperWhateverTheLengthOfTheQuaternion) {
  test::Random random(1);
  for (int i = 0; i < 20; ++i) {
    const Eigen::Vector4d L = random.quaternion();
    const Eigen::Matrix3d A = rotation_matrix(L);
    EXPECT_LT((A * A.transpose() - Eigen::Matrix3d::Identity()).norm(), kRoundOff);
    EXPECT_NEAR(A.determinant(), 1.0, kRoundOff);
    EXPECT_LT((rotation_matrix(3.0 * L) - A).norm(), kRoundOff);
    EXPECT_LT((rotation_matrix(quaternion_from_matrix(A)) - A).norm(), kRoundOff);
    EXPECT_LT((rate_matrix(L) * L).norm(), kRoundOff);  // no rotation along L
  }
}

TEST(Rotation, RateOfTheQuaternionTurnsTheMatrixAtItsAngularVelocity) {
  // A' = w~ A, by a difference of second order: tolerance dt^2 |w|^3.
  test::Random random(2);
  const double dt = 1e-5;
  const Eigen::Vector4d L = random.quaternion();
  const Eigen::Vector3d w = random.vector(2.0);
  const Eigen::Vector4d dL = quaternion_rate(L, w);
  const Eigen::Matrix3d difference = (rotation_matrix(L + dt * dL) - rotation_matrix(L - dt * dL)) / (2.0 * dt);
  EXPECT_LT((difference - skew(w) * rotation_matrix(L)).norm(), 1e-9);
  EXPECT_LT((2.0 * rate_matrix(L) * dL - w).norm(), kRoundOff);
}

TEST(Rotation, IncrementsAreExactForAnyAngle) {
  test::Random random(3);
  const Eigen::Vector4d L = random.quaternion();
  for (double angle : {1e-9, 1e-4, 1.0, 3.0}) {
    const Eigen::Vector3d axis = random.vector().normalized();
    const Eigen::Matrix3d expected = Eigen::AngleAxisd(angle, axis).toRotationMatrix() * rotation_matrix(L);
    EXPECT_LT((rotation_matrix(rotated(L, angle * axis)) - expected).norm(), kRoundOff) << angle;
  }
  EXPECT_LT((rotation_matrix(quaternion_about({0.0, 0.0, 2.0}, 0.3)) -
             Eigen::AngleAxisd(0.3, Eigen::Vector3d::UnitZ()).toRotationMatrix())
                .norm(),
            kRoundOff);
}

TEST(Rotation, AxesHaveTheirZAndAreRightHanded) {
  test::Random random(4);
  for (const Eigen::Vector3d& hint : {Eigen::Vector3d(1.0, 0.0, 0.0), Eigen::Vector3d(0.0, 0.0, 5.0)}) {
    const Eigen::Matrix3d axes = axes_with_z({0.0, 0.0, 3.0}, hint);
    EXPECT_LT((axes.col(2) - Eigen::Vector3d::UnitZ()).norm(), kRoundOff);
    EXPECT_NEAR(axes.determinant(), 1.0, kRoundOff);
  }
}

TEST(Rotation, ShortestTurnTakesOneDirectionToTheOther) {
  test::Random random(9);
  for (int k = 0; k < 50; ++k) {
    const Eigen::Vector3d from = rotation_matrix(random.quaternion()).col(0),
                          other = rotation_matrix(random.quaternion()).col(0);
    for (const Eigen::Vector3d& to : {other, from, Eigen::Vector3d(-from)}) {
      const Eigen::Matrix3d R = shortest_turn(from, to);
      EXPECT_LT((R * from - to).norm(), 1e2 * kRoundOff);
      EXPECT_LT((R.transpose() * R - Eigen::Matrix3d::Identity()).norm(), kRoundOff);
      EXPECT_NEAR(R.determinant(), 1.0, kRoundOff);
      EXPECT_NEAR(R.trace(), 1.0 + 2.0 * from.dot(to), kRoundOff) << "no turn about the direction itself";
    }
  }
}

TEST(MassProperties, OfSolidsAreThoseOfTheHandbook) {
  const MassProperties box = box_properties({1.0, 2.0, 3.0}, 10.0);
  EXPECT_DOUBLE_EQ(box.mass, 60.0);
  EXPECT_DOUBLE_EQ(box.inertia(0, 0), 60.0 / 12.0 * 13.0);
  const MassProperties ball = sphere_properties(0.5, 8.0);
  EXPECT_DOUBLE_EQ(ball.inertia(1, 1), 0.4 * ball.mass * 0.25);
  const MassProperties disc = disc_properties(0.2, 1e-6, 1000.0);  // so thin that J_x = m r^2 / 4
  EXPECT_NEAR(disc.inertia(0, 0), 0.25 * disc.mass * 0.04, 1e-9 * disc.mass);
  EXPECT_NEAR(disc.inertia(2, 2), 0.5 * disc.mass * 0.04, 1e-12);
  // A tube along a slanted line: axial inertia m r^2 for a thin wall, centre in the middle.
  const Eigen::Vector3d from(1.0, 0.0, 0.0), to(1.0, 2.0, 2.0);
  const MassProperties tube = tube_properties(from, to, 0.2, 1e-7, 5000.0);
  const Eigen::Vector3d e = (to - from).normalized();
  EXPECT_LT((tube.centre - Eigen::Vector3d(1.0, 1.0, 1.0)).norm(), kRoundOff);
  EXPECT_NEAR(e.dot(tube.inertia * e), tube.mass * 0.01, 1e-6 * tube.mass * 0.01);
}

TEST(MassProperties, OfAWholeAreThoseOfItsParts) {
  // A rod cut anywhere and put together again.
  const Eigen::Vector3d a(0.0, 0.0, 0.0), b(0.3, 0.1, 0.2), c = 2.5 * b;
  const MassProperties whole = rod_properties(a, c, 0.02, 7850.0);
  const MassProperties sum = rod_properties(a, b, 0.02, 7850.0) + rod_properties(b, c, 0.02, 7850.0);
  EXPECT_NEAR(sum.mass, whole.mass, kRoundOff);
  EXPECT_LT((sum.centre - whole.centre).norm(), kRoundOff);
  EXPECT_LT((sum.inertia - whole.inertia).norm(), 1e-13 * whole.inertia.norm());
}

TEST(MassProperties, RefuseWhatIsNotPositive) {
  EXPECT_THROW(box_properties({1.0, 0.0, 1.0}, 1.0), InputError);
  EXPECT_THROW(sphere_properties(1.0, -1.0), InputError);
  EXPECT_THROW(tube_properties(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitX(), 0.1, 0.06, 1.0), InputError);
  EXPECT_THROW(rod_properties(Eigen::Vector3d::Zero(), Eigen::Vector3d::Zero(), 0.1, 1.0), InputError);
}

TEST(TimeFunction, DerivativesAreDerivatives) {
  const std::vector<TimeFunctionPtr> functions = {
      polynomial({1.0, -2.0, 0.5, 0.25}), ramp(1.0, 3.0, 0.2, 0.9), sine(2.0, 0.6, 0.3, 1.0),
      table({0.0, 0.3, 0.7, 1.5}, {0.0, 0.4, -0.2, 1.0}, TableShape::kSpline),
      sum({sine(1.0, 0.5), polynomial({0.0, 1.0})})};
  const double dt = 1e-5;  // truncation dt^2, round-off 1e-16 / dt: both about 1e-10
  for (std::size_t i = 0; i < functions.size(); ++i) {
    for (double t : {-0.5, 0.1, 0.5, 1.2, 2.0}) {
      const TimeValue now = functions[i]->at(t), next = functions[i]->at(t + dt), last = functions[i]->at(t - dt);
      EXPECT_NEAR(now.rate, (next.value - last.value) / (2.0 * dt), 1e-8) << i << " at " << t;
      EXPECT_NEAR(now.accel, (next.rate - last.rate) / (2.0 * dt), 1e-7) << i << " at " << t;
    }
  }
}

TEST(TimeFunction, TablePassesItsPointsAndIsStraightOutside) {
  const TimeFunctionPtr f = table({0.0, 0.3, 0.7, 1.5}, {0.0, 0.4, -0.2, 1.0}, TableShape::kSpline);
  EXPECT_NEAR(f->at(0.3).value, 0.4, kRoundOff);
  EXPECT_NEAR(f->at(0.7).value, -0.2, kRoundOff);
  EXPECT_EQ(f->at(5.0).accel, 0.0);
  EXPECT_NEAR(f->at(5.0).value, 1.0 + 3.5 * f->at(1.5).rate, 1e-13);
  const TimeFunctionPtr line = table({0.0, 2.0}, {1.0, 5.0}, TableShape::kSpline);
  EXPECT_NEAR(line->at(0.5).value, 2.0, kRoundOff);
  for (const TableShape shape : {TableShape::kSpline, TableShape::kMonotone, TableShape::kLines}) {
    EXPECT_THROW(table({0.0, 0.0}, {1.0, 2.0}, shape), InputError);
    EXPECT_THROW(table({0.0}, {1.0}, shape), InputError);
  }
}

TEST(TimeFunction, OnlySplinesLeaveTheRangeOfTheirPoints) {
  const std::vector<double> times = {0.0, 1.0, 1.01, 5.0}, values = {1000.0, 1000.0, 0.0, 0.0};  // a cut-off of thrust
  for (const TableShape shape : {TableShape::kMonotone, TableShape::kLines}) {
    const TimeFunctionPtr f = table(times, values, shape);
    for (double t = -1.0; t < 7.0; t += 0.0037) {
      EXPECT_GE(f->at(t).value, -1e-9) << t;  // round-off of the pieces
      EXPECT_LE(f->at(t).value, 1000.0 + 1e-9) << t;
    }
    EXPECT_EQ(f->at(0.5).value, 1000.0);
    EXPECT_EQ(f->at(-1.0).value, 1000.0);
    EXPECT_EQ(f->at(6.0).value, 0.0);
  }
  const TimeFunctionPtr lines = table(times, values, TableShape::kLines);
  EXPECT_NEAR(lines->at(1.005).value, 500.0, 1e-9);
  EXPECT_NEAR(lines->at(1.005).rate, -1e5, 1e-6);
  const TimeFunctionPtr monotone = table({0.0, 0.3, 0.7, 1.5}, {0.0, 0.4, 1.2, 1.5}, TableShape::kMonotone);
  const double dt = 1e-6;
  for (const double t : {0.1, 0.5, 1.2})
    EXPECT_NEAR(monotone->at(t).rate, (monotone->at(t + dt).value - monotone->at(t - dt).value) / (2.0 * dt), 1e-8)
        << t;
}

TEST(ExternalLoad, MomentTurnsWithTheBodyAndTangentVanishesOnTheMeanPath) {
  test::Random random(9);
  BodyKinematics at;
  at.ground = false;
  at.L = random.quaternion();
  at.A = rotation_matrix(at.L);
  at.r = random.vector();
  at.dr = random.vector();
  at.w = random.vector();
  ExternalLoad load;
  load.F_W = random.vector();
  load.T_B = random.vector();
  TangentLoad tangent;
  tangent.K.setRandom();
  tangent.C.setRandom();
  tangent.r_mean = at.r;
  tangent.L_mean = at.L;
  tangent.v_mean << at.dr, at.w;
  load.tangent = tangent;
  Eigen::VectorXd Q = Eigen::VectorXd::Zero(6);
  add_load_force(load, at, Q);
  EXPECT_LT((Q.head<3>() - load.F_W).norm(), kRoundOff);
  EXPECT_LT((Q.tail<3>() - at.A * load.T_B).norm(), kRoundOff);
  // A rotation of 0.01 rad about y from the mean answers with -K e_5 0.01, to third order.
  load.tangent->L_mean = rotated(at.L, {0.0, -0.01, 0.0});
  Eigen::VectorXd turned = Eigen::VectorXd::Zero(6);
  add_load_force(load, at, turned);
  EXPECT_LT((turned - Q + 0.01 * tangent.K.col(4)).norm(), 1e-6);
}

}  // namespace
}  // namespace footfall
