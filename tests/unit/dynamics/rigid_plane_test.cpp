// mbd_solver/model/elements/rigid_plane.h. Friction on a slope and on the flat: what sticks stays, what slides has mu f_n.

#include <cmath>
#include <vector>

#include "coupler/base/pi.h"
#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

constexpr double kGravity = 9.81, kBlockMass = 2.0, kStiffness = 1e6;

// A block that stands on a plane through the origin, inclined about y, on a grid of points; x runs down the slope.
struct Block {
  Block(double slope, double friction, double speed, int points_per_side = 2)
      : down(std::cos(slope), 0.0, -std::sin(slope)) {
    plane.normal = {std::sin(slope), 0.0, std::cos(slope)};
    plane.stiffness = kStiffness;
    plane.damping = 10.0;
    plane.friction = friction;
    const int count = points_per_side * points_per_side;
    const double overlap = std::pow(kBlockMass * kGravity * std::cos(slope) / (count * kStiffness), 2.0 / 3.0);
    BodyState state;
    state.L = quaternion_about(Eigen::Vector3d::UnitY(), slope);
    state.r = (0.05 - overlap) * plane.normal;
    state.dr = speed * down;
    model.add_body(Body("block", kBlockMass, 0.02 * Eigen::Matrix3d::Identity()), state);
    std::vector<ContactPoint> points;
    for (int i = 0; i < count; ++i) {
      const double x = i % points_per_side, y = i / points_per_side;
      const double step = 0.2 / (points_per_side - 1);
      points.push_back({body_marker(0, model.body(0), {x * step - 0.1, y * step - 0.1, -0.05}), 0.0});
    }
    model.add_force(std::make_unique<RigidPlane>("plane", points, plane));
  }
  double way(test::Run& run) const { return run.body(0).r.dot(down); }
  double speed(test::Run& run) const { return run.body(0).dr.norm(); }

  Eigen::Vector3d down;
  RigidPlane::Parameters plane;
  Model model{{0.0, 0.0, -kGravity}};
};

class OnThePlane : public ::testing::TestWithParam<const char*> {};
INSTANTIATE_TEST_SUITE_P(Integrators, OnThePlane, ::testing::Values("one_step", "ida"));

TEST_P(OnThePlane, BlockOnASlopeStaysWhereItIs) {
  // 10 degrees ask for 59 % of the friction there is; 16.5 for 98.7 %.
  constexpr double kRest = 1e-6;  // [m/s]
  for (double degrees : {10.0, 16.5}) {
    for (int points_per_side : {2, 12}) {
      const Block block(degrees * kPi / 180.0, 0.3, 0.0, points_per_side);
      test::Run run(block.model, GetParam());
      // Near the limit it slides a little first, until the springs are nearly full: they fill ever more slowly.
      const double settled = degrees < 15.0 ? 1.0 : 3.0;  // [s]
      run.to(settled);
      const double way = block.way(run);
      EXPECT_LT(block.speed(run), kRest) << degrees;
      run.to(settled + 2.0);
      EXPECT_LT(block.speed(run), kRest) << degrees;
      EXPECT_LT(std::abs(block.way(run) - way), 1e-7) << degrees;
      EXPECT_LT(std::abs(run.imbalance()), 1e-4);
    }
  }
}

TEST_P(OnThePlane, BlockSlidesWithMuTimesTheNormalForce) {
  const double slope = 30.0 * kPi / 180.0, mu = 0.2, v = 0.1;
  const Block block(slope, mu, v);
  test::Run run(block.model, GetParam(), test::tight(1e-8));
  const double way = block.way(run);
  run.to(0.5, 3);
  const double acceleration = kGravity * (std::sin(slope) - mu * std::cos(slope));
  // Friction lacks (v_s / v)^2 / 2 of mu f_n, 5e-5 at the start; the block rocks for a moment, as friction acts below it.
  EXPECT_NEAR(block.way(run) - way, 0.5 * v + 0.125 * acceleration, 1e-4);
  EXPECT_LT(std::abs(run.imbalance()), 1e-5 * run.state.dissipated[Dissipation::kFriction]);
}

TEST_P(OnThePlane, ThrownBlockStopsAndStays) {
  const double mu = 0.3, v = 0.5;
  const Block block(0.0, mu, v);
  test::Run run(block.model, GetParam());
  run.to(1.0, 5);
  EXPECT_NEAR(block.way(run), v * v / (2.0 * mu * kGravity), 1e-3);  // it rocks when it stops
  EXPECT_LT(block.speed(run), 1e-6);
  EXPECT_NEAR(run.state.dissipated.total(), 0.5 * kBlockMass * v * v, 1e-4);
  EXPECT_LT(std::abs(run.imbalance()), 1e-4);
}

TEST_P(OnThePlane, TurnedBlockStopsTurning) {
  // Spin about the normal on a slope on which it would stick: friction takes it, and then holds.
  Block block(10.0 * kPi / 180.0, 0.5, 0.0, 4);
  test::Run run(block.model, GetParam());
  run.state.v.segment<3>(3) = 3.0 * block.plane.normal;
  run.to(1.0, 2);
  EXPECT_LT(run.body(0).w.norm(), 1e-5);
  EXPECT_LT(block.speed(run), 1e-6);
}

}  // namespace
}  // namespace footfall
