// The scheme `tangent` on the body's side.

#include "coupler/schemes/tangent.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

// [kg, kg m2]
Matrix6d inertia() {
  Vector6d diagonal;
  diagonal << 10.0, 10.0, 10.0, 0.1, 0.2, 0.3;
  return diagonal.asDiagonal();
}

ContactTangent along_z(double k) {
  ContactTangent slope;
  slope.K(2, 2) = k;
  return slope;
}

// A straight path from the origin at 0.1 m/s for 10 ms.
PredictedPath one_millimetre_up() {
  PredictedPath path;
  path.r_mean[2] = 0.0005;
  path.r_end[2] = 0.001;
  path.v_mean[2] = 0.1;
  return path;
}

TEST(MeanVelocity, WithoutContactIsThatOfConstantAcceleration) {
  Vector6d v_0 = Vector6d::Zero();
  v_0 << 1.0, 2.0, 3.0, 0.1, 0.0, 0.0;
  const Vector6d v = mean_velocity(inertia(), v_0, -10.0 * Vector6d::Unit(2), {}, 0.01);
  EXPECT_NEAR(v[2], 3.0 - 0.05, 1e-14);
  EXPECT_NEAR(v[0], 1.0, 1e-14);
  EXPECT_NEAR(v[3], 0.1, 1e-14);
}

TEST(MeanVelocity, MissesTheOscillatorByThirdOrder) {
  // 10 kg on 1e5 N/m, at x = 1 mm from rest: x = x0 cos(om t) + v0 / om sin(om t).
  const double om = 100.0, x0 = 1e-3, v0 = 0.2;
  const Vector6d v = v0 * Vector6d::Unit(2), a = -om * om * x0 * Vector6d::Unit(2);
  const auto error = [&](double H) {
    const double x = x0 * std::cos(om * H) + v0 / om * std::sin(om * H);
    return std::abs(H * mean_velocity(inertia(), v, a, along_z(1e5), H)[2] - (x - x0));
  };
  EXPECT_NEAR(std::log2(error(2e-3) / error(1e-3)), 3.0, 0.15);
}

TEST(MeanVelocity, OnStiffContactLeadsToWhereTheyBalance) {
  // L-stable: what is missing is of the size v0 / (omega^2 H), here 2 % of x0 at omega H = 100.
  const double om = 100.0, x0 = 1e-3, v0 = 0.2;
  const Vector6d v = v0 * Vector6d::Unit(2), a = -om * om * x0 * Vector6d::Unit(2);
  for (const double H : {1.0, 10.0})
    EXPECT_NEAR(H * mean_velocity(inertia(), v, a, along_z(1e5), H)[2], -x0, 6.0 * v0 / (om * om * H));
}

TEST(TangentLoad, DampsOnlyWhatTheWindowDoesNotResolve) {
  // Damping ratio C omega / (2 K) with omega = omega_h / H.
  const auto ratio = [&](double omega_h) {
    return tangent_load(along_z(1e5), PredictedPath(), omega_h, 0.01).C(2, 2) * omega_h / 0.01 / 2e5;
  };
  EXPECT_NEAR(ratio(0.2), std::pow(0.1, 7) / 2.0, 1e-12);
  EXPECT_NEAR(ratio(20.0), 5.0, 1e-4);
}

TEST(SurplusImpulse, IsZeroOnThePredictedPathAndTheSpringsPushBesideIt) {
  BodyMotion start;
  start.dr[2] = 0.1;
  const TangentLoad load = tangent_load(along_z(1e5), one_millimetre_up(), 0.0, 0.01);
  BodyMotion end = start;
  end.r[2] = 0.001;
  EXPECT_LT(surplus_impulse(load, start, end, 0.01).norm(), 1e-12);
  // Stopped at once: it stays 0.5 mm behind the mean, where the spring pushes by 50 N more.
  start.dr[2] = end.dr[2] = end.r[2] = 0.0;
  EXPECT_NEAR(surplus_impulse(load, start, end, 0.01)[2], 0.01 * 50.0, 1e-9);
}

TEST(PendingWork, OfALinearSpringIsItsEnergyBetweenPredictedAndComputed) {
  // The spring k x resists; predicted end at x_p, computed at x_c: k/2 (x_p^2 - x_c^2).
  const double k = 1e5, x_p = 0.001, x_c = 0.0004;
  const PredictedPath path = one_millimetre_up();
  BodyLoad load;
  load.mean.F_W[2] = -k * path.r_mean[2];
  load.tangent = {along_z(k)};
  BodyMotion computed;
  computed.r[2] = x_c;
  EXPECT_NEAR(Tangent().pending_work({load, MeanLoad(), 0.0}, path, computed), 0.5 * k * (x_p * x_p - x_c * x_c),
              1e-12);
}

}  // namespace
}  // namespace footfall
