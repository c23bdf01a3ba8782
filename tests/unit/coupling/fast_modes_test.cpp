// Elastic modes that swing within a window.

#include "mbd_solver/coupling/fast_modes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace footfall {
namespace {

BodyMotion one_mode(double a, double da, double dda) {
  BodyMotion motion(1);
  motion.a[0] = a;
  motion.da[0] = da;
  motion.dda[0] = dda;
  return motion;
}

BodyMotion slowed(const BodyMotion& motion, double Omega, double H) {
  BodyMotion path = motion;
  slow_down_fast_modes(motion, Eigen::VectorXd::Constant(1, Omega * Omega), H, path);
  return path;
}

// a(tau) = a_s + (a - a_s) cos(Omega tau) + da / Omega sin(Omega tau), by the trapezoidal rule.
TEST(FastModes, PathHasTheMeanOfTheFreeSwing) {
  const double Omega = 2000.0, H = 0.01, a_s = 0.3, a = 0.1, da = 50.0;
  const int parts = 20000;
  double mean = 0.0;
  for (int k = 0; k <= parts; ++k) {
    const double tau = H * k / parts;
    mean += (k == 0 || k == parts ? 0.5 : 1.0) / parts *
            (a_s + (a - a_s) * std::cos(Omega * tau) + da / Omega * std::sin(Omega * tau));
  }
  const BodyMotion path = slowed(one_mode(a, da, Omega * Omega * (a_s - a)), Omega, H);
  EXPECT_NEAR(a + path.da[0] * H / 2.0, mean, 1e-5);
  EXPECT_LT(std::abs(path.dda[0]), 1e-5 * Omega * Omega);
}

TEST(FastModes, SlowModesAndRigidBodiesKeepTheirPath) {
  const BodyMotion slow = one_mode(0.1, 3.0, -2.0);
  EXPECT_EQ(slowed(slow, 1.0, 0.005).da, slow.da);
  EXPECT_NEAR(slowed(slow, 1.0, 0.1).da[0], 3.0, 1e-4);
  BodyMotion rigid;
  rigid.dr = {1.0, 2.0, 3.0};
  BodyMotion path = rigid;
  slow_down_fast_modes(rigid, {}, 1.0, path);
  EXPECT_EQ(path.dr, rigid.dr);
}

// Largest growth per window of a mode (Omega = theta, H = 1) that pushes on grains of kappa Omega^2, without damping;
// the path starts where the boundary stands, s, and the mode gets the mean force. State [a, da, dda, s].
double growth(double theta, double kappa, bool slowing) {
  const double stiffness = theta * theta;
  Eigen::Matrix4d map;
  for (int j = 0; j < 4; ++j) {
    const Eigen::Vector4d z = Eigen::Vector4d::Unit(j);
    BodyMotion path = one_mode(z[0], z[1], z[2]);
    if (slowing) path = slowed(path, theta, 1.0);
    const double end = z[0] + path.da[0], Q = -kappa * stiffness * 0.5 * (z[3] + end), held = Q / stiffness;
    const double a = held + (z[0] - held) * std::cos(theta) + z[1] / theta * std::sin(theta);
    const double da = -(z[0] - held) * theta * std::sin(theta) + z[1] * std::cos(theta);
    map.col(j) << a, da, Q - stiffness * a, end;
  }
  return map.eigenvalues().cwiseAbs().maxCoeff();
}

TEST(FastModes, NoLongerPumpEnergy) {
  double straight = 0.0, slow = 0.0;
  for (double theta = 0.02; theta < 25.0; theta += 0.0167) {
    straight = std::max(straight, growth(theta, 0.05, false));
    slow = std::max(slow, growth(theta, 0.05, true));
  }
  std::printf("  largest growth per window: %.4f straight, %.4f slowed\n", straight, slow);
  EXPECT_GT(straight, 1.2);
  EXPECT_LT(slow, 1.02);
}

}  // namespace
}  // namespace footfall
