// mbd_solver/cli/grains/bed_slope.h: beds whose surface is a known line, and the figure of an experiment that is read from dumps.
#include "mbd_solver/cli/grains/bed_slope.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "mbd_solver/cli/experiments/figures.h"

namespace footfall {
namespace {

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
  const fs::path folder = fs::temp_directory_path() / ("footfall_slope_" + std::to_string(::getpid()));
  fs::create_directories(folder);
  std::ofstream(folder / "summary.json") << "{}";
  FigureSpec figure;
  figure.slope = {-0.9, -0.1};
  EXPECT_THROW(figures_of_run({figure}, folder.string(), "file.toml"), InputError) << "no dumps";
  for (const int step : {0, 100}) {  // level first, then one in two
    const BedFrame bed = bed_under([&](double x) { return step > 0 ? -0.5 * x - 0.05 : 0.0; });
    std::ofstream dump(folder / ("grains_" + std::to_string(step) + ".txt"));
    dump << "ITEM: TIMESTEP\n"
         << step << "\nITEM: NUMBER OF ATOMS\n"
         << bed.count() << "\nITEM: ATOMS id x y z radius\n";
    for (int i = 0; i < bed.count(); ++i)
      dump << bed.id[static_cast<std::size_t>(i)] << ' ' << bed.x(0, i) << " 0 " << bed.x(2, i) << ' ' << kGrain
           << '\n';
  }
  EXPECT_NEAR(figures_of_run({figure}, folder.string(), "file.toml")[0], std::atan(0.5) * 180.0 / kPi, kDegree);
  fs::remove_all(folder);
}

}  // namespace
}  // namespace footfall
