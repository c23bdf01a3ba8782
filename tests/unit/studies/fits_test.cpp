// Fits of power laws to results, and rigs.
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <initializer_list>
#include <random>

#include "coupler/base/errors.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/fits.h"
#include "mbd_solver/studies/rig.h"
#include "mbd_solver/studies/rig_command.h"
#include "mbd_solver/studies/sweep_file.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// Power laws of an experiment: what its file may say, what is fitted to which runs, and the sweep of dropped spheres.

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::ThrowsMessage;

const std::string kSweep = R"(scene = "scene.toml"
[[parameters]]
name = "density"
settings = ["a={value}"]
values = [1000, 2000, 4000]
[[parameters]]
name = "height"
settings = ["b={value}"]
values = [0.1, 0.4, 1.6]
[[parameters]]
name = "colour"
settings = ["c={value}"]
values = ["red", "blue"]
[[figures]]
name = "depth [m]"
key = "depth"
)";
const std::string kFit = R"([[fits]]
name = "law"
figure = "depth [m]"
label = "d"
marks = "density"
[[fits.factors]]
name = "rho"
sum = "density"
published = { Uehara = 0.5 }
[[fits.factors]]
name = "H"
sum = ["height", "depth [m]"]
published = { Uehara = 0.3333, Walsh = 0.25 }
)";

class FitsTest : public ::testing::Test, protected TemporaryFolder {
 protected:
  SweepSpec read(const std::string& text) const { return read_sweep_file(write("sweep.toml", text)); }
  // kSweep + kFit with `from` replaced.
  SweepSpec read_with(const std::string& from, const std::string& to) const {
    std::string text = kSweep + kFit;
    text.replace(text.find(from), from.size(), to);
    return read(text);
  }
};

// d = 0.002 rho^(1/2) (h + d)^(1/3), solved for d.
double depth_of(double rho, double h) {
  double d = 0.1;
  for (int i = 0; i < 200; ++i) d = 0.002 * std::sqrt(rho) * std::cbrt(h + d);
  return d;
}

std::vector<RunResult> results_of(const Plan& plan) {
  std::vector<RunResult> results(plan.runs.size());
  for (std::size_t i = 0; i < results.size(); ++i)
    results[i].metrics = {depth_of(std::stod(plan.runs[i].values[0]), std::stod(plan.runs[i].values[1]))};
  return results;
}

TEST_F(FitsTest, AFactorMayHoldTheFigureItself) {
  const SweepSpec sweep = read(kSweep + kFit);
  const Plan plan = plan_of(sweep, false);
  const FitData data = fit_data(sweep, sweep.fits[0], plan, results_of(plan));
  ASSERT_EQ(data.x.rows(), 18);
  EXPECT_EQ(data.x(0, 0), 1000.0);
  EXPECT_EQ(data.x(0, 1), 0.1 + data.y[0]);
  const PowerLaw law = fit_power_law(data.x, data.y);
  EXPECT_NEAR(law.exponents[0], 0.5, 1e-10);
  EXPECT_NEAR(law.exponents[1], 1.0 / 3, 1e-10);
  EXPECT_NEAR(law.factor, 0.002, 1e-11);
}

TEST_F(FitsTest, UnfinishedRunsAreLeftOut) {
  const SweepSpec sweep = read(kSweep + kFit);
  const Plan plan = plan_of(sweep, false);
  std::vector<RunResult> results = results_of(plan);
  results[3].end.code = 1;
  const FitData data = fit_data(sweep, sweep.fits[0], plan, results);
  EXPECT_EQ(data.runs.size(), 17U);
  EXPECT_EQ(data.runs[3], 4U);
}

