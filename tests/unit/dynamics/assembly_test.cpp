// From a model to a consistent start.

#include "mbd_solver/dynamics/assembly.h"
#include "coupler/base/pi.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "tests/unit/dynamics/random_model.h"

namespace footfall {
namespace {

std::string refusal(const Model& model) {
  try {
    assemble(model);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no InputError";
}

// Two bodies one metre apart, the second moved by `gap`.
Model pair_with_gap(const Eigen::Vector3d& gap) {
  Model model;
  BodyState second;
  second.r = Eigen::Vector3d(1.0, 0.0, 0.0) + gap;
  model.add_body(Body("a", 1.0, Eigen::Matrix3d::Identity()), {});
  model.add_body(Body("b", 2.0, Eigen::Matrix3d::Identity()), second);
  return model;
}

Marker at(const Model& model, int body, const Eigen::Vector3d& p_B,
          const Eigen::Matrix3d& axes = Eigen::Matrix3d::Identity()) {
  return body_marker(body, model.body(body), p_B, axes);
}

TEST(Assembly, ClosesSmallGapsToRoundOff) {
  Model model = pair_with_gap({2e-4, -3e-4, 1e-4});
  model.add_joint(
      fixed_joint("weld", at(model, 0, {0.5, 0.0, 0.0}),
                  at(model, 1, {-0.5, 0.0, 0.0}, rotation_matrix(quaternion_about({1.0, 1.0, 0.0}, 4e-4)))));
  const Assembly assembly = assemble(model);
  EXPECT_NEAR(assembly.largest_gap, std::sqrt(14.0) * 1e-4, 1e-12);
  Equations equations(model, assembly);
  EXPECT_LT(equations.drift(assembly.state).position, 1e-14);
  // The smallest change in the mass metric leaves the common mass centre where it was.
  const Eigen::Vector3d before = model.initial(0).r + 2.0 * model.initial(1).r;
  EXPECT_LT((assembly.state.q.segment<3>(0) + 2.0 * assembly.state.q.segment<3>(7) - before).norm(), 1e-12);
}

TEST(Assembly, RefusesWhatIsFarFromClosedAndNamesAllOfIt) {
  Model model = pair_with_gap({0.012, 0.0, 0.0});
  model.add_joint(spherical_joint("hinge_3", at(model, 0, {0.5, 0.0, 0.0}), at(model, 1, {-0.5, 0.0, 0.0})));
  model.add_joint(
      revolute_joint("tilted", ground_marker({0.0, 0.0, 0.0}, rotation_matrix(quaternion_about({1.0, 0.0, 0.0}, 0.1))),
                     at(model, 0, {0.0, 0.0, 0.0})));
  const std::string said = refusal(model);
  EXPECT_NE(said.find("joint \"hinge_3\" (spherical): gap of 0.012 m"), std::string::npos) << said;
  EXPECT_NE(said.find("joint \"tilted\" (revolute): its axes are off by 5.73 degrees"), std::string::npos) << said;
}

TEST(Assembly, SeesAHalfTurn) {
  // All sines of a prismatic joint vanish when body 2 is turned by 180 degrees about its axis.
  Model model = pair_with_gap(Eigen::Vector3d::Zero());
  model.add_joint(
      prismatic_joint("slide", at(model, 0, {0.0, 0.0, 0.0}, axes_with_z({1.0, 0.0, 0.0})),
                      at(model, 1, {0.0, 0.0, 0.0},
                         rotation_matrix(quaternion_about({1.0, 0.0, 0.0}, kPi)) * axes_with_z({1.0, 0.0, 0.0}))));
  EXPECT_NE(refusal(model).find("180 degrees"), std::string::npos) << refusal(model);
}

TEST(Assembly, MakesVelocitiesConsistent) {
  test::Random random(2);
  Model model;
  BodyState state;
  state.r = {1.0, 0.0, 0.0};
  state.dr = {3.0, 1.0, 0.0};
  const int body = model.add_body(Body("arm", 1.0, Eigen::Vector3d(0.1, 1.0, 1.0).asDiagonal()), state);
  model.add_joint(revolute_joint("pivot", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                 model.marker_at(body, Eigen::Vector3d::Zero())));
  const Assembly assembly = assemble(model);
  Equations equations(model, assembly);
  EXPECT_LT(equations.drift(assembly.state).velocity, 1e-14);
  // Projection in the mass metric keeps the moment of momentum about the pivot: m r v = (J + m r^2) w.
  EXPECT_NEAR(assembly.state.v[5], 1.0 / 2.0, 1e-14);
  EXPECT_NEAR(assembly.state.v[1], 0.5, 1e-14);
  EXPECT_NEAR(assembly.largest_speed_change, 3.0, 1e-14);
}

TEST(Assembly, LeavesOutRedundantConditionsAndSaysWhichFollowFromWhich) {
  // A door on two hinges: the second one repeats five conditions.
  Model model;
  const int door = model.add_body(Body("door", 20.0, Eigen::Vector3d(2.0, 1.0, 1.0).asDiagonal()), {});
  model.add_joint(
      revolute_joint("upper", model.marker_at(kGround, {-0.5, 0.0, 0.7}), model.marker_at(door, {-0.5, 0.0, 0.7})));
  model.add_joint(
      revolute_joint("lower", model.marker_at(kGround, {-0.5, 0.0, -0.7}), model.marker_at(door, {-0.5, 0.0, -0.7})));
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.kept_rows.size(), 5u);
  ASSERT_FALSE(assembly.notes.empty());
  std::string all;
  for (const std::string& note : assembly.notes) all += note;
  EXPECT_NE(all.find("\"upper\""), std::string::npos) << all;
  EXPECT_NE(all.find("\"lower\""), std::string::npos) << all;
  EXPECT_NE(all.find("redundant"), std::string::npos) << all;
}

TEST(Assembly, RefusesJointsThatContradictEachOther) {
  // Hinges of the door 0.4 mm out of line: parallel axes that can never meet, each within the gap that is
  // closed silently.
  Model model;
  const int door = model.add_body(Body("door", 20.0, Eigen::Vector3d(2.0, 1.0, 1.0).asDiagonal()), {});
  model.add_joint(revolute_joint("upper", ground_marker({0.0, 0.0, 0.7}), at(model, door, {0.0, 0.0, 0.7})));
  model.add_joint(prismatic_joint("lower", ground_marker({4e-4, 0.0, -0.7}), at(model, door, {0.0, 0.0, -0.7})));
  const std::string said = refusal(model);
  EXPECT_NE(said.find("contradict"), std::string::npos) << said;
  EXPECT_NE(said.find("\"lower\""), std::string::npos) << said;
}

TEST(Assembly, RefusesDrivesThatContradictEachOther) {
  Model model;
  const int body = model.add_body(Body("cart", 1.0, Eigen::Matrix3d::Identity()), {});
  for (int i = 0; i < 2; ++i) {
    PrescribedMotion motion;
    motion.translation[0] = polynomial({0.0, 1.0 + i});
    model.add_joint(prescribed_joint(i == 0 ? "slow" : "fast", ground_marker(Eigen::Vector3d::Zero()),
                                     at(model, body, {0.0, 0.0, 0.0}), motion));
  }
  const std::string said = refusal(model);
  EXPECT_NE(said.find("\"slow\", \"fast\""), std::string::npos) << said;
}

TEST(Assembly, NoticesWhenItStartedInASingularPosition) {
  // A crank and a rod stretched in line with their slide: one condition looks redundant there, and stops
  // being so in motion.
  Model model;
  BodyState rod;
  rod.r = {1.0, 0.0, 0.0};
  model.add_body(Body("crank", 1.0, Eigen::Matrix3d::Identity()), {});
  model.add_body(Body("rod", 1.0, Eigen::Matrix3d::Identity()), rod);
  model.add_joint(revolute_joint("bearing", ground_marker(Eigen::Vector3d::Zero()), at(model, 0, {0.0, 0.0, 0.0})));
  model.add_joint(revolute_joint("pin", at(model, 0, {1.0, 0.0, 0.0}), at(model, 1, {0.0, 0.0, 0.0})));
  // always redundant
  model.add_joint(distance_joint("stay", ground_marker({0.0, 0.0, 0.0}), at(model, 1, {0.0, 0.0, 0.0}), 1.0));
  // only here
  model.add_joint(distance_joint("tie", ground_marker({-1.0, 0.0, 0.0}), at(model, 1, {0.0, 0.0, 0.0}), 2.0));
  const Assembly assembly = assemble(model);
  Equations equations(model, assembly);
  State state = assembly.state;
  add_increment(
      equations.layout(),
      [&] {
        Eigen::VectorXd dx = Eigen::VectorXd::Zero(12);
        dx[5] = 0.3;
        dx.segment<3>(6) = Eigen::Vector3d(std::cos(0.3) - 1.0, std::sin(0.3), 0.0);
        return dx;
      }(),
      state.q);
  EXPECT_THROW(equations.project(state), NumericalError);
}

TEST(Model, RefusesBodiesThatCannotExist) {
  EXPECT_THROW(Body("b", -1.0, Eigen::Matrix3d::Identity()), InputError);
  EXPECT_THROW(Body("b", std::nan(""), Eigen::Matrix3d::Identity()), InputError);
  EXPECT_THROW(Body("b", 1.0, Eigen::Matrix3d::Zero()), InputError);
  // triangle inequality
  EXPECT_THROW(Body("b", 1.0, Eigen::Vector3d(1.0, 1.0, 3.0).asDiagonal()), InputError);
  Eigen::Matrix3d skewed = Eigen::Matrix3d::Identity();
  skewed(0, 1) = 0.2;
  EXPECT_THROW(Body("b", 1.0, skewed), InputError);
}

TEST(Model, RefusesNamesTwiceAndBodiesUnknown) {
  Model model = pair_with_gap(Eigen::Vector3d::Zero());
  EXPECT_THROW(model.add_body(Body("a", 1.0, Eigen::Matrix3d::Identity()), {}), InputError);
  const Joint joint = spherical_joint("j", at(model, 0, {0.5, 0.0, 0.0}), at(model, 1, {-0.5, 0.0, 0.0}));
  model.add_joint(joint);
  EXPECT_THROW(model.add_joint(joint), InputError);
  EXPECT_THROW(spherical_joint("k", at(model, 0, {0.5, 0.0, 0.0}), at(model, 0, {-0.5, 0.0, 0.0})), InputError);
  try {
    model.body_index("c");
    FAIL();
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("Known bodies: a, b"), std::string::npos);
  }
}

TEST(Model, FlexibleBodyMustKeepItsMassCentre) {
  // A basis that is not in mean axes would make gravity wrong without a word.
  test::Random random(8);
  std::shared_ptr<ModalBody> modal = test::hand_made_body(random, 4, 2);
  for (int j = 0; j < 4; ++j) modal->Phi(3 * j, 1) += 0.2;
  EXPECT_THROW(Body("b", modal), InputError);
}

}  // namespace
}  // namespace footfall
