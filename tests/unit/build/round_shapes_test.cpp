// Rigid spheres, rods and discs meet the plane as what they are, not by the nodes of their triangles:
// mbd_solver/build/build_boundaries.cpp and the round edges of mbd_solver/model/elements/rigid_plane.h.

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/pi.h"
#include "mbd_solver/build/mechanism.h"
#include "tests/unit/dynamics/jacobian_check.h"
#include "tests/unit/dynamics/run.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

constexpr double kRadius = 0.1, kGravity = 9.81, kStiffness = 1e6;

// One body of 2 kg that touches the plane with its surface.
Mechanism built(const std::string& shape, const std::vector<std::string>& settings = {}) {
  const SceneText folder;
  return build_mechanism(
      folder.read("end_time = 1\ngravity = [0, 0, -9.81]\n[[bodies]]\nname = \"b\"\nmass = 2\nshape = " + shape +
                      "\n[[boundaries]]\nbody = \"b\"\nsurface = {}\n[ground]\nkind = \"plane\"\n"
                      "[ground.plane]\nstiffness = 1e6\ndamping = 1\nfriction = 0.5\n"
                      "[initial]\nclearance = 0\n",
                  settings));
}

const char* const kBall = "{ kind = \"sphere\", centre = [0, 0, 0.3], radius = 0.1 }";
const char* const kRod = "{ kind = \"rod\", from = [0, -0.15, 0], to = [0, 0.15, 0], diameter = 0.2 }";
const char* const kTube = "{ kind = \"tube\", from = [0, -0.15, 0], to = [0, 0.15, 0], diameter = 0.2, wall = 0.02 }";
const char* const kWheel = "{ kind = \"disc\", axis = \"y\", radius = 0.1, thickness = 0.05 }";
const char* const kRoller = "{ kind = \"cylinder\", axis = \"y\", radius = 0.1, length = 0.3 }";
const char* const kCapsule = "{ kind = \"capsule\", from = [0, -0.15, 0], to = [0, 0.15, 0], diameter = 0.2 }";
const char* const kPlate = "{ kind = \"disc\", axis = \"z\", radius = 0.1, thickness = 0.05 }";

TEST(RoundShape, StandsOnThePlaneWithItsLowestPlace) {
  for (const char* shape : {kBall, kRod, kTube, kWheel, kRoller, kCapsule})
    EXPECT_NEAR(built(shape).model.initial(0).r.z(), kRadius, 1e-15) << shape;
  EXPECT_NEAR(built(kPlate).model.initial(0).r.z(), 0.025, 1e-15);
  // Tilted: half the thickness along the axis, the radius across.
  const double tilt = 0.3;
  EXPECT_NEAR(built(kPlate, {"initial.roll=0.3"}).model.initial(0).r.z(),
              0.025 * std::cos(tilt) + kRadius * std::sin(tilt), 1e-15);
}

// From rest down a slope of 10 degrees without slip: a = g sin / (1 + J / (m R^2)).
TEST(RoundShape, RollsDownASlopeAsRoundAsItIs) {
  const double sine = std::sin(10.0 * kPi / 180.0), cosine = std::sqrt(1.0 - sine * sine);
  const std::string normal = "ground.plane.normal=[" + std::to_string(-sine) + ",0," + std::to_string(cosine) + "]";
  const double inner = 0.08;
  const std::pair<const char*, double> shapes[] = {{kBall, 2.0 / 5.0},
                                                   {kRod, 1.0 / 2.0},
                                                   {kTube, 0.5 * (1.0 + inner * inner / (kRadius * kRadius))},
                                                   {kWheel, 1.0 / 2.0},
                                                   {kRoller, 1.0 / 2.0},
                                                   // A cylinder 0.3 long and a ball: 9/13 and 4/13 of the mass.
                                                   {kCapsule, (9.0 * 0.5 + 4.0 * 0.4) / 13.0}};
  for (const auto& [shape, J] : shapes) {
    const Mechanism mechanism = built(shape, {normal});
    test::Run run(mechanism.model);
    run.to(0.4, 10);
    const double speed = run.body(0).dr.dot(Eigen::Vector3d(-cosine, 0.0, -sine));
    const double rolling = 0.4 * kGravity * sine / (1.0 + J);
    // It slips by v_s (2/7 of tan 10 degrees) / mu at most, 1e-4 of this speed, while it settles by 1e-3 m: 1e-3.
    EXPECT_NEAR(speed, rolling, 1e-3 * rolling) << shape;
    EXPECT_LT(std::abs(run.imbalance()), 1e-3 * run.energy().stored[Stored::kKinetic])
        << shape;  // the integrator's tolerance
  }
}

