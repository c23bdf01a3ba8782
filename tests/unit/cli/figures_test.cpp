// Figures of a run: peaks that stand out of a curve, reductions of columns.
#include "mbd_solver/cli/experiments/figures.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

namespace footfall {
namespace {

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

TEST(FiguresOfRun, ReduceEveryColumnAndTakeTheExtremeOrTheMean) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("footfall_figures_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json") << "{\"weight\": 2.0}";
  std::ofstream(folder / "history.csv") << "# units: s,N,N\ntime,a,b\n0,1,5\n1,3,-1\n2,2,4\n";
  const std::vector<std::string> both = {"a", "b"};
  std::vector<FigureSpec> figures(7);
  for (FigureSpec& figure : figures) figure.columns = both;
  figures[1].average = true;
  figures[2].reduction = Reduction::kMin;
  figures[3].reduction = Reduction::kMin;
  figures[3].average = true;
  figures[4].reduction = Reduction::kFinal;
  figures[5].average = true;
  figures[5].over = "weight";
  figures[6].reduction = Reduction::kDrop;
  EXPECT_THAT(figures_of_run(figures, folder.string(), "file.toml"),
              ::testing::ElementsAre(5.0, 4.0, -1.0, 0.0, 4.0, 2.0, 6.0));
  std::filesystem::remove_all(folder);
}

// The last four of ten rows: (1 + 3 + 2 + 6) / 4.
TEST(FiguresOfRun, SteadyIsTheMeanOfTheLastRows) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("footfall_steady_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json") << "{}";
  std::ofstream(folder / "history.csv")
      << "# units: s,N\ntime,a\n0,99\n1,99\n2,99\n3,99\n4,99\n5,99\n6,1\n7,3\n8,2\n9,6\n";
  FigureSpec figure;
  figure.columns = {"a"};
  figure.reduction = Reduction::kSteady;
  EXPECT_THAT(figures_of_run({figure}, folder.string(), "file.toml"), ::testing::ElementsAre(3.0));
  std::filesystem::remove_all(folder);
}

TEST(FiguresOfRun, AreReducedColumnsOverAKeyOfTheSummary) {
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("footfall_figures_" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json") << "{\"reference_energy_J\": 50.0}\n";
  std::ofstream(folder / "history.csv") << "# units: s,J\ntime,work.contact\n0,0\n0.1,-20\n0.2,-10\n";
  FigureSpec figure;
  figure.columns = {"work.contact"};
  figure.reduction = Reduction::kLargest;
  figure.over = "reference_energy_J";
  EXPECT_THAT(figures_of_run({figure}, folder.string(), "file.toml"), ::testing::ElementsAre(0.4));
  std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace footfall
