// Power laws of an experiment: what its file may say, what is fitted to which runs, and the sweep of dropped spheres.
#include "mbd_solver/cli/experiments/fits.h"

#include <gmock/gmock.h>
#include <stdlib.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/experiments/experiment.h"

namespace footfall {
namespace {

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

class FitsTest : public ::testing::Test {
 protected:
  FitsTest() {
    std::string pattern = (std::filesystem::temp_directory_path() / "footfall_fit_XXXXXX").string();
    folder_ = ::mkdtemp(pattern.data());
  }
  ~FitsTest() override { std::filesystem::remove_all(folder_); }
  ExperimentSpec read(const std::string& text) const {
    std::ofstream(folder_ / "sweep.toml") << text;
    return read_experiment((folder_ / "sweep.toml").string());
  }
  // kSweep + kFit with `from` replaced.
  ExperimentSpec read_with(const std::string& from, const std::string& to) const {
    std::string text = kSweep + kFit;
    text.replace(text.find(from), from.size(), to);
    return read(text);
  }
  std::string written(const std::string& name) const {
    std::ifstream stream(folder_ / name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  std::filesystem::path folder_;
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
    results[i].figures = {depth_of(std::stod(plan.runs[i].values[0]), std::stod(plan.runs[i].values[1]))};
  return results;
}

TEST_F(FitsTest, AFactorMayHoldTheFigureItself) {
  const ExperimentSpec sweep = read(kSweep + kFit);
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
  const ExperimentSpec sweep = read(kSweep + kFit);
  const Plan plan = plan_of(sweep, false);
  std::vector<RunResult> results = results_of(plan);
  results[3].end.code = 1;
  const FitData data = fit_data(sweep, sweep.fits[0], plan, results);
  EXPECT_EQ(data.runs.size(), 17U);
  EXPECT_EQ(data.runs[3], 4U);
}

TEST_F(FitsTest, WhereNamesTheRunsThatAreMeant) {
  const ExperimentSpec sweep = read_with("label = \"d\"", "where = { density = 2000, colour = \"blue\" }");
  const Plan plan = plan_of(sweep, false);
  const FitData data = fit_data(sweep, sweep.fits[0], plan, results_of(plan));
  EXPECT_EQ(data.runs, (std::vector<std::size_t>{7, 9, 11}));
  EXPECT_TRUE((data.x.col(0).array() == 2000.0).all());
}

TEST_F(FitsTest, WhereKnowsAValueThatIsWrittenAsAPower) {
  std::string text = kSweep + kFit;
  text.replace(text.find("[1000, 2000, 4000]"), 18, "[2.5e6, 1e7, 4e7] ");
  text.insert(text.find("label = \"d\""), "where = { density = 2.5e6 }\n");
  const ExperimentSpec sweep = read(text);
  const Plan plan = plan_of(sweep, false);
  EXPECT_EQ(fit_data(sweep, sweep.fits[0], plan, results_of(plan)).runs.size(), 6U);
}

TEST_F(FitsTest, TablesAndPictureAreWritten) {
  const ExperimentSpec sweep = read(kSweep + kFit);
  const Plan plan = plan_of(sweep, false);
  const std::vector<std::string> files = write_fits(sweep, plan, results_of(plan), folder_.string());
  for (const std::string& file : files) EXPECT_GT(std::filesystem::file_size(file), 100U) << file;
  EXPECT_TRUE(std::filesystem::exists(folder_ / "law.svg"));
  EXPECT_THAT(written("fits.md"), HasSubstr("`d = 0.002 (rho)^0.50 (H)^0.33`: 18 runs, R^2 = 1.0000"));
  EXPECT_THAT(written("fits.md"),
              HasSubstr("| exponent of | found | standard error | 95 % interval | Uehara | Walsh |"));
  EXPECT_THAT(written("fits.md"), HasSubstr("| rho | 0.500 | 0.000 | 0.500 to 0.500 | 0.5 |  |"));
  EXPECT_THAT(written("fits.md"), HasSubstr("With the exponents of Uehara: `d = 0.002 (rho)^0.50 (H)^0.33`"));
  // who gives only one of two
  EXPECT_THAT(written("fits.md"), ::testing::Not(HasSubstr("With the exponents of Walsh")));
  EXPECT_THAT(written("fits.csv"), HasSubstr("\nlaw,fitted,rho,0.5,"));
}

TEST_F(FitsTest, WrongFilesAreTold) {
  const auto expect = [&](const std::string& from, const std::string& to, const std::string& message) {
    EXPECT_THAT([&] { read_with(from, to); }, ThrowsMessage<InputError>(HasSubstr(message))) << to;
  };
  expect("figure = \"depth [m]\"\nlabel", "figure = \"width\"\nlabel",
         "sweep.toml:19: fits.law.figure: \"width\" is not one of [[figures]]");
  expect("sum = \"density\"", "sum = \"rho\"",
         "sweep.toml:24: fits.law.factors.rho.sum: \"rho\" is not one of [[parameters]], nor of [[figures]]");
  expect("sum = \"density\"", "sum = \"colour\"",
         "fits.law.factors.rho.sum: parameter \"colour\" has the value \"red\", expected numbers in a power law");
  expect("marks = \"density\"", "marks = \"size\"", "fits.law.marks: \"size\" is not one of [[parameters]]");
  expect("Walsh = 0.25", "Walsh = \"1/4\"", "published.Walsh: is \"1/4\", expected a number");
  expect("{ Uehara = 0.5 }", "0.5", "published: is the number 0.5, expected a table");
  expect("label = \"d\"", "where = { size = 1 }",
         "sweep.toml:20: fits.law.where: \"size\" is not one of [[parameters]]");
  expect("label = \"d\"", "where = { density = 3 }", "fits.law.where: parameter \"density\" has no value \"3\"");
  expect("label = \"d\"", "where = 5", "fits.law.where: is the number 5, expected a table");
  expect("label = \"d\"", "labels = \"d\"", "labels: unknown key.");
}

TEST_F(FitsTest, NumbersWithoutALogarithmAreTold) {
  const ExperimentSpec sweep = read(kSweep + kFit);
  const Plan plan = plan_of(sweep, false);
  std::vector<RunResult> results = results_of(plan);
  results[5].figures[0] = -0.01;
  EXPECT_THAT([&] { fit_data(sweep, sweep.fits[0], plan, results); },
              ThrowsMessage<InputError>(HasSubstr(
                  "fits.law.figure: is -0.01 in the run density_1000__height_1.6__colour_blue, expected more than 0")));
  for (RunResult& result : results) result.end.code = 1;
  EXPECT_THAT([&] { write_fits(sweep, plan, results, folder_.string()); },
              ThrowsMessage<InputError>(HasSubstr("0 values for 3 coefficients")));
}

// What the names of the choices say is what they set: the speed of a fall through the height, and half the diameter.
TEST(DroppedSphere, SettingsFollowFromHeightsAndDiameters) {
  const ExperimentSpec sweep = read_experiment(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/sweeps/dropped_sphere.toml");
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

}  // namespace
}  // namespace footfall
