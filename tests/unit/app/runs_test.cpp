// Looks at runs: grains of a run, replay, progress, new cases.
#include <gtest/gtest.h>
#include <unistd.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/check_command.h"
#include "mbd_solver/app/compare_command.h"
#include "mbd_solver/app/follow.h"
#include "mbd_solver/app/new_case.h"
#include "mbd_solver/app/paraview_files.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/session/output/vtk_writer.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// The dumps with their times, for ParaView.

namespace fs = std::filesystem;

class GrainSeries : public ::testing::Test, protected TemporaryFolder {
 protected:
  const std::string folder = folder_.string();
  // grains.pvd, after dumps every 10 ms and drawings of the bodies at these times.
  std::vector<std::pair<double, std::string>> series(std::initializer_list<double> drawn) const {
    for (const int step : {0, 100, 200, 300})
      write("grains_" + std::to_string(step) + ".vtk",
            "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n1 2 3\n\nPOINT_DATA 1\nFIELD "
            "FieldData 2\nid 1 1 int\n7\nradius 1 1 double\n0.1\n");
    VtkFrame frame;
    frame.points = Eigen::Matrix3Xd::Zero(3, 1);
    VtkSeries bodies(folder, "bodies");
    for (const double t : drawn) bodies.write(t, frame);
    write_grain_series(folder);
    return read_vtk_series(folder + "/grains.pvd");
  }
};

// The bodies were drawn at the first window end behind each 10 ms, 0.2 ms later, but for the last.
TEST_F(GrainSeries, StepsTogetherWithTheDrawingsOfTheBodies) {
  write_summary(folder + "/summary.json", {{"dt_dem_s", 1e-4}, {"substeps_per_window", 3}});
  const auto found = series({0.0, 0.0102, 0.0201});
  ASSERT_EQ(found.size(), 4u);
  const double expected[] = {0.0, 0.0102, 0.0201, 0.03};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(found[k].first, expected[k], 1e-12);
    EXPECT_EQ(found[k].second, "grains_" + std::to_string(100 * k) + ".vtp");
    EXPECT_TRUE(fs::exists(folder + "/" + found[k].second));
  }
}

// The run chose windows of 4 substeps, then of 2: the drawings come 0.3 ms and 0.1 ms behind the dumps; the last one comes 0.3 ms behind,
// which is no window of 2.
TEST_F(GrainSeries, StepsTogetherWithTheDrawingsWhereTheRunChoseItsWindows) {
  write_summary(folder + "/summary.json", {{"dt_dem_s", 1e-4}, {"substeps_per_window", "auto"}});
  write_history(folder + "/history.csv",
                {{"time", "coupling.substeps"}, {"s", "-"}, {{0.0, 0.0103, 0.0201, 0.0303}, {0.0, 4.0, 2.0, 2.0}}});
  const auto found = series({0.0, 0.0103, 0.0201, 0.0303});
  ASSERT_EQ(found.size(), 4u);
  const double expected[] = {0.0, 0.0103, 0.0201, 0.03};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(found[k].first, expected[k], 1e-12);
}

