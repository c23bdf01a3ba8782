// Motion of a boundary through a window and the mean load on it.
#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/load_average.h"
#include "coupler/modal_boundary.h"
#include "coupler/schemes/registry.h"
#include "coupler/window.h"
#include "mbd_solver/base/pi.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

using test::RandomNumbers;

class ModalBoundaryOf : public testing::TestWithParam<int> {};  // number of modes
INSTANTIATE_TEST_SUITE_P(Modes, ModalBoundaryOf, testing::Values(0, 1, 7));

TEST_P(ModalBoundaryOf, ConservesVirtualWork) {
  RandomNumbers random(11);
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
  RandomNumbers random(12);
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
  RandomNumbers random(13);
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
  RandomNumbers random(14);
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
  RandomNumbers random(15);
  for (int trial = 0; trial < 50; ++trial) {
    const Eigen::Vector4d L = random.motion(0).L;
    Eigen::Vector3d theta = random.vector();
    theta *= (trial % 3 == 0 ? 1e-9 : 3.0) / theta.norm();
    EXPECT_LT((rotation_vector(L, turned(L, theta)) - theta).norm(), 1e-14);
  }
}

constexpr int kSubsteps = 40;
constexpr double kDt = 1e-3;  // [s]

class EveryScheme : public testing::TestWithParam<std::string> {};
std::string of_scheme(const testing::TestParamInfo<std::string>& scheme) {
  std::string name = scheme.param;
  for (char& c : name)
    if (c == '-') c = '_';
  return name;
}
INSTANTIATE_TEST_SUITE_P(Schemes, EveryScheme, testing::ValuesIn(scheme_names()), of_scheme);

// A path that is a little off the state from which the next window starts.
struct Beside {
  explicit Beside(const std::string& scheme_name, int modes) : scheme(make_scheme(scheme_name)), random(21) {
    start = random.motion(modes);
    BodyMotion stands = start;
    stands.r += 1e-3 * random.vector();
    stands.L = turned(stands.L, 1e-2 * random.vector());
    stands.a += 1e-3 * Eigen::VectorXd::Ones(modes);
    path = std::make_unique<BoundaryPath>(*scheme, stands);
  }
  std::unique_ptr<Scheme> scheme;
  RandomNumbers random;
  BodyMotion start;
  std::unique_ptr<BoundaryPath> path;
};

TEST_P(EveryScheme, PredictsVelocitiesThatAreTheRatesOfItsPositions) {
  const std::unique_ptr<Scheme> scheme = make_scheme(GetParam());
  RandomNumbers random(22);
  const BodyMotion start = random.motion(3);
  const double tau = 0.07, h = 1e-5;  // difference error h^2 = 1e-10 times third derivatives of about 100
  BodyMotion before(3), here(3), after(3);
  scheme->predict(start, tau - h, before);
  scheme->predict(start, tau, here);
  scheme->predict(start, tau + h, after);
  EXPECT_LT(((after.r - before.r) / (2 * h) - here.dr).norm(), 1e-7);
  EXPECT_LT((rotation_vector(before.L, after.L) / (2 * h) - here.w).norm(), 1e-7);
  EXPECT_LT(((after.a - before.a) / (2 * h) - here.da).norm(), 1e-7);
}

TEST_P(EveryScheme, PathEndsAtThePrediction) {
  Beside b(GetParam(), 2);
  b.path->begin_window(b.start, kSubsteps, kDt);
  for (int i = 0; i < kSubsteps; ++i) b.path->advance();
  BodyMotion end(2);
  b.scheme->predict(b.start, kSubsteps * kDt, end);
  EXPECT_LT((b.path->pose().r - end.r).norm(), 1e-15);
  EXPECT_LT(rotation_vector(b.path->pose().L, end.L).norm(), 1e-15);
  EXPECT_LT((b.path->pose().a - end.a).norm(), 1e-15);
  EXPECT_EQ(b.path->substeps_left(), 0);
}

