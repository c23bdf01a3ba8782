// Two runs next to each other, mbd_solver/app/difference; the feed of a run in progress, mbd_solver/app/live; verdicts of compare;
// meshes of scripts, mbd_solver/app/scenery.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>

#include "coupler/base/errors.h"
#include "mbd_solver/app/compare_command.h"
#include "mbd_solver/app/difference/difference_page.h"
#include "mbd_solver/app/difference/pair_page.h"
#include "mbd_solver/app/difference/run_pair.h"
#include "mbd_solver/app/difference/samples.h"
#include "mbd_solver/app/film/film.h"
#include "mbd_solver/app/live/run_feed.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/app/scenery/scenery.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/session/output/summary.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

using Json = nlohmann::ordered_json;

bool contains(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

TEST(SceneDifferences, AreNamedAsSetNamesThem) {
  const Json a = Json::parse(R"({"end_time": 1.0, "bodies": [{"name": "cabin", "mass": 5}, {"name": "leg", "mass": 1}],
                                 "gravity": [0, 0, -9.81]})"),
             b = Json::parse(R"({"end_time": 1.0, "bodies": [{"name": "leg", "mass": 1.5}, {"name": "pad"},
                                 {"name": "cabin", "mass": 5}], "gravity": [0, 0, -1.62], "title": "Moon"})");
  const std::vector<KeyDifference> found = scene_differences(a, b);
  std::string all;
  for (const KeyDifference& one : found) all += one.key + ": " + one.a + ", " + one.b + "\n";
  EXPECT_EQ(all, "bodies.leg.mass: 1, 1.5\nbodies.pad: -, there\ngravity: [0,0,-9.81], [0,0,-1.62]\ntitle: -, Moon\n");
  EXPECT_TRUE(scene_differences(a, a).empty());
}

TEST(FigureDifferences, LeaveOutCostsAndEqualNumbers) {
  const Json a = {{"peak_acceleration_g", 3.0},
                  {"max_descent_m", 0.1},
                  {"wall_s", 10.0},
                  {"steps", 5},
                  {"status", "done"}},
             b = {{"peak_acceleration_g", 3.3}, {"max_descent_m", 0.1}, {"wall_s", 20.0}, {"steps", 7}};
  const std::vector<FigureDifference> found = figure_differences(a, b);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].name, "peak acceleration");
  EXPECT_EQ(found[0].unit, "g");
  EXPECT_EQ(found[0].b, 3.3);
}

// x = t, and x = t + 0.1 sin(2 pi t) at other times and for longer; y is the same in both.
class Pair : public ::testing::Test, protected TemporaryFolder {
 protected:
  void write_run(const std::string& name, double step, double end, double size, double mass) const {
    std::string rows = "# units: s,m,N,m\ntime,cabin.x,leg.force,leg.y\n";
    for (int k = 0; k * step <= end + 1e-9; ++k) {
      const double t = k * step;
      rows += std::to_string(t) + "," + std::to_string(t + size * std::sin(2.0 * M_PI * t)) + ",7," +
              (size > 0.0 ? "1e-9" : "2e-9") + "\n";
    }
    write(name + "/history.csv", rows);
    write(name + "/summary.json",
          Json{{"status", "done"}, {"max_descent_m", 0.1 + size}, {"scene", {{"mass", mass}}}}.dump());
  }
  void SetUp() override {
    write_run("one", 0.01, 1.0, 0.0, 5.0);
    write_run("two", 0.015, 1.2, 0.1, 6.0);
  }
};

TEST_F(Pair, HasCurvesThatDiffer) {
  const RunPair pair(file("one"), file("two"));
  const std::vector<CurveDifference> found = curve_differences(pair.a.history, pair.b.history);
  ASSERT_EQ(found.size(), 1u);  // not the force, nor round-off
  EXPECT_EQ(found[0].name, "cabin.x");
  EXPECT_NEAR(found[0].largest, 0.1, 1e-3);                 // at a quarter of the period
  EXPECT_NEAR(found[0].share, 0.1 / std::sqrt(2.0), 1e-2);  // of a range of 1 m
  const History both = on_one_clock(pair, {"cabin.x"});
  EXPECT_EQ(both.names, (std::vector<std::string>{"time", "cabin.x (first)", "cabin.x (second)"}));
  EXPECT_NEAR(both.columns[0].back(), 1.0, 1e-9) << "the time that both cover";
  EXPECT_NEAR(both.columns[2][25], 0.35, 1e-3);
  EXPECT_TRUE(std::isnan(value_at(pair.a.history, pair.a.history.columns[1], 1.1)));
  EXPECT_NEAR(value_at(pair.a.history, pair.a.history.columns[1], 0.123), 0.123, 1e-9);
}