// Single precision holds more than the six digits of a dump: the .vtp is the same bed, and takes its place. A dump with columns that a .vtp
// does not hold stays, and so does a text, which scripts of users read.
TEST_F(GrainSeries, TakeThePlaceOfDumpsThatTheyHoldWhole) {
  const std::string head =
      "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 2 float\n1.25 -2.5 3.12345 4 5 6\n\nPOINT_DATA "
      "2\n";
  const std::string columns =
      "id 1 2 int\n9 7\ntype 1 2 int\n1 2\nv 3 2 double\n0 0.001234 1 0 0 -2\nradius 1 2 double\n0.1 0.2\n";
  std::ofstream(folder + "/grains_0.vtk") << head << "FIELD FieldData 4\n" << columns;
  std::ofstream(folder + "/grains_10.vtk") << head << "FIELD FieldData 5\n" << columns << "heat 1 2 double\n3 4\n";
  write_summary(folder + "/summary.json", {{"dt_dem_s", 1e-4}, {"substeps_per_window", 3}});
  const BedFrame dumped = read_bed_frame(folder + "/grains_0.vtk");
  write_grain_series(folder);
  EXPECT_FALSE(fs::exists(folder + "/grains_0.vtk"));
  EXPECT_TRUE(fs::exists(folder + "/grains_10.vtk")) << "its column \"heat\" is nowhere else";
  const std::map<long, std::string> frames = find_bed_frames(folder);
  ASSERT_EQ(frames.size(), 2u);
  EXPECT_EQ(frames.at(0), folder + "/grains_0.vtp");
  EXPECT_EQ(frames.at(10), folder + "/grains_10.vtk");
  const BedFrame kept = read_bed_frame(frames.at(0));
  EXPECT_EQ(kept.id, dumped.id);
  EXPECT_EQ(kept.type, dumped.type);
  EXPECT_LT((kept.x - dumped.x).cwiseAbs().maxCoeff(), 6.0 * 6e-8) << "half a step of single precision";
  EXPECT_LT((kept.v - dumped.v).cwiseAbs().maxCoeff(), 2.0 * 6e-8);
  EXPECT_NEAR(kept.radius[1], dumped.radius[1], 6e-8);
  write_grain_series(folder);  // as after a run that was resumed
  EXPECT_EQ(read_vtk_series(folder + "/grains.pvd").size(), 2u);
  // Damaged: named, not read.
  const std::string whole = read_whole_file(folder + "/grains_0.vtp").value_or("");
  for (const std::size_t size : {whole.size() / 2, whole.size() / 3, std::size_t{200}, std::size_t{0}}) {
    std::ofstream(folder + "/cut_0.vtp") << whole.substr(0, size);
    EXPECT_THROW(read_bed_frame(folder + "/cut_0.vtp"), InputError) << size;
  }
}

TEST_F(GrainSeries, ARunWithoutGrainsGetsNone) {
  write_summary(folder + "/summary.json", {{"status", "done"}});
  write_grain_series(folder);
  EXPECT_FALSE(fs::exists(folder + "/grains.pvd"));
}

// mbd_solver/app/compare_command.h: the stock script that replays a run's motion, as text.

class ReplayTest : public ::testing::Test, protected TemporaryFolder {
 protected:
  ReplayTest() { std::filesystem::create_directories(folder_ / "motion"); }
  Replay replay(const std::string& script) const {
    return stock_replay(write("in.coupled", script), (folder_ / "motion").string(), (folder_ / "out").string(), 1e-3);
  }
  // Falls at 2 m/s, then faster, and turns about z at 5 rad/s; windows of 2 steps.
  void record_pad() const {
    write(
        "motion/pad.csv",
        "# units: s,m,m,m,rad,rad,rad,m,N,N,N\ntime,x,y,z,rx,ry,rz,bend,fx,fy,fz\n0,1,2,3,0,0,0,0,0,0,0\n"
        "0.002,1,2,2.996,0,0,0.01,0,0,0,0\n0.004,1,2,2.990,0,0,0.02,0.001,0,0,7\n0.005,1,2,2.987,0,0,0.025,0,0,0,9\n");
  }
};

const char* const kScript =
    "timestep 1e-3\nfix geo all couple/mbd/geometry body pad\nfix mesh all mesh/surface fix geo type 2\n"
    "fix wall all wall/gran model hertz mesh n_meshes 1 meshes mesh\nfix rod all wall/gran/beam model hertz &\n  type "
    "2 body rod\n"
    "fix mbd all couple/mbd every 2 mesh mesh pad\nthermo_style custom step f_mbd[1] f_rod[1] &\n cpu\nfix p all print "
    "10 \"f_mbd[2]\"\n"
    "dump grains all custom 2 ${out}/grains_*.txt id x y z radius\nrun 1000000\nprint after\n";

