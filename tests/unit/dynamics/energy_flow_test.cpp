// The scale of energy errors: what has moved from one form to another, whoever looks on.

#include "mbd_solver/dynamics/energy_flow.h"

#include <gtest/gtest.h>

#include "coupler/base/pi.h"
#include "mbd_solver/model/elements/joint_force.h"
#include "tests/unit/dynamics/run.h"

namespace footfall {
namespace {

// Runs to t_end in windows and takes the flow at each.
double flow_of(test::Run& run, const Model& model, double t_end, int windows) {
  EnergyFlow flow(model);
  Kinematics kinematics(model);
  const auto take = [&] {
    kinematics.load(run.equations.layout(), run.state.q, run.state.v, Eigen::VectorXd());
    flow.take(run.energy().stored, run.state, kinematics);
  };
  take();
  for (int k = 1; k <= windows; ++k) {
    run.to(t_end * k / windows);
    take();
  }
  return flow.scale();
}

// A crank of 1 kg on an arm of 0.5 m, driven once round within `period` about a level axis.
Model driven_crank(double period) {
  Model model({0.0, 0.0, -10.0});
  BodyState start;
  start.r = {0.0, 0.0, -0.5};
  const int crank = model.add_body(Body("crank", 1.0, 0.01 * Eigen::Matrix3d::Identity()), start);
  PrescribedMotion motion;
  motion.translation = {polynomial({0.0}), polynomial({0.0}), polynomial({0.0})};
  motion.rotation = ramp(0.0, 2.0 * kPi, 0.0, period);
  motion.rotation_axis = 1;
  motion.hold_other_rotations = true;
  model.add_joint(prescribed_joint("drive", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                   model.marker_at(crank, Eigen::Vector3d::Zero()), motion));
  return model;
}

TEST(EnergyFlow, OfASlowCrankIsTheWorkOfItsDrive) {
  // Up by 1 m and down again: the drive lifts 10 J and takes 10 J back. The kinetic energy is 1e-4 of it.
  const Model model = driven_crank(100.0);
  test::Run run(model);
  EXPECT_NEAR(flow_of(run, model, 100.0, 200), 20.0, 0.01);  // extremes between the samples: 1 - cos(pi / 200)
  // The account of that run closes to some mJ: well of 20 J, and three times the kinetic energy it was set against.
  EXPECT_LT(std::abs(run.imbalance()), 0.01 * 20.0);
}

// Two wheels of unequal inertia on a spring that turns them against each other, thrown; the bearing flies with them.
Model two_wheels(const Eigen::Vector3d& frame) {
  Model model;
  BodyState a, b;
  a.dr = b.dr = frame;
  a.w = {0.0, 0.0, 1.0};
  const int first = model.add_body(Body("a", 2.0, 0.3 * Eigen::Matrix3d::Identity()), a);
  const int second = model.add_body(Body("b", 1.0, 0.1 * Eigen::Matrix3d::Identity()), b);
  model.add_joint(revolute_joint("bearing", model.marker_at(first, Eigen::Vector3d::Zero()),
                                 model.marker_at(second, Eigen::Vector3d::Zero())));
  LinearSpringDamperParameters parameters;
  parameters.stiffness = 4.0;
  parameters.damping = 0.05;
  model.add_force(torsional_spring("spring", model.marker_at(first, Eigen::Vector3d::Zero()),
                                   model.marker_at(second, Eigen::Vector3d::Zero()), parameters));
  return model;
}

TEST(EnergyFlow, IsTheSameInAMovingFrame) {
  const Model still = two_wheels(Eigen::Vector3d::Zero());
  const Model moving = two_wheels({100.0, -30.0, 20.0});
  test::Run at_rest(still, "one_step", test::tight(1e-9)), in_flight(moving, "one_step", test::tight(1e-9));
  const double flow = flow_of(at_rest, still, 2.0, 100);
  EXPECT_GT(flow, 0.1);
  // Tolerances are relative to velocities of 100 m/s there.
  EXPECT_NEAR(flow_of(in_flight, moving, 2.0, 100), flow, 1e-5 * flow);
}

TEST(EnergyFlow, OfAFreeSpinIsItsKineticEnergy) {
  Model model;
  BodyState spin;
  spin.dr = {100.0, 0.0, 0.0};
  spin.w = {0.0, 0.0, 3.0};
  model.add_body(Body("top", 1.0, 0.2 * Eigen::Matrix3d::Identity()), spin);
  test::Run run(model);
  EXPECT_NEAR(flow_of(run, model, 1.0, 10), 0.5 * 0.2 * 9.0, 1e-9);  // round-off of 5000 J
}

}  // namespace
}  // namespace footfall
