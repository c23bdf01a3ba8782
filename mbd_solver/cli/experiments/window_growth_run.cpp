#include "mbd_solver/cli/experiments/window_growth_run.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/text.h"
#include "mbd_solver/cli/experiments/study_run.h"

namespace footfall {
namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
const double kOmega = std::sqrt(50.0 * 1e4 / 20.0);  // of the pad of linear.toml on 50 contacts of kn [1/s]
constexpr double kClosed = 5e-4;                     // the contacts stay closed within this [m]
constexpr double kFast = 3.0;                        // growth from which one pair of windows tells it
constexpr double kSettled = 0.1;                     // and by which two such ratios agree when one mode is left
constexpr double kDecayed = 1e-7;                    // of the first velocity: below, tolerances would be measured
constexpr int kWindows = 200;

std::string number(double x) { return number_text(x, 10); }

}  // namespace

double growth_of_series(const std::vector<double>& v) {
  if (v.size() < 4) return kNone;
  const double last = std::abs(v.back() / v[v.size() - 2]), before = std::abs(v[v.size() - 2] / v[v.size() - 3]);
  if (last > kFast && std::abs(last / before - 1.0) < kSettled) return last;
  const std::size_t from = v.size() / 2, count = v.size() - from;
  if (count < 4) return kNone;
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

double growth_in_liggghts(const std::string& scene, const std::string& scheme, double omega_h, int n,
                          const std::string& out) {
  const double dt = omega_h / (kOmega * n), H = n * dt;
  const bool grows = predicted_growth(scheme, omega_h, n) > 1.2;
  const double push = grows ? 1e-11 : 1e-2;  // [m/s]
  StudyRunRequest request;
  request.scene = scene;
  request.out = out;
  request.settings = {"coupling.scheme=" + scheme,
                      "coupling.stop_on_energy_gain=false",
                      "particles.variables.every=" + std::to_string(n),
                      "particles.variables.dt=" + number(dt),
                      "initial.velocity=[0,0," + number(-push) + "]",
                      "output.interval=" + number(0.5 * H)};
  request.settings.push_back("end_time=" + number((grows ? 40 : kWindows) * H));
  request.settings.push_back("particles.max_time_step=" + number(2.0 * dt));
  const StudyRun run = run_once(request);
  if (run.history.columns.empty()) return kNone;
  const std::vector<double>&z = run.history.column("pad.z"), &vz = run.history.column("pad.vz");
  std::size_t count = 0;
  while (count < z.size() && std::abs(z[count] - z.front()) <= kClosed && std::abs(vz[count]) >= kDecayed * push)
    ++count;
  return growth_of_series({vz.begin(), vz.begin() + static_cast<std::ptrdiff_t>(count)});
}

}  // namespace footfall
