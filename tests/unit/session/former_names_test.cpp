#include "mbd_solver/session/output/former_names.h"

#include <gtest/gtest.h>

#include <fstream>

#include "mbd_solver/session/output/history.h"
#include "mbd_solver/session/output/summary.h"
#include "tests/support/temporary_folder.h"

namespace footfall {
namespace {

TEST(FormerNames, OfFilesAndQuestionsMeanThePresentOnes) {
  const TemporaryFolder folder;
  std::ofstream(folder.file("history.csv")) << "# units: s,J\ntime,coupling.energy_residual\n0,0\n1,-2\n";
  std::ofstream(folder.file("summary.json"))
      << R"({"status": "done", "max_penetration_m": 0.2, "max_sinkage_time_s": 1})";
  const History history = read_history(folder.file("history.csv"));
  EXPECT_EQ(history.names[1], "coupling.energy_error");
  EXPECT_EQ(history.column("coupling.energy_residual")[1], -2.0);
  EXPECT_EQ(history.column("coupling.energy_error")[1], -2.0);
  EXPECT_EQ(read_summary(folder.file("summary.json")).at("max_sinkage_m"), 0.2);
  EXPECT_EQ(present_name("cabin.az"), "cabin.az");
}

}  // namespace
}  // namespace footfall
