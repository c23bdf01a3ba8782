// The same slope by tilted gravity and by [ground.terrain], on grains.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>
#include <vector>

#include "mbd_solver/base/pi.h"
#include "mbd_solver/session/output/history.h"
#include "tests/app/programs.h"

namespace footfall {
namespace {

constexpr double kSlope = 8.0 * kPi / 180.0;  // falls along x

std::string vector_text(double x, double y, double z) {
  std::ostringstream out;
  out.precision(12);
  out << "[" << x << ", " << y << ", " << z << "]";
  return out.str();
}

// A pad parallel to the ground meets it along its normal with 1 m/s, does not turn, and is free otherwise. Below its place the bed
// is 0.13 m deep.
std::string pad_on_slope(bool terrain) {
  const double s = std::sin(kSlope), c = std::cos(kSlope), g = 9.81;
  const auto normal = [&](double length) {
    return terrain ? vector_text(length * s, 0.0, length * c) : vector_text(0.0, 0.0, length);
  };
  const std::string along = terrain ? vector_text(c, 0.0, -s) : vector_text(1.0, 0.0, 0.0);
  const std::string depth = std::to_string(0.13 - (terrain ? 0.2 * std::tan(kSlope) : 0.0));
  return "end_time = 0.12\ngravity = " + (terrain ? vector_text(0, 0, -g) : vector_text(g * s, 0, -g * c)) +
         "\noutput = { plots = false, interval = 0.0005 }\n"
         "bodies = [{ name = \"pad\", mass = 1, shape = { kind = \"disc\", centre = " +
         normal(0.06) + ", axis = " + normal(1.0) + ", radius = 0.05, thickness = 0.01 } }]\n" +
         "boundaries = [{ body = \"pad\", surface = { closed = true, element_size = 0.02 } }]\n"
         "initial = { clearance = 0.002, velocity = " +
         normal(-1.0) + " }\n[ground]\nkind = \"particles\"\n" +
         (terrain ? "[ground.terrain]\nslope_deg = 8\nazimuth_deg = 0\n" : "") +
         "[particles]\nranks = 1\n[particles.box]\nsize = [0.4, 0.3]\ndepth = " + depth +
         "\nradius = 0.01\n[[joints]]\nname = \"upright\"\nkind = \"prescribed\"\nbodies = [\"ground\", "
         "\"pad\"]\npoint = " +
         normal(0.06) + "\naxis = " + normal(1.0) + "\naxis2 = " + along +
         "\nmotion = { rotation = { polynomial = [0] }, hold_other_rotations = true }\n";
}

struct Spread {
  double mean = 0.0, error = 0.0;  // error: of the mean
};
Spread spread_of(const std::vector<double>& values) {
  const auto n = static_cast<double>(values.size());
  double mean = 0.0, square = 0.0;
  for (const double value : values) mean += value / n;
  for (const double value : values) square += (value - mean) * (value - mean) / (n - 1.0);
  return {mean, std::sqrt(square / n)};
}

// Of five samples of the bed each: depth along the normal, and the largest and the mean force along it. Means differ by less than
// four of their standard errors; the mean force, which is mostly the momentum of the pad, also by less than 3 %.
TEST(Slopes, OfGravityAndOfTerrainCarryAPadAlike) {
  const app::Folder folder("slopes");
  std::vector<Spread> depths, peaks, means;
  for (const bool terrain : {false, true}) {
    folder.write("scene.toml", pad_on_slope(terrain));
    const double s = terrain ? std::sin(kSlope) : 0.0, c = terrain ? std::cos(kSlope) : 1.0;
    std::vector<double> depth, peak, mean;
    for (int seed = 1; seed <= 5; ++seed) {
      folder.done("run scene.toml --out run --force --quiet --set particles.box.seed=" + std::to_string(seed), 900);
      const History history = read_history(folder.file("run/history.csv"));
      const std::vector<double>&x = history.column("pad.x"), &z = history.column("pad.z"),
            &fx = history.column("pad.contact.fx"), &fz = history.column("pad.contact.fz");
      double lowest = 1.0, largest = 0.0, sum = 0.0;
      for (std::size_t i = 0; i < x.size(); ++i) {
        lowest = std::min(lowest, s * x[i] + c * z[i]);
        largest = std::max(largest, s * fx[i] + c * fz[i]);
        sum += s * fx[i] + c * fz[i];
      }
      depth.push_back(0.005 - lowest);  // of its lower face below the surface
      peak.push_back(largest);
      mean.push_back(sum / static_cast<double>(x.size()));
      // Grains at rest stay: at the start they move slower than 2 mm/s, the root of the mean square over 20 kg.
      std::istringstream rows(folder.read("run/grains_energy.txt"));
      std::string line;
      while (std::getline(rows, line) && line[0] == '#') {
      }
      double step = 0.0, time = 0.0, kinetic = 1.0;
      std::istringstream(line) >> step >> time >> kinetic;
      EXPECT_LT(kinetic, 0.5 * 20.0 * 4e-6);
    }
    depths.push_back(spread_of(depth));
    peaks.push_back(spread_of(peak));
    means.push_back(spread_of(mean));
  }
  const auto expect_alike = [](const std::vector<Spread>& two, const char* what, double more) {
    EXPECT_NEAR(two[0].mean, two[1].mean, 4.0 * std::hypot(two[0].error, two[1].error) + more) << what;
  };
  expect_alike(depths, "depth", 0.0);
  expect_alike(peaks, "largest force", 0.0);
  expect_alike(means, "mean force", 0.03 * means[0].mean);
}

}  // namespace
}  // namespace footfall
