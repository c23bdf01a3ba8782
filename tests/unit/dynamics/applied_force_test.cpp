// mbd_solver/model/elements/applied_force.h: forces and torques over time on free bodies, against exact motions.

#include "mbd_solver/model/elements/applied_force.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/unit/dynamics/random_model.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

// Of fifth order: a second-order run would take ten thousand steps for the same.
constexpr double kMass = 2.0, kInertia = 0.5;  // [kg], about every axis [kg m2]
// rtol of the runs is 1e-11; positions, speeds and works are of order one to ten, and works are summed step by step.
constexpr double kTolerance = 1e-7;

struct FreeBody {
  FreeBody(const Eigen::Vector3d& p_B, std::optional<Eigen::Vector3d> direction, TimeFunctionPtr force,
           TimeFunctionPtr torque, const BodyState& initial = {}) {
    model.add_body(Body("body", kMass, kInertia * Eigen::Matrix3d::Identity()), initial);
    Eigen::Matrix3d axes;  // z of the marker is x of the body
    axes << 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 1.0, 0.0;
    model.add_force(std::make_unique<AppliedForce>("push", body_marker(0, model.body(0), p_B, axes), direction,
                                                   std::move(force), std::move(torque)));
  }
  Model model;
};

TEST(AppliedForce, ConstantMovesABodyAlongAParabola) {
  const FreeBody body(Eigen::Vector3d::Zero(), Eigen::Vector3d::UnitZ(), polynomial({3.0}), nullptr);
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(2.0);
  EXPECT_NEAR(run.body(0).r.z(), 0.5 * 3.0 / kMass * 4.0, kTolerance);
  EXPECT_NEAR(run.body(0).dr.z(), 3.0 / kMass * 2.0, kTolerance);
  EXPECT_NEAR(run.state.supplied[Supply::kForce], 3.0 * 3.0, kTolerance);  // F s
  EXPECT_NEAR(run.imbalance(), 0.0, kTolerance);
}

TEST(AppliedForce, TorqueSpinsUpOverTime) {
  // m(t) = 0.2 + 0.6 t:  w = (0.2 t + 0.3 t^2) / I, about x of the body
  const FreeBody body(Eigen::Vector3d(0.3, 0.2, 0.1), std::nullopt, nullptr, polynomial({0.2, 0.6}));
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(2.0);
  const double w = (0.4 + 1.2) / kInertia;
  EXPECT_NEAR(run.body(0).w.x(), w, kTolerance);
  EXPECT_NEAR(run.body(0).r.norm(), 0.0, kTolerance);
  EXPECT_NEAR(run.state.supplied[Supply::kForce], 0.5 * kInertia * w * w, kTolerance);
}

// A force along x of a body that spins about z at W turns with it: the acceleration is a circle.
//   v = F / (m W) [sin W t, 1 - cos W t],  r = F / (m W^2) [1 - cos W t, W t - sin W t]
TEST(AppliedForce, FollowsTheBody) {
  const double F = 3.0, W = 5.0, t = 1.7;
  BodyState initial;
  initial.w = W * Eigen::Vector3d::UnitZ();
  const FreeBody body(Eigen::Vector3d::Zero(), std::nullopt, polynomial({F}), nullptr, initial);
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(t);
  const Eigen::Vector3d r = F / (kMass * W * W) * Eigen::Vector3d(1.0 - std::cos(W * t), W * t - std::sin(W * t), 0.0);
  const Eigen::Vector3d v = F / (kMass * W) * Eigen::Vector3d(std::sin(W * t), 1.0 - std::cos(W * t), 0.0);
  EXPECT_LT((run.body(0).r - r).norm(), kTolerance);
  EXPECT_LT((run.body(0).dr - v).norm(), kTolerance);
  EXPECT_NEAR(run.imbalance(), 0.0, kTolerance);
}

// At a point off the centre a fixed force is a pendulum's weight, and conserves F.p - energy.
TEST(AppliedForce, StandsInSpaceAndMovesWithItsPoint) {
  const double F = 4.0;
  const FreeBody body(Eigen::Vector3d(0.4, 0.0, 0.0), -F / F * Eigen::Vector3d::UnitZ(), polynomial({F}), nullptr);
  test::Run run(body.model, "one_step", test::precise(1e-11));
  run.to(1.5);
  const BodyKinematics at = run.body(0);
  const double fallen = 0.0 - (at.r + at.A * Eigen::Vector3d(0.4, 0.0, 0.0)).z();
  EXPECT_NEAR(at.r.z(), -0.5 * F / kMass * 1.5 * 1.5, kTolerance);  // the centre moves as a point
  EXPECT_NEAR(run.state.supplied[Supply::kForce], F * fallen, kTolerance);
  EXPECT_GT(std::abs(at.w.y()), 1.0);
}

TEST(AppliedForce, IsTheSameOnBothIntegrators) {
  const FreeBody body(Eigen::Vector3d(0.1, 0.2, 0.3), std::nullopt, sine(3.0, 2.0), sine(0.5, 1.0, 0.3));
  test::Run one(body.model, "one_step", test::precise(1e-10)), other(body.model, "ida", test::precise(1e-10));
  one.to(1.0);
  other.to(1.0);
  EXPECT_LT((one.state.q - other.state.q).norm(), 1e-6);  // the errors of both
}

}  // namespace
}  // namespace footfall