TEST_F(Pair, IsPlottedWithItsDifference) {
  const PairPlots plots = plots_of_columns(RunPair(file("one"), file("two")), {"cabin.x"});
  ASSERT_EQ(plots.panels.figures.size(), 2u);
  const Figure &curves = plots.panels.figures[0], &difference = plots.panels.figures[1];
  ASSERT_EQ(curves.curves.size(), 2u);
  EXPECT_FALSE(curves.curves[0].dashed);
  EXPECT_TRUE(curves.curves[1].dashed);
  EXPECT_EQ(difference.title, "two minus one");
  double most = 0.0;
  for (const double value : difference.curves.at(0).formula.values(plots.history))
    most = std::max(most, std::abs(value));
  EXPECT_NEAR(most, 100.0, 1.0);  // [mm]
  EXPECT_THROW(plots_of_columns(RunPair(file("one"), file("two")), {"cabin.y"}), InputError);
}

TEST_F(Pair, HasAPageOfItsDifferences) {
  const std::string page =
      text(std::filesystem::path(write_difference(file("one"), file("two"))).lexically_relative(folder_));
  for (const char* part : {"<td>mass</td>", "max descent", "cabin.x", "columns differ"})
    EXPECT_TRUE(contains(page, part)) << part;
  EXPECT_FALSE(contains(page, folder_.string())) << "no folders of this machine";
  EXPECT_TRUE(contains(page, "id=\"footfall-other-history\""));
  EXPECT_THROW(write_difference(file("one"), file("none")), InputError);
}

// ---- runs that are samples

// A sweep of five samples, cabin.x = k t for k = 0 ... 4, and of a case with a single run, 10 t.
class Sampled : public Pair {
 protected:
  void SetUp() override {
    std::string samples = "case,run\n";
    for (int k = 0; k < 6; ++k) {
      const std::string run = "sweep/runs/" + std::to_string(k);
      std::string rows = "# units: s,m\ntime,cabin.x\n";
      for (int i = 0; i <= 10; ++i)
        rows += std::to_string(0.1 * i) + "," + std::to_string((k < 5 ? k : 10) * 0.1 * i) + "\n";
      write(run + "/history.csv", rows);
      write(run + "/summary.json", Json{{"status", "done"}}.dump());
      samples += (k < 5 ? "\"slow, soft\",runs/" : "fast,runs/") + std::to_string(k) + "\n";
    }
    write("sweep/samples.csv", samples);
    write("sweep/runs.csv", "run,status\n");
    write_run("one", 0.05, 2.0, 0.0, 5.0);
  }
};

TEST_F(Sampled, HaveAMeanAndABand) {
  const std::vector<SampledCase> cases = cases_in(file("sweep"));
  ASSERT_EQ(cases.size(), 2u);
  EXPECT_EQ(cases[0].name, "slow, soft");
  EXPECT_EQ(cases[0].runs.size(), 5u);
  const History bands = bands_on_one_clock(cases, {"cabin.x"});
  EXPECT_EQ(bands.names,
            (std::vector<std::string>{"time", "cabin.x (1)", "cabin.x (1 low)", "cabin.x (1 high)", "cabin.x (2)"}));
  // Of 0, 1, 2, 3, 4 the mean, and a fifth of the way from an end to its neighbour.
  EXPECT_NEAR(bands.columns[1].back(), 2.0, 1e-9);
  EXPECT_NEAR(bands.columns[2].back(), 0.2, 1e-9);
  EXPECT_NEAR(bands.columns[3].back(), 3.8, 1e-9);
  EXPECT_NEAR(bands.columns[4].back(), 10.0, 1e-9);
  EXPECT_THROW(bands_on_one_clock(cases, {"cabin.y"}), InputError);
}

TEST_F(Sampled, AreDrawnAsBandsAlsoOverARun) {
  for (const char* other : {"", "one"}) {
    ColumnPlot plot;
    plot.run = file("sweep");
    plot.other = *other ? file(other) : "";
    plot.columns = {"cabin.x"};
    plot.out = file("plot.png");
    EXPECT_EQ(plot_columns(plot), std::vector<std::string>{plot.out});
    EXPECT_EQ(text("plot.png").substr(1, 3), "PNG");
    const std::string script = text(*other ? "sweep/plots/cabin.x-with-one.gp" : "sweep/plots/cabin.x.gp");
    for (const char* part : {"with filledcurves", "slow, soft: mean and 5 to 95 % of 5"})
      EXPECT_TRUE(contains(script, part)) << part;
    EXPECT_EQ(contains(script, "title 'one'"), *other != '\0');
  }
}