TEST_P(EveryScheme, StepsAndJumpAddUpToTheWholeWay) {
  Beside b(GetParam(), 2);
  const BodyMotion stood = b.path->pose();
  b.path->begin_window(b.start, kSubsteps, kDt);
  Eigen::Vector3d way = b.path->jump().r;
  Eigen::VectorXd modal = b.path->jump().a;
  Eigen::Vector4d L = turned(stood.L, b.path->jump().theta_W);
  for (int i = 0; i < kSubsteps; ++i) {
    b.path->advance();
    way += b.path->last_step().r;
    modal += b.path->last_step().a;
    L = turned(L, b.path->last_step().theta_W);
  }
  EXPECT_LT((stood.r + way - b.path->pose().r).norm(), 1e-14);
  EXPECT_LT((stood.a + modal - b.path->pose().a).norm(), 1e-14);
  EXPECT_LT(rotation_vector(L, b.path->pose().L).norm(), 1e-14);
}

TEST_P(EveryScheme, OnlyTheFrozenBoundaryJumps) {
  Beside b(GetParam(), 2);
  b.path->begin_window(b.start, kSubsteps, kDt);
  EXPECT_EQ(b.path->jump().r.norm() > 0.0, GetParam() == "frozen");
}

TEST_P(EveryScheme, PathVelocityIsTheRateOfThePathAfterItsJump) {
  Beside b(GetParam(), 2);
  // Substeps so short that the central difference is exact to h^2 times the third derivatives: 1e-10 * 1e3.
  constexpr int kFine = 4000;
  b.path->begin_window(b.start, kFine, kSubsteps * kDt / kFine);
  const double h = kSubsteps * kDt / kFine;
  for (int i = 0; i < 1500; ++i) b.path->advance();
  const BodyMotion before = b.path->pose();
  b.path->advance();
  const BodyMotion here = b.path->pose();
  b.path->advance();
  const BodyMotion after = b.path->pose();
  EXPECT_LT(((after.r - before.r) / (2 * h) - here.dr).norm(), 1e-7);
  EXPECT_LT((rotation_vector(before.L, after.L) / (2 * h) - here.w).norm(), 1e-7);
  EXPECT_LT(((after.a - before.a) / (2 * h) - here.da).norm(), 1e-7);
}

TEST(BoundaryPath, KeepsTheMeanPositionOfThePredictionWhileItClosesTheGap) {
  Beside b("css-trapezoid", 0);
  constexpr int kFine = 2000;  // trapezoid error of the mean: gap / kFine^2 = 1e-9 of the gap of 1e-3
  b.path->begin_window(b.start, kFine, kSubsteps * kDt / kFine);
  Eigen::Vector3d mean = 0.5 * b.path->pose().r;
  for (int i = 0; i < kFine; ++i) {
    b.path->advance();
    mean += (i + 1 < kFine ? 1.0 : 0.5) * b.path->pose().r;
  }
  BodyMotion middle;
  b.scheme->predict(b.start, 0.5 * kSubsteps * kDt, middle);
  EXPECT_LT((mean / kFine - middle.r).norm(), 1e-9);
}

TEST(BoundaryPath, AddsUpASteadyTranslationAsLiggghtsDoes) {
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  const Eigen::Vector3d v(0.1, -0.3, -1.0);
  const double dt = 5e-5;
  BodyMotion state;
  state.r = {0.1, 0.2, 0.24};
  state.dr = v;
  BoundaryPath path(*scheme, state);
  Eigen::Vector3d sum = state.r;
  for (int window = 0; window < 2000; ++window) {
    BodyMotion start = state;
    start.r = state.r + (window * 5 * dt) * v;  // adds up in another way: differs by round-off
    path.begin_window(start, 5, dt);
    ASSERT_TRUE(path.steady_translation());
    for (int i = 0; i < 5; ++i) {
      path.advance();
      for (int c = 0; c < 3; ++c) sum[c] += v[c] * dt;
    }
    ASSERT_EQ(path.pose().r, sum) << "window " << window;
  }
}

