// What `footfall check` foretells: overlaps at the start, and bodies that will leave the bed.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mbd_solver/bed/bed_forecast.h"
#include "mbd_solver/bed/bed_report.h"
#include "mbd_solver/session/observe/start_check.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// Two balls of radius 5 cm, 30 cm apart, on a bed of 0.6 x 0.4 m.
const std::string kBalls = R"(end_time = 0.5
gravity = [0, 0, -9.81]
[ground]
kind = "particles"
[particles.box]
size = [0.6, 0.4]
depth = 0.1
radius = 0.01
[[bodies]]
name = "left"
mass = 1.0
shape = { kind = "sphere", centre = [-0.15, 0, 0.1], radius = 0.05 }
[[bodies]]
name = "right"
mass = 1.0
shape = { kind = "sphere", centre = [0.15, 0, 0.1], radius = 0.05 }
[[boundaries]]
body = "left"
surface = {}
[[boundaries]]
body = "right"
surface = {}
)";

std::vector<std::string> overlaps(const std::vector<std::string>& settings, const std::vector<GrainPlace>& grains) {
  const SceneText text;
  const Scene scene = text.read(kBalls, settings);
  return overlaps_at_start(scene, build_mechanism(scene), grains);
}

TEST(OverlapsAtStart, OfBodiesAndGrainsAreNamed) {
  EXPECT_THAT(overlaps({}, {}), IsEmpty());
  EXPECT_THAT(overlaps({"bodies.right.shape.centre=[-0.06,0,0.1]"}, {}), ElementsAre(HasSubstr("W1660")));
  const GrainPlace rests{{0.15, 0, 0.0401}, 0.01}, pressed{{0.15, 0, 0.046}, 0.01}, inside{{0.15, 0.0499, 0.1}, 0.01};
  EXPECT_THAT(overlaps({}, {rests}), IsEmpty());
  EXPECT_THAT(overlaps({}, {rests, pressed}), ElementsAre(testing::AllOf(HasSubstr("W0656"), HasSubstr("right"))));
  EXPECT_THAT(overlaps({}, {inside}), ElementsAre(HasSubstr("W0656")));
}

// Balls that stand in the floor or in a side of a bed that is not made yet.
TEST(OverlapsAtStart, OfFloorAndSidesOfABoxAreNamed) {
  EXPECT_THAT(overlaps({"bodies.right.shape.centre=[0.15,0,-0.04]"}, {}), IsEmpty());
  EXPECT_THAT(overlaps({"bodies.right.shape.centre=[0.15,0,-0.08]"}, {}),
              ElementsAre(testing::AllOf(HasSubstr("W1670"), HasSubstr("right"), HasSubstr("through the floor"))));
  EXPECT_THAT(overlaps({"bodies.right.shape.centre=[0.28,0,-0.04]"}, {}),
              ElementsAre(testing::AllOf(HasSubstr("W1670"), HasSubstr("side of the bed towards +x"))));
  EXPECT_THAT(overlaps({"bodies.right.shape.centre=[0.28,0,-0.04]", "particles.box.periodic=true"}, {}), IsEmpty());
  EXPECT_THAT(overlaps({"bodies.right.shape.centre=[0.28,0,0.06]"}, {}), IsEmpty()) << "above the bed";
}

// A tetrahedron of 0.1 m drawn about the origin of its file, for a body elsewhere.
TEST(SurfacesAway, AreNamedWithTheirDistance) {
  const SceneText text;
  const std::string file =
      text.write("foot.obj", "v 0 0 0\nv 0.1 0 0\nv 0 0.1 0\nv 0 0 0.1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n");
  const auto away = [&](const std::string& position) {
    return surfaces_away(text.read(
        kBalls, {"boundaries.right.surface.file=\"" + file + "\"", "boundaries.right.surface.position=" + position}));
  };
  EXPECT_THAT(away("[0.1,-0.05,0.05]"), IsEmpty());
  EXPECT_THAT(away("[0.15,0,-0.2]"), IsEmpty());
  EXPECT_THAT(away("[0.15,0,-1.2]"), ElementsAre(testing::AllOf(HasSubstr("W1671"), HasSubstr("surface.position"))));
}

std::vector<std::string> leaving(const std::string& more, const std::vector<std::string>& settings) {
  const SceneText text;
  const Scene scene = text.read(kBalls + more, settings);
  return leaving_bodies(scene, build_mechanism(scene));
}

TEST(ProposedBed, IsOneWidthAroundTheBodiesAndTheirWay) {
  const SceneText text;
  const auto proposed = [&](const std::vector<std::string>& settings) {
    const Scene scene = text.read(kBalls, settings);
    return proposed_bed(scene, build_mechanism(scene));
  };
  // Two balls of 0.1 m, 0.4 m from end to end: 0.1 m more on each side, and below.
  const BedProposal still = proposed({});
  EXPECT_NEAR(still.width, 0.1, 1e-6);
  EXPECT_NEAR(still.size.x(), 0.6, 1e-6);
  EXPECT_NEAR(still.size.y(), 0.3, 1e-6);
  EXPECT_NEAR(still.depth, still.sinkage + 0.1, 1e-12);
  EXPECT_NEAR(still.centre.norm(), 0.0, 1e-9);
  // A plate of 70 % of the squares around them, on 50 rho g per metre: 1/2 k A s^2 = M g s.
  const double k = 50.0 * 0.57 * 2600.0 * 9.81 * 0.7 * 2.0 * 0.01;
  EXPECT_NEAR(still.sinkage, 2.0 * 2.0 * 9.81 / k, 1e-6);
  // A way of 0.15 m, by the flight and the friction after it; two widths on each side.
  const BedProposal moving = proposed({"initial.velocity=[0.5,0,-1]"});
  EXPECT_NEAR(moving.size.x(), 0.4 + 0.1 + 4 * 0.1, 0.1);
  EXPECT_GT(moving.centre.x(), 0.02);
  EXPECT_GT(moving.sinkage, still.sinkage);
}

