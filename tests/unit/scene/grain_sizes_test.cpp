// mbd_solver/scene/grains: size distributions, zones, and the lists by which inputs/box/in.bed pours them.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/grains/bed_parts.h"
#include "mbd_solver/scene/grains/grain_sizes.h"
#include "mbd_solver/scene/particle_script.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;

const std::string kTwoPads = R"(end_time = 1.0
gravity = [0, 0, -1.63]
[[bodies]]
name = "left"
mass = 1.0
shape = { kind = "disc", centre = [-0.5, 0, 0.05], radius = 0.05, thickness = 0.01 }
[[bodies]]
name = "right"
mass = 1.0
shape = { kind = "disc", centre = [0.5, 0, 0.05], radius = 0.05, thickness = 0.01 }
[[joints]]
name = "beam"
kind = "fixed"
bodies = ["left", "right"]
point = [0, 0, 0.05]
[[boundaries]]
body = "left"
surface = {}
[[boundaries]]
body = "right"
surface = {}
[ground]
kind = "particles"
[particles.box]
size = [2.0, 1.0]
depth = 0.3
radius = 0.02
zones = [{ under = ["left", "right"], size = [0.4, 0.4], depth = 0.1, radius = 0.008 }]
)";

// Mass and number of grains of a density of the mass over ln(diameter), between two diameters: Simpson's rule.
std::pair<double, double> mass_and_number(const std::function<double(double)>& f, double from, double to) {
  constexpr int kSteps = 2000;
  double mass = 0.0, number = 0.0;
  const double a = std::log(from), h = (std::log(to) - a) / kSteps;
  for (int k = 0; k <= kSteps; ++k) {
    const double weight = (k == 0 || k == kSteps ? 1.0 : k % 2 ? 4.0 : 2.0) * h / 3.0, y = a + k * h;
    mass += weight * f(y);
    number += weight * f(y) * std::exp(-3.0 * y);
  }
  return {mass, number};
}

// As many grains as the curve has between its ends, and shares that are a whole.
TEST(SizeDistribution, OfALognormalHasItsNumberOfGrains) {
  SizeDistributionSpec d;
  d.kind = SizeDistributionKind::kLognormal;
  d.median = 0.02;
  d.deviation = 0.4;
  d.finest = 0.008;
  d.coarsest = 0.05;
  d.classes = 6;
  const auto f = [&](double y) {
    const double x = (y - std::log(d.median)) / d.deviation;
    return std::exp(-0.5 * x * x) / (d.deviation * std::sqrt(2.0 * kPi));
  };
  const auto [mass, number] = mass_and_number(f, *d.finest, *d.coarsest);
  const std::vector<GrainClass> classes = classes_of(d);
  ASSERT_EQ(classes.size(), 6u);
  double shares = 0.0, grains = 0.0;
  for (std::size_t k = 0; k < classes.size(); ++k) {
    shares += classes[k].share;
    grains += classes[k].share * std::pow(2.0 * classes[k].radius, -3);
    const double low = 0.008 * std::pow(0.05 / 0.008, static_cast<double>(k) / 6.0);
    EXPECT_GT(2.0 * classes[k].radius, low);
    EXPECT_LT(2.0 * classes[k].radius, low * std::pow(0.05 / 0.008, 1.0 / 6.0));
    EXPECT_NEAR(classes[k].share, mass_and_number(f, low, low * std::pow(0.05 / 0.008, 1.0 / 6.0)).first / mass, 1e-9);
  }
  EXPECT_NEAR(shares, 1.0, 1e-12);
  EXPECT_NEAR(grains, number / mass, 1e-8 * grains);
}

TEST(SizeDistribution, OfALognormalEndsWhereFiveAndNinetyFivePerCentPass) {
  SizeDistributionSpec d;
  d.kind = SizeDistributionKind::kLognormal;
  d.median = 0.02;
  d.deviation = 0.3;
  d.classes = 12;
  const std::vector<GrainClass> classes = classes_of(d);
  EXPECT_GT(2.0 * classes.front().radius, 0.02 * std::exp(-1.645 * 0.3));
  EXPECT_LT(2.0 * classes.back().radius, 0.02 * std::exp(1.645 * 0.3));
}

// What is between two sieves is one radius; sieves between which nothing lies, and what passes the finest, are left out.
TEST(SizeDistribution, OfASieveCurveHasARadiusBetweenSieves) {
  SizeDistributionSpec d;
  d.kind = SizeDistributionKind::kSieve;
  d.diameters = {0.01, 0.02, 0.03, 0.05};
  d.passing = {0.1, 0.4, 0.4, 0.9};
  const std::vector<GrainClass> classes = classes_of(d);
  ASSERT_EQ(classes.size(), 2u);
  EXPECT_NEAR(classes[0].share, 0.3 / 0.8, 1e-12);
  EXPECT_NEAR(classes[1].share, 0.5 / 0.8, 1e-12);
  const auto [mass, number] = mass_and_number([](double) { return 1.0; }, 0.01, 0.02);
  EXPECT_NEAR(std::pow(2.0 * classes[0].radius, -3), number / mass, 1e-6 * number / mass);
}

