// What a run writes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/run/output/checkpoint_folder.h"
#include "mbd_solver/run/output/history.h"
#include "mbd_solver/run/output/summary.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// mbd_solver/output/history.h, summary.h and cli/analysis/plots.h:
// history.csv, summary.json and the scripts of the pictures.

constexpr double kTenDigits = 1e-9;  // relative: what a number of ten digits keeps

class OutputTest : public ::testing::Test, protected TemporaryFolder {
 protected:
};

template <class Action>
std::string input_error(const Action& action) {
  return test::refusal([&] { action(); });
}

TEST_F(OutputTest, HistoryStartsWithUnitsThenNames) {
  HistoryWriter(file("h.csv"), {"time", "cabin.z"}, {"s", "m"}).write({0.0, 1.5});
  EXPECT_EQ(text("h.csv"), "# units: s,m\ntime,cabin.z\n0,1.5\n");
}

TEST_F(OutputTest, HistoryReadsBackWhatWasWritten) {
  const std::vector<double> values = {1.0 / 3.0, -1e-300, 6.02214076e23, 0.0};
  {
    HistoryWriter writer(file("h.csv"), {"time", "v"}, {"s", "-"});
    for (std::size_t i = 0; i < values.size(); ++i) writer.write({static_cast<double>(i), values[i]});
  }
  const History history = read_history(file("h.csv"));
  ASSERT_EQ(history.column("v").size(), values.size());
  for (std::size_t i = 0; i < values.size(); ++i)
    EXPECT_NEAR(history.column("v")[i], values[i], kTenDigits * std::abs(values[i]));
}

TEST_F(OutputTest, HistoryNeverHoldsANumberThatIsNotFinite) {
  HistoryWriter writer(file("h.csv"), {"time", "cabin.z"}, {"s", "m"});
  writer.write({0.0, 1.0});
  for (double bad : {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity()}) {
    EXPECT_TRUE(test::names(test::error_of<NumericalError>([&] { writer.write({0.25, bad}); }), {"cabin.z", "0.25"}));
  }
  writer.flush();
  EXPECT_EQ(text("h.csv"), "# units: s,m\ntime,cabin.z\n0,1\n");
}

TEST_F(OutputTest, HistoryOfAnUnknownColumnNamesTheKnownOnes) {
  HistoryWriter(file("h.csv"), {"time", "cabin.z"}, {"s", "m"}).write({0.0, 1.0});
  EXPECT_NE(input_error([&] { read_history(file("h.csv")).column("cabin.w"); }).find("it has time,cabin.z"),
            std::string::npos);
}

TEST_F(OutputTest, BrokenHistoryIsNamedWithItsLine) {
  std::ofstream(file("h.csv")) << "# units: s,m\ntime,z\n0,1\n1\n";
  EXPECT_TRUE(test::names(input_error([&] { read_history(file("h.csv")); }), {"h.csv:4:"}));
}

TEST_F(OutputTest, SummaryIsWholeOrAbsent) {
  write_summary(file("s.json"), {{"status", "done"}, {"peak_acceleration_g", 1.25}});
  EXPECT_EQ(read_summary(file("s.json"))["peak_acceleration_g"], 1.25);
  EXPECT_FALSE(std::filesystem::exists(file("s.json.part")));
  const nlohmann::ordered_json bad = {{"a", {{"b", std::nan("")}}}};
  EXPECT_THROW(write_summary(file("t.json"), bad), NumericalError);
  EXPECT_FALSE(std::filesystem::exists(file("t.json")));
}

TEST_F(OutputTest, SummaryThatCannotBeWrittenIsNamed) {
  EXPECT_TRUE(test::names(input_error([] {
                            write_summary("/nowhere/s.json", {{"status", "done"}});
                          }),
                          {"/nowhere/s.json"}));
}

History lander_history() {
  History h;
  h.names = {"time",           "cabin.z",        "cabin.vz",   "cabin.az",       "pad.contact.fx",
             "pad.contact.fy", "pad.contact.fz", "leg.stroke", "energy.kinetic", "energy.strain"};
  h.units.assign(h.names.size(), "-");
  for (std::size_t i = 0; i < h.names.size(); ++i) h.columns.push_back({i == 9 ? 0.0 : 1.0, i == 9 ? 0.0 : 2.0});
  return h;
}

TEST(Figures, ShowWhatTheHistoryHoldsAndLeaveOutTheRest) {
  std::vector<std::string> names;
  for (const Figure& figure : standard_figures(lander_history(), "")) {
    names.push_back(figure.name);
    if (figure.name == "energy") {
      EXPECT_EQ(figure.curves.size(), 1u) << "the strain energy is always zero";
    }
    if (figure.name == "descent") {
      EXPECT_EQ(figure.curves[0].formula.values(lander_history()), (std::vector<double>{0.0, -1.0}));  // z is 1, then 2
    }
  }
  EXPECT_EQ(names,
            (std::vector<std::string>{"acceleration", "velocity", "descent", "energy", "strokes", "contact_forces"}));
}