TEST(BoundaryPath, IsNotSteadyWhenItTurnsDeformsAcceleratesOrLags) {
  const std::unique_ptr<Scheme> linear = make_scheme("css-trapezoid"), quadratic = make_scheme("quadratic");
  BodyMotion state(1);
  state.r = {1, 0, 0};
  state.dr = {0, 0, 1};
  const auto steady = [&](const Scheme& scheme, const BodyMotion& start) {
    BoundaryPath path(scheme, state);
    path.begin_window(start, 10, 1e-4);
    return path.steady_translation();
  };
  EXPECT_TRUE(steady(*linear, state));
  EXPECT_TRUE(steady(*quadratic, state));
  BodyMotion changed = state;
  changed.w = {0, 1e-30, 0};
  EXPECT_FALSE(steady(*linear, changed));
  changed = state;
  changed.da[0] = 1e-30;
  EXPECT_FALSE(steady(*linear, changed));
  changed = state;
  changed.ddr = {0, 1, 0};
  EXPECT_TRUE(steady(*linear, changed));
  EXPECT_FALSE(steady(*quadratic, changed));
  changed = state;
  changed.r[0] += 1e-9;
  EXPECT_FALSE(steady(*linear, changed));
}

// A gap of 1 mm made in 50 substeps closes over as many, here in windows of 2: no faster than 4 mm per 50 substeps, as
// within one window, and exactly.
TEST(BoundaryPath, CatchesUpNoFasterThanInTheWindowThatMadeTheGap) {
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  const double dt = 1e-4, e = 1e-3;
  BodyMotion state;
  state.r = {0.1, 0.0, 0.0};
  BoundaryPath path(*scheme, state);
  path.begin_window(state, 50, dt);
  for (int i = 0; i < 50; ++i) path.advance();
  state.r.x() += e;
  state.L = turned(state.L, {0.0, e, 0.0});
  for (int window = 0; window < 25; ++window) {
    path.begin_window(state, 2, dt, window == 0 ? 50 : 2);
    for (int i = 0; i < 2; ++i) {
      path.advance();
      EXPECT_LT(path.pose().dr.norm(), 4.0 * e / (50 * dt) * (1.0 + 1e-9)) << window;
      EXPECT_LT(path.pose().w.norm(), 4.0 * e / (50 * dt) * (1.0 + 1e-6)) << window;
    }
    EXPECT_LT((path.pose().r - state.r - path.left_open().r).norm(), 1e-15);
  }
  EXPECT_LT((path.pose().r - state.r).norm(), 1e-15);
  EXPECT_LT(rotation_vector(path.pose().L, state.L).norm(), 1e-15);
}

TEST(BoundaryPath, FollowsAKnownMotion) {
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  BodyMotion state(1);
  state.da[0] = 2.0;
  KnownPath known(13, 3);
  for (int i = 0; i < 3; ++i)
    known.col(i) << 0.1 * i * i, 0.0, 0.0, turned(state.L, {0.1 * i, 0.0, 0.0}), 1.0 * i, 0.0, 0.0, 0.0, 2.0 * i, 0.0;
  BoundaryPath path(*scheme, state);
  path.begin_window(state, 3, 0.1, 3, known);
  for (int i = 0; i < 3; ++i) {
    path.advance();
    EXPECT_EQ(path.pose().r, known.col(i).head<3>());
    EXPECT_EQ(path.pose().L, known.col(i).segment<4>(3));
    EXPECT_EQ(path.pose().w, known.col(i).tail<3>());
    EXPECT_NEAR(path.pose().a[0], 0.2 * (i + 1), 1e-15);  // modes follow the scheme
  }
}

TEST(Scheme, QuadraticPredictionIsThirdOrderInPositionOfASmoothMotion) {
  // Circle of radius 1 with the body turning along: error of r in tau^3 / 6, of the turn in zero (constant
  // w).
  const std::unique_ptr<Scheme> scheme = make_scheme("quadratic");
  const auto exact = [](double t, BodyMotion& m) {
    m.r = {std::cos(t), std::sin(t), 0.0};
    m.dr = {-std::sin(t), std::cos(t), 0.0};
    m.ddr = -m.r;
    m.L = turned(Eigen::Vector4d(1, 0, 0, 0), {0, 0, t});
    m.w = {0, 0, 1};
  };
  BodyMotion start, predicted, truth;
  exact(0.3, start);
  const auto error = [&](double tau) {
    scheme->predict(start, tau, predicted);
    exact(0.3 + tau, truth);
    EXPECT_LT(rotation_vector(truth.L, predicted.L).norm(), 1e-14);
    return (truth.r - predicted.r).norm();
  };
  EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 3.0, 0.01);
}

