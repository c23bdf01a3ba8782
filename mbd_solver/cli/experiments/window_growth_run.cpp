#include "mbd_solver/cli/experiments/window_growth_run.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "coupler/schemes/registry.h"
#include "mbd_solver/cli/experiments/text.h"
#include "mbd_solver/cli/experiments/window_growth.h"
#include "mbd_solver/output/history.h"

namespace footfall {
namespace {

constexpr double kNoRate = std::numeric_limits<double>::quiet_NaN();
const double kOmega = std::sqrt(50.0 * 1e4 / 20.0);  // of the pad of linear.toml on 50 contacts of kn [1/s]
constexpr double kClosed = 5e-4;                     // the contacts stay closed within this [m]
constexpr double kFast = 3.0;                        // growth from which one pair of windows tells it
constexpr double kSettled = 0.1;                     // and by which two such ratios agree when one mode is left
constexpr double kDecayed = 1e-7;                    // of the first velocity: below, tolerances would be measured
constexpr int kWindows = 200;

constexpr int kDigits = 10;

bool grows(const std::string& scheme, double omega_h, int n) { return predicted_growth(scheme, omega_h, n) > 1.2; }

// First velocity [m/s].
double push(const std::string& scheme, double omega_h, int n) { return grows(scheme, omega_h, n) ? 1e-11 : 1e-2; }

std::string run_name(const std::string& scheme, double omega_h) { return scheme + "_" + number_text(omega_h); }

}  // namespace

double growth_of_series(const std::vector<double>& v) {
  if (v.size() < 4) return kNoRate;
  const double last = std::abs(v.back() / v[v.size() - 2]), before = std::abs(v[v.size() - 2] / v[v.size() - 3]);
  if (last > kFast && std::abs(last / before - 1.0) < kSettled) return last;
  const std::size_t from = v.size() / 2, count = v.size() - from;
  if (count < 4) return kNoRate;
  Eigen::MatrixX2d past(count - 2, 2);
  Eigen::VectorXd next(count - 2);
  for (std::size_t k = 0; k + 2 < count; ++k) {
    const double scale =
        1.0 / (std::abs(v[from + k]) + std::abs(v[from + k + 1]));  // every window counts alike while the motion decays
    const auto row = static_cast<Eigen::Index>(k);
    past.row(row) << scale * v[from + k + 1], scale * v[from + k];
    next[row] = scale * v[from + k + 2];
  }
  const Eigen::Vector2d ab = past.colPivHouseholderQr().solve(next);
  const double half = 0.5 * ab[0], square = half * half + ab[1];
  return square < 0.0 ? std::sqrt(-ab[1]) : std::abs(half) + std::sqrt(square);
}

std::vector<RunRequest> growth_runs(const GrowthSpec& growth, const std::string& scene) {
  std::vector<RunRequest> requests;
  const int n = growth.substeps;
  for (const double omega_h : growth.omega_h) {
    for (const std::string& scheme : scheme_names()) {
      const double dt = omega_h / (kOmega * n), H = n * dt;
      RunRequest request;
      request.name = run_name(scheme, omega_h);
      request.scene = scene;
      request.settings = {"output.plots=false",
                          "output.vtk=false",
                          "coupling.scheme=" + scheme,
                          "coupling.stop_on_energy_gain=false",
                          "particles.variables.every=" + std::to_string(n),
                          "particles.variables.dt=" + number_text(dt, kDigits),
                          "initial.velocity=[0,0," + number_text(-push(scheme, omega_h, n), kDigits) + "]",
                          "output.interval=" + number_text(0.5 * H, kDigits),
                          "end_time=" + number_text((grows(scheme, omega_h, n) ? 40 : kWindows) * H, kDigits),
                          "particles.max_time_step=" + number_text(2.0 * dt, kDigits)};
      requests.push_back(request);
    }
  }
  return requests;
}

double growth_in_liggghts(const std::string& folder, const std::string& scheme, double omega_h, int n) {
  const std::filesystem::path file = std::filesystem::path(folder) / run_name(scheme, omega_h) / "history.csv";
  if (!std::filesystem::exists(file)) return kNoRate;
  const History history = read_history(file.string());
  const std::vector<double>&z = history.column("pad.z"), &vz = history.column("pad.vz");
  const double least = kDecayed * push(scheme, omega_h, n);
  std::size_t count = 0;
  while (count < z.size() && std::abs(z[count] - z.front()) <= kClosed && std::abs(vz[count]) >= least) ++count;
  return growth_of_series({vz.begin(), vz.begin() + static_cast<std::ptrdiff_t>(count)});
}

}  // namespace footfall
