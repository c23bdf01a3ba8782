// The dumps with their times, for ParaView.
#include "mbd_solver/cli/analysis/grain_series.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

#include "mbd_solver/output/history.h"
#include "mbd_solver/output/summary.h"
#include "mbd_solver/output/vtk_writer.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

std::string run_folder() {
  const std::string folder =
      (fs::temp_directory_path() / ("footfall_grain_series_" + std::to_string(::getpid()))).string();
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

void dump(const std::string& folder, int step) {
  std::ofstream(folder + "/grains_" + std::to_string(step) + ".vtk")
      << "# vtk DataFile Version 5.1\nx\nASCII\nDATASET POLYDATA\nPOINTS 1 float\n1 2 3\n\nPOINT_DATA 1\nFIELD "
         "FieldData 2\nid 1 1 int\n7\nradius 1 1 double\n0.1\n";
}

// Dumps every 10 ms; the bodies were drawn at the first window end behind each 10 ms, 0.2 ms later, but for the last.
TEST(GrainSeries, StepsTogetherWithTheDrawingsOfTheBodies) {
  const std::string folder = run_folder();
  for (const int step : {0, 100, 200, 300}) dump(folder, step);
  write_summary(folder + "/summary.json", {{"dt_dem_s", 1e-4}, {"substeps_per_window", 3}});
  VtkFrame frame;
  frame.points = Eigen::Matrix3Xd::Zero(3, 1);
  VtkSeries bodies(folder, "bodies");
  for (const double t : {0.0, 0.0102, 0.0201}) bodies.write(t, frame);
  write_grain_series(folder);
  const auto series = read_vtk_series(folder + "/grains.pvd");
  ASSERT_EQ(series.size(), 4u);
  const double expected[] = {0.0, 0.0102, 0.0201, 0.03};
  for (std::size_t k = 0; k < 4; ++k) {
    EXPECT_NEAR(series[k].first, expected[k], 1e-12);
    EXPECT_EQ(series[k].second, "grains_" + std::to_string(100 * k) + ".vtp");
    EXPECT_TRUE(fs::exists(folder + "/" + series[k].second));
  }
  fs::remove_all(folder);
}

// The run chose windows of 4 substeps, then of 2: the drawings come 0.3 ms and 0.1 ms behind the dumps; the last one comes 0.3 ms behind,
// which is no window of 2.
TEST(GrainSeries, StepsTogetherWithTheDrawingsWhereTheRunChoseItsWindows) {
  const std::string folder = run_folder();
  for (const int step : {0, 100, 200, 300}) dump(folder, step);
  write_summary(folder + "/summary.json", {{"dt_dem_s", 1e-4}, {"substeps_per_window", "auto"}});
  write_history(folder + "/history.csv",
                {{"time", "coupling.substeps"}, {"s", "-"}, {{0.0, 0.0103, 0.0201, 0.0303}, {0.0, 4.0, 2.0, 2.0}}});
  VtkFrame frame;
  frame.points = Eigen::Matrix3Xd::Zero(3, 1);
  VtkSeries bodies(folder, "bodies");
  for (const double t : {0.0, 0.0103, 0.0201, 0.0303}) bodies.write(t, frame);
  write_grain_series(folder);
  const auto series = read_vtk_series(folder + "/grains.pvd");
  ASSERT_EQ(series.size(), 4u);
  const double expected[] = {0.0, 0.0103, 0.0201, 0.03};
  for (std::size_t k = 0; k < 4; ++k) EXPECT_NEAR(series[k].first, expected[k], 1e-12);
  fs::remove_all(folder);
}

TEST(GrainSeries, ARunWithoutGrainsGetsNone) {
  const std::string folder = run_folder();
  write_summary(folder + "/summary.json", {{"status", "done"}});
  write_grain_series(folder);
  EXPECT_FALSE(fs::exists(folder + "/grains.pvd"));
  fs::remove_all(folder);
}

}  // namespace
}  // namespace footfall