TEST_F(Sampled, AreComparedInStandardErrors) {
  write("sweep/samples.csv", "case,run\nslow,runs/0\nslow,runs/1\nslow,runs/2\nslow,runs/3\nslow,runs/4\n");
  write("other/runs.csv", "run,status\n");
  write("other/samples.csv", "case,run\nslow,../sweep/runs/3\nslow,../sweep/runs/4\nslow,../sweep/runs/5\n");
  for (int k = 0; k < 6; ++k)  // means 2 and 13, 11 / sqrt(2.5 / 5 + 271 / 3) = 1.2
    write("sweep/runs/" + std::to_string(k) + "/summary.json",
          Json{{"status", "done"}, {"max_descent_m", k < 5 ? k : 32}, {"scene", {{"seed", k}, {"mass", k < 3 ? 1 : 2}}}}
              .dump());
  const std::string page =
      text(std::filesystem::path(write_difference(file("sweep"), file("other"))).lexically_relative(folder_));
  for (const char* part : {"5 samples", "<td>within scatter</td>", "95 % of them"})
    EXPECT_TRUE(contains(page, part)) << part;
  EXPECT_FALSE(contains(page, "<td>seed</td>")) << "samples differ in it";
  EXPECT_FALSE(contains(page, folder_.string()));
  EXPECT_TRUE(contains(page, "cabin.x 95 %")) << "the edge of a band";
}

TEST_F(Sampled, NeedTheListOfTheSweep) {
  std::filesystem::remove(file("sweep/samples.csv"));
  EXPECT_THROW(cases_in(file("sweep")), InputError);
  EXPECT_THROW(cases_in(file("sweep/runs")), InputError);
  EXPECT_EQ(cases_in(file("one")).front().name, "one");
}

// ---- a run in progress

class Feed : public ::testing::Test, protected TemporaryFolder {
 protected:
  const std::string run = folder_.string();
};

TEST_F(Feed, GivesEachRowOnceAndKeepsPeaks) {
  write_run_note(run, {"A landing", "/scene.toml", 1.0});
  add_live_note(run, {0.0, Json{{"gravity", {0, 0, -1}}}});
  RunFeed feed(run);
  EXPECT_TRUE(feed.look(false).empty());
  // A thousand rows in a span of 0.5 ms: two of them are given, which hold its least and largest value.
  std::string rows = "# units: s,m\ntime,a.az\n";
  for (int k = 0; k < 1000; ++k)
    rows += std::to_string(4e-7 * k) + "," + (k == 500 ? "9" : k == 700 ? "-4" : "0") + "\n";
  write("history.csv", rows + "0.0006,1\n0.0011,");
  std::vector<LiveEvent> events = feed.look(false);
  ASSERT_EQ(events.size(), 2u);
  EXPECT_EQ(events[0].kind, "columns");
  EXPECT_EQ(Json::parse(events[0].data).at("names"), Json({"a.az"}));
  EXPECT_EQ(events[1].kind, "rows");
  EXPECT_EQ(Json::parse(events[1].data).at("time").size(), 2u);
  EXPECT_TRUE(feed.look(false).empty()) << "nothing is given twice";
  events = feed.look(true);
  ASSERT_EQ(events.size(), 1u);
  EXPECT_EQ(Json::parse(events[0].data).at("time"), Json({0.0006})) << "the last one is given at the end";
}

TEST_F(Feed, ReadsADumpOnceItIsComplete) {
  write_run_note(run, {"A landing", "/scene.toml", 1.0});
  add_live_note(run, {1e-5, Json::object()});
  RunFeed feed(run);
  const std::string head = "ITEM: TIMESTEP\n100\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x y z radius\n";
  write("grains_100.txt", head + "1 0 0 0 0.01\n");
  EXPECT_TRUE(feed.look(false).empty()) << "seen for the first time";
  write("grains_100.txt", head + "1 0 0 0 0.01\n2 1 0 0 0.01\n");
  EXPECT_TRUE(feed.look(false).empty()) << "it has grown";
  const std::vector<LiveEvent> events = feed.look(false);
  ASSERT_EQ(events.size(), 1u);
  const Json data = Json::parse(events[0].data);
  EXPECT_EQ(data.at("run").at("grains").at("count"), 2);
  EXPECT_NEAR(data.at("run").at("grains").at("times").at(0).get<double>(), 1e-3, 1e-12);
  EXPECT_TRUE(data.at("chunks").contains("grains-ids"));
}

TEST_F(Feed, TailBeginsAgainWhereTheFileDoes) {
  write("history.csv", "# units: s,m\ntime,a\n0,1\n1,2\n2,3\n");
  HistoryTail tail(file("history.csv"));
  EXPECT_EQ(tail.read(), "0,1\n1,2\n2,3\n");
  EXPECT_EQ(tail.read(), "");
  EXPECT_EQ(tail.last().values, (std::vector<double>{2, 3}));
  write("history.csv", "# units: s,m\ntime,a\n0,5\n");
  EXPECT_EQ(tail.read(), "0,5\n");
  EXPECT_EQ(tail.rows(), 1);
}

