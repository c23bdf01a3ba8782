// Figures of a sweep: peaks that stand out of a curve; what its file must hold.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/cli/experiments/sweep.h"
#include "mbd_solver/cli/experiments/sweep_figure.h"

namespace footfall {
namespace {

std::vector<double> humps(std::initializer_list<double> heights, double ripple) {
  std::vector<double> x;
  for (const double height : heights)
    for (int i = 0; i < 100; ++i) x.push_back(height * std::sin(kPi * i / 100.0) + ripple * (i % 2));
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
  const std::filesystem::path folder = std::filesystem::temp_directory_path() / "footfall_sweep_figure_run";
  std::filesystem::create_directories(folder);
  std::ofstream(folder / "summary.json") << "{\"weight\": 2.0}";
  std::ofstream(folder / "history.csv") << "# units: s,N,N\ntime,a,b\n0,1,5\n1,3,-1\n2,2,4\n";
  const std::vector<std::string> both = {"a", "b"};
  std::vector<SweepFigure> figures(7);
  for (SweepFigure& figure : figures) figure.columns = both;
  figures[1].average = true;
  figures[2].reduction = Reduction::kMin;
  figures[3].reduction = Reduction::kMin;
  figures[3].average = true;
  figures[4].reduction = Reduction::kFinal;
  figures[5].average = true;
  figures[5].over = "weight";
  figures[6].reduction = Reduction::kDrop;
  EXPECT_THAT(figures_of_run(figures, folder.string(), "sweep.toml"),
              ::testing::ElementsAre(5.0, 4.0, -1.0, 0.0, 4.0, 2.0, 6.0));
  std::filesystem::remove_all(folder);
}

// What read_sweep says of a file that ends in `tail`.
std::string complaint(const std::string& tail) {
  const std::string path = (std::filesystem::temp_directory_path() / "footfall_sweep_figure_test.toml").string();
  std::ofstream(path)
      << "scene = \"scene.toml\"\n[[parameters]]\nname = \"speed\"\nvalues = [1, 2]\nsettings = [\"x={value}\"]\n"
         "[[figures]]\nname = \"peak\"\nkey = \"peak_acceleration_g\"\n"
      << tail;
  std::string what;
  try {
    read_sweep(path);
  } catch (const InputError& error) {
    what = error.what();
  }
  std::filesystem::remove(path);
  return what;
}

TEST(ReadSweep, SaysWhatIsWrongWithStatementsAndPrintedFigures) {
  using ::testing::HasSubstr;
  const std::string statement = "[[statements]]\ntext = \"t\"\nfigure = \"peak\"\n";
  EXPECT_EQ(complaint(statement + "case = \"speed 1\"\nmost = 3\n"), "");
  EXPECT_THAT(complaint(statement + "case = \"speed 1\"\n"), HasSubstr("expected least, most or both"));
  EXPECT_THAT(complaint(statement + "case = \"speed 7\"\nmost = 3\n"), HasSubstr("no case \"speed 7\""));
  EXPECT_THAT(complaint("[[statements]]\ntext = \"t\"\nfigure = \"force\"\ncase = \"speed 1\"\nmost = 3\n"),
              HasSubstr("\"force\" is not one of [[figures]]"));
  EXPECT_THAT(complaint("[[printed]]\nname = \"p\"\nvalues = [1, 2]\n"),
              HasSubstr("more values than there are [[figures]]"));
  EXPECT_THAT(complaint("[[printed]]\nname = \"p\"\nvalues = [\"much\"]\n"), HasSubstr("\"much\" is not a number"));
  EXPECT_THAT(complaint("[[figures]]\nname = \"f\"\ncolumns = [\"x\"]\nreduce = \"mean\"\n"),
              HasSubstr("expected max, min, final, largest, drop, peaks or variation"));
  EXPECT_THAT(complaint("[[figures]]\nname = \"f\"\nkey = \"x\"\naverage = true\n"),
              HasSubstr("expected at least two columns"));
}

}  // namespace
}  // namespace footfall
