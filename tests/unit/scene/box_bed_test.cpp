// mbd_solver/scene/box_bed.h and grain_time_step.h: a bed by numbers.
#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/particle_script.h"
#include "tests/unit/scene/scene_text.h"

namespace footfall {
namespace {

const std::string kPlate = R"(end_time = 1.0
gravity = [0, 0, -1.63]
[[bodies]]
name = "plate"
mass = 1.0
shape = { kind = "disc", centre = [0, 0, 0.05], radius = 0.05, thickness = 0.01 }
[[bodies]]
name = "tine"
mass = 1.0
shape = { kind = "rod", from = [0, 0, 0.05], to = [0, 0, 0.1], diameter = 0.02 }
[[boundaries]]
body = "plate"
surface = {}
[[boundaries]]
body = "tine"
beams = {}
[ground]
kind = "particles"
[particles.box]
size = [0.3, 0.2]
depth = 0.08
radius = 0.008
)";

// The number of the project's notes: 9.4e-4 s for r = 2 cm, rho = 2600, E = 35 MPa, nu = 0.3.
TEST(GrainTimeStep, RayleighTimeOfRegolith) {
  const ElasticGrain grain{0.02, 2600.0, 35e6, 0.3};
  EXPECT_NEAR(rayleigh_time(grain), 9.44e-4, 0.01e-4);
  EXPECT_NEAR(rayleigh_time({0.01, 2600.0, 35e6, 0.3}), 0.5 * rayleigh_time(grain), 1e-18);
}

// The collision itself, integrated: m x'' = -k x^1.5 from speed v, k = 4/3 E* sqrt(r*), until it lets go.
TEST(GrainTimeStep, HertzTimeIsThatOfACollision) {
  const ElasticGrain grain{0.01, 2600.0, 1e7, 0.3};
  const double speed = 0.7, m = 0.5 * grain.density * 4.0 / 3.0 * kPi * 1e-6, young = grain.young / (2 * (1 - 0.09));
  const double k = 4.0 / 3.0 * young * std::sqrt(0.5 * grain.radius), dt = 1e-8;
  double x = 0.0, v = speed, t = 0.0;
  for (; x >= 0.0; t += dt) {
    v -= 0.5 * dt * k / m * std::pow(x, 1.5);
    x += dt * v;
    v -= 0.5 * dt * k / m * std::pow(std::max(x, 0.0), 1.5);
  }
  EXPECT_NEAR(hertz_time(grain, speed), t, 2e-3 * t);  // 2.87 is 2.868 in pi^(1/5) ... of the closed form
}

TEST(GrainTimeStep, IsRoundedDownToTwoDigits) {
  EXPECT_DOUBLE_EQ(rounded_down(8.84e-5), 8.8e-5);
  EXPECT_DOUBLE_EQ(rounded_down(8.8e-5), 8.8e-5);
  EXPECT_DOUBLE_EQ(rounded_down(9.99e-4), 9.9e-4);
}

// The scripts of inputs/box with the numbers of the scene pass every check of script against scene, and of bed against
// run, without a warning.
TEST(BoxBed, ItsScriptsAgreeWithTheScene) {
  const SceneText text;
  for (const std::vector<std::string>& settings : std::vector<std::vector<std::string>>{
           {},
           {"particles.box.packing=\"dense\"", "particles.box.bodies={friction=0.9,cohesion=10}"},
           {"particles.box.periodic=true", "particles.box.radius=[0.006,0.008]"},
           {"gravity=[0.3,0,-1.6]", "particles.box.exchange_steps=3", "particles.box.material.cohesion=100"},
           {"particles.box.clumps=[\"pair\",\"octahedron\"]", "particles.box.radius=[0.006,0.008]"}}) {
    const Scene scene = text.read(kPlate, settings);
    EXPECT_TRUE(scene.warnings.empty()) << (scene.warnings.empty() ? "" : scene.warnings[0]);
    const ScriptText script(scene.particles->script, scene.particles->variables);
    EXPECT_TRUE(script.whole());
    // Every variable that is given is read.
    for (const auto& [name, value] : scene.particles->variables) EXPECT_EQ(script.names().count(name), 1u) << name;
    const ScriptText bed(scene.particles->bed->script, scene.particles->bed->variables);
    for (const auto& [name, value] : scene.particles->bed->variables) EXPECT_EQ(bed.names().count(name), 1u) << name;
  }
}

TEST(BoxBed, BodiesAreCoupledAsTheSceneSays) {
  const SceneText text;
  const auto v = text.read(kPlate).particles->variables;
  EXPECT_EQ(v.at("mesh_bodies"), "plate");
  EXPECT_EQ(v.at("couples"), "gravity scene mesh mesh_plate plate");
  EXPECT_EQ(v.at("beams"), "body tine");
  EXPECT_EQ(v.at("every"), "auto");
}

// Of one radius, with shares in the mass: the words of LIGGGHTS' templates, in quotes, and of their distribution.
TEST(BoxBed, ClumpsBecomeTemplatesOfLiggghts) {
  const SceneText text;
  const Scene scene =
      text.read(kPlate, {"particles.box.clumps=[\"pair\",\"tetrahedron\"]", "particles.box.clump_shares=[1,3]"});
  const auto bed = scene.particles->bed->variables;
  EXPECT_EQ(bed.at("clumps"), "1");
  EXPECT_EQ(scene.particles->variables.at("clumps"), "1");
  EXPECT_EQ(bed.at("clump_mix"), "2 clump_1 0.25 clump_2 0.75");
  const std::string& words = bed.at("clump_words");
  EXPECT_EQ(words.find("'nspheres 2 ntry 1000000 spheres -0.0055"), 0u) << words;
  EXPECT_NE(words.find("' 'nspheres 4 "), std::string::npos) << words;
  // Each weighs what a sphere of its radius does: 2600 * 4/3 pi 0.008^3.
  EXPECT_NE(words.find(" mass 0.00557611752061 "), std::string::npos) << words;
  EXPECT_NE(words.find(" use_density'"), std::string::npos) << words;
  EXPECT_DOUBLE_EQ(box_numbers(scene).grains, box_numbers(text.read(kPlate)).grains);
  EXPECT_LT(box_numbers(scene).time_step, box_numbers(text.read(kPlate)).time_step);  // by its smallest sphere
}

// It represents corners.
TEST(BoxBed, ClumpsHaveRollingFrictionOnlyWhenTheSceneNamesAModel) {
  const SceneText text;
  const auto model = [&](const std::vector<std::string>& settings) {
    return text.read(kPlate, settings).particles->variables.at("model");
  };
  const std::string clumps = "particles.box.clumps=[\"pair\"]";
  EXPECT_EQ(model({}), "hertz tangential history rolling_friction cdt");
  EXPECT_EQ(model({clumps}), "hertz tangential history");
  EXPECT_EQ(model({clumps, "particles.box.material.rolling_model=\"cdt\""}),
            "hertz tangential history rolling_friction cdt");
}

// A change of what only the run knows asks for no other bed; the density does.
TEST(BoxBed, IsMadeAnewOnlyForWhatTheBedKnows) {
  const SceneText text;
  const auto bed = [&](const std::vector<std::string>& settings) {
    return text.read(kPlate, settings).particles->bed->variables;
  };
  EXPECT_EQ(bed({}), bed({"particles.box.bodies.friction=0.9", "particles.box.exchange_steps=2",
                          "particles.box.frame_interval=0.1", "particles.box.time_step=1e-5",
                          "initial.velocity=[0,0,-20]", "end_time=3"}));
  EXPECT_NE(bed({}), bed({"particles.box.material.density=1500"}));
  EXPECT_NE(bed({}), bed({"particles.box.seed=2"}));
}

// The seeds of a campaign's runs are drawn from all positive int; primes of LIGGGHTS are above 10000. Small seeds keep theirs.
TEST(BoxBed, TakesTheSeedsOfCampaigns) {
  const SceneText text;
  std::set<std::string> primes;
  const std::vector<std::string> seeds = {"1", "2", "9999", "10000", "10001", "305305426", "1450725065", "2147483647"};
  for (const std::string& seed : seeds) {
    const std::string prime = text.read(kPlate, {"particles.box.seed=" + seed}).particles->bed->variables.at("seed");
    primes.insert(prime);
    const long n = std::stol(prime);
    EXPECT_GT(n, 10000);
    EXPECT_LE(n, 2147483647);
    for (long d = 2; d * d <= n; ++d) ASSERT_NE(n % d, 0) << seed;
  }
  EXPECT_EQ(primes.size(), seeds.size());
  EXPECT_EQ(text.read(kPlate).particles->bed->variables.at("seed"), "20000003");
  EXPECT_NE(text.findings(kPlate, {"particles.box.seed=2147483648"}), "");
}

TEST(BoxBed, TimeStepFollowsTheGrainsAndTheSpeed) {
  const SceneText text;
  const Scene slow = text.read(kPlate), fast = text.read(kPlate, {"initial.velocity=[0,0,-50]"});
  const ElasticGrain grain{0.008, 2600.0, 1e7, 0.3};
  EXPECT_DOUBLE_EQ(box_numbers(slow).time_step, rounded_down(0.1 * rayleigh_time(grain)));
  EXPECT_DOUBLE_EQ(box_numbers(fast).time_step, rounded_down(0.05 * hertz_time(grain, 50.0)));
  EXPECT_DOUBLE_EQ(slow.particles->max_time_step, box_numbers(slow).time_step);
  // Who knows better says so.
  EXPECT_EQ(
      text.read(kPlate, {"particles.box.time_step=2e-4", "particles.max_time_step=2e-4"}).particles->variables.at("dt"),
      "0.0002");
}

TEST(BoxBed, VariablesOfTheSceneStay) {
  const SceneText text;
  const Scene scene = text.read(kPlate, {"particles.variables.every=7"});
  EXPECT_EQ(scene.particles->variables.at("every"), "7");
}

}  // namespace
}  // namespace footfall