TEST(SizeDistribution, SetsRadiusAndShares) {
  const SceneText text;
  const std::string set =
      "particles.box.size_distribution={kind=\"table\",diameters=[0.02,0.03,0.04],fractions=[0.2,0.3,0.5]}";
  const Scene scene = text.read(kTwoPads, {set, "particles.box.zones=[]"});
  EXPECT_THAT(scene.particles->box->radius, ::testing::ElementsAre(0.01, 0.015, 0.02));
  const auto bed = scene.particles->bed->variables;
  EXPECT_EQ(bed.at("part_mixes"), "'3 kind_1 0.2 kind_2 0.3 kind_3 0.5'");
  EXPECT_THAT(bed.at("kind_words"), HasSubstr(" atom_type 1 density constant 2600 radius constant 0.015'"));
  EXPECT_EQ(bed.at("part_words"), "'union 2 soil soil'");
  EXPECT_EQ(bed.count("region_names"), 0u);
  EXPECT_NE(text.findings(kTwoPads, {set, "particles.box.radius=0.03"}), "");
}

// [Desmond and Weeks 2014]: equal grains have no more than their own; two sizes a little more.
TEST(SizeDistribution, PacksDenserThanEqualGrains) {
  GrainSizesSpec sizes;
  sizes.radius = {0.01, 0.01};
  EXPECT_DOUBLE_EQ(mixed_fraction(sizes, 0.61), 0.61);
  sizes.radius = {0.01, 0.014};  // half the mass each: 27 and 73 % of the grains are small
  sizes.shares = {0.5, 0.5};
  EXPECT_NEAR(mixed_fraction(sizes, 0.61), 0.61 + 0.0658 * 0.161 + 0.0857 * 1.05 * 0.161 * 0.161, 2e-3);
}

TEST(BedParts, ZonesAndTheRestAreTheBed) {
  const SceneText text;
  const Scene scene = text.read(kTwoPads);
  const std::vector<BedPart> parts = bed_parts(scene, -0.3, 0.02, false, 1.0);
  ASSERT_EQ(parts.size(), 2u);
  EXPECT_EQ(parts[0].blocks.size(), 2u);
  EXPECT_NEAR(parts[0].volume, 2 * 0.4 * 0.4 * 0.12, 1e-12);
  EXPECT_NEAR(parts[0].volume + parts[1].volume, 2.0 * 1.0 * 0.32, 1e-12);
}

// Blocks that overlap count once, the first zone has the place, and what is outside the bed is left out.
TEST(BedParts, OverlapsCountOnce) {
  const SceneText text;
  const Scene scene =
      text.read(kTwoPads, {"particles.box.zones=[{under=[\"left\",\"right\"],size=[1.2,0.2],depth=0.1,radius=0.008},"
                           "{centre=[0,0],size=[4,0.4],depth=0.2,radius=0.012}]"});
  const std::vector<BedPart> parts = bed_parts(scene, -0.3, 0.0, false, 1.0);
  ASSERT_EQ(parts.size(), 3u);
  EXPECT_NEAR(parts[0].volume, 2.0 * 0.2 * 0.1, 1e-12);  // from -1 to 1 m
  EXPECT_NEAR(parts[1].volume, 2.0 * 0.4 * 0.2 - parts[0].volume, 1e-12);
  EXPECT_NEAR(parts[2].volume, 2.0 * 0.3 - 2.0 * 0.4 * 0.2, 1e-12);
  const auto bed = scene.particles->bed->variables;
  EXPECT_EQ(bed.at("part_words"),
            "'intersect 2 soil zone_1' 'intersect 3 soil zone_2 not_zone_1' 'intersect 3 soil not_zone_1 not_zone_2'");
  EXPECT_EQ(bed.at("region_names"), "block_1 block_2 zone_1 not_zone_1 block_3 zone_2 not_zone_2");
}

// A yawed mechanism has its zones with it; pitch and roll, which differ from landing to landing, ask for no other bed.
TEST(BedParts, ZonesLieUnderTheBodies) {
  const SceneText text;
  const auto place = [&](const std::vector<std::string>& settings) {
    const Scene scene = text.read(kTwoPads, settings);
    return zone_places(scene, scene.particles->box->zones[0])[1];
  };
  EXPECT_TRUE(place({}).isApprox(Eigen::Vector2d(0.5, 0.0)));
  EXPECT_TRUE(place({"initial.yaw_deg=30", "initial.position=[0.1,0,0]"})
                  .isApprox(Eigen::Vector2d(0.1 + 0.5 * std::cos(kPi / 6), 0.25)));
  EXPECT_TRUE(place({"initial.pitch_deg=10"}) == place({}));
}