TEST_F(ReplayTest, TakesTheCouplingOutAndPutsMoversIn) {
  record_pad();
  const Replay r = replay(kScript);
  EXPECT_EQ(r.script.find("couple/mbd"), std::string::npos) << r.script;
  EXPECT_EQ(r.script.find("gran/beam"), std::string::npos);
  EXPECT_EQ(r.script.find("f_mbd"), std::string::npos);
  EXPECT_NE(r.script.find("fix mesh all mesh/surface/stress file " + (folder_ / "motion/pad.stl").string() + " type 2"),
            std::string::npos);
  EXPECT_NE(r.script.find("fix wall all wall/gran model hertz mesh n_meshes 1 meshes mesh"), std::string::npos);
  EXPECT_NE(
      r.script.find("fix replay1_move all move/mesh mesh mesh linear/variable v_replay1_vx v_replay1_vy v_replay1_vz"),
      std::string::npos);
  EXPECT_NE(r.script.find("rotate/variable origin 1 2 3 axis 0 0 1 omega v_replay1_wz"), std::string::npos);
  EXPECT_NE(r.script.find("thermo_style custom step cpu\n"), std::string::npos);
  EXPECT_NE(r.script.find("dump grains all custom 2 ${out}/grains_*.txt id x y z radius"), std::string::npos);
  EXPECT_NE(r.script.find("run 5 pre no post no every 2 \"next "), std::string::npos);
  EXPECT_EQ(r.bodies, std::vector<std::string>{"pad"});
  ASSERT_EQ(r.notes.size(), 1u);
  EXPECT_NE(r.notes[0].find("fix rod"), std::string::npos);
}

// The script of [particles.box] names its meshes in a loop over a variable.
TEST_F(ReplayTest, WritesLoopsOverMeshesOut) {
  record_pad();
  std::filesystem::copy_file(folder_ / "motion/pad.csv", folder_ / "motion/foot.csv");
  const std::map<std::string, std::string> variables = {{"mesh_bodies", "pad foot"},
                                                        {"mesh_count", "2"},
                                                        {"beam_count", "1"},
                                                        {"meshes", "mesh_pad mesh_foot"},
                                                        {"couples", "mesh mesh_pad pad mesh mesh_foot foot"}};
  const Replay r = stock_replay(FOOTFALL_SOURCE_DIR "/inputs/box/in.grains", (folder_ / "motion").string(),
                                (folder_ / "out").string(), 1e-3, variables);
  EXPECT_EQ(r.bodies, (std::vector<std::string>{"pad", "foot"}));
  for (const char* body : {"pad", "foot"})
    EXPECT_NE(r.script.find("fix mesh_" + std::string(body) + " all mesh/surface/stress file " +
                            (folder_ / "motion" / body).string() + ".stl type 2"),
              std::string::npos)
        << r.script;
  for (const char* gone : {"all couple/mbd", "${body}", "next_body", "gran/beam", "f_mbd"})
    EXPECT_EQ(r.script.find(gone), std::string::npos) << gone << "\n" << r.script;
  EXPECT_NE(r.script.find("fix contact all wall/gran model ${model} mesh n_meshes ${mesh_count} meshes ${meshes}"),
            std::string::npos);
  ASSERT_EQ(r.notes.size(), 1u);
  EXPECT_NE(r.notes[0].find("beams"), std::string::npos);
}

TEST_F(ReplayTest, VelocitiesAreThoseOfTheWindows) {
  record_pad();
  const Replay r = replay(kScript);
  EXPECT_EQ(r.steps, 5);
  EXPECT_EQ(r.every, 2);
  const auto numbers = [&](const std::string& name) {
    std::istringstream text(r.files.at(name));
    std::vector<double> values;
    for (double value; text >> value;) values.push_back(value);
    return values;
  };
  const std::vector<double> vz = numbers("replay1_vz.txt"), wz = numbers("replay1_wz.txt"),
                            vx = numbers("replay1_vx.txt");
  ASSERT_EQ(vz.size(), 4u);  // three spans of two steps, and one line for the last `next`
  EXPECT_NEAR(vz[0], -2.0, 1e-9);
  EXPECT_NEAR(vz[1], -3.0, 1e-9);
  EXPECT_NEAR(wz[0], 5.0, 1e-9);
  EXPECT_NEAR(wz[1], 5.0, 1e-9);
  EXPECT_EQ(vx[0], 0.0);
}

TEST_F(ReplayTest, SaysWhatItCannotReplay) {
  EXPECT_THROW(replay("run 100\n"), InputError);                                 // no coupling
  EXPECT_THROW(replay(kScript), InputError);                                     // the motion was not recorded
  EXPECT_THROW(replay("fix mbd all couple/mbd every 2\nrun 10\n"), InputError);  // no mesh
}

// A look at a run: mbd_solver/app/follow.h

