// mbd_solver/cli/rigs: the fits of rigs on runs whose soil is known exactly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/cli/rigs/rft.h"
#include "mbd_solver/cli/rigs/rig.h"
#include "mbd_solver/cli/rigs/rig_checks.h"
#include "mbd_solver/cli/rigs/rig_command.h"
#include "mbd_solver/cli/rigs/rig_output.h"
#include "mbd_solver/output/history.h"
#include "mbd_solver/scene/scene_reader.h"

namespace footfall {
namespace {

using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

// The deviation of a fit from the soil that the columns were made of: bins are means over curved lines.
constexpr double kOfBins = 5e-3;

RigRun run_with(const std::string& name, const BodySpec& body, const History& history) {
  RigRun run;
  run.name = name;
  run.folder =
      (std::filesystem::path(testing::TempDir()) / ("rig_" + std::to_string(::getpid()) + "_" + name)).string();
  std::filesystem::create_directories(run.folder);
  write_history(run.folder + "/history.csv", history);
  run.scene.bodies = {body};
  run.scene.gravity = {0.0, 0.0, -9.81};
  run.scene.particles.emplace();
  run.scene.particles->box.emplace();
  run.scene.particles->box->radius = {0.005};
  return run;
}

double answer(const RigSample& sample, const std::string& name) {
  for (const RigAnswer& a : sample.answers)
    if (a.name == name) return a.value;
  ADD_FAILURE() << "no answer " << name;
  return std::nan("");
}

TEST(Rigs, APlateFindsBekkersNumbers) {
  const double k_c = 2e3, k_phi = 4e5, n = 0.9;
  std::vector<RigRun> runs;
  for (const double b : {0.08, 0.12}) {
    BodySpec plate;
    plate.name = "plate";
    plate.shape.emplace();
    plate.shape->size = {b, b, 0.02};
    History h{{"time", "plate.z", "plate.contact.fz"}, {"s", "m", "N"}, {{}, {}, {}}};
    for (int i = 0; i <= 4000; ++i) {
      const double z = -1e-5 * i, s = -0.005 - z;  // of the lower face; the surface lies a radius down
      h.columns[0].push_back(1e-4 * i);
      h.columns[1].push_back(z + 0.01);
      h.columns[2].push_back(s > 0.0 ? b * b * (k_c / b + k_phi) * std::pow(s, n) : 0.0);
    }
    runs.push_back(run_with("plate" + std::to_string(runs.size()), plate, h));
  }
  const RigSample sample = evaluate_plate(runs);
  EXPECT_NEAR(answer(sample, "n"), n, kOfBins);
  EXPECT_NEAR(answer(sample, "k_c"), k_c, 10 * kOfBins * k_c);  // a difference of two nearly equal numbers
  EXPECT_NEAR(answer(sample, "k_phi"), k_phi, 2 * kOfBins * k_phi);
}

TEST(Rigs, ASphereFindsItsDrag) {
  const double D = 0.1, m = 1.2, k = 150.0, d1 = 0.15, g = 9.81, dt = 1e-5;
  BodySpec ball;
  ball.name = "ball";
  ball.mass = m;
  ball.shape.emplace();
  ball.shape->kind = ShapeKind::kSphere;
  ball.shape->radius = 0.5 * D;
  History h{{"time", "ball.z", "ball.vz", "ball.contact.fz"}, {"s", "m", "m/s", "N"}, {{}, {}, {}, {}}};
  double z = 0.0, v = 2.0;  // downwards, from the mean surface
  for (int i = 0; v > -1e-9 && i < 100000; ++i) {
    const double drag = k * z + m * v * v / d1;
    h.columns[0].push_back(dt * i);
    h.columns[1].push_back(-0.005 - z + 0.5 * D);
    h.columns[2].push_back(-v);
    h.columns[3].push_back(drag);
    v += dt * (g - drag / m);
    z += dt * v;
  }
  for (auto& column : h.columns) column.push_back(column.back());
  h.columns[2].back() = 0.0;  // its stop
  const RigSample sample = evaluate_sphere({run_with("ball", ball, h)});
  EXPECT_NEAR(answer(sample, "k"), k, kOfBins * k);
  EXPECT_NEAR(answer(sample, "d1"), d1, kOfBins * d1);
  EXPECT_GT(answer(sample, "R^2"), 0.9999);
}

TEST(Rigs, ARingFindsFrictionAndCohesion) {
  const double phi = 32.0 * kPi / 180.0, c = 300.0, a = 0.05, b = 0.1;
  std::vector<RigRun> runs;
  for (const double load : {20.0, 50.0, 80.0}) {
    BodySpec ring;
    ring.name = "ring";
    ring.shape.emplace();
    ring.shape->kind = ShapeKind::kMesh;
    ring.shape->file = "ring.stl";
    ring.shape->scale = b;
    const double tau = c + load / (kPi * (b * b - a * a)) * std::tan(phi);
    const double moment = -tau * 2.0 * kPi * (b * b * b - a * a * a) / 3.0;
    History h{{"time", "ring.contact.fz", "ring.contact.mz"},
              {"s", "N", "N m"},
              {{0, 0.5, 1}, {0, load, load}, {0, moment, moment}}};
    runs.push_back(run_with("ring" + std::to_string(runs.size()), ring, h));
  }
  const RigSample sample = evaluate_shear(runs);
  EXPECT_NEAR(answer(sample, "friction angle phi"), 32.0, 1e-3);  // the file has six digits
  EXPECT_NEAR(answer(sample, "cohesion c"), c, 1e-3 * c);
}

// What the paper draws: alpha_z of a flat plate that goes down is the scalar itself, a plate that is drawn to the side has
// no preferred side at gamma = 90 degrees, and turning the plate the other way then turns alpha_x.
TEST(Rft, TheCoefficientsGiveTheDrawnStresses) {
  EXPECT_NEAR(rft_alpha(0.0, 0.5 * kPi).z, 1.0, 1e-12);
  EXPECT_NEAR(rft_alpha(0.0, 0.5 * kPi).x, 0.0, 1e-12);
  EXPECT_NEAR(rft_alpha(0.3, 0.5 * kPi).x, -rft_alpha(-0.3, 0.5 * kPi).x, 1e-12);
  EXPECT_GT(rft_alpha(0.3, 0.5 * kPi).x, 0.0);
  // Upright from both sides.
  EXPECT_NEAR(rft_alpha(0.5 * kPi, 0.7).z, rft_alpha(-0.5 * kPi, 0.7).z, 1e-12);
}

TEST(Rft, FrictionOfTheScalarOfThreeDimensions) {
  const double mu = 0.6;
  EXPECT_NEAR(friction_of_xi(15000.0 * ((894 * mu - 386) * mu + 89) * mu, 15000.0), mu, 1e-9);
  EXPECT_TRUE(std::isnan(friction_of_xi(-1.0, 15000.0)));
}

TEST(RigChecks, HalfTheSpeedIsTheSamePathInTwiceTheTime) {
  Scene scene;
  scene.end_time = 0.5;
  scene.particles.emplace();
  scene.particles->box.emplace();
  scene.particles->box->size = {0.3, 0.2};
  scene.particles->box->depth = 0.1;
  scene.particles->box->radius = {0.004, 0.006};
  JointSpec press;
  press.name = "press";
  press.motion.emplace();
  press.motion->z.emplace();
  press.motion->z->polynomial = {0.0, -0.2, 0.4};
  scene.joints = {press};
  const std::vector<RigCheck> checks = checks_of(scene, true);
  ASSERT_EQ(checks.size(), 3u);
  EXPECT_EQ(checks[0].settings[0], "particles.box.size=[0.6,0.4]");
  EXPECT_EQ(checks[1].settings[0], "particles.box.radius=[0.002,0.003]");
  EXPECT_EQ(checks[2].settings,
            (std::vector<std::string>{"end_time=1", "joints.press.motion.z.polynomial=[0,-0.1,0.1]"}));
  EXPECT_EQ(checks_of(scene, false).size(), 2u);
}

// The pressure stays: four times the force on four times the area.
TEST(RigChecks, AShearBoxOfTwiceTheSizeHasTheSamePressure) {
  const Scene scene = read_scene(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/rigs/scenes/box.toml", {});
  const std::vector<RigCheck> checks = checks_of_holding_bodies(scene, true);
  ASSERT_EQ(checks.size(), 3u);
  const Scene twice = read_scene(scene.file, checks[0].settings);
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const ShapeSpec &a = *scene.bodies[i].shape, &b = *twice.bodies[i].shape;
    EXPECT_TRUE(b.position.isApprox(2.0 * a.position) && b.size.isApprox(2.0 * a.size)) << scene.bodies[i].name;
    EXPECT_TRUE(a.kind != ShapeKind::kMesh || b.scale == 2.0 * a.scale) << scene.bodies[i].name;
  }
  EXPECT_EQ(twice.forces[0].force->polynomial[0], 4.0 * scene.forces[0].force->polynomial[0]);
  EXPECT_EQ(twice.bodies[2].mass, 4.0 * scene.bodies[2].mass);
  EXPECT_EQ(twice.particles->bed->variables.at("depth"), "0.193");
  EXPECT_EQ(twice.particles->box->margin, 2.0 * *scene.particles->box->margin);
  EXPECT_EQ(twice.end_time, 2.0 * scene.end_time);
  const Scene fine = read_scene(scene.file, checks[1].settings);
  EXPECT_EQ(fine.particles->variables.at("radius_1"), "0.0025");
  EXPECT_EQ(checks[2].name, "half speed");
}

TEST(RigChecks, ASlopeOfTwiceTheSizeHasItsGateAndItsPit) {
  const Scene scene = read_scene(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/rigs/scenes/repose.toml", {});
  const std::vector<RigCheck> checks = checks_of_holding_bodies(scene, true);
  ASSERT_EQ(checks.size(), 3u);
  const Scene twice = read_scene(scene.file, checks[0].settings);
  EXPECT_TRUE(twice.bodies[0].shape->size.isApprox(2.0 * scene.bodies[0].shape->size));
  EXPECT_TRUE(twice.bodies[0].shape->centre.isApprox(2.0 * scene.bodies[0].shape->centre));
  EXPECT_EQ(twice.particles->box->pit[1], 2.0 * scene.particles->box->pit[1]);
  EXPECT_EQ(twice.particles->box->pit_depth, 2.0 * scene.particles->box->pit_depth);
  EXPECT_EQ(twice.end_time, 2.0 * scene.end_time);
}

TEST(RigChecks, NameWhatTheyCannotChange) {
  Scene scene;
  scene.file = "own.toml";
  EXPECT_THAT([&] { checks_of(scene, true); }, ThrowsMessage<InputError>(HasSubstr("own.toml comes from a script")));
  EXPECT_THAT([&] { checks_of_holding_bodies(scene, true); },
              ThrowsMessage<InputError>(HasSubstr("own.toml comes from a script")));
}

TEST(RigCommand, KnowsTheGravities) {
  EXPECT_EQ(gravity_setting("moon"), "gravity=[0,0,-1.62]");
  EXPECT_EQ(gravity_setting("3.3"), "gravity=[0,0,-3.3]");
  EXPECT_THROW(gravity_setting("venus"), InputError);
  EXPECT_THROW(gravity_setting("-1"), InputError);
  EXPECT_THROW(rig_named("plough"), InputError);
}

// 1, 2, 3: mean 2, s = 1, t(2) = 4.30265.
TEST(RigOutput, IntervalsAreStudents) {
  std::vector<RigSample> samples(3);
  for (int k = 0; k < 3; ++k) samples[static_cast<std::size_t>(k)].answers = {{"x", "", k + 1.0}};
  samples.push_back({{{"x", "", std::nan("")}}, {}});
  const RigStatistic s = statistic_of(samples, 0);
  EXPECT_EQ(s.samples, 3);
  EXPECT_NEAR(s.mean, 2.0, 1e-12);
  EXPECT_NEAR(s.interval, 4.30265 / std::sqrt(3.0), 1e-4);
}

}  // namespace
}  // namespace footfall
