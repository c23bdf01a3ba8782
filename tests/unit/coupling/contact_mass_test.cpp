#include "mbd_solver/coupling/contact_mass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/dynamics/assembly.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using Eigen::Vector3d;

// Solves for accelerations are good to this.
constexpr double kRoundOff = 1e-9;

constexpr double kPlate = 3.0, kInertia = 0.02;  // [kg], [kg m2]
const std::string kFree = R"(end_time = 1.0
gravity = [0, 0, -9.81]
[[bodies]]
name = "plate"
mass = 3.0
inertia = [0.02, 0.02, 0.02]
position = [1, 0, 0]
)";
std::string joined_by(const std::string& type, const std::string& more = "") {
  return kFree + "[[joints]]\nname = \"joint\"\ntype = \"" + type +
         "\"\nbodies = [\"ground\", \"plate\"]\npoint = [0, 0, 0]\n" + more;
}

// Mass along a load on the plate, whose boundary reaches 0.5 m.
double mass(const std::string& scene, const Vector3d& F_W, const Vector3d& T_B = Vector3d::Zero()) {
  const Mechanism mechanism = build_mechanism(SceneText().read(scene));
  const Assembly assembly = assemble(mechanism.model);
  Equations equations(mechanism.model, assembly);
  Eigen::Matrix3Xd nodes(3, 2);
  nodes << 0.0, 0.5, 0.0, 0.0, 0.0, 0.0;
  ContactMass contact(equations, 0, ModalBoundary("plate", nodes, {}));
  Inputs inputs;
  inputs.loads.resize(1);
  inputs.loads[0].F_W = F_W;
  inputs.loads[0].T_B = T_B;
  return contact.along(inputs.loads[0], assembly.state, 1e-3);
}

TEST(ContactMass, OfAFreeBodyIsItsMass) {
  EXPECT_EQ(mass(kFree, Vector3d::Zero()), kPlate);
  EXPECT_NEAR(mass(kFree, Vector3d(0.1, -20.0, 3.0)), kPlate, kRoundOff);
}

TEST(ContactMass, OfAForceBesideTheCentreIsLess) {
  // 1/m = 1/m0 + d^2/J for a force at the distance d.
  EXPECT_NEAR(mass(kFree, Vector3d(0, 0, 5), Vector3d(0, -5 * 0.1, 0)), 1.0 / (1.0 / kPlate + 0.01 / kInertia),
              kRoundOff);
}

TEST(ContactMass, OfForcesThatCancelIsThatAtTheReach) {
  EXPECT_NEAR(mass(kFree, Vector3d(0, 0, 1e-9), Vector3d(0, 7, 0)), 1.0 / (1.0 / kPlate + 0.25 / kInertia), kRoundOff);
}

TEST(ContactMass, WhereAJointTakesTheLoadIsInfinite) {
  EXPECT_TRUE(std::isinf(mass(joined_by("fixed"), Vector3d(1, 2, 3), Vector3d(1, 0, 0))));
  const std::string slides = joined_by("prismatic", "axis = \"x\"\n");
  EXPECT_TRUE(std::isinf(mass(slides, Vector3d(0, 0, 4))));
  EXPECT_NEAR(mass(slides, Vector3d(4, 0, 0)), kPlate, kRoundOff);
  const std::string led = joined_by("prescribed",
                                    "axis = \"z\"\naxis2 = \"x\"\n[joints.motion]\nhold_other_rotations = true\n"
                                    "x = { polynomial = [0] }\ny = { polynomial = [0] }\n"
                                    "z = { amplitude = 0.1, frequency = 5 }\nrotation = { polynomial = [0] }\n");
  EXPECT_TRUE(std::isinf(mass(led, Vector3d(1, 2, 3))));
}

TEST(ContactMass, OnAnArmIsItsInertiaOverTheSquareOfTheArm) {
  // Hinged at the origin, 1 m from the mass centre: m = (J + m0 l^2) / l^2.
  EXPECT_NEAR(mass(joined_by("revolute", "axis = \"y\"\n"), Vector3d(0, 0, 2)), kPlate + kInertia, kRoundOff);
}

}  // namespace
}  // namespace footfall