TEST(Figures, HaveNoMoreSeriesThanColours) {
  History h = lander_history();
  for (const std::string strut : {"primary", "left", "right"})
    for (int leg = 1; leg <= 4; ++leg) h.names.push_back("leg_" + std::to_string(leg) + "_" + strut + ".force");
  h.units.assign(h.names.size(), "N");
  h.columns.resize(h.names.size(), {1.0, 2.0});
  std::vector<std::string> titles;
  for (const Figure& figure : standard_figures(h, "")) {
    EXPECT_LE(figure.curves.size(), static_cast<std::size_t>(kSeriesColours)) << figure.name;
    if (figure.name.rfind("strut_forces", 0) == 0) titles.push_back(figure.name + " " + figure.title.substr(34));
  }
  EXPECT_EQ(titles, (std::vector<std::string>{"strut_forces : leg_*_primary", "strut_forces_2 : leg_*_left",
                                              "strut_forces_3 : leg_*_right"}));
}

TEST_F(OutputTest, ScriptsDrawWithGnuplotAsPngAndSvg) {
  const History history = lander_history();
  HistoryWriter writer(file("history.csv"), history.names, history.units);
  for (std::size_t row : {0u, 1u}) {
    std::vector<double> values;
    for (const auto& column : history.columns) values.push_back(column[row]);
    writer.write(values);
  }
  writer.flush();
  const std::vector<std::string> scripts =
      write_plot_scripts(file("plots"), standard_figures(history, "cabin"), "A \"lander\"");
  std::string command = "cd '" + file("plots") + "' && gnuplot";
  for (const std::string& script : scripts) command += " " + script;
  ASSERT_EQ(std::system((command + " 2>gnuplot.log").c_str()), 0) << text("plots/gnuplot.log");
  for (std::string script : scripts) {
    for (const char* ending : {".png", ".svg"}) {
      const auto picture = folder_ / "plots" / std::filesystem::path(script).replace_extension(ending);
      EXPECT_GT(std::filesystem::file_size(picture), 1000u) << picture;
    }
  }
}

namespace fs = std::filesystem;

class CheckpointFolderTest : public testing::Test, TemporaryFolder {
 protected:
  void keep(long n) {
    CheckpointFolder folder(run_);
    std::ofstream(folder.begin(n) + "/run.txt") << "memory " << n;
    folder.finish();
  }
  bool there(const std::string& name) const { return fs::exists(fs::path(run_) / "checkpoint" / name); }

  const std::string run_ = folder_.string();
};

TEST_F(CheckpointFolderTest, TheLastTwoSetsAreKept) {
  for (const long n : {9, 10, 11}) keep(n);
  EXPECT_FALSE(there("9"));
  EXPECT_TRUE(there("10") && there("11"));
  EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "11");
}

TEST_F(CheckpointFolderTest, ASetThatIsNotFinishedDoesNotCount) {
  keep(1);
  {
    CheckpointFolder folder(run_);
    std::ofstream(folder.begin(2) + "/run.txt") << "half of it";
    EXPECT_TRUE(there("2.part"));
    EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "1");
  }
  EXPECT_FALSE(there("2.part")) << "it went with who wrote it";
}

TEST_F(CheckpointFolderTest, WhatProgramsThatWereKilledHaveLeftIsRemoved) {
  fs::create_directories(run_ + "/checkpoint/3.part");
  std::ofstream(run_ + "/checkpoint/3.part/run.txt") << "half of it";
  remove_unfinished_sets(run_);
  EXPECT_FALSE(fs::exists(run_ + "/checkpoint")) << "there was nothing else in it";
  keep(1);
  fs::create_directories(run_ + "/checkpoint/3.part");
  remove_unfinished_sets(run_);
  EXPECT_TRUE(there("1"));
  EXPECT_FALSE(there("3.part"));
}

TEST_F(CheckpointFolderTest, ADamagedSetIsPassedOver) {
  keep(1);
  keep(2);
  std::ofstream(run_ + "/checkpoint/2/run.txt", std::ios::app) << "x";
  EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "1");
  fs::remove(run_ + "/checkpoint/1/run.txt");
  EXPECT_TRUE(test::names(test::error_of<InputError>([&] { newest_checkpoint(run_); }), {"run.txt"}));
}

TEST_F(CheckpointFolderTest, WhatIsDroppedOrClearedIsGoneAndOlderSetsStay) {
  keep(1);
  CheckpointFolder folder(run_);
  folder.begin(2);
  folder.drop();
  EXPECT_FALSE(there("2.part"));
  folder.begin(3);
  folder.finish();
  EXPECT_TRUE(there("1") && there("3"));
  folder.clear();
  EXPECT_FALSE(there("3"));
  EXPECT_EQ(fs::path(newest_checkpoint(run_)).filename(), "1");
}

TEST_F(CheckpointFolderTest, NoneIsAnError) { EXPECT_THROW(newest_checkpoint(run_), InputError); }

}  // namespace
}  // namespace footfall
