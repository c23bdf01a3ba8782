#include "coupler/load_average.h"

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/pi.h"
#include "coupler/schemes/registry.h"
#include "tests/unit/coupler/random_boundary.h"

namespace footfall {
namespace {

using test::Random;

GeneralizedForce random_force(Random& random, int modes) {
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
    average.set_standing(scaled(forces[0]), path.pose());
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
  Random random;
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
  Random random(33);
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
  average.set_standing(force(), path.pose());
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
  Random random(34);
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
    average.set_standing(force(), path.pose());
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
  Random random(36);
  const BodyMotion start = random.motion(0);
  BodyMotion stands = start;
  stands.r -= Eigen::Vector3d(0.0, 0.0, 0.01);
  BoundaryPath path(*scheme, stands);
  LoadAverage average(*scheme, 0);
  GeneralizedForce Q;
  Q.F_W = {0.0, 0.0, 500.0};
  average.set_standing(Q, path.pose());
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
  Random random(37);
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