class LastRowTest : public ::testing::Test, protected TemporaryFolder {};
class RunLookTest : public ::testing::Test, protected TemporaryFolder {
 protected:
  const std::string run = folder_.string();
  RunProgress look() const {
    HistoryTail history(run + "/history.csv");
    return progress_of_run(run, history);
  }
};

constexpr const char* kHead =
    "# units: s,N,N,N,N,N,N\ntime,a.contact.fx,a.contact.fy,a.contact.fz,b.contact.fx,b.contact.fy,b.contact.fz\n";

TEST_F(LastRowTest, ARowInWritingDoesNotCount) {
  const auto last_row = [&] {
    HistoryTail tail(file("history.csv"));
    tail.read();
    return tail.last();
  };
  EXPECT_EQ(last_row().rows, 0);
  write("history.csv", kHead);
  EXPECT_EQ(last_row().rows, 0);
  write("history.csv", std::string(kHead) + "0,0,0,0,0,0,0\n0.25,3,0,4,0,0,1\n0.5,1,1");
  const LastRow row = last_row();
  EXPECT_EQ(row.rows, 2);
  EXPECT_EQ(row.values.front(), 0.25);
}

TEST_F(RunLookTest, KnowsAtWhichPointARunIs) {
  EXPECT_THROW(look(), InputError);
  write(".footfall.lock", std::to_string(getpid()) + "\n");
  EXPECT_EQ(look().state, RunProgress::State::kSettingUp);
  write("liggghts.log", "run 200\nStep Atoms KinEng\n50 10 1.5\n");
  EXPECT_EQ(look().preparation, "step 50 of 200 (25 %)");
  write_run_note(run, {"A landing", "/scene.toml", 1.0});
  write("history.csv", std::string(kHead) + "0,0,0,0,0,0,0\n0.25,3,0,4,0,0,1\n");
  const RunProgress seen = look();
  EXPECT_EQ(seen.state, RunProgress::State::kRunning);
  EXPECT_EQ(seen.time, 0.25);
  EXPECT_EQ(seen.end_time, 1.0);
  EXPECT_EQ(seen.contact_force, 5.0);
}

TEST_F(RunLookTest, TellsARunThatEndedFromOneThatWasKilled) {
  write(".footfall.lock", "0\n");
  write("history.csv", std::string(kHead) + "0,0,0,0,0,0,0\n");
  EXPECT_EQ(look().state, RunProgress::State::kGone);
  write("summary.json", R"({"status": "failed", "reason": "a strut broke"})");
  const RunProgress seen = look();
  EXPECT_EQ(seen.state, RunProgress::State::kFailed);
  EXPECT_EQ(seen.reason, "a strut broke");
}

using Json = nlohmann::ordered_json;

Json marks(double dem, long steps_early, long steps_late) {
  return {{"time_s", {0.0, 0.1, 0.2}},
          {"wall_s", {0.0, 1.0, 2.0}},
          {"dem_wall_s", {0.0, dem, 2.0 * dem}},
          {"steps", {0L, steps_early, steps_early + steps_late}},
          {"windows", {0L, 100L, 200L}}};
}

TEST(RunTime, AnEvenPaceGoesOn) {
  const RunTime time = expected_run_time(marks(0.9, 200, 200), 1.0);
  EXPECT_NEAR(time.seconds, 10.0, 1e-12);
  EXPECT_NEAR(time.most, 10.0, 1e-12);
  EXPECT_NEAR(time.least, 2.0 + 8.0 * (0.9 + 0.1 * 0.5), 1e-12);
  EXPECT_NEAR(time.share_of_grains, 0.9, 1e-12);
}

TEST(RunTime, StepsThatGrowAreExpectedToGrowOn) {
  const RunTime time = expected_run_time(marks(0.0, 800, 400), 1.0);  // 4 steps in a window in the end
  EXPECT_NEAR(time.most, 10.0, 1e-12);
  EXPECT_NEAR(time.least, 4.0, 1e-12);
  EXPECT_NEAR(time.seconds, 2.0 + 8.0 * 0.5, 1e-12);
}

TEST(RunTime, StepsGrowToFourTimesAtMost) {
  EXPECT_NEAR(expected_run_time(marks(0.0, 80000, 40000), 1.0).least, 2.0 + 8.0 * 0.25, 1e-12);
}

