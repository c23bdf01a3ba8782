// What a run writes.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <limits>

#include "coupler/base/errors.h"
#include "mbd_solver/session/codes.h"
#include "mbd_solver/session/output/checkpoint_folder.h"
#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/summary.h"
#include "tests/support/refused.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

// history.csv and summary.json.

constexpr double kTenDigits = 1e-9;  // relative: what a number of ten digits keeps

class OutputTest : public ::testing::Test, protected TemporaryFolder {};

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

TEST_F(OutputTest, HistoryThatIsResumedEndsAtItsPosition) {
  const std::vector<std::string> names = {"time", "v"}, units = {"s", "-"};
  long position = 0;
  {
    HistoryWriter writer(file("h.csv"), names, units);
    writer.write({0.0, 1.0});
    position = writer.position();
    writer.write({1.0, 2.0});
  }
  HistoryWriter resumed(file("h.csv"), names, units, Beginning::kResume);
  resumed.resume_at(position);
  resumed.write({1.0, 3.0});
  EXPECT_EQ(text("h.csv"), "# units: s,-\ntime,v\n0,1\n1,3\n");
  EXPECT_TRUE(test::names(input_error([&] { resumed.resume_at(1000); }), {code::kHistoryChanged.number, "h.csv"}));
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

// A run that is killed leaves a row without its end, be it short or cut within a number.
TEST_F(OutputTest, HistoryOfAKilledRunEndsWithItsLastWholeRow) {
  for (const char* cut : {"1", "1,0.", "1,2.5"}) {
    std::ofstream(file("h.csv")) << "# units: s,m\ntime,z\n0,1\n0.5,1.5\n" << cut;
    EXPECT_EQ(read_history(file("h.csv")).column("z"), (std::vector<double>{1.0, 1.5})) << cut;
  }
  // Of a run that has ended every row counts.
  write_summary(file("summary.json"), {{"status", "done"}});
  EXPECT_EQ(read_history(file("h.csv")).column("z"), (std::vector<double>{1.0, 1.5, 2.5}));
}

TEST_F(OutputTest, SummaryIsWholeOrAbsent) {
  write_summary(file("s.json"), {{"status", "done"}, {"peak_acceleration_g", 1.25}});
  EXPECT_EQ(read_summary(file("s.json"))["peak_acceleration_g"], 1.25);
  EXPECT_FALSE(std::filesystem::exists(file("s.json.part")));
  const nlohmann::ordered_json bad = {{"a", {{"b", std::nan("")}}}};
  EXPECT_THROW(write_summary(file("t.json"), bad), NumericalError);
  EXPECT_FALSE(std::filesystem::exists(file("t.json")));
}

// A note of a run that was cut off, lacks an entry or has one of another kind: said in our words, with the place.
TEST_F(OutputTest, DamagedNotesAreToldInPlainWords) {
  const std::pair<const char*, const char*> damaged[] = {
      {"{\"title\": \"x\",\n \"scene_fi", "line 2"},
      {"{\"title\": \"x\", \"end_time_s\": 1}", "\"scene_file\" is missing"},
      {"{\"title\": \"x\", \"scene_file\": \"y\", \"end_time_s\": \"z\"}", "type"},
      {"", "line 1"}};
  for (const auto& [text, said] : damaged) {
    std::ofstream(file("run.json")) << text;
    try {
      read_run_note(folder_.string());
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      const std::string what = error.what();
      EXPECT_NE(what.find(said), std::string::npos) << what;
      for (const char* word : {"json.exception", "parse error", "parse_error", "[json", "while parsing"})
        EXPECT_EQ(what.find(word), std::string::npos) << what;
    }
  }
}

TEST_F(OutputTest, SummaryThatCannotBeWrittenIsNamed) {
  EXPECT_TRUE(test::names(input_error([] {
                            write_summary("/nowhere/s.json", {{"status", "done"}});
                          }),
                          {"/nowhere/s.json"}));
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
  remove_unfinished_checkpoints(run_);
  EXPECT_FALSE(fs::exists(run_ + "/checkpoint")) << "there was nothing else in it";
  keep(1);
  fs::create_directories(run_ + "/checkpoint/3.part");
  remove_unfinished_checkpoints(run_);
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
  folder.cancel();
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
