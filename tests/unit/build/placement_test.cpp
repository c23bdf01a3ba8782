// Where the mechanism starts: mbd_solver/build/placement.cpp, by its steps in mbd_solver/build/mechanism.h.

#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/pi.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/rotation.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

// Two bodies, their mass centre at (1, 0, 2); the lower one touches the ground with a plate 0.4 m wide at z = 1.5.
const std::string kTwoBodies = R"(end_time = 0.1
gravity = [0, 0, -1.62]
[[bodies]]
name = "top"
mass = 1.0
inertia = [0.1, 0.1, 0.1]
position = [1, 0, 3.5]
[[bodies]]
name = "pad"
mass = 3.0
inertia = [0.1, 0.1, 0.1]
position = [1, 0, 1.5]
[[joints]]
name = "weld"
type = "fixed"
bodies = ["top", "pad"]
point = [1, 0, 2]
[[boundaries]]
body = "pad"
[boundaries.beams]
points = [[0.8, 0, 1.5], [1.2, 0, 1.5]]
radius = 0.05
)";
const Eigen::Vector3d kCentre(1.0, 0.0, 2.0);
const std::string kOnPlane = kTwoBodies +
                             "[ground]\nkind = \"plane\"\n[ground.plane]\nyoung_MPa = 35\nrestitution = 0.4\n" +
                             "impact_speed = 1.0\n";
const std::string kOnGrains = kTwoBodies + "[ground]\nkind = \"particles\"\n[particles]\nscript = \"in.grains\"\n";
constexpr double kRoundOff = 1e-14;

class PlacementTest : public ::testing::Test {
 protected:
  PlacementTest() {
    folder.write(
        "in.grains",
        "timestep 1e-4\nfix m all mesh/surface file m.stl type 1\nfix mbd all couple/mbd every 4 mesh m pad\nrun 1\n");
  }
  Mechanism built(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    return build_mechanism(folder.read(toml, settings));
  }
  Placement placed(const std::string& toml, const std::vector<std::string>& settings = {}) const {
    return built(toml, settings).placement;
  }
  // Grains as LIGGGHTS dumps them: x y z radius.
  std::vector<std::string> grains(const std::string& lines) const {
    return {"particles.grains=\"" + folder.write("bed.grains", lines) + "\""};
  }
  std::string complaint(const std::string& toml, const std::vector<std::string>& settings) const {
    try {
      placed(toml, settings);
    } catch (const InputError& error) {
      return error.what();
    }
    return "no complaint";
  }
  SceneText folder;
};

const std::string kHead = "ITEM: TIMESTEP\n0\nITEM: ATOMS x y z radius\n";

std::vector<std::string> operator+(std::vector<std::string> a, const std::string& b) {
  a.push_back(b);
  return a;
}

TEST_F(PlacementTest, OfADrawingThatIsNotMovedIsTheDrawing) {
  const Placement placement = placed(kTwoBodies);
  EXPECT_LT((placement.R_WD - Eigen::Matrix3d::Identity()).norm(), kRoundOff);
  EXPECT_LT(placement.p_WD.norm(), kRoundOff);
  EXPECT_FALSE(placement.ground_known);
}

TEST_F(PlacementTest, TurnsAboutTheTotalMassCentre) {
  const Placement placement =
      placed(kTwoBodies, {"initial.roll_deg=20", "initial.pitch_deg=-35", "initial.yaw_deg=80"});
  EXPECT_LT((placement.point(kCentre) - kCentre).norm(), kRoundOff);
}

// The order of the history and of a body's orientation: Rz(yaw) Ry(pitch) Rx(roll).
TEST_F(PlacementTest, RollPitchAndYawReadBackAsGiven) {
  const Mechanism mechanism = built(kTwoBodies, {"initial.roll_deg=30", "initial.pitch_deg=20", "initial.yaw_deg=40"});
  const Eigen::Vector3d rpy = rpy_from_rotation(rotation_matrix(mechanism.model.initial(0).L));
  EXPECT_LT((rpy * 180.0 / kPi - Eigen::Vector3d(30, 20, 40)).norm(), 1e-12);  // round-off of degrees
  const Scene scene = folder.read(kTwoBodies, {"bodies.top.orientation={rpy_deg=[30,20,40]}"});
  EXPECT_LT((scene.bodies[0].orientation.toRotationMatrix() - mechanism.placement.R_WD).norm(), kRoundOff);
}

TEST_F(PlacementTest, MovesTheWholeDrawing) {
  const Placement placement = placed(kTwoBodies, {"initial.position=[1,2,3]", "initial.yaw_deg=50"});
  EXPECT_LT((placement.point(kCentre) - kCentre - Eigen::Vector3d(1, 2, 3)).norm(), kRoundOff);
}

// The beam touches with its radius of 0.05 m.
TEST_F(PlacementTest, ClearanceIsOfTheLowestPlaceAboveThePlane) {
  const Placement placement = placed(kOnPlane, {"ground.plane.point=[0,0,0.25]", "initial.clearance=0.1"});
  EXPECT_TRUE(placement.ground_known);
  EXPECT_NEAR(placement.ground_height, 0.25, kRoundOff);
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.35, kRoundOff);
}