// Every list is read, and as much is poured as the parts weigh.
TEST(BedParts, AreListsOfTheScript) {
  const SceneText text;
  for (const std::vector<std::string>& settings : std::vector<std::vector<std::string>>{
           {}, {"particles.box.clumps=[\"pair\",\"rod\"]"}, {"particles.box.pour={friction=0.1,settle_time=0.4}"}}) {
    const Scene scene = text.read(kTwoPads, settings);
    EXPECT_TRUE(scene.warnings.empty()) << scene.warnings[0];
    const auto v = scene.particles->bed->variables;
    const ScriptText bed(scene.particles->bed->script, v);
    for (const auto& [name, value] : v) EXPECT_EQ(bed.names().count(name), 1u) << name;
    EXPECT_EQ(v.at("part_names"), "part_1 part_2");
    std::istringstream masses(v.at("part_masses"));
    double fine = 0.0, rest = 0.0;
    masses >> fine >> rest;
    const double depth = 0.3 + 0.5 * 0.02;  // half a radius more than the bed
    EXPECT_NEAR(fine, 2600 * 0.61 * 2 * 0.16 * (0.1 + 0.01), 1e-6 * fine);
    EXPECT_NEAR(fine + rest, 2600 * 0.61 * 2.0 * depth, 1e-6 * rest);
  }
}

TEST(BedParts, CountTheirGrains) {
  const SceneText text;
  const double with = box_numbers(text.read(kTwoPads)).grains;
  const double fine = 0.55 * 2 * 0.16 * 0.092 / (4.0 / 3.0 * kPi * std::pow(0.008, 3));
  const double rest = 0.55 * (2.0 * 0.292 - 2 * 0.16 * 0.092) / (4.0 / 3.0 * kPi * std::pow(0.02, 3));
  EXPECT_NEAR(with, fine + rest, 1e-6 * with);
  const BoxNumbers n = box_numbers(text.read(kTwoPads));
  EXPECT_DOUBLE_EQ(n.rayleigh, rayleigh_time({0.008, 2600.0, 1e7, 0.3}));  // of the smallest grain
}

// On a slope the fine grains follow the surface.
TEST(BedParts, FollowTheTerrain) {
  const SceneText text;
  const Scene scene = text.read(kTwoPads, {"ground.terrain.slope_deg=10"});
  const double floor = box_floor(scene), rise = 0.5 * std::tan(kPi / 18), half = 0.2 * std::tan(kPi / 18);
  const std::vector<BedPart> parts = bed_parts(scene, floor, 1.0, true, 0.01);
  EXPECT_NEAR(parts[0].blocks[0].min().z(), rise - half - 0.1, 1e-9);  // falls towards x: the left one is higher
  EXPECT_NEAR(parts[0].blocks[0].max().z(), rise + half + 0.01, 1e-9);
  EXPECT_NEAR(parts[0].blocks[1].min().z(), -rise - half - 0.1, 1e-9);
}

TEST(BedParts, OfTheLandingAreUnderItsPads) {
  const Scene scene = read_scene(FOOTFALL_SOURCE_DIR "/inputs/landing_mr");
  const BoxSpec& box = *scene.particles->box;
  for (const Eigen::Vector2d& place : zone_places(scene, box.zones[0])) EXPECT_NEAR(place.norm(), 1.75, 1e-6);
  EXPECT_DOUBLE_EQ(box_numbers(scene).time_step, 1e-4);
  EXPECT_EQ(scene.particles->bed->variables.at("dt"), "0.00015");
  EXPECT_NEAR(box_numbers(scene).grains, 23000, 1500);  // 22 730 in the settled bed
}

// A script with a gravity of its own: how to make it equal to the scene's. A slope is none of size.
TEST(ScriptGravity, IsSetByTheVariableOfTheScript) {
  const auto refusal = [](const std::string& gravity) {
    return test::refusal([&] { read_scene(FOOTFALL_SOURCE_DIR "/inputs/landing_script", {"gravity=" + gravity}); });
  };
  const std::string size = "--set particles.variables.gravity=3.71 --set particles.bed.variables.gravity=3.71";
  EXPECT_THAT(refusal("[0,0,-3.71]"), HasSubstr("make them agree: " + size));
  EXPECT_THAT(refusal("[0.3,0,-1.6]"), HasSubstr("make them agree. A bed by [particles.box]"));
}

}  // namespace
}  // namespace footfall
