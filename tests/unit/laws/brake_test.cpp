// The brake: it holds, slides, lets go, and keeps its account.

#include "mbd_solver/model/laws/brake.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/laws/law_checks.h"

namespace footfall {
namespace {

Brake brake() {
  BrakeParameters p;
  p.command = polynomial({0.5});
  p.largest_force = 10.0;
  p.lag = 0.01;
  return Brake(p);
}

TEST(Brake, SlidesAtItsForceTimesItsPressure) {
  const Brake law = brake();
  StrutOutput out(2);
  // A bristle bent by F_c / k = 1e-4 m is all that sliding leaves.
  const Eigen::Vector2d z(0.5, 1e-4);
  law.evaluate({0.0, 3.0, 0.0, z, 0.0}, out);
  EXPECT_NEAR(out.force, 0.5 * 10.0, 1e-9);
  EXPECT_NEAR(out.dz[0], 0.0, 1e-12);
  EXPECT_NEAR(out.dz[1], 0.0, 1e-9);
}

TEST(Brake, IsPressedByItsCommandAndASignalWithinItsLimits) {
  const Brake law = brake();
  StrutOutput out(2);
  const Eigen::Vector2d z(0.25, 0.0);
  const auto rate_of_pressure = [&](double command) {
    StrutInput in{0.0, 0.0, 0.0, z, 0.0};
    in.command = command;
    law.evaluate(in, out);
    return out.dz[0];
  };
  EXPECT_NEAR(rate_of_pressure(0.0), (0.5 - 0.25) / 0.01, 1e-12);
  EXPECT_NEAR(rate_of_pressure(9.0), (1.0 - 0.25) / 0.01, 1e-12);
  EXPECT_NEAR(rate_of_pressure(-9.0), -0.25 / 0.01, 1e-12);
}

TEST(Brake, LetsItsBristleGo) {
  const Brake law = brake();
  StrutOutput out(2);
  const Eigen::Vector2d z(0.3, 5e-5);
  StrutInput in{0.0, 0.0, 0.0, z, 0.0};
  in.command = -1.0;
  law.evaluate(in, out);
  EXPECT_NEAR(out.dz[1], -5e-5 / 0.01, 1e-12);
  EXPECT_NEAR(out.ddz_dz(1, 1), -1.0 / 0.01, 1e-9);
}

}  // namespace
}  // namespace footfall
