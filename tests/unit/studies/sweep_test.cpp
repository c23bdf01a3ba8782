// Sweeps: plan, runs, figures, results.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <nlohmann/json.hpp>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "mbd_solver/base/fingerprint.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/bed/bed_measures.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/toml_file.h"
#include "mbd_solver/studies/metrics.h"
#include "mbd_solver/studies/plan.h"
#include "mbd_solver/studies/results.h"
#include "mbd_solver/studies/run_store.h"
#include "mbd_solver/studies/sweep_file.h"
#include "mbd_solver/studies/tables.h"
#include "tests/support/temporary_folder.h"
#include "tests/unit/studies/text_file.h"

namespace footfall {
namespace {

// What the file of an experiment must hold: mbd_solver/studies/sweep_file.cpp.

using ::testing::ContainsRegex;
using ::testing::HasSubstr;

// Pages: mbd_solver/studies/tables.h.
TEST(StudyPage, SaysTheSameAsMarkdownAndHtml) {
  StudyPage page("Strut");
  page.section("Best set");
  page.paragraph("Near & far");
  Table table({"name", "value"});
  table.add({"viscous", "3000"});
  page.table(table);
  EXPECT_EQ(page.markdown(),
            "# Strut\n\n## Best set\n\nNear & far\n\n| name | value |\n|---|---|\n| viscous | 3000 |\n");
  for (const char* part : {"<h1>Strut</h1>", ">Best set</h2>", "<p>Near &amp; far</p>", "<td>viscous</td>"})
    EXPECT_THAT(page.html(), HasSubstr(part));
  EXPECT_EQ(Table({"a #1", "b\nc", "d"}).csv(), "\"a #1\",\"b\nc\",d\n") << "as CsvReader takes it";
}

// Of a sweep with these lines.
std::string complaint(const std::string& lines) { return test::sweep_complaint("scene = \"scene.toml\"\n" + lines); }

TEST(ReadExperiment, AsksForNoDrawingsUnlessTheFileDoes) {
  const SweepSpec sweep = test::sweep_of(
      "scene = \"scene.toml\"\nsettings = [\"output.vtk=true\"]\n"
      "[[parameters]]\nname = \"v\"\nsettings = [\"x={value}\"]\nvalues = [1]\n"
      "[[figures]]\nname = \"m\"\nkey = \"k\"\n");
  // The last word counts.
  EXPECT_EQ(sweep.settings, (std::vector<std::string>{"output.vtk=false", "output.plots=false", "output.vtk=true"}));
}

TEST(ReadExperiment, TheShortFormOfACurveIsItsFirstValueUnlessTheFileSaysOtherwise) {
  const TemporaryFolder folder;
  const std::string path = folder.file("sweep.toml");
  const auto shortened = [&](const std::string& words) {
    std::ofstream(path) << "scene = \"scene.toml\"\n[reference]\n[[curves]]\nname = \"c\"\nsettings = [\"x={value}\"]\n"
                           "values = [1, 2]\n" +
                               words + "[[figures]]\nname = \"m\"\nkey = \"k\"\n";
    return read_sweep_file(path).curves[0].short_values;
  };
  EXPECT_EQ(shortened(""), std::vector<std::string>{"1"});
  EXPECT_EQ(shortened("short = [2]\n"), std::vector<std::string>{"2"});
  EXPECT_EQ(shortened("short = []\n"), std::vector<std::string>{});
}

TEST(ReadExperiment, SaysWhatIsWrongWithCurvesAndFigures) {
  const std::string curve =
      "[reference]\n[[curves]]\nname = \"c\"\nsettings = [\"x={value}\", \"y={beside}\"]\nvalues = [1, 2]\n";
  const std::string figure = "[[figures]]\nname = \"m\"\n";
  EXPECT_EQ(complaint(curve + "beside = [3, 4]\ndefault = 2\n" + figure +
                      "columns = [\"a.b\"]\nreduce = \"largest\"\nover = \"mass\"\n"),
            "");
  EXPECT_NE(complaint(curve + "beside = [3]\n" + figure + "key = \"k\"\n"), "");
  EXPECT_THAT(complaint(curve + "default = 7\n" + figure + "key = \"k\"\n"), HasSubstr("\"7\""));
  EXPECT_THAT(complaint(curve + figure), HasSubstr("history.csv"));
  EXPECT_THAT(complaint(curve + figure + "columns = [\"a\"]\nreduce = \"mean\"\n"), HasSubstr("\"mean\""));
}

TEST(ReadExperiment, SaysWhatIsWrongWithStatements) {
  const std::string figure =
      "[[parameters]]\nname = \"speed\"\nvalues = [1, 2]\nsettings = [\"x={value}\"]\n"
      "[[figures]]\nname = \"peak\"\nkey = \"peak_acceleration_g\"\n";
  const std::string statement = figure + "[[statements]]\ntext = \"t\"\nfigure = \"peak\"\n";
  EXPECT_EQ(complaint(statement + "case = \"speed 1\"\nmost = 3\n"), "");
  EXPECT_NE(complaint(statement + "case = \"speed 1\"\n"), "");
  EXPECT_NE(complaint(statement + "case = \"speed 1\"\nleast = 4\nmost = 3\n"), "");
  EXPECT_THAT(complaint(statement + "case = \"speed 7\"\nmost = 3\n"), HasSubstr("\"speed 7\""));
  EXPECT_THAT(complaint(figure + "[[statements]]\ntext = \"t\"\nfigure = \"force\"\ncase = \"speed 1\"\nmost = 3\n"),
              HasSubstr("\"force\""));
  EXPECT_NE(complaint(figure + "[[figures]]\nname = \"f\"\ncolumns = [\"x\"]\nreduce = \"mean\"\n"), "");
  EXPECT_NE(complaint(figure + "[[figures]]\nname = \"f\"\nkey = \"x\"\naverage = true\n"), "");
}

TEST(ReadExperiment, SaysWhatIsWrongWithStabilityMaps) {
  const std::string curve = "[[curves]]\nname = \"c\"\nsettings = [\"x={value}\"]\nvalues = [1, 2]\n";
  EXPECT_EQ(complaint(curve + "group = \"g\"\n"), "");
  EXPECT_EQ(complaint("[[curves]]\nname = \"c\"\ngroup = \"g\"\n"), "");  // one run
  EXPECT_NE(complaint(curve + "group = \"g\"\ncolumns = \"a\"\n"), "");
  EXPECT_NE(complaint(curve + "group = \"g\"\n[[curves]]\nname = \"d\"\nvalues = 1\n"), "");
}

TEST(ReadExperiment, KeysThatAreGoneAreUnknown) {
  const std::string curve = "[[curves]]\nname = \"c\"\ngroup = \"g\"\n";
  for (const char* lines :
       {"ends = \"stopped\"\n", "order_beyond = 2\n", "message = \"m\"\n", "[growth]\n", "[[printed]]\n"})
    EXPECT_THAT(complaint(curve + lines), HasSubstr("E0103")) << lines;
}

TEST(ReadExperiment, ExpectationsOfACurveAreOrdersOrErrors) {
  const std::string curve =
      "[reference]\n[[curves]]\nname = \"c\"\nvalues = [1, 2]\n[[figures]]\nname = \"f\"\nkey = \"k\"\n"
      "[[expect]]\nfigure = \"f\"\ncurve = \"c\"\n";
  EXPECT_EQ(complaint(curve + "order = [1.9, 2.1]\n"), "");
  EXPECT_EQ(complaint(curve + "error = 0.1\n"), "");
  EXPECT_NE(complaint(curve), "");
  EXPECT_NE(complaint(curve + "order = 2\n"), "");
  EXPECT_THAT(complaint(curve + "error = 0.1\n[[expect]]\nfigure = \"f\"\ncurve = \"e\"\nerror = 1\n"),
              HasSubstr("\"e\""));
}

// sweep_schema() of mbd_solver/studies/sweep_file.cpp says what the reader does: every shipped file
// is valid by its keys and types.

using Json = nlohmann::json;
using Kind = ConfigNode::Kind;

Json schema() { return Json::parse(sweep_schema()); }

bool is_of(const ConfigNode& value, const std::string& type) {
  if (type == "string") return value.kind == Kind::kText;
  if (type == "number") return value.is_number();
  if (type == "integer") return value.kind == Kind::kInteger;
  if (type == "boolean") return value.kind == Kind::kFlag;
  if (type == "array") return value.kind == Kind::kList;
  return type == "object" && value.kind == Kind::kTable;
}

// What is wrong with a value by the schema, or "".
std::string wrong(const ConfigNode& value, const Json& s, const std::string& path) {
  if (s.empty()) return "";
  if (s.contains("anyOf")) {
    for (const Json& way : s["anyOf"])
      if (wrong(value, way, path).empty()) return "";
    return path + ": none of the types";
  }
  if (s.contains("enum")) return std::count(s["enum"].begin(), s["enum"].end(), value.text) ? "" : path + ": no choice";
  const Json types = s["type"].is_string() ? Json::array({s["type"]}) : s["type"];
  if (std::none_of(types.begin(), types.end(), [&](const Json& type) { return is_of(value, type); }))
    return path + ": is " + value.description() + ", expected " + types.dump();
  for (const ConfigNode& item : value.list)
    if (const std::string problem = wrong(item, s["items"], path + "[]"); !problem.empty()) return problem;
  for (const auto& [key, item] : value.table) {
    const bool known = s.contains("properties") && s["properties"].contains(key);
    if (!known && !s["additionalProperties"].is_object()) return path + ": knows no " + key;
    const Json& of_key = known ? s["properties"][key] : s["additionalProperties"];
    if (const std::string problem = wrong(item, of_key, path + "." + key); !problem.empty()) return problem;
  }
  return "";
}

TEST(ExperimentSchema, TakesEveryShippedExperiment) {
  const Json s = schema();
  int count = 0;
  for (const char* folder : {"inputs/accuracy", "inputs/sweeps"})
    for (const auto& entry : std::filesystem::directory_iterator(std::string(FOOTFALL_SOURCE_DIR) + "/" + folder)) {
      if (entry.path().extension() != ".toml") continue;
      EXPECT_EQ(wrong(parse_toml_file(entry.path()), s, ""), "") << entry.path();
      ++count;
    }
  EXPECT_GT(count, 20);
}

TEST(ExperimentSchema, HoldsTheKeysOfEverySection) {
  const Json s = schema()["properties"];
  EXPECT_TRUE(s["parameters"]["items"]["properties"]["choices"]["items"]["properties"].contains("settings"));
  EXPECT_TRUE(s["curves"]["items"]["properties"].contains("tolerance"));
  EXPECT_TRUE(s["figures"]["items"]["properties"]["reduce"].contains("enum"));
  EXPECT_TRUE(s["fits"]["items"]["properties"]["factors"]["items"]["properties"].contains("published"));
  EXPECT_EQ(
      wrong(parse_toml_file(std::string(FOOTFALL_SOURCE_DIR) + "/inputs/dropped_sphere/scene.toml"), schema(), ""),
      ": knows no bodies");
}

// What an experiment runs.

using ::testing::ElementsAre;

std::vector<std::string> names(const Plan& plan) {
  std::vector<std::string> names;
  for (const RunRequest& run : plan.runs) names.push_back(run.name);
  return names;
}

// Two curves over two seeds, one with a reference of its own.
SweepSpec two_curves() {
  SweepSpec spec;
  spec.scene = "scene.toml";
  spec.settings = {"all=1"};
  spec.reference.emplace();
  spec.reference->settings = {"fine=1"};
  spec.curves.resize(2);
  spec.curves[0].name = "window";
  spec.curves[0].settings = {"every={value}"};
  spec.curves[0].values = {"5", "2"};
  spec.curves[0].short_values = {"2"};
  spec.curves[1].name = "time step";
  spec.curves[1].settings = {"dt={value}", "every={beside}"};
  spec.curves[1].reference = {"dt=1e-5"};
  spec.curves[1].values = {"1e-4", "5e-5"};
  spec.curves[1].short_values = {"1e-4"};
  spec.curves[1].beside = {"3", "6"};
  ParameterSpec seed;
  seed.name = "seed";
  seed.ensemble = true;
  seed.choices = {{"7", "", {"seed=7"}}, {"8", "", {"seed=8"}}};
  seed.short_choices = {seed.choices[0]};
  spec.parameters = {seed};
  return spec;
}

TEST(PlanOf, RunsEveryValueOfACurveForEveryMemberOfTheEnsemble) {
  const Plan plan = plan_of(two_curves(), false);
  EXPECT_EQ(plan.members, 2U);
  EXPECT_THAT(names(plan), ElementsAre("reference__seed_7", "reference__seed_8", "window_5__seed_7", "window_5__seed_8",
                                       "window_2__seed_7", "window_2__seed_8", "time_step_reference__seed_7",
                                       "time_step_reference__seed_8", "time_step_1e-4__seed_7",
                                       "time_step_1e-4__seed_8", "time_step_5e-5__seed_7", "time_step_5e-5__seed_8"));
  EXPECT_THAT(plan.runs[10].settings, ElementsAre("all=1", "dt=5e-5", "every=6", "seed=7"));
  EXPECT_THAT(plan.runs[7].settings, ElementsAre("all=1", "fine=1", "dt=1e-5", "seed=8"));
}

TEST(PlanOf, EveryCaseKnowsWhatItIsComparedWith) {
  const Plan plan = plan_of(two_curves(), false);
  ASSERT_EQ(plan.cases.size(), 6U);
  EXPECT_EQ(plan.cases[1].name, "window 5");
  EXPECT_EQ(plan.cases[1].reference, 0);
  EXPECT_EQ(plan.cases[3].name, "time step reference");
  EXPECT_EQ(plan.cases[5].reference, 3);
  EXPECT_THAT(plan.cases[5].runs, ElementsAre(10, 11));
}

TEST(PlanOf, ShortFormTakesItsOwnValuesTimeAndSettings) {
  SweepSpec spec = two_curves();
  spec.until = 2.0;
  spec.short_form = {0.1, {"small=1"}};
  const Plan plan = plan_of(spec, true);
  EXPECT_THAT(names(plan), ElementsAre("reference__seed_7", "window_2__seed_7", "time_step_reference__seed_7",
                                       "time_step_1e-4__seed_7"));
  EXPECT_THAT(plan.runs[1].settings, ElementsAre("all=1", "small=1", "every=2", "seed=7"));
  EXPECT_EQ(plan.runs[1].until, 0.1);
}

TEST(PlanOf, AReferenceThatDependsOnTheValueIsRunForEach) {
  SweepSpec spec = two_curves();
  spec.reference.reset();
  spec.parameters.clear();
  spec.curves.pop_back();
  spec.curves[0].reference = {"every={value}", "tolerance=1e-9"};
  const Plan plan = plan_of(spec, false);
  EXPECT_THAT(names(plan), ElementsAre("window_5_reference", "window_5", "window_2_reference", "window_2"));
  EXPECT_EQ(plan.cases[3].reference, 2);
}

TEST(PlanOf, ParametersAreCombinedAndTheEnsembleIsOneCase) {
  SweepSpec spec = two_curves();
  spec.curves.clear();
  spec.reference.reset();
  ParameterSpec speed;
  speed.name = "speed";
  speed.choices = {{"1", "", {"v=1"}}, {"on ice", "ice.toml", {"v=2"}}};
  spec.parameters.push_back(speed);
  const Plan plan = plan_of(spec, false);
  EXPECT_THAT(names(plan),
              ElementsAre("seed_7__speed_1", "seed_7__speed_on_ice", "seed_8__speed_1", "seed_8__speed_on_ice"));
  ASSERT_EQ(plan.cases.size(), 2U);
  EXPECT_EQ(plan.cases[1].name, "speed on ice");
  EXPECT_THAT(plan.cases[1].runs, ElementsAre(1, 3));
  EXPECT_EQ(plan.runs[1].scene, "ice.toml");
}

TEST(PlanOf, RunsOfOneNameAreTold) {
  SweepSpec spec = two_curves();
  spec.curves[1].name = "window";
  spec.curves[1].values = {"5", "6"};
  EXPECT_THROW(plan_of(spec, false), InputError);
}

// What a finished run is known by: its scene, and the contents of every file that the scene names.

namespace fs = std::filesystem;

class RunStoreTest : public ::testing::Test, protected TemporaryFolder {};

TEST_F(RunStoreTest, KnowsARunByEveryFileThatItsSceneNames) {
  write("scene.toml", R"(
end_time = 0.1
[materials.steel]
density = 7800
[[bodies]]
name = "pad"
material = "steel"
shape = { kind = "sphere", radius = 0.1, centre = [0, 0, 1] }
[[boundaries]]
body = "pad"
surface = { file = "pad.stl" }
[ground]
kind = "particles"
[particles]
script = "in.grains"
bed = { script = "in.bed" }
)");
  write("in.grains",
        "include more.grains\nfix pad all mesh/surface file pad.stl type 1\nfix mbd all couple/mbd every 1 mesh pad "
        "pad\nrun 1\n");
  write("more.grains", "# grains\n");
  write("in.bed", "write_restart ${bed}\n");
  write("pad.stl",
        "solid pad\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 "
        "0\nendloop\nendfacet\nendsolid pad\n");
  const auto recipe = [&] { return recipe_of(read_scene(file("scene.toml"), {}), 0.1); };
  const std::string before = recipe();
  ASSERT_FALSE(before.empty());
  EXPECT_EQ(recipe(), before);
  for (const char* name : {"in.grains", "more.grains", "in.bed", "pad.stl"}) {
    const std::string kept = recipe();
    std::ofstream(file(name), std::ios::app) << "# changed\n";
    EXPECT_NE(recipe(), kept) << name;
  }
  // On another ground the scripts of the grains do not matter.
  const auto on_soil = [&] {
    return recipe_of(read_scene(file("scene.toml"), {"ground.kind=soil", "ground.soil=dry-sand"}), 0.1);
  };
  const std::string kept = on_soil();
  std::ofstream(file("in.bed"), std::ios::app) << "# changed\n";
  EXPECT_EQ(on_soil(), kept);
}

// A scene without grains.
RunRequest request(const std::string& name, const std::vector<std::string>& settings) {
  RunRequest request;
  request.name = name;
  request.scene = std::string(FOOTFALL_SOURCE_DIR) + "/inputs/accuracy/scenes/slider_crank.toml";
  request.settings = settings;
  return request;
}

TEST_F(RunStoreTest, RunsOfOneRecipeAreOne) {
  RunStore store(folder_.string(), true);
  const std::size_t first = store.add(request("first", {"solver.rtol=1e-6"}));
  const std::size_t same = store.add(request("same", {"solver.rtol=1e-3", "solver.rtol=1e-6"}));
  const std::size_t other = store.add(request("other", {"solver.rtol=1e-3"}));
  EXPECT_EQ(store.folder(same), file("first"));
  EXPECT_EQ(store.folder(other), file("other"));
  EXPECT_EQ(store.left({same, first, other}), (std::vector<std::size_t>{first, other}));
}

TEST_F(RunStoreTest, AFinishedRunIsKeptUntilItsRecipeChanges) {
  const RunRequest run = request("run", {});
  fs::create_directory(file("run"));
  write("run/summary.json", "{\"status\": \"done\"}");
  const std::string recipe = fingerprint(recipe_of(read_scene(run.scene, {}), run.until));
  write("run.done.json", "{\"recipe\": \"" + recipe + "\", \"cost\": {\"cpu_s\": 2.5}}");
  const auto done = [&](bool keep, const RunRequest& asked) {
    RunStore store(folder_.string(), keep);
    return store.is_done(store.add(asked));
  };
  EXPECT_TRUE(done(true, run));
  EXPECT_FALSE(done(false, run));
  EXPECT_FALSE(done(true, request("run", {"solver.rtol=1e-3"})));
  RunStore store(folder_.string(), true);
  EXPECT_EQ(store.end_of(store.add(run)).cost.cpu, 2.5);
  fs::remove(file("run/summary.json"));
  EXPECT_FALSE(done(true, run));
}

TEST_F(RunStoreTest, AWrongSceneIsToldUnlessTheRunMayBeRefused) {
  RunStore store(folder_.string(), true);
  RunRequest wrong = request("wrong", {"solver.rtol=-1"});
  EXPECT_THROW(store.add(wrong), InputError);
  wrong.may_be_refused = true;
  EXPECT_FALSE(store.is_done(store.add(wrong)));
}

TEST_F(RunStoreTest, WhatStoodThereIsKeptWhenTheNewFileCannotBeWritten) {
  write("result.csv", "old\n");
  fs::create_directories(file("result.csv.part/full"));  // nothing can be written under this name
  EXPECT_THROW(write_whole_file(file("result.csv"), "new\n"), InputError);
  std::string text;
  std::ifstream(file("result.csv")) >> text;
  EXPECT_EQ(text, "old");
  fs::remove_all(file("result.csv.part"));
  write_whole_file(file("result.csv"), "new\n");
  std::ifstream(file("result.csv")) >> text;
  EXPECT_EQ(text, "new");
  EXPECT_FALSE(fs::exists(file("result.csv.part")));
}

// Figures of a run: peaks that stand out of a curve, reductions of columns.

std::vector<double> humps(std::initializer_list<double> heights, double ripple) {
  std::vector<double> x;
  for (const double height : heights)
    for (int i = 0; i < 100; ++i) x.push_back(height * std::sin(M_PI * i / 100.0) + ripple * (i % 2));
  return x;
}

TEST(CountPeaks, CountsHumpsAndNotTheRippleOnThem) {
  EXPECT_EQ(count_peaks(humps({1.0}, 0.05), 0.3), 1);
  EXPECT_EQ(count_peaks(humps({1.0, 0.8}, 0.05), 0.3), 2);
  EXPECT_EQ(count_peaks(humps({0.7, 1.0, 0.5}, 0.05), 0.3), 3);
  EXPECT_EQ(count_peaks(humps({1.0, 0.2}, 0.05), 0.3), 1);
  EXPECT_EQ(count_peaks(humps({0.2, 1.0}, 0.0), 0.3), 1);
}

TEST(CountPeaks, ShoulderIsNoPeakAndARiseAtTheEndIsOne) {
  EXPECT_EQ(count_peaks({0.0, 0.9, 0.8, 1.0, 0.0}, 0.3), 1);
  EXPECT_EQ(count_peaks({0.0, 0.5, 1.0}, 0.3), 1);
  EXPECT_EQ(count_peaks({1.0, 0.5, 0.0}, 0.3), 0);
  EXPECT_EQ(count_peaks({2.0, 2.0, 2.0}, 0.3), 0);
  EXPECT_EQ(count_peaks({}, 0.3), 0);
}

// Of a run with these files.
std::vector<double> metrics_of(const std::vector<MetricSpec>& metrics, const char* summary, const char* history) {
  const TemporaryFolder place;
  std::ofstream(place.folder_ / "summary.json") << summary;
  std::ofstream(place.folder_ / "history.csv") << history;
  return metrics_of_run(metrics, place.folder_.string(), "file.toml");
}

TEST(FiguresOfRun, ReduceEveryColumnAndTakeTheExtremeOrTheMean) {
  const std::vector<std::string> both = {"a", "b"};
  std::vector<MetricSpec> figures(7);
  for (MetricSpec& figure : figures) figure.columns = both;
  figures[1].average = true;
  figures[2].reduction = Reduction::kMin;
  figures[3].reduction = Reduction::kMin;
  figures[3].average = true;
  figures[4].reduction = Reduction::kFinal;
  figures[5].average = true;
  figures[5].over = "weight";
  figures[6].reduction = Reduction::kDrop;
  EXPECT_THAT(metrics_of(figures, "{\"weight\": 2.0}", "# units: s,N,N\ntime,a,b\n0,1,5\n1,3,-1\n2,2,4\n"),
              ElementsAre(5.0, 4.0, -1.0, 0.0, 4.0, 2.0, 6.0));
}

// (first - last) / first.
TEST(FiguresOfRun, LossIsTheShareOfTheFirstValueThatIsGone) {
  MetricSpec figure;
  figure.columns = {"E"};
  figure.reduction = Reduction::kLoss;
  EXPECT_THAT(metrics_of({figure}, "{}", "# units: s,J\ntime,E\n0,8\n1,1\n2,2\n"), ElementsAre(0.75));
}

// The last four of ten rows: (1 + 3 + 2 + 6) / 4.
TEST(FiguresOfRun, SteadyIsTheMeanOfTheLastRows) {
  MetricSpec figure;
  figure.columns = {"a"};
  figure.reduction = Reduction::kSteady;
  const char* rows = "# units: s,N\ntime,a\n0,99\n1,99\n2,99\n3,99\n4,99\n5,99\n6,1\n7,3\n8,2\n9,6\n";
  EXPECT_THAT(metrics_of({figure}, "{}", rows), ElementsAre(3.0));
}

TEST(FiguresOfRun, AreReducedColumnsOverAKeyOfTheSummary) {
  MetricSpec figure;
  figure.columns = {"work.contact"};
  figure.reduction = Reduction::kLargest;
  figure.over = "reference_energy_J";
  EXPECT_THAT(metrics_of({figure}, "{\"reference_energy_J\": 50.0}\n",
                         "# units: s,J\ntime,work.contact\n0,0\n0.1,-20\n0.2,-10\n"),
              ElementsAre(0.4));
}

// mbd_solver/studies/metrics.h: beds whose surface is a known line, and the figure of an experiment that is read from dumps.

constexpr double kGrain = 0.005;  // radius [m]

constexpr double kDegree = 0.05;  // by the places of grains in the slices [deg]

// A row of grains on z = height(x), from 0 to 1 m, a tenth of a radius apart, and as many 0.1 m below it.
template <class Height>
BedFrame bed_under(Height height) {
  BedFrame bed;
  const int n = 2000;
  bed.x.resize(3, 2 * n);
  for (int i = 0; i < n; ++i) {
    const double x = 0.1 * kGrain * i;
    bed.x.col(2 * i) << x, 0.0, height(x);
    bed.x.col(2 * i + 1) << x, 0.0, height(x) - 0.1;
    for (int k = 0; k < 2; ++k) bed.id.push_back(2 * i + k + 1), bed.radius.push_back(kGrain);
  }
  return bed;
}

TEST(BedSlope, FindsTheAngleOfAPlaneSurface) {
  for (const double angle : {5.0, 20.0, 35.0, 50.0}) {
    const double steep = std::tan(angle * kPi / 180.0);
    const BedSlope slope =
        bed_slope(bed_under([&](double x) { return -steep * x; }), {0.0, 1.0, kGrain, -0.9 * steep, -0.1 * steep});
    EXPECT_NEAR(slope.angle, angle, kDegree);
    EXPECT_NEAR(slope.r_squared, 1.0, 1e-4);
    EXPECT_EQ(slope.x.size(), slope.height.size());
  }
}

TEST(BedSlope, LeavesOutLevelPartsBeyondTheBounds) {
  const auto step = [](double x) { return x < 0.4 ? 0.0 : x > 0.6 ? -0.1 : -0.5 * (x - 0.4); };
  const BedSlope slope = bed_slope(bed_under(step), {0.0, 1.0, kGrain, -0.08, -0.02});
  EXPECT_NEAR(slope.angle, std::atan(0.5) * 180.0 / kPi, kDegree);
}

TEST(BedSlope, OfTooFewSlicesIsNoNumber) {
  const BedSlope none = bed_slope(bed_under([](double) { return 0.0; }), {0.0, 1.0, kGrain, -0.08, -0.02});
  EXPECT_TRUE(std::isnan(none.angle));
  EXPECT_TRUE(std::isnan(none.r_squared));
  EXPECT_TRUE(std::isnan(bed_slope(BedFrame{}, {0.0, 0.0, 0.0, -1.0, 1.0}).angle)) << "no grain at all";
}

TEST(BedSlope, IsAFigureOfARunFromItsLastDump) {
  namespace fs = std::filesystem;
  const TemporaryFolder place;
  const fs::path& folder = place.folder_;
  std::ofstream(folder / "summary.json") << "{}";
  MetricSpec figure;
  figure.slope = {-0.9, -0.1};
  EXPECT_THROW(metrics_of_run({figure}, folder.string(), "file.toml"), InputError) << "no dumps";
  for (const int step : {0, 100}) {  // level first, then one in two
    const BedFrame bed = bed_under([&](double x) { return step > 0 ? -0.5 * x - 0.05 : 0.0; });
    std::ofstream dump(folder / ("grains_" + std::to_string(step) + ".txt"));
    dump << "ITEM: TIMESTEP\n"
         << step << "\nITEM: NUMBER OF ATOMS\n"
         << bed.count() << "\nITEM: ATOMS id x y z radius\n";
    for (int i = 0; i < bed.count(); ++i)
      dump << bed.id[i] << ' ' << bed.x(0, i) << " 0 " << bed.x(2, i) << ' ' << kGrain << '\n';
  }
  EXPECT_NEAR(metrics_of_run({figure}, folder.string(), "file.toml")[0], std::atan(0.5) * 180.0 / kPi, kDegree);
}

// What known runs say: means of cases, limits and ranking, and whether statements come out.

// Speeds 1 and 2 over two seeds; the figure is the peak.
class ResultsTest : public ::testing::Test {
 protected:
  ResultsTest() {
    spec_.scene = "scene.toml";
    ParameterSpec speed, seed;
    speed.name = "speed";
    speed.choices = {{"1", "", {}}, {"2", "", {}}};
    seed.name = "seed";
    seed.choices = {{"7", "", {}}, {"8", "", {}}};
    seed.ensemble = true;
    spec_.parameters = {speed, seed};
    spec_.metrics.resize(1);
    spec_.metrics[0].name = "peak";
    plan_ = plan_of(spec_, false);
    for (const double peak : {4.0, 6.0, 9.0, 11.0}) {
      RunResult run;
      run.metrics = {peak};
      run.end.cost.cpu = 2.0 * peak;
      runs_.push_back(run);
    }
  }
  std::vector<CheckResult> outcomes(const CheckSpec& statement) {
    spec_.checks = {statement};
    return check_results_of(spec_, cases_of(spec_, plan_, runs_));
  }