// m places of a rim that lies flat carry alike: m k delta^1.5 = m g.
TEST(RoundShape, DiscLiesOnItsWholeRim) {
  const Mechanism mechanism = built(kPlate, {"ground.plane.damping=100"});  // it comes to rest soon
  test::Run run(mechanism.model);
  run.to(1.0, 10);
  const double overlap = std::pow(2.0 * kGravity / (12.0 * kStiffness), 2.0 / 3.0);
  EXPECT_NEAR(run.body(0).r.z(), 0.025 - overlap, 0.01 * overlap);  // what is left of its bounce
  EXPECT_NEAR(run.body(0).A(2, 2), 1.0, 1e-12);
}

// What sticks stays; with smooth friction it creeps, slowly, and as fast as the summary says.
TEST(RoundShape, PlateOnASlopeCreepsAsSlowlyAsIsSaid) {
  const double slope = 10.0 * kPi / 180.0, v_s = 1e-4;
  const std::string normal =
      "ground.plane.normal=[" + std::to_string(-std::sin(slope)) + ",0," + std::to_string(std::cos(slope)) + "]";
  const auto speed_after = [&](std::vector<std::string> settings) {
    for (const char* other : {"initial.pitch_deg=-10", "ground.plane.friction=0.3", "ground.plane.damping=100"})
      settings.push_back(other);
    const Mechanism mechanism = built(kPlate, settings);
    test::Run run(mechanism.model);
    run.to(1.0, 10);
    return run.body(0).dr.dot(Eigen::Vector3d(-std::cos(slope), 0.0, -std::sin(slope)));
  };
  const double creep = creep_speed(0.3, v_s, slope);
  EXPECT_NEAR(creep, 0.727 * v_s, 1e-3 * v_s);  // tan 10 deg = 0.1763: 0.1763 / sqrt(0.09 - 0.0311)
  EXPECT_NEAR(speed_after({normal, "ground.plane.friction_speed=1e-4"}), creep, 0.02 * creep);  // left of its bounce
  EXPECT_LT(std::abs(speed_after({normal})), 1e-6);
}

// Grains meet both faces of a rigid disc and a rim of its thickness, unless its mid-surface is asked for.
TEST(RoundShape, DiscHasItsThicknessForGrains) {
  const auto half_width = [](const std::vector<std::string>& settings) {
    return built(kPlate, settings).boundaries[0].boundary.rho0().row(2).cwiseAbs().maxCoeff();
  };
  EXPECT_NEAR(half_width({}), 0.025, 1e-15);
  EXPECT_NEAR(half_width({"boundaries.b.surface.faces=\"middle\""}), 0.0, 1e-15);
}

TEST(RoundShape, DerivativesOfItsForceAreThoseOfDifferences) {
  for (const char* shape : {kBall, kRod, kWheel, kPlate, kCapsule}) {
    for (const char* roll : {"initial.roll=0.02", "initial.roll=0.7"}) {
      const Mechanism mechanism =
          built(shape, {roll, "initial.pitch=0.4", "initial.clearance=-0.02", "ground.plane.friction_speed=0.5",
                        "ground.plane.normal=[0.1,0.2,1]", "initial.velocity=[0.3,-0.2,-0.1]",
                        "initial.angular_velocity=[1,-2,3]"});
      test::Run run(mechanism.model);
      Eigen::VectorXd rates(run.equations.layout().size()), y(run.equations.layout().size());
      run.equations.accelerations(run.state, run.inputs, rates);
      run.equations.pack(run.state, rates.tail(run.equations.layout().row_count), y);
      std::string where;
      EXPECT_LT(test::jacobian_error(run.equations, y, rates, 10.0, run.inputs, &where), 1e-7)  // see its step
          << shape << ", " << roll << ": " << where;
    }
  }
}

// A plate thrown on its edge falls flat, turning all the while: what its places travel along the rim does no work.
TEST(RoundShape, EnergyClosesWhileAPlateFallsFlat) {
  const Mechanism mechanism =
      built(kPlate, {"initial.roll=0.5", "initial.clearance=0.01", "initial.angular_velocity=[1,2,5]"});
  test::Run run(mechanism.model, "one_step", test::tight(1e-9));
  run.to(0.3, 20);
  EXPECT_GT(run.state.dissipated[Dissipation::kContact], 0.05);
  EXPECT_GT(run.state.dissipated[Dissipation::kFriction], 0.01);
  EXPECT_LT(std::abs(run.imbalance()), 1e-4 * run.state.dissipated.total());  // at a tolerance of 1e-9
}

}  // namespace
}  // namespace footfall
