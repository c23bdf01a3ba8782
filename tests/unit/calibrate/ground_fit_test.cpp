// The fit of a soil without grains: known numbers come back; runs that cannot tell anything are refused.
#include <gtest/gtest.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/campaign/ground/ground_fit.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

constexpr double kDensity = 1580.0, kGravity = 1.62;

// A square plate of 3 x 3 facets, moved at a constant velocity from the surface on.
PadRun moved(const std::string& name, const Eigen::Vector3d& velocity, double tilt, double depth) {
  PadRun run;
  run.name = name;
  for (int i = -1; i <= 1; ++i) {
    for (int j = -1; j <= 1; ++j) {
      SoilFacet facet;
      facet.marker.s0 = {0.1 * i, 0.1 * j, 0.0};
      facet.normal = -Eigen::Vector3d::UnitZ();
      facet.area = 0.01;
      run.facets.push_back(facet);
    }
  }
  run.two_sided = true;
  run.R_WB = rotation_matrix(quaternion_about(Eigen::Vector3d::UnitY(), tilt));
  run.surface = -0.02;
  const double duration = depth / -velocity.z();
  for (int row = 0; row <= 60; ++row) {
    run.place.push_back(Eigen::Vector3d(0.0, 0.0, run.surface + 0.1 * std::abs(std::sin(tilt))) +
                        velocity * duration * row / 60);
    run.velocity.push_back(velocity);
    run.force.emplace_back(0.0, 0.0, 0.0);
  }
  return run;
}

std::vector<PadRun> runs_of(const GroundFit& truth) {
  std::vector<PadRun> runs;
  int k = 0;
  for (const double speed : {0.2, 1.0, 3.0}) {
    for (const double angle : {90.0, 60.0, 30.0}) {
      const double g = angle * M_PI / 180.0;
      const Eigen::Vector3d v = speed * Eigen::Vector3d(angle < 90.0 ? std::cos(g) : 0.0, 0.0, -std::sin(g));
      runs.push_back(moved("run " + std::to_string(k), v, k % 3 == 2 ? 0.1 : 0.0, 0.06 + 0.01 * (k % 4)));
      runs.back().held_back = k % 5 == 4;
      runs.back().force = predicted_forces(runs.back(), truth, kDensity);
      ++k;
    }
  }
  return runs;
}

GroundFit resistive_ground(double speed_resistance, double cohesion) {
  GroundFit ground;
  ground.form = {"rft", SpeedForm::kDepth};
  ground.numbers = {{"resistance", "", 6e5, 0, 0},
                    {"speed_resistance", "", speed_resistance, 0, 0},
                    {"speed_depth", "", 0.03, 0, 0},
                    {"cohesion", "", cohesion, 0, 0},
                    {"surface_friction", "", 0.25, 0, 0}};
  return ground;
}

TEST(GroundFit, FindsTheNumbersOfALawItself) {
  const GroundFit rft = resistive_ground(1.3e5, 120.0);
  GroundFit sinkage;
  sinkage.form = {"pressure_sinkage", SpeedForm::kDepth};
  sinkage.numbers = {{"frictional_modulus", "", 4e5, 0, 0}, {"exponent", "", 0.8, 0, 0},
                     {"speed_resistance", "", 2e5, 0, 0},   {"speed_depth", "", 0.04, 0, 0},
                     {"friction", "", 0.5, 0, 0},           {"cohesion", "", 300.0, 0, 0},
                     {"shear_length", "", 0.015, 0, 0}};
  GroundFit square = rft;
  square.form.speed = SpeedForm::kSquare;
  square.numbers[1] = {"inertia", "", 1.3, 0, 0};
  square.numbers.erase(square.numbers.begin() + 2);
  for (const GroundFit& truth : {rft, sinkage, square}) {
    const GroundFit found = fit_ground(runs_of(truth), truth.form, kDensity, kGravity);
    ASSERT_EQ(found.numbers.size(), truth.numbers.size());
    for (std::size_t k = 0; k < found.numbers.size(); ++k) {
      const double value = truth.numbers[k].value;
      EXPECT_NEAR(found.numbers[k].value, value, 0.01 * value) << found.numbers[k].key;
      EXPECT_LE(found.numbers[k].low, found.numbers[k].value);
      EXPECT_GE(found.numbers[k].high, found.numbers[k].value);
    }
    EXPECT_GT(found.r_squared, 0.9999);
    EXPECT_GT(found.held_r_squared, 0.9999);
    EXPECT_EQ(found.worst.size(), 9u) << "one of each run";
  }
}

TEST(GroundFit, TellsWhereTheLawIsWrong) {
  std::vector<PadRun> runs = runs_of(resistive_ground(1e5, 1.0));
  for (Eigen::Vector3d& force : runs[1].force) force.y() += 0.5 * runs[1].force.back().z();  // from the side
  const GroundFit found = fit_ground(runs, {"rft", SpeedForm::kDepth}, kDensity, kGravity);
  EXPECT_EQ(found.worst.front().run, "run 1");
  EXPECT_EQ(found.worst.front().axis, 'y');
  EXPECT_LT(found.r_squared, 0.99);
}

TEST(GroundFit, RefusesRunsThatTellNothing) {
  std::vector<PadRun> runs = runs_of(resistive_ground(1e5, 1.0));
  EXPECT_TRUE(reaches_the_bed(runs[0]));
  for (Eigen::Vector3d& place : runs[0].place) place.z() += 1.0;
  EXPECT_FALSE(reaches_the_bed(runs[0]));
  EXPECT_THROW(fit_ground(runs, {"rft", SpeedForm::kDepth}, kDensity, kGravity), InputError);
  runs = runs_of(resistive_ground(1e5, 1.0));
  runs.resize(2);
  EXPECT_THROW(fit_ground(runs, {"rft", SpeedForm::kDepth}, kDensity, kGravity), InputError);
}

}  // namespace
}  // namespace footfall