// On a slope of 20 degrees that falls along x the right ball starts 0.109 m below the left one, as high above the bed; half of the friction
// holds both. Rocks are ground.
const std::vector<std::string> kOnSlope = {"ground.terrain.slope_deg=20", "particles.box.bodies.friction=1",
                                           "bodies.left.shape.centre=[-0.15,0,0.109]",
                                           "bodies.right.shape.centre=[0.15,0,0]"};

TEST(ProposedBed, CountsHeightsFromTheTerrain) {
  const SceneText text;
  const auto proposed = [&](const std::string& more, const std::vector<std::string>& settings) {
    const Scene scene = text.read(kBalls + more, settings);
    return proposed_bed(scene, build_mechanism(scene));
  };
  const BedProposal level = proposed("", {}), sloping = proposed("", kOnSlope);
  // A fall of a millimetre, and a slip of less.
  EXPECT_NEAR(sloping.size.y(), level.size.y(), 1e-6);
  EXPECT_GT(sloping.size.x(), level.size.x() - 1e-6);
  EXPECT_LT(sloping.size.x(), level.size.x() + 0.05);
  EXPECT_NEAR(sloping.sinkage, level.sinkage, 1e-6);
  // The floor is as deep below the lower ball; the lowest place of the surface, at the end of the bed, keeps at least half of that.
  const double end = sloping.centre.x() + 0.5 * sloping.size.x();
  EXPECT_NEAR(sloping.depth,
              std::max(level.depth - (end - 0.15) * std::tan(20.0 * 3.14159265358979 / 180.0), 0.5 * level.depth),
              1e-6);
  const std::string rock =
      "[ground.plane]\nstiffness = 1e6\n[[ground.terrain.rocks]]\nx = 0.22\ny = 0.14\ndiameter = 0.1\n";
  const BedProposal rocky = proposed(rock, {});
  EXPECT_NEAR((rocky.size - level.size).norm() + rocky.centre.norm(), 0.0, 1e-9);
  EXPECT_NEAR(rocky.sinkage, level.sinkage, 1e-9);
}

TEST(LeavingBodies, SlideDownATerrain) {
  EXPECT_THAT(leaving("", kOnSlope), IsEmpty());
  // The lower ball, as on the slope of gravity below, at the same time.
  const auto steep = [](const std::string& slope, const std::string& gravity, double drop) {
    return leaving("", {"ground.terrain.slope_deg=" + slope, "gravity=" + gravity,
                        "bodies.left.shape.centre=[-0.15,0," + std::to_string(0.1 + drop) + "]",
                        "bodies.right.shape.centre=[0.15,0," + std::to_string(0.1 - drop) + "]", "end_time=0.4"});
  };
  const std::vector<std::string> terrain = steep("24", "[0,0,-9.81]", 0.15 * std::tan(24.0 * 3.14159265358979 / 180.0));
  EXPECT_THAT(terrain, ElementsAre(testing::AllOf(HasSubstr("W1555"), HasSubstr("right"))));
  EXPECT_THAT(steep("0", "[4,0,-8.96]", 0.0), ElementsAre(testing::AllOf(HasSubstr("W1555"), HasSubstr("right"))));
  // Both slopes take each other away.
  EXPECT_THAT(steep("24", "[-4,0,-8.96]", 0.15 * std::tan(24.0 * 3.14159265358979 / 180.0)), IsEmpty());
}

TEST(LeavingBodies, AreForetoldByTheirMotion) {
  EXPECT_THAT(leaving("", {}), IsEmpty());
  // 0.15 m to the side: 0.1 s of flight and then friction.
  EXPECT_THAT(leaving("", {"initial.velocity=[0.5,0,0]"}), IsEmpty());
  EXPECT_THAT(leaving("", {"initial.velocity=[1.2,0,0]"}), ElementsAre(HasSubstr("right")));
  // A steep slope: bodies slide; on a flat one they are held.
  EXPECT_THAT(leaving("", {"gravity=[4,0,-8.9]"}), ElementsAre(HasSubstr("W1555")));
  EXPECT_THAT(leaving("", {"gravity=[1.7,0,-9.66]"}), IsEmpty());
  // Periodic sides cannot be left.
  EXPECT_THAT(leaving("", {"initial.velocity=[2.5,0,0]", "particles.box.periodic=true"}), IsEmpty());
}

TEST(LeavingBodies, AreForetoldByPrescribedMotions) {
  const auto drag = [](const std::string& speed) {
    return "[[joints]]\nname = \"drag\"\nkind = \"prescribed\"\nbodies = [\"ground\", \"left\"]\npoint = [-0.15, 0, "
           "0.1]\naxis = \"z\"\naxis2 = \"y\"\n[joints.motion]\nx = { polynomial = [0, " +
           speed + "] }\ny = { polynomial = [0] }\nz = { polynomial = [0] }\n";
  };
  EXPECT_THAT(leaving(drag("0.3"), {}), IsEmpty());  // 0.15 m along y
  EXPECT_THAT(leaving(drag("-0.5"), {}), ElementsAre(testing::AllOf(HasSubstr("left"), HasSubstr("t = 0.4 s"))));
}

}  // namespace
}  // namespace footfall