  SweepSpec spec_;
  Plan plan_;
  std::vector<RunResult> runs_;
};

TEST_F(ResultsTest, ACaseIsTheMeanOfItsSamples) {
  const std::vector<CaseResult> cases = cases_of(spec_, plan_, runs_);
  ASSERT_EQ(cases.size(), 2U);
  EXPECT_DOUBLE_EQ(cases[0].metrics[0].mean, 5.0);
  EXPECT_DOUBLE_EQ(cases[0].metrics[0].spread, std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(cases[1].cost.cpu, 20.0);
}

TEST_F(ResultsTest, AFailedRunIsLeftOutOfTheMeanAndTold) {
  runs_[2].end.code = 1;
  runs_[2].end.message = "it left the box";
  const CaseResult c = cases_of(spec_, plan_, runs_)[1];
  EXPECT_THAT(c.done, ElementsAre(3));
  EXPECT_DOUBLE_EQ(c.metrics[0].mean, 11.0);
  EXPECT_EQ(c.code, 1);
  EXPECT_EQ(c.message, "it left the box");
}

TEST_F(ResultsTest, RankingLeavesOutWhatIsBeyondTheLimits) {
  spec_.minimise = "peak";
  EXPECT_THAT(ranking(spec_, cases_of(spec_, plan_, runs_)), ElementsAre(0, 1));
  spec_.limits = {{"peak", 7.0, {}}};
  EXPECT_THAT(ranking(spec_, cases_of(spec_, plan_, runs_)), ElementsAre(0));
}

TEST_F(ResultsTest, NothingIsClaimedOfACaseWhoseRunsFailed) {
  const auto said = [&] {
    std::vector<std::string> words;
    const Table table = case_table(spec_, cases_of(spec_, plan_, runs_));
    std::istringstream rows(table.csv());
    for (std::string row; std::getline(rows, row);) {
      std::istringstream cells(row);
      for (int k = 0; k < table.column("within_limits"); ++k) std::getline(cells, row, ',');
      words.push_back(row);
    }
    words.erase(words.begin());  // the head
    return words;
  };
  EXPECT_THAT(said(), ElementsAre("yes", "yes"));
  runs_[2].end.code = 1;
  EXPECT_THAT(said(), ElementsAre("yes", "incomplete"));
  runs_[3].end.code = 2;
  EXPECT_THAT(said(), ElementsAre("yes", "failed"));  // without any limit, and with one
  spec_.limits = {{"peak", 4.5, {}}};
  EXPECT_THAT(said(), ElementsAre("no", "failed"));
  EXPECT_FALSE(cases_of(spec_, plan_, runs_)[1].within_limits);
}

TEST_F(ResultsTest, AStatementIsAboutACaseOrItsRatioToAnother) {
  CheckSpec statement;
  statement.metric = "peak";
  statement.of_case = "speed 2";
  statement.least = 9.5;
  EXPECT_TRUE(outcomes(statement)[0].reproduced);
  statement.against = "speed 1";
  EXPECT_DOUBLE_EQ(outcomes(statement)[0].judged, 2.0);
  EXPECT_FALSE(outcomes(statement)[0].reproduced);
  statement.difference = true;
  EXPECT_DOUBLE_EQ(outcomes(statement)[0].judged, outcomes(statement)[0].value - outcomes(statement)[0].reference);
}

TEST_F(ResultsTest, AStatementWithoutItsRunsIsNotJudged) {
  CheckSpec statement;
  statement.metric = "peak";
  statement.of_case = "speed 1";
  statement.most = 100.0;
  runs_[0].end.code = runs_[1].end.code = 2;
  EXPECT_TRUE(std::isnan(outcomes(statement)[0].judged));
  EXPECT_FALSE(outcomes(statement)[0].reproduced);
}

TEST_F(ResultsTest, AnOrderIsTheSlopeOfTheErrorsOfItsCurve) {
  spec_.parameters.clear();
  spec_.curves.resize(1);
  spec_.curves[0].name = "window";
  CheckSpec statement;
  statement.order = {1.9, 2.1};
  statement.metric = "peak";
  statement.curve = "window";
  statement.least = 1.9;
  statement.most = 2.1;
  spec_.checks = {statement};
  std::vector<CaseResult> cases(3);
  for (std::size_t k = 0; k < cases.size(); ++k) {
    cases[k].plan.curve = 0;
    cases[k].plan.x = std::pow(2.0, static_cast<double>(k));
    cases[k].metrics.resize(1);
    cases[k].metrics[0].error = 1e-3 * cases[k].plan.x * cases[k].plan.x;
  }
  cases[0].plan.is_reference = true;  // no point of the line, whatever its numbers
  cases[0].metrics[0].error = 1.0;
  EXPECT_NEAR(check_results_of(spec_, cases)[0].judged, 2.0, 1e-12);
  spec_.checks[0].order.clear();
  spec_.checks[0].error = 0.1;
  EXPECT_DOUBLE_EQ(check_results_of(spec_, cases)[0].judged, 16e-3);  // the last value's
}

// Errors of an ensemble's figures, and of curves.

TEST(SampledMetric, ErrorIsOfTheMeanAndItsScatterThatOfTheDifferences) {
  // Samples far apart that all change by the same: the error is known exactly, however large the spread.
  const SampledMetric same = sampled_metric({11.0, 21.0, 31.0}, {10.0, 20.0, 30.0});
  EXPECT_DOUBLE_EQ(same.mean, 21.0);
  EXPECT_DOUBLE_EQ(same.spread, 10.0);
  EXPECT_DOUBLE_EQ(same.error, 0.05);
  EXPECT_DOUBLE_EQ(same.standard_error, 0.0);
  // Differences -1, 1, 3: mean 1, deviation 2, standard error 2 / sqrt(3), of 20.
  const SampledMetric other = sampled_metric({9.0, 21.0, 33.0}, {10.0, 20.0, 30.0});
  EXPECT_DOUBLE_EQ(other.error, 0.05);
  EXPECT_NEAR(other.standard_error, 2.0 / std::sqrt(3.0) / 20.0, 1e-15);
  EXPECT_DOUBLE_EQ(sampled_metric({3.0}, {2.0}).standard_error, 0.0);
}

TEST(ObservedOrder, IsTheSlopeOfTheLogarithms) {
  EXPECT_NEAR(observed_order({{0.1, 3e-2}, {0.2, 12e-2}, {0.4, 48e-2}}), 2.0, 1e-12);
  EXPECT_EQ(observed_order({{0.1, 3e-2}, {0.2, 0.0}}), 0.0);  // one point that has a logarithm
}

// What is recommended from a known table of errors, and how the page says it.

// Of curve -1: the reference of all.
CaseResult point(int curve, const std::string& value, const std::vector<double>& errors,
                 const std::vector<double>& standard_errors, double cpu) {
  CaseResult p;
  p.plan.curve = curve;
  p.plan.value = value;
  p.plan.is_reference = value == "reference";
  for (std::size_t m = 0; m < errors.size(); ++m) p.metrics.push_back({2.0, 0.1, errors[m], standard_errors[m]});
  p.cost.cpu = cpu;
  return p;
}

struct Known {
  SweepSpec spec;
  Results results;
};

// Windows: 20 fails, 10 is lucky at 1 %, 5 is not, 2 is. Steps: none is within 1 %, and the coarse one leaves more open
// than 5 %.
Known known_errors() {
  Known known;
  known.spec.title = "Known";
  known.spec.curves.resize(3);
  known.spec.curves[0].name = "windows";
  known.spec.curves[0].default_value = "5";
  known.spec.curves[1].name = "steps";
  known.spec.curves[2].name = "rigid";
  known.spec.metrics.resize(2);
  known.spec.metrics[0].name = "force";
  known.spec.metrics[1].name = "depth";
  known.results.members = 4;
  CaseResult failed = point(0, "20", {0.0, 0.0}, {0.0, 0.0}, 1.0);
  failed.code = 2;
  failed.message = "it left the box";
  known.results.cases = {point(-1, "reference", {0.0, 0.0}, {0.0, 0.0}, 80.0),
                         point(1, "reference", {0.0, 0.0}, {0.0, 0.0}, 50.0),
                         failed,
                         point(0, "10", {0.008, 0.009}, {0.001, 0.001}, 6.0),
                         point(0, "5", {0.02, 0.001}, {0.001, 0.001}, 10.0),
                         point(0, "2", {0.001, 0.004}, {0.001, 0.002}, 25.0),
                         point(1, "2e-4", {0.02, 0.04}, {0.06, 0.01}, 30.0),
                         point(1, "1e-4", {0.03, 0.02}, {0.001, 0.001}, 40.0),
                         point(2, "false", {0.3, std::numeric_limits<double>::quiet_NaN()}, {0.0, 0.0}, 8.0)};
  return known;
}

TEST(Recommendation, TakesTheFirstValueFromWhichOnAllErrorsAreWithin) {
  const Known k = known_errors();
  const std::vector<Recommendation> fine = recommendations_of(k.spec, k.results, 0.01),
                                    coarse = recommendations_of(k.spec, k.results, 0.05);
  EXPECT_TRUE(fine[0].within);
  EXPECT_EQ(fine[0].point->plan.value, "2");
  EXPECT_EQ(k.spec.metrics[fine[0].worst].name, "depth");
  EXPECT_DOUBLE_EQ(fine[0].largest().error, 0.004);
  EXPECT_DOUBLE_EQ(fine[0].largest().standard_error, 0.002);
  EXPECT_DOUBLE_EQ(fine[0].time_ratio, 2.5);  // over the default, 5
  EXPECT_EQ(coarse[0].point->plan.value, "10");
  EXPECT_DOUBLE_EQ(coarse[0].time_ratio, 0.6);
}

TEST(Recommendation, SaysWhenNoneIsWithinAndWhenTheSamplesLeaveMoreOpen) {
  const Known k = known_errors();
  const std::vector<Recommendation> fine = recommendations_of(k.spec, k.results, 0.01),
                                    coarse = recommendations_of(k.spec, k.results, 0.05);
  EXPECT_FALSE(fine[1].within);
  EXPECT_EQ(fine[1].point->plan.value, "1e-4");
  EXPECT_TRUE(fine[1].resolved);
  EXPECT_TRUE(coarse[1].within);
  EXPECT_EQ(coarse[1].point->plan.value, "2e-4");
  EXPECT_FALSE(coarse[1].resolved);
  EXPECT_DOUBLE_EQ(coarse[1].time_ratio, 0.6);  // over the reference of its own
  EXPECT_EQ(coarse[2].point, nullptr);          // an error that is no number is not within
}

TEST(Recommendation, LeavesOutOneMeasureThatNoValueKeepsWithin) {
  Known k = known_errors();
  for (CaseResult& p : k.results.cases)
    if (p.code == 0) p.metrics[0].error = 0.2;
  const std::vector<Recommendation> coarse = recommendations_of(k.spec, k.results, 0.05);
  EXPECT_EQ(coarse[0].point->plan.value, "10");
  EXPECT_EQ(k.spec.metrics[coarse[0].excepted].name, "force");
  EXPECT_EQ(k.spec.metrics[coarse[0].worst].name, "depth");
  EXPECT_DOUBLE_EQ(coarse[0].largest().error, 0.009);
}

TEST(Recommendation, LinesOfThePage) {
  const Known k = known_errors();
  const std::string page = recommendation_section(k.spec, k.results);
  EXPECT_THAT(page, HasSubstr("| windows | 2 | 0.4 ± 0.2 %, depth | 2.50 | 10 | 0.9 ± 0.1 %, depth | 0.60 |\n"));
  EXPECT_THAT(page, ContainsRegex("\\| steps \\| none; [^|]*1e-4 \\| 3 ± 0.1 %, force \\| 0.80 "
                                  "\\| 2e-4 \\([^|]*\\) \\| 4 ± 1 %, depth \\| 0.60 \\|\n"));
  EXPECT_THAT(page, ContainsRegex("\\| rigid \\| none [^|]*\\|  \\|  \\| none [^|]*\\|  \\|  \\|\n"));
  EXPECT_THAT(page, HasSubstr("the largest error occurs for \"windows\": 2 ± 0.1 % of force at 5."));
  EXPECT_THAT(page, HasSubstr(" 5 % (force), 5 % (depth);\n"));
  EXPECT_THAT(page, HasSubstr(" 4 by 0.50 times that"));
}

// Stability maps: how a run ended, by its exit code, its message and its files.

class StabilityMap : public ::testing::Test {
 protected:
  StabilityMap() {
    spec.file = "/inputs/accuracy/map.toml";
    spec.folder = "/inputs/accuracy";
    spec.title = "Map";
    spec.curves.resize(1);
    spec.curves[0].name = "pad";
    spec.curves[0].map.group = "Windows";
    results.runs.resize(1);
    results.cases.resize(1);
    results.cases[0].plan.curve = 0;
    results.cases[0].plan.value = "5";
    results.cases[0].plan.runs = {0};
    RunEnd& end = results.runs[0].end;
    end.folder = folder.file("run");
    std::filesystem::create_directory(end.folder);
    write({1.0, 1.0});
    end.summary["reference_energy_J"] = 1.0;
  }
  void write(const std::vector<double>& energies) {
    std::ofstream history(folder.file("run/history.csv"));
    history << "# units: s,J\ntime,energy.total\n";
    for (std::size_t k = 0; k < energies.size(); ++k) history << k << "," << energies[k] << "\n";
  }
  MapRow row(int code = 0, const std::string& message = "", const std::vector<std::string>& warnings = {}) {
    results.runs[0].end.code = code;
    results.runs[0].end.message = message;
    results.runs[0].end.warnings = warnings;
    return map_rows(spec, results).at(0);
  }
  const TemporaryFolder folder;
  SweepSpec spec;
  Results results;
};

TEST_F(StabilityMap, ShowsHowEveryRunEnded) {
  EXPECT_EQ(row().end, "accurate");
  EXPECT_EQ(row(0, "", {"stiff"}).end, "warned");
  EXPECT_EQ(row(1, "unstable").end, "stopped");
  EXPECT_EQ(row(2, "no such body").end, "refused");
  EXPECT_FALSE(row().fault || row(0, "", {"stiff"}).fault || row(1, "unstable").fault || row(2, "no body").fault);
  EXPECT_THAT(map_page(spec, {row(1, "unstable")}), HasSubstr("## Windows\n\n| case | value | end | result |\n"
                                                              "|---|---|---|---|\n| pad | 5 | stopped | unstable |\n"));
}

TEST_F(StabilityMap, AFaultIsAnEndWithoutAWordOrAWrongResultWithoutAWarning) {
  EXPECT_TRUE(row(1).fault);
  EXPECT_TRUE(row(RunEnd::kHung, "hangs").fault);
  EXPECT_TRUE(row(139, "signal 11").fault);
  write({1.0, 1.5});  // half of the reference energy is created
  EXPECT_TRUE(row().fault);
  EXPECT_FALSE(row(0, "", {"the coupling added energy"}).fault);
}

}  // namespace
}  // namespace footfall