// ---- verdicts

TEST(CompareVerdict, NamesSizeAndCause) {
  Comparison equal;
  equal.worst_impulse = 1e-4;
  equal.smallest_radius = 0.01;
  EXPECT_EQ(verdict_of(equal, 0.0).substr(0, 6), "equal:");
  Comparison scatter = equal;
  scatter.first_apart = 0.2;
  scatter.worst_impulse = 0.02;
  EXPECT_TRUE(contains(verdict_of(scatter, 0.0), "within scatter:") && contains(verdict_of(scatter, 0.0), "chaos"));
  Comparison bent = equal;
  bent.worst_impulse = 0.2;
  EXPECT_TRUE(contains(verdict_of(bent, 1e-3), "differs:") && contains(verdict_of(bent, 1e-3), "facets"));
  bent.touches_at_start = true;
  EXPECT_TRUE(contains(verdict_of(bent, 0.0), "overlap at the start"));
}

// ---- scenery

class Meshes : public ::testing::Test, protected TemporaryFolder {};

TEST_F(Meshes, OfAScriptAreShownWhereLiggghtsPutsThem) {
  const std::string mesh = write("hopper.stl",
                                 "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                 "endloop\nendfacet\nendsolid a\n");
  const std::string script = write("in.hopper", "variable high index 2\nfix hopper all mesh/surface file " + mesh +
                                                    " type 1 scale 0.5 move 0 0 ${high} rotate axis 0 0 1 angle 90\n"
                                                    "fix gate all mesh/surface file " +
                                                    mesh + " type 1\nfix move all move/mesh mesh gate linear 0 0 1\n");
  PageParts parts;
  std::vector<std::string> notes;
  add_static_meshes({{"particles", {{"script", script}, {"variables", Json::object()}}}}, parts, notes);
  EXPECT_TRUE(notes.empty()) << notes.front();
  EXPECT_EQ(parts.run.at("meshes"), Json({"hopper"})) << "not the gate, which moves";
  ASSERT_EQ(parts.chunks.size(), 1u);
  EXPECT_EQ(parts.chunks[0].first, "mesh-0");
}

TEST_F(Meshes, OfABoxIsItsBlock) {
  PageParts parts;
  add_bed_block({{"particles", {{"box", {{"size", {2.0, 1.0}}, {"depth", 0.3}, {"centre", {1.0, 0.0}}}}}}}, parts);
  EXPECT_EQ(parts.run.at("bed").at("low"), Json({0.0, -0.5, -0.3}));
  EXPECT_EQ(parts.run.at("bed").at("high"), Json({2.0, 0.5, 0.0}));
}

// ---- a picture of a scene

class ReferencePage : public ::testing::Test, protected TemporaryFolder {};

TEST_F(ReferencePage, NamesNoFolderOfThisMachine) {
  const std::string scene = write("crane/scene.toml",
                                  "end_time = 1\n[[bodies]]\nname = \"jib\"\nmass = 1\n"
                                  "shape = { kind = \"sphere\", centre = [0, 0, 1], radius = 0.1 }\n");
  ASSERT_EQ(draw_reference(read_scene(scene), file("page.html")), 0);
  const std::string page = text("page.html");
  EXPECT_FALSE(contains(page, folder_.string()));
  EXPECT_TRUE(contains(page, "<span>crane/scene.toml</span>"));
}

// ---- a run that failed at its start

class FailedStart : public ::testing::Test, protected TemporaryFolder {};

TEST_F(FailedStart, IsNamedAsOne) {
  write("run.json", "{}");
  EXPECT_TRUE(contains(without_summary(folder_.string(), "x"), "killed at its start"));
  write("liggghts.log", "run 10\nERROR: Invalid fix style (input.cpp:1)\n");
  EXPECT_TRUE(contains(without_summary(folder_.string(), "x"), "Invalid fix style"));
  write("history.csv", "# units: s\ntime\n0\n");
  EXPECT_TRUE(contains(without_summary(folder_.string(), "x"), "was killed"));
  write(".footfall.lock", std::to_string(getpid()) + "\n");
  EXPECT_TRUE(contains(without_summary(folder_.string(), "x"), "has not ended"));
  note_end_of_run(folder_.string(), "failed", "no floor");
  EXPECT_TRUE(contains(without_summary(folder_.string(), "x"), "failed at the start: no floor"));
  note_end_of_run(folder_.string(), "failed", "another");  // the first reason remains
  EXPECT_EQ(end_text(read_summary((folder_ / "summary.json").string())), "failed at the start: no floor");
}

}  // namespace
}  // namespace footfall