GeneralizedForce random_force(RandomNumbers& random, int modes) {
  GeneralizedForce Q(modes);
  Q.F_W = 1000.0 * random.vector();
  Q.T_W = 100.0 * random.vector();
  random.fill(Q.Q_a);
  return Q;
}

// One window on a random path under the forces Q_0 (standing), Q_1 .. Q_n.
struct Window {
  Window(const std::string& scheme_name, int modes, unsigned seed)
      : scheme(make_scheme(scheme_name)),
        random(seed),
        start(random.motion(modes)),
        path(*scheme, start),
        average(*scheme, modes) {
    for (int i = 0; i <= n; ++i) forces.push_back(random_force(random, modes));
  }
  const MeanLoad& run(double factor = 1.0) {
    const auto scaled = [factor](GeneralizedForce Q) {
      Q.F_W *= factor;
      Q.T_W *= factor;
      Q.Q_a *= factor;
      return Q;
    };
    average.set_opening_force(scaled(forces[0]), path.pose());
    path.begin_window(start, n, dt);
    average.begin_window(path.jump(), path.pose());
    for (int i = 1; i <= n; ++i) {
      path.advance();
      average.add_step(scaled(forces[static_cast<std::size_t>(i)]), path.pose(), path.last_step(), dt);
    }
    return average.finish();
  }
  static constexpr int n = 7;
  static constexpr double dt = 2e-3;
  std::unique_ptr<Scheme> scheme;
  RandomNumbers random;
  BodyMotion start;
  BoundaryPath path;
  LoadAverage average;
  std::vector<GeneralizedForce> forces;
};

TEST(LoadAverage, TrapezoidGivesTheImpulseThatVerletGave) {
  Window window("css-trapezoid", 2, 31);
  const MeanLoad& mean = window.run();
  Eigen::Vector3d impulse = 0.5 * window.dt * (window.forces.front().F_W + window.forces.back().F_W);
  for (int i = 1; i < window.n; ++i) impulse += window.dt * window.forces[static_cast<std::size_t>(i)].F_W;
  EXPECT_LT((mean.impulse_W - impulse).norm(), 1e-14 * 1000.0);
  EXPECT_LT((mean.F_W * (window.n * window.dt) - impulse).norm(), 1e-14 * 1000.0);
}

TEST(LoadAverage, CssIsTheMeanOfSteps1ToN) {
  Window window("css", 0, 32);
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (int i = 1; i <= window.n; ++i) mean += window.forces[static_cast<std::size_t>(i)].F_W / window.n;
  EXPECT_LT((window.run().F_W - mean).norm(), 1e-12 * 1000.0);
}

TEST(LoadAverage, WorkIsForceTimesWay) {
  // A constant force and moment in B on a turning, deforming body: work = F.dr + T_B.theta_B + Q.da, whatever
  // the substeps.
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  RandomNumbers random(33);
  BodyMotion start = random.motion(1);
  start.w = {0.0, 0.0, 4.0};
  BoundaryPath path(*scheme, start);
  LoadAverage average(*scheme, 1);
  const Eigen::Vector3d F(3, -2, 5), T_B = 7.0 * start.rotation().transpose() * Eigen::Vector3d::UnitZ();
  const auto force = [&] {
    GeneralizedForce Q(1);
    Q.F_W = F;
    Q.T_W = path.pose().rotation() * T_B;
    Q.Q_a[0] = 2.0;
    return Q;
  };
  average.set_opening_force(force(), path.pose());
  path.begin_window(start, 50, 1e-2);
  average.begin_window(path.jump(), path.pose());
  for (int i = 0; i < 50; ++i) {
    path.advance();
    average.add_step(force(), path.pose(), path.last_step(), 1e-2);
  }
  const MeanLoad& mean = average.finish();
  const double work = F.dot(start.dr) * 0.5 + 7.0 * 4.0 * 0.5 + 2.0 * start.da[0] * 0.5;
  EXPECT_NEAR(mean.work, work, 1e-12 * std::abs(work));
  EXPECT_LT((mean.T_B - T_B).norm(), 1e-12 * 7.0);  // the moment is the same number in the body's frame
}

