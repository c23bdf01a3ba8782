// [initial.joints]: numbers for joints of one coordinate, tables for all; starts beyond stops.

#include "mbd_solver/scene/initial_joints.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::Not;

// The pendulum with its hinge of another type.
std::string pendulum_on(const std::string& type) {
  std::string toml = kPendulum;
  return toml.replace(toml.find("revolute"), 8, type);
}

const std::string kNumber = "[initial.joints]\nhinge = 0.3\n";

TEST(InitialJoints, ANumberIsTheOneCoordinate) {
  const SceneText text;
  const Scene turned = text.read(kPendulum + kNumber), moved = text.read(pendulum_on("prismatic") + kNumber);
  ASSERT_EQ(turned.initial.joints.size(), 1u);
  EXPECT_EQ(turned.initial.joints[0].angle, 0.3);
  EXPECT_FALSE(turned.initial.joints[0].displacement);
  EXPECT_EQ(moved.initial.joints.at(0).displacement, 0.3);
  EXPECT_FALSE(moved.initial.joints[0].angle);
  EXPECT_EQ(text.read(kPendulum, {"initial.joints.hinge=0.3"}).initial.joints.at(0).angle, 0.3);
}

TEST(InitialJoints, ANumberGoesToAnEntryOfAnArray) {
  const SceneText text;
  std::string toml = "end_time = 1\n[arrays.leg]\ncount = 2\n" + kPendulum.substr(kPendulum.find("[[bodies]]"));
  for (const std::string name : {"bob", "hinge"})
    for (std::size_t at = toml.find("\"" + name + "\""); at != std::string::npos; at = toml.find("\"" + name + "\""))
      toml.replace(at, name.size() + 2, "\"" + name + "_{leg}\"");
  const Scene scene = text.read(toml + "[initial.joints]\nhinge_2 = 0.3\n");
  ASSERT_EQ(scene.initial.joints.size(), 1u);
  EXPECT_EQ(scene.initial.joints[0].angle, 0.3);
}

TEST(InitialJoints, ANumberForSeveralCoordinatesTellsWhatToWrite) {
  const SceneText text;
  const std::string findings = text.findings(pendulum_on("cylindrical") + kNumber);
  EXPECT_THAT(findings,
              AllOf(HasSubstr("scene.toml:14: initial.joints.hinge: is the number 0.3, but a cylindrical joint has "
                              "angle and displacement; write [initial.joints.hinge] angle = 0.3"),
                    Not(HasSubstr("\n"))));
}

TEST(InitialJoints, WhatNoJointTakesIsOneFinding) {
  const SceneText text;
  EXPECT_THAT(text.findings(pendulum_on("spherical") + kNumber),
              HasSubstr("initial.joints.hinge: is given, but a spherical joint has no coordinate to start at"));
  EXPECT_THAT(text.findings(kPendulum + "[initial.joints]\nhinge = \"up\"\n"),
              AllOf(HasSubstr("initial.joints.hinge: is text \"up\", expected a number (rad, m), or a table"),
                    Not(HasSubstr("\n"))));
  EXPECT_THAT(text.findings(kPendulum + "[initial.joints]\nhing = 0.3\n"),
              AllOf(HasSubstr("initial.joints.hing: unknown joint \"hing\""), Not(HasSubstr("\n"))));
}

TEST(InitialJoints, AStartBeyondAStopIsWarnedOf) {
  const SceneText text;
  const std::string stops = "[joints.angle]\nstops = { min_deg = -10, max_deg = 10, stiffness = 500 }\n";
  const auto warnings = [&](const std::string& degrees) {
    std::string all;
    for (const std::string& warning :
         text.read(kPendulum + stops + "[initial.joints.hinge]\nangle_deg = " + degrees + "\n").warnings)
      all += warning + "\n";
    return all;
  };
  EXPECT_THAT(warnings("12"),
              HasSubstr("initial.joints.hinge.angle: starts joint \"hinge\" at 12 degrees, beyond its stop "
                        "at 10 degrees"));
  EXPECT_THAT(warnings("-11"), HasSubstr("beyond its stop at -10 degrees"));
  EXPECT_EQ(warnings("9"), "");
}

}  // namespace
}  // namespace footfall