TEST_F(FitsTest, WhereNamesTheRunsThatAreMeant) {
  const SweepSpec sweep = read_with("label = \"d\"", "where = { density = 2000, colour = \"blue\" }");
  const Plan plan = plan_of(sweep, false);
  const FitData data = fit_data(sweep, sweep.fits[0], plan, results_of(plan));
  EXPECT_EQ(data.runs, (std::vector<std::size_t>{7, 9, 11}));
  EXPECT_TRUE((data.x.col(0).array() == 2000.0).all());
}

TEST_F(FitsTest, WhereKnowsAValueThatIsWrittenAsAPower) {
  std::string text = kSweep + kFit;
  text.replace(text.find("[1000, 2000, 4000]"), 18, "[2.5e6, 1e7, 4e7] ");
  text.insert(text.find("label = \"d\""), "where = { density = 2.5e6 }\n");
  const SweepSpec sweep = read(text);
  const Plan plan = plan_of(sweep, false);
  EXPECT_EQ(fit_data(sweep, sweep.fits[0], plan, results_of(plan)).runs.size(), 6U);
}

TEST_F(FitsTest, TablesAndPictureAreWritten) {
  const SweepSpec sweep = read(kSweep + kFit);
  const Plan plan = plan_of(sweep, false);
  const std::vector<std::string> files = write_fits(sweep, plan, results_of(plan), folder_.string());
  for (const std::string& file : files) EXPECT_GT(std::filesystem::file_size(file), 100U) << file;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "law.svg"));
  EXPECT_THAT(text("fits.md"), HasSubstr("`d = 0.002 (rho)^0.50 (H)^0.33`: 18 runs, R^2 = 1.0000"));
  EXPECT_THAT(text("fits.md"), HasSubstr("| exponent of | found | standard error | 95 % interval | Uehara | Walsh |"));
  EXPECT_THAT(text("fits.md"), HasSubstr("| rho | 0.500 | 0.000 | 0.500 to 0.500 | 0.5 |  |"));
  EXPECT_THAT(text("fits.md"), HasSubstr("With the exponents of Uehara: `d = 0.002 (rho)^0.50 (H)^0.33`"));
  // who gives only one of two
  EXPECT_THAT(text("fits.md"), ::testing::Not(HasSubstr("With the exponents of Walsh")));
  EXPECT_THAT(text("fits.csv"), HasSubstr("\nlaw,fitted,rho,0.5,"));
}

TEST_F(FitsTest, WrongFilesAreReportedAtTheirKey) {
  const auto expect = [&](const std::string& from, const std::string& to, const MessageCode& code,
                          std::initializer_list<std::string> words) {
    const std::string text = test::refusal([&] { read_with(from, to); });
    EXPECT_TRUE(test::names(text, {code.number})) << to;
    EXPECT_TRUE(test::names(text, words)) << to;
  };
  expect("figure = \"depth [m]\"\nlabel", "figure = \"width\"\nlabel", code::kUnknownMetric,
         {"sweep.toml:19: fits.law.figure:", "\"width\""});
  expect("sum = \"density\"", "sum = \"rho\"", code::kUnknownParameter,
         {"sweep.toml:24: fits.law.factors.rho.sum:", "\"rho\""});
  expect("sum = \"density\"", "sum = \"colour\"", code::kWrongType,
         {"fits.law.factors.rho.sum:", "\"colour\"", "\"red\""});
  expect("marks = \"density\"", "marks = \"size\"", code::kUnknownParameter, {"fits.law.marks:", "\"size\""});
  expect("Walsh = 0.25", "Walsh = \"1/4\"", code::kWrongType, {"published.Walsh:", "\"1/4\""});
  expect("{ Uehara = 0.5 }", "0.5", code::kWrongType, {"published:", "0.5"});
  expect("label = \"d\"", "where = { size = 1 }", code::kUnknownParameter,
         {"sweep.toml:20: fits.law.where:", "\"size\""});
  expect("label = \"d\"", "where = { density = 3 }", code::kNotAValue, {"fits.law.where:", "\"density\"", "\"3\""});
  expect("label = \"d\"", "where = 5", code::kWrongType, {"fits.law.where:"});
  expect("label = \"d\"", "labels = \"d\"", code::kUnknownKey, {"labels:"});
}