// In the first half of a trial the grains may stand still yet: the bounds tell how even their pace was.
TEST(RunTime, TheBoundsHoldBothPacesOfTheGrains) {
  Json uneven = marks(0.0, 200, 200);
  uneven["dem_wall_s"] = {0.0, 0.6, 1.5};
  const RunTime time = expected_run_time(uneven, 1.0);
  EXPECT_NEAR(time.seconds, 2.0 + 8.0 * (0.9 + 0.1), 1e-12) << "the later one is expected";
  EXPECT_NEAR(time.least, 2.0 + 8.0 * (0.6 + 0.1 * 0.5), 1e-12);
  EXPECT_NEAR(time.most, 10.0, 1e-12);
  uneven["dem_wall_s"] = {0.0, 1.2, 2.1};
  EXPECT_NEAR(expected_run_time(uneven, 1.0).most, 2.0 + 8.0 * (1.2 + 0.1), 1e-12);
}

TEST(RunTime, NothingIsLeftBehindTheEnd) {
  EXPECT_NEAR(expected_run_time(marks(0.5, 200, 200), 0.1).seconds, 2.0, 1e-12);
}

TEST(RunTime, MarksThatAreMissingAreTold) {
  EXPECT_THROW(expected_run_time(nullptr, 1.0), nlohmann::json::exception);
  EXPECT_THROW(expected_run_time({{"time_s", {0.0, 1.0}}}, 1.0), nlohmann::json::exception);
}

TEST(RunTime, DurationsHaveTwoDigits) {
  EXPECT_EQ(duration_text(0.51), "0.51 s");
  EXPECT_EQ(duration_text(45.4), "45 s");
  EXPECT_EQ(duration_text(150.0), "2.5 min");
  EXPECT_EQ(duration_text(7200.0), "2 h");
  EXPECT_EQ(duration_text(99.7), "1.7 min");
  EXPECT_EQ(duration_text(99.7 * 60.0), "1.7 h");
  EXPECT_EQ(duration_text(99.7 * 3600.0), "100 h");
  EXPECT_EQ(duration_text(1234.0 * 3600.0), "1234 h");
}

class NewCaseTest : public ::testing::Test, protected TemporaryFolder {};

TEST_F(NewCaseTest, EveryCaseIsACompleteSceneOfItsOwn) {
  for (const CaseKind& kind : case_kinds()) {
    const std::string made = file("my_" + kind.name);
    make_case(made, kind.name);
    EXPECT_NO_THROW(checked_scene(made, {})) << kind.name;
    const std::string page = read_whole_file(made + "/README.md").value_or("");
    EXPECT_EQ(std::count(page.begin(), page.end(), '\n'), 3) << page;
    // Nothing in it leads out of it, but for words of comments.
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(made)) {
      if (!entry.is_regular_file() || entry.path().filename() == "README.md") continue;
      const std::string text = read_whole_file(entry.path().string()).value_or("");
      for (std::string line : split(text, '\n')) {
        line.resize(std::min(line.size(), line.find('#')));
        const bool leads_out = line.find("../") != std::string::npos && entry.path().parent_path() == made;
        EXPECT_FALSE(leads_out) << entry.path() << ": " << line;
      }
    }
  }
}

TEST_F(NewCaseTest, TheCommonCasesAreThere) {
  std::vector<std::string> names;
  for (const CaseKind& kind : case_kinds()) names.push_back(kind.name);
  for (const char* name : {"wheel", "arm", "scoop", "lander", "drop", "pendulum", "auger", "gripper", "rover"})
    EXPECT_EQ(std::count(names.begin(), names.end(), name), 1) << name;
}

TEST_F(NewCaseTest, NothingIsWrittenOverAndNothingIsLeftOfACaseThatCannotBe) {
  const std::string made = file("mine");
  EXPECT_TRUE(test::names(test::error_of([&] { make_case(made, "whele"); }), {"\"wheel\""}));
  EXPECT_FALSE(fs::exists(made));
  make_case(made, "wheel");
  EXPECT_TRUE(test::names(test::error_of([&] { make_case(made, "wheel"); }), {made}));
  EXPECT_TRUE(test::names(test::error_of([&] { make_case(file("my wheel"), "wheel"); }), {"my wheel"}));
  EXPECT_FALSE(fs::exists(file("my wheel")));
}

}  // namespace
}  // namespace footfall
