// A look at a run: mbd_solver/cli/analysis/watch.h
#include "mbd_solver/cli/analysis/watch.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include "coupler/base/errors.h"
#include "mbd_solver/output/run_note.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

class LastRowTest : public ::testing::Test, protected TemporaryFolder {};
class RunLookTest : public ::testing::Test, protected TemporaryFolder {
 protected:
  const std::string run = folder_.string();
};

constexpr const char* kHead =
    "# units: s,N,N,N,N,N,N\ntime,a.contact.fx,a.contact.fy,a.contact.fz,b.contact.fx,b.contact.fy,b.contact.fz\n";

TEST_F(LastRowTest, ARowInWritingDoesNotCount) {
  const std::string history = file("history.csv");
  EXPECT_EQ(last_row(history).rows, 0);
  write("history.csv", kHead);
  EXPECT_EQ(last_row(history).rows, 0);
  write("history.csv", std::string(kHead) + "0,0,0,0,0,0,0\n0.25,3,0,4,0,0,1\n0.5,1,1");
  const LastRow row = last_row(history);
  EXPECT_EQ(row.rows, 2);
  EXPECT_EQ(row.values.front(), 0.25);
}

TEST_F(RunLookTest, KnowsAtWhichPointARunIs) {
  EXPECT_THROW(look_at_run(run), InputError);
  write(".footfall.lock", std::to_string(getpid()) + "\n");
  EXPECT_EQ(look_at_run(run).state, RunLook::State::kSettingUp);
  write("liggghts.log", "run 200\nStep Atoms KinEng\n50 10 1.5\n");
  EXPECT_EQ(look_at_run(run).preparation, "step 50 of 200 (25 %)");
  write_run_note(run, {"A landing", "/scene.toml", 1.0});
  write("history.csv", std::string(kHead) + "0,0,0,0,0,0,0\n0.25,3,0,4,0,0,1\n");
  const RunLook look = look_at_run(run);
  EXPECT_EQ(look.state, RunLook::State::kRunning);
  EXPECT_EQ(look.title, "A landing");
  EXPECT_EQ(look.time, 0.25);
  EXPECT_EQ(look.end_time, 1.0);
  EXPECT_EQ(look.contact_force, 5.0);
}

TEST_F(RunLookTest, TellsARunThatEndedFromOneThatWasKilled) {
  write(".footfall.lock", "0\n");
  write("history.csv", std::string(kHead) + "0,0,0,0,0,0,0\n");
  EXPECT_EQ(look_at_run(run).state, RunLook::State::kGone);
  write("summary.json", R"({"status": "failed", "reason": "a strut broke"})");
  const RunLook look = look_at_run(run);
  EXPECT_EQ(look.state, RunLook::State::kFailed);
  EXPECT_EQ(look.reason, "a strut broke");
}

}  // namespace
}  // namespace footfall