TEST_F(FitsTest, NumbersWithoutALogarithmAreReported) {
  const SweepSpec sweep = read(kSweep + kFit);
  const Plan plan = plan_of(sweep, false);
  std::vector<RunResult> results = results_of(plan);
  results[5].metrics[0] = -0.01;
  EXPECT_THAT([&] { fit_data(sweep, sweep.fits[0], plan, results); },
              ThrowsMessage<InputError>(AllOf(HasSubstr("fits.law.figure"), HasSubstr(code::kPowerLaw.number))));
  for (RunResult& result : results) result.end.code = 1;
  EXPECT_THAT([&] { write_fits(sweep, plan, results, folder_.string()); }, ::testing::Throws<InputError>());
}

// What the names of the choices say is what they set: the speed of a fall through the height, and half the diameter.
TEST(DroppedSphere, SettingsFollowFromHeightsAndDiameters) {
  const SweepSpec sweep = read_sweep_file(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/sweeps/dropped_sphere.toml");
  constexpr double kDigits = 1e-6;  // of the file
  const auto number_after = [](const std::string& text, const std::string& what) {
    return std::stod(text.substr(text.find(what) + what.size()));
  };
  int checked = 0;
  for (const ParameterSpec& parameter : sweep.parameters) {
    for (const ChoiceSpec& choice : parameter.choices) {
      const double value = std::stod(choice.name);
      if (parameter.name == "height") {
        EXPECT_NEAR(number_after(choice.settings[0], "velocity=[0,0,-"), std::sqrt(2.0 * 9.81 * value), kDigits);
        ++checked;
      }
      if (parameter.name == "diameter") {
        EXPECT_NEAR(number_after(choice.settings[0], "radius="), value / 2.0, kDigits);
        ++checked;
      }
    }
  }
  EXPECT_EQ(checked, 7);
}

// Exponents from measured values: exact laws, known quantiles, and how often an interval holds the truth.

constexpr double kRoundOff = 1e-12;

// All combinations of 3 x 2 x 4 values over rather different ranges.
Eigen::MatrixXd combinations() {
  Eigen::MatrixXd x(24, 3);
  int row = 0;
  for (const double density : {1400.0, 2800.0, 5600.0})
    for (const double diameter : {0.14, 0.24})
      for (const double height : {0.2, 0.4, 0.8, 1.6}) x.row(row++) << density, diameter, height;
  return x;
}

const Eigen::Vector3d kExponents(1.0 / 2, 2.0 / 3, 1.0 / 3);

Eigen::VectorXd law_of(const Eigen::MatrixXd& x, double factor) {
  return factor * (x.array().log().matrix() * kExponents).array().exp();
}

TEST(PowerLaw, AnExactLawComesBackToTheLastDigits) {
  const Eigen::MatrixXd x = combinations();
  const PowerLaw law = fit_power_law(x, law_of(x, 0.14));
  EXPECT_LT((law.exponents - kExponents).norm(), kRoundOff);
  EXPECT_NEAR(law.factor, 0.14, 0.14 * 10 * kRoundOff);
  EXPECT_EQ(law.degrees_of_freedom, 20);
  EXPECT_NEAR(law.r_squared, 1.0, kRoundOff);
  EXPECT_LT(law.scatter, kRoundOff);
  EXPECT_NEAR(law.at(Eigen::Vector3d(1e3, 0.1, 1.0)), 0.14 * std::sqrt(1e3) * std::pow(0.1, 2.0 / 3), 1e-9);
}

// Whole tables have t to four or five digits (two-sided 95 %); one and two degrees are known in closed form.
TEST(PowerLaw, QuantilesOfStudent) {
  constexpr double kOfTheTable = 5e-5;
  EXPECT_NEAR(student_t(0.95, 1), std::tan(0.95 * kPi / 2), 1e-9);
  EXPECT_NEAR(student_t(0.95, 2), 0.95 * std::sqrt(2.0 / (1 - 0.95 * 0.95)), 1e-12);
  EXPECT_NEAR(student_t(0.95, 3), 3.18245, kOfTheTable);
  EXPECT_NEAR(student_t(0.95, 10), 2.22814, kOfTheTable);
  EXPECT_NEAR(student_t(0.95, 30), 2.04227, kOfTheTable);
  EXPECT_NEAR(student_t(0.99, 20), 2.84534, kOfTheTable);
  EXPECT_NEAR(student_t(0.95, 100000), 1.95996, kOfTheTable);
}

// Errors of one exponent against the formula of a straight line, s / sqrt(sum (x - mean)^2): four points by hand.
TEST(PowerLaw, ErrorsOfAStraightLine) {
  const Eigen::Vector4d log_x(0, 1, 2, 3), log_y(0.1, 0.9, 2.1, 2.9);  // slope 0.96, residuals 0.04, -0.12, 0.12, -0.04
  const PowerLaw law = fit_power_law(log_x.array().exp().matrix(), log_y.array().exp());
  const double scatter = std::sqrt((2 * 0.04 * 0.04 + 2 * 0.12 * 0.12) / 2);
  EXPECT_NEAR(law.exponents[0], 0.96, kRoundOff);
  EXPECT_NEAR(law.scatter, scatter, kRoundOff);
  EXPECT_NEAR(law.errors[0], scatter / std::sqrt(5.0), kRoundOff);
  EXPECT_NEAR(law.upper[0] - law.lower[0], 2 * 4.302653 * scatter / std::sqrt(5.0), 1e-6);
  EXPECT_NEAR(std::log(law.factor), 0.06, kRoundOff);
  EXPECT_NEAR(std::log(law.factor_interval.second / law.factor), 4.302653 * scatter * std::sqrt(0.25 + 2.25 / 5.0),
              1e-6);
}

// Noise of 10 %, 4000 times: 95 of 100 intervals hold the truth. The share of n trials scatters by sqrt(0.95 0.05 / n)
// = 0.35 %; four times that.
TEST(PowerLaw, IntervalsHoldTheTruthAsOftenAsTheySay) {
  constexpr int kTrials = 4000;
  const Eigen::MatrixXd x = combinations();
  const Eigen::VectorXd exact = law_of(x, 0.14);
  std::mt19937 generator(20030514);
  std::normal_distribution<double> noise(0.0, 0.1);
  Eigen::Array4i held = Eigen::Array4i::Zero();
  double scatter = 0.0;
  for (int trial = 0; trial < kTrials; ++trial) {
    Eigen::VectorXd y = exact;
    for (double& value : y) value *= std::exp(noise(generator));
    const PowerLaw law = fit_power_law(x, y);
    for (int k = 0; k < 3; ++k) held[k] += law.lower[k] < kExponents[k] && kExponents[k] < law.upper[k];
    held[3] += law.factor_interval.first < 0.14 && 0.14 < law.factor_interval.second;
    scatter += law.scatter * law.scatter / kTrials;
  }
  for (int k = 0; k < 4; ++k) EXPECT_NEAR(held[k] / static_cast<double>(kTrials), 0.95, 0.014) << "coefficient " << k;
  EXPECT_NEAR(std::sqrt(scatter), 0.1, 0.001);
}

TEST(PowerLaw, WithGivenExponentsOnlyTheFactorIsFound) {
  const Eigen::MatrixXd x = combinations();
  const PowerLaw right = fit_factor(x, law_of(x, 0.14), kExponents);
  EXPECT_NEAR(right.factor, 0.14, 1e-12);
  EXPECT_LT(right.scatter, kRoundOff);
  const PowerLaw wrong = fit_factor(x, law_of(x, 0.14), Eigen::Vector3d(-1.0, 2.0 / 3, 1.0 / 3));
  EXPECT_LT(wrong.r_squared, 0.0);
}

TEST(PowerLaw, RefusesWhatLeavesExponentsOpen) {
  const Eigen::MatrixXd x = combinations();
  EXPECT_THROW(fit_power_law(x.topRows(4), Eigen::VectorXd::Ones(4)), InputError);
  Eigen::MatrixXd together = x;
  together.col(1) = x.col(0).array().square();
  EXPECT_THROW(fit_power_law(together, law_of(x, 1.0)), InputError);
  Eigen::MatrixXd constant = x;
  constant.col(2).setConstant(0.3);
  EXPECT_THROW(fit_power_law(constant, law_of(x, 1.0)), InputError);
}

// mbd_solver/studies/rig.h: the fits of rigs on runs whose soil is known exactly.

// The deviation of a fit from the soil that the columns were made of: bins are means over curved lines.
constexpr double kOfBins = 5e-3;

class Rigs : public ::testing::Test, protected TemporaryFolder {
 protected:
  RigRun run_with(const std::string& name, const BodySpec& body, const History& history) const {
    RigRun run;
    run.name = name;
    run.folder = file(name);
    std::filesystem::create_directories(run.folder);
    write_history(run.folder + "/history.csv", history);
    run.scene.bodies = {body};
    run.scene.gravity = {0.0, 0.0, -9.81};
    run.scene.particles.emplace();
    run.scene.particles->box.emplace();
    run.scene.particles->box->radius = {0.005};
    return run;
  }
};

double answer(const RigSample& sample, const std::string& name) {
  for (const RigAnswer& a : sample.answers)
    if (a.name == name) return a.value;
  ADD_FAILURE() << "no answer " << name;
  return std::nan("");
}

TEST_F(Rigs, APlateFindsBekkersNumbers) {
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

TEST_F(Rigs, ASphereFindsItsDrag) {
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

TEST_F(Rigs, ARingFindsFrictionAndCohesion) {
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
  const std::vector<RigVariation> checks = variations_of(scene, true);
  ASSERT_EQ(checks.size(), 3u);
  EXPECT_EQ(checks[0].settings[0], "particles.box.size=[0.6,0.4]");
  EXPECT_EQ(checks[1].settings[0], "particles.box.radius=[0.002,0.003]");
  EXPECT_EQ(checks[2].settings,
            (std::vector<std::string>{"end_time=1", "joints.press.motion.z.polynomial=[0,-0.1,0.1]"}));
  EXPECT_EQ(variations_of(scene, false).size(), 2u);
}

// The pressure stays: four times the force on four times the area.
TEST(RigChecks, AShearBoxOfTwiceTheSizeHasTheSamePressure) {
  const Scene scene = read_scene(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/rigs/scenes/box.toml", {});
  const std::vector<RigVariation> checks = variations_of_holding_bodies(scene, true);
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
  const std::vector<RigVariation> checks = variations_of_holding_bodies(scene, true);
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
  EXPECT_THAT([&] { variations_of(scene, true); }, ThrowsMessage<InputError>(HasSubstr("own.toml")));
  EXPECT_THAT([&] { variations_of_holding_bodies(scene, true); }, ThrowsMessage<InputError>(HasSubstr("own.toml")));
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
  for (int k = 0; k < 3; ++k) samples[k].answers = {{"x", "", k + 1.0}};
  samples.push_back({{{"x", "", std::nan("")}}, {}});
  const RigStatistic s = statistic_of(samples, 0);
  EXPECT_EQ(s.samples, 3);
  EXPECT_NEAR(s.mean, 2.0, 1e-12);
  EXPECT_NEAR(s.interval, 4.30265 / std::sqrt(3.0), 1e-4);
}

}  // namespace
}  // namespace footfall