// On a slope the nearest place counts, measured straight up.
TEST_F(PlacementTest, ClearanceOnASlopeIsOfThePlaceNearestToIt) {
  const Placement placement = placed(kOnPlane, {"ground.plane.normal=[-0.6,0,0.8]", "initial.clearance=0.1"});
  const double slope = 0.6 / 0.8;  // the plane rises with x
  double smallest = 1e9;
  for (const double x : {0.8, 1.2}) {
    const Eigen::Vector3d p = placement.point({x, 0, 1.5}) - 0.05 * Eigen::Vector3d(-0.6, 0, 0.8);
    smallest = std::min(smallest, p.z() - slope * p.x());
  }
  EXPECT_NEAR(smallest, 0.1, kRoundOff);
}

// A boundary that the plane leaves out does not count.
TEST_F(PlacementTest, ClearanceIsOfWhatThePlaneTouches) {
  const std::string second = "[[boundaries]]\nbody = \"top\"\nbeams = { points = [[1,0,0],[1,0,1]], radius = 0.1 }\n";
  const Placement placement = placed(kOnPlane + second, {"ground.plane.bodies=[\"pad\"]", "initial.clearance=0.1"});
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.1, kRoundOff);
}

TEST_F(PlacementTest, ClearanceFollowsGravityNotZ) {
  const Placement placement =
      placed(kOnPlane, {"gravity=[-1.62,0,0]", "ground.plane.normal=\"x\"", "initial.clearance=0.1"});
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).x() - 0.05, 0.1, kRoundOff);  // lowest: its ends, 0.05 m thick
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z(), 1.5, kRoundOff);
}

TEST_F(PlacementTest, AStatedSurfaceIsTheGround) {
  const Placement placement = placed(kOnGrains, {"particles.surface_height=0.4", "initial.clearance=0.1"});
  EXPECT_TRUE(placement.ground_known);
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.5, kRoundOff);
}

// The pad's outline reaches 0.2 m and its beam's radius: a higher grain outside does not count.
TEST_F(PlacementTest, TheHighestGrainUnderTheBoundaryIsItsGround) {
  const Placement placement = placed(
      kOnGrains, grains(kHead + "1.0 0 0.3 0.02\n1.1 0.1 0.35 0.02\n1.5 0 0.9 0.02\n") + "initial.clearance=0.1");
  EXPECT_NEAR(placement.ground_height, 0.37, kRoundOff);
  EXPECT_NEAR(placement.point({0.8, 0, 1.5}).z() - 0.05, 0.47, kRoundOff);
}

// Its landing site is a tenth wider, and knows how far it may stray.
TEST_F(PlacementTest, TheLandingSiteSeesATenthFartherThanTheOutline) {
  const Placement placement =
      placed(kOnGrains, grains(kHead + "1.0 0 0.3 0.01\n1.28 0 0.5 0.01\n1.3 0 0.9 0.01\n") + "initial.clearance=0.1");
  ASSERT_EQ(placement.sites.size(), 1u);
  EXPECT_NEAR(placement.sites[0].stray, 0.025, kRoundOff);
  EXPECT_NEAR(placement.sites[0].height, 0.51, kRoundOff);  // at 0.28 m, beyond 0.26 but not 0.285
  EXPECT_NEAR(placement.ground_height, 0.31, kRoundOff);
  EXPECT_LT((placement.sites[0].r - placement.point({1, 0, 1.5})).norm(), kRoundOff);
}

TEST_F(PlacementTest, OfSeveralFramesTheLastCounts) {
  const Placement placement = placed(kOnGrains, grains(kHead + "1 0 0.3 0.02\n" + kHead + "1 0 0.2 0.02\n"));
  EXPECT_NEAR(placement.ground_height, 0.22, kRoundOff);
}

TEST_F(PlacementTest, ClearanceAboveGrainsOfUnknownHeightIsRefused) {
  EXPECT_NE(complaint(kOnGrains, {"initial.clearance=0.1"}).find("particles.surface_height"), std::string::npos);
}

TEST_F(PlacementTest, ClearanceWithoutAGrainBelowIsRefused) {
  EXPECT_NE(complaint(kOnGrains, grains(kHead + "5 5 0.3 0.02\n") + "initial.clearance=0.1").find("no grain under"),
            std::string::npos);
}

TEST_F(PlacementTest, ABrokenDumpIsNamedWithItsLine) {
  EXPECT_NE(complaint(kOnGrains, grains(kHead + "1 0 0.3 0.02\n1 0 soil 0.02\n")).find("bed.grains:5:"),
            std::string::npos);
  EXPECT_NE(complaint(kOnGrains, grains("ITEM: TIMESTEP\n0\n")).find("holds no grains"), std::string::npos);
}

}  // namespace
}  // namespace footfall