TEST(LoadAverage, MomentThatTurnsWithTheBodyDoesNotDependOnTheWindow) {
  // theory, wrench frame. In W the mean of this moment over a turn of 0.4 rad would be shorter by sin(0.2) /
  // 0.2.
  RandomNumbers random(34);
  const std::unique_ptr<Scheme> scheme = make_scheme("css-trapezoid");
  BodyMotion start = random.motion(0);
  start.w = {4.0, 0.0, 0.0};
  const Eigen::Vector3d T_B(0.0, 1.0, 0.0);
  for (const int n : {1, 10, 100}) {
    BoundaryPath path(*scheme, start);
    LoadAverage average(*scheme, 0);
    const auto force = [&] {
      GeneralizedForce Q;
      Q.T_W = path.pose().rotation() * T_B;
      return Q;
    };
    average.set_opening_force(force(), path.pose());
    path.begin_window(start, n, 1e-3);
    average.begin_window(path.jump(), path.pose());
    for (int i = 0; i < n; ++i) {
      path.advance();
      average.add_step(force(), path.pose(), path.last_step(), 1e-3);
    }
    EXPECT_LT((average.finish().T_B - T_B).norm(), 1e-14 * 10.0);
  }
}

TEST(LoadAverage, IsLinearSoThatRanksMayAddUp) {
  Window whole("css-trapezoid", 3, 35), third("css-trapezoid", 3, 35), rest("css-trapezoid", 3, 35);
  const MeanLoad a = third.run(1.0 / 3.0), b = rest.run(2.0 / 3.0), c = whole.run();
  EXPECT_LT((a.F_W + b.F_W - c.F_W).norm(), 1e-12 * 1000.0);
  EXPECT_LT((a.T_B + b.T_B - c.T_B).norm(), 1e-12 * 100.0);
  EXPECT_LT((a.Q_a + b.Q_a - c.Q_a).norm(), 1e-12);
  EXPECT_NEAR(a.work + b.work, c.work, 1e-12 * 100.0);
}

TEST(LoadAverage, CountsTheWorkOfAJumpUnderTheStandingForce) {
  const std::unique_ptr<Scheme> scheme = make_scheme("frozen");
  RandomNumbers random(36);
  const BodyMotion start = random.motion(0);
  BodyMotion stands = start;
  stands.r -= Eigen::Vector3d(0.0, 0.0, 0.01);
  BoundaryPath path(*scheme, stands);
  LoadAverage average(*scheme, 0);
  GeneralizedForce Q;
  Q.F_W = {0.0, 0.0, 500.0};
  average.set_opening_force(Q, path.pose());
  path.begin_window(start, 3, 1e-3);
  average.begin_window(path.jump(), path.pose());
  for (int i = 0; i < 3; ++i) {
    path.advance();
    average.add_step(Q, path.pose(), path.last_step(), 1e-3);
  }
  const MeanLoad& mean = average.finish();
  EXPECT_NEAR(mean.jump_work, 5.0, 1e-12);
  EXPECT_NEAR(mean.work, 5.0, 1e-12);
}

TEST(LoadAverage, MeanActsInWAndTurnsItsMomentWithTheBody) {
  RandomNumbers random(37);
  MeanLoad mean(1);
  mean.F_W = {1, 2, 3};
  mean.T_B = {0, 0, 1};
  mean.Q_a[0] = 4;
  BodyMotion motion(1);
  motion.L = turned(motion.L, {kPi / 2, 0, 0});
  GeneralizedForce Q(1);
  apply(mean, motion, Q);
  EXPECT_EQ(Q.F_W, mean.F_W);
  EXPECT_LT((Q.T_W - Eigen::Vector3d(0, -1, 0)).norm(), 1e-15);
  EXPECT_EQ(Q.Q_a[0], 4.0);
}

}  // namespace
}  // namespace footfall
