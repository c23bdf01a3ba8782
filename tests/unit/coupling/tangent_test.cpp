// The scheme `tangent` on the multibody side.

#include "mbd_solver/coupling/tangent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

Body ball() { return Body("ball", 10.0, Eigen::Vector3d(0.1, 0.2, 0.3).asDiagonal()); }

ContactTangent along_z(double k) {
  ContactTangent slope;
  slope.K(2, 2) = k;
  return slope;
}

TEST(MeanVelocity, WithoutContactIsThatOfConstantAcceleration) {
  BodyMotion motion;
  motion.dr = {1.0, 2.0, 3.0};
  motion.ddr = {0.0, 0.0, -10.0};
  motion.w = {0.1, 0.0, 0.0};
  const Vector6d v = mean_velocity(ball(), motion, {}, 0.01);
  EXPECT_NEAR(v[2], 3.0 - 0.05, 1e-14);
  EXPECT_NEAR(v[0], 1.0, 1e-14);
  EXPECT_NEAR(v[3], 0.1, 1e-14);
}

TEST(MeanVelocity, MissesTheOscillatorByThirdOrder) {
  // 10 kg on 1e5 N/m, at x = 1 mm from rest: x = x0 cos(om t) + v0 / om sin(om t).
  const double om = 100.0, x0 = 1e-3, v0 = 0.2;
  BodyMotion motion;
  motion.dr[2] = v0;
  motion.ddr[2] = -om * om * x0;
  const auto error = [&](double H) {
    const double x = x0 * std::cos(om * H) + v0 / om * std::sin(om * H);
    return std::abs(H * mean_velocity(ball(), motion, along_z(1e5), H)[2] - (x - x0));
  };
  EXPECT_NEAR(std::log2(error(2e-3) / error(1e-3)), 3.0, 0.15);
}

TEST(MeanVelocity, OnStiffContactLeadsToWhereTheyBalance) {
  // L-stable: what is missing is of the size v0 / (omega^2 H), here 2 % of x0 at omega H = 100.
  const double om = 100.0, x0 = 1e-3, v0 = 0.2;
  BodyMotion motion;
  motion.dr[2] = v0;
  motion.ddr[2] = -om * om * x0;
  for (const double H : {1.0, 10.0})
    EXPECT_NEAR(H * mean_velocity(ball(), motion, along_z(1e5), H)[2], -x0, 6.0 * v0 / (om * om * H));
}

TEST(TangentLoad, DampsOnlyWhatTheWindowDoesNotResolve) {
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  const PredictedWindow predicted(*scheme, BodyMotion());
  // Damping ratio C omega / (2 K) with omega = omega_h / H.
  const auto ratio = [&](double omega_h) {
    return tangent_load(along_z(1e5), predicted, omega_h, 0.01).C(2, 2) * omega_h / 0.01 / 2e5;
  };
  EXPECT_NEAR(ratio(0.2), std::pow(0.1, 7) / 2.0, 1e-12);
  EXPECT_NEAR(ratio(20.0), 5.0, 1e-4);
}

TEST(PredictedWindow, MeansAreThoseOfThePathOfTheGrains) {
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  BodyMotion start;
  start.dr = {0.0, 0.0, -1.0};
  start.w = {0.0, 0.5, 0.0};
  PredictedWindow predicted(*scheme, start);
  predicted.begin(start, 10, 1e-3);
  EXPECT_NEAR(predicted.r_mean()[2], -0.005, 1e-15);
  EXPECT_NEAR(predicted.v_mean()[2], -1.0, 1e-12);
  EXPECT_NEAR(rotation_vector(start.L, predicted.L_mean())[1], 0.0025, 1e-12);
  // The body came 1 mm less far: the next path closes that gap, and goes 1 mm less in the mean of its velocity.
  BodyMotion computed = start;
  computed.r[2] = -0.009;
  EXPECT_NEAR(predicted.gap(computed)[2], 0.001, 1e-15);
  predicted.begin(computed, 10, 1e-3);
  EXPECT_NEAR(predicted.v_mean()[2], -1.0 + 0.001 / 0.01, 0.02);  // 10 substeps sample the closing roughly
}

TEST(SurplusImpulse, IsZeroOnThePredictedPathAndTheSpringsPushBesideIt) {
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  BodyMotion start;
  start.dr[2] = 0.1;
  PredictedWindow predicted(*scheme, start);
  predicted.begin(start, 10, 1e-3);
  const TangentLoad load = tangent_load(along_z(1e5), predicted, 0.0, 0.01);
  BodyMotion end = start;
  end.r[2] = 0.001;
  EXPECT_LT(surplus_impulse(load, start, end, 0.01).norm(), 1e-12);
  // Stopped at once: it stays 0.5 mm behind the mean, where the spring pushes by 50 N more.
  start.dr[2] = end.dr[2] = end.r[2] = 0.0;
  EXPECT_NEAR(surplus_impulse(load, start, end, 0.01)[2], 0.01 * 50.0, 1e-9);
}

TEST(PendingWork, OfALinearSpringIsItsEnergyBetweenPredictedAndComputed) {
  // The spring k x resists; predicted end at x_p, computed at x_c: k/2 (x_p^2 - x_c^2).
  const double k = 1e5;
  const std::unique_ptr<Scheme> scheme = make_scheme("tangent");
  BodyMotion start;
  start.dr[2] = 0.1;
  PredictedWindow predicted(*scheme, start);
  predicted.begin(start, 10, 1e-3);
  MeanLoad mean;
  mean.F_W[2] = -k * predicted.r_mean()[2];
  BodyMotion computed = start;
  computed.r[2] = 0.0004;
  const double x_p = 0.001, x_c = 0.0004;
  EXPECT_NEAR(pending_work(mean, along_z(k), predicted, computed), 0.5 * k * (x_p * x_p - x_c * x_c), 1e-12);
}

}  // namespace
}  // namespace footfall
