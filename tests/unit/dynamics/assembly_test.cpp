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

TEST(Assembly, FindsRedundantConditionsAndSaysWhichFollowFromWhich) {
  // A door on two hinges: the second one repeats five conditions.
  Model model;
  const int door = model.add_body(Body("door", 20.0, Eigen::Vector3d(2.0, 1.0, 1.0).asDiagonal()), {});
  model.add_joint(
      revolute_joint("upper", model.marker_at(kGround, {-0.5, 0.0, 0.7}), model.marker_at(door, {-0.5, 0.0, 0.7})));
  model.add_joint(
      revolute_joint("lower", model.marker_at(kGround, {-0.5, 0.0, -0.7}), model.marker_at(door, {-0.5, 0.0, -0.7})));
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, 5);
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

TEST(Assembly, TellsWhatItChangedOfTheGivenVelocities) {
  Model model;
  BodyState state;
  state.r = {1.0, 0.0, 0.0};
  state.dr = {3.0, 1.0, 0.0};
  const int body = model.add_body(Body("arm", 1.0, Eigen::Vector3d(0.1, 1.0, 1.0).asDiagonal()), state);
  model.add_joint(revolute_joint("pivot", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                 model.marker_at(body, Eigen::Vector3d::Zero())));
  const Assembly changed = assemble(model);
  ASSERT_EQ(changed.notes.size(), 1u);
  EXPECT_NE(changed.notes[0].find("joint \"pivot\" would open at 3 m/s"), std::string::npos) << changed.notes[0];
  EXPECT_NE(changed.notes[0].find("body \"arm\" is changed most, by 3.04 m/s and 0.5 rad/s"), std::string::npos)
      << changed.notes[0];
  AssemblyOptions lenient;
  lenient.speed_tolerance = 3.1;
  EXPECT_TRUE(assemble(model, lenient).notes.empty());
}

TEST(Assembly, TellsVelocitiesThatContradictEachOtherByATenThousandth) {
  Model model;
  BodyState state;
  state.r = {1.0, 0.0, 0.0};
  state.dr = {0.0, 1.0, 0.0};
  state.w = {0.0, 0.0, 1.0001};
  const int body = model.add_body(Body("arm", 1.0, Eigen::Matrix3d::Identity()), state);
  model.add_joint(revolute_joint("pivot", model.marker_at(kGround, Eigen::Vector3d::Zero()),
                                 model.marker_at(body, Eigen::Vector3d::Zero())));
  const Assembly changed = assemble(model);
  ASSERT_EQ(changed.notes.size(), 1u);
  EXPECT_NE(changed.notes[0].find("would open at 0.0001 m/s"), std::string::npos) << changed.notes[0];
}

TEST(Assembly, ChainsOfManyBodiesAreSparse) {
  // With dense matrices 1000 hinges would take minutes and 1 GB; the time limit of a unit test sees it.
  Model model;
  const int n = 1000;
  for (int i = 0; i < n; ++i) {
    BodyState state;
    state.r = {i + 0.5, 1e-4 * std::sin(0.1 * i), 0.0};
    model.add_body(Body("link_" + std::to_string(i), 1.0, Eigen::Matrix3d::Identity()), state);
    const Marker last = i == 0 ? ground_marker(Eigen::Vector3d::Zero()) : at(model, i - 1, {0.5, 0.0, 0.0});
    model.add_joint(revolute_joint("hinge_" + std::to_string(i), last, at(model, i, {-0.5, 0.0, 0.0})));
  }
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, 5 * n);
  EXPECT_TRUE(assembly.redundant.empty());
  Equations equations(model, assembly);
  EXPECT_LT(equations.drift(assembly.state).position, 1e-12);  // round-off of 1000 m
}

// A crank whose pin is 1 m from its bearing and 2 m from a peg in line with both: `tie` tells nothing new in this
// position, and holds the crank in all others.
Model toggle() {
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
  return model;
}

TEST(Equations, ClosesWhatWasRedundantAtTheStartOnly) {
  const Model model = toggle();
  const Assembly assembly = assemble(model);
  EXPECT_EQ(assembly.rank, 10);
  Equations equations(model, assembly);
  State state = assembly.state;
  Eigen::VectorXd dx = Eigen::VectorXd::Zero(12);
  dx[5] = 0.01;
  dx.segment<3>(6) = Eigen::Vector3d(std::cos(0.01) - 1.0, std::sin(0.01), 0.0);
  add_increment(equations.layout(), dx, state.q);
  EXPECT_GT(equations.drift(state).position, 1e-6);
  // Near a double root the way back is halved by each step of Newton's: some calls, as in the steps of a run.
  double left = 1.0;
  for (int i = 0; i < 10 && left > 1e-9; ++i) {
    try {
      left = equations.project(state).position_left;
    } catch (const NumericalError&) {
      left = equations.drift(state).position;
    }
  }
  EXPECT_LT(left, 1e-9);
}

TEST(Equations, NamesTheJointThatStaysOpen) {
  const Model model = toggle();
  Equations equations(model, assemble(model));
  State state = assemble(model).state;
  state.q.segment<3>(7) += Eigen::Vector3d(0.0, 0.0, 50.0);  // far from any closed position of the rod
  state.q[0] = 40.0;
  try {
    equations.project(state);
    FAIL() << "open joints were taken for closed";
  } catch (const NumericalError& error) {
    EXPECT_NE(std::string(error.what()).find("joint \""), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("is open by"), std::string::npos) << error.what();
  }
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
