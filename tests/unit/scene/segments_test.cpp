// mbd_solver/scene/segments.cpp: a tube or rod as several bodies in a row.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mbd_solver/scene/resolve.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kSegmentRoundOff = 1e-12;

std::string arm(const std::string& flexible, const std::string& more = "") {
  return "end_time = 1\n[materials.steel]\ndensity = 7850\nyoung_GPa = 207\n[[bodies]]\nname = \"arm\"\n"
         "material = \"steel\"\nshape = { kind = \"rod\", from = [0, 0, 1], to = [2, 0, 1], diameter = 0.02 }\n"
         "flexible = { " +
         flexible + " }\n" + more;
}

const std::string kHub =
    "[[joints]]\nname = \"hub\"\ntype = \"revolute\"\nbodies = [\"ground\", \"arm\"]\npoint = [0, 0, 1]\naxis = "
    "\"y\"\n";

TEST(Segments, AreEqualPiecesJoinedInARow) {
  const SceneText text;
  const Scene whole = text.read(arm("modes = 3", kHub)), cut = text.read(arm("segments = 4", kHub));
  ASSERT_EQ(cut.bodies.size(), 4u);
  for (int k = 0; k < 4; ++k) {
    const BodySpec& body = cut.bodies[static_cast<std::size_t>(k)];
    EXPECT_EQ(body.name, "arm_" + std::to_string(k + 1));
    EXPECT_NEAR(body.mass, whole.bodies[0].mass / 4, kSegmentRoundOff);
    EXPECT_NEAR((body.position - Eigen::Vector3d(0.25 + 0.5 * k, 0, 1)).norm(), 0.0, kSegmentRoundOff);
    EXPECT_EQ(body.flexible->modes, 2);  // what a short piece needs beside its static shapes
  }
  ASSERT_EQ(cut.joints.size(), 4u);
  EXPECT_THAT(cut.joints[0].bodies, ElementsAre("ground", "arm_1"));
  for (int k = 1; k < 4; ++k) {
    const JointSpec& joint = cut.joints[static_cast<std::size_t>(k)];
    EXPECT_EQ(joint.type, JointType::kFixed);
    EXPECT_THAT(joint.bodies, ElementsAre("arm_" + std::to_string(k), "arm_" + std::to_string(k + 1)));
    EXPECT_NEAR((joint.point_b - Eigen::Vector3d(0.5 * k, 0, 1)).norm(), 0.0, kSegmentRoundOff);
  }
  EXPECT_NEAR(total_mass(cut), total_mass(whole), kSegmentRoundOff);
  EXPECT_NEAR((mass_centre(cut) - mass_centre(whole)).norm(), 0.0, kSegmentRoundOff);
}

TEST(Segments, WhatIsAttachedGoesToTheSegmentAtItsPoint) {
  const SceneText text;
  const Scene scene =
      text.read(arm("segments = 4", kHub + "[[struts]]\nname = \"stay\"\nbodies = [\"ground\", \"arm\"]\npoints = "
                                           "[[1.2, 0, 0], [1.2, 0, 1]]\nspring = { stiffness = 10 }\n"
                                           "[[springs]]\nname = \"end\"\nkind = \"torsion\"\nbodies = [\"ground\", "
                                           "\"arm\"]\npoint = [2, 0, 1]\naxis = \"y\"\nstiffness = 1\n"
                                           "[[boundaries]]\nbody = \"arm\"\nbeams = { segments = 8 }\n"
                                           "[initial]\nvelocity = [0, 0, 0]\n[[initial.bodies]]\nbody = "
                                           "\"arm\"\nvelocity = [1, 0, 0]\nangular_velocity = [0, 2, 0]\n"
                                           "[output]\nbodies = [\"arm\"]\n"));
  EXPECT_EQ(scene.struts[0].bodies[1], "arm_3");
  EXPECT_EQ(scene.springs[0].bodies[1], "arm_4");
  EXPECT_THAT(scene.output.bodies, ElementsAre("arm_1", "arm_2", "arm_3", "arm_4"));
  ASSERT_EQ(scene.boundaries.size(), 4u);
  EXPECT_EQ(scene.boundaries[2].body, "arm_3");
  EXPECT_EQ(scene.boundaries[2].beams->segments, 2);
  ASSERT_EQ(scene.initial.bodies.size(), 4u);
  // v = v_centre + w x (c_k - c): (0, 2, 0) x (-0.75, 0, 0) = (0, 0, 1.5)
  EXPECT_NEAR((*scene.initial.bodies[0].velocity - Eigen::Vector3d(1, 0, 1.5)).norm(), 0.0, kSegmentRoundOff);
}

TEST(Segments, ACutBelongsToTheEarlierOne) {
  const SceneText text;
  const Scene scene = text.read(arm(
      "segments = 4",
      kHub + "[[joints]]\nname = \"pin\"\ntype = \"spherical\"\nbodies = [\"arm\", \"ground\"]\npoint = [1, 0, 1]\n"));
  EXPECT_EQ(scene.joints[1].bodies[0], "arm_2");
}

TEST(Segments, AreRefusedWhereTheyMeanNothing) {
  const SceneText text;
  EXPECT_THAT(
      text.findings("end_time = 1\n[materials.steel]\ndensity = 7850\nyoung_GPa = 207\n[[bodies]]\nname = \"plate\"\n"
                    "material = \"steel\"\nshape = { kind = \"disc\", radius = 0.2, thickness = 0.01 }\n"
                    "flexible = { segments = 3 }\n"),
      HasSubstr("flexible.segments: cuts a tube or rod along its axis"));
  EXPECT_THAT(
      text.findings(arm("segments = 4", kHub + "[[controllers]]\nname = \"c\"\nkind = \"constant\"\nbody = \"arm\"\n"
                                               "outputs = [\"U1\"]\n")),
      HasSubstr("observe one of them, such as \"arm_1\""));
}

}  // namespace
}  // namespace footfall
