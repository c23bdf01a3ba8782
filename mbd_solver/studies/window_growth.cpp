// Measures growth as the slope of log size over windows, with the coupling code and with LIGGGHTS.
#include "mbd_solver/studies/window_growth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/text.h"
#include "coupler/load_average.h"
#include "coupler/schemes/registry.h"
#include "mbd_solver/coupling/body_window.h"
#include "mbd_solver/run/output/history.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {
namespace {

constexpr double kNoRate = std::numeric_limits<double>::quiet_NaN();
const double kOmega = std::sqrt(50.0 * 1e4 / 20.0);  // of the pad of linear.toml on 50 contacts of kn [1/s]
constexpr double kClosed = 5e-4;                     // the contacts stay closed within this [m]
constexpr double kFast = 3.0;                        // growth from which one pair of windows suffices
constexpr double kSettled = 0.1;                     // agreement of two such ratios when one mode dominates
constexpr double kDecayed = 1e-7;                    // of the first velocity; below, tolerances dominate
constexpr int kWindows = 200, kFewWindows = 40;      // of a bounded motion, of a growing one
constexpr int kDigits = 10;

bool grows(const std::string& scheme, double omega_h, int n) { return predicted_growth(scheme, omega_h, n) > 1.2; }

// First velocity [m/s]: the contacts stay closed in the first window, and in all of them unless the motion grows by more than a billion.
double push(const std::string& scheme, double omega_h, int n) {
  const double first = std::min(1e-2, 0.1 * kClosed * kOmega / omega_h);
  return first / std::clamp(std::pow(predicted_growth(scheme, omega_h, n), kWindows), 1.0, 1e9);
}

// Of the run in `folder`.
double growth_in_liggghts(const std::string& folder, const std::string& scheme, double omega_h, int n) {
  const std::filesystem::path file = std::filesystem::path(folder) / "history.csv";
  if (!std::filesystem::exists(file)) return kNoRate;
  const History history = read_history(file.string());
  const std::vector<double>&z = history.column("pad.z"), &vz = history.column("pad.vz");
  const double least = kDecayed * push(scheme, omega_h, n);
  std::size_t count = 0;
  const auto size = [&](std::size_t k) { return std::hypot(vz[k], kOmega * (z[k] - z.front())); };
  while (count < z.size() && std::abs(z[count] - z.front()) <= kClosed && size(count) >= least) ++count;
  return growth_of_series({vz.begin(), vz.begin() + static_cast<std::ptrdiff_t>(count)});
}

}  // namespace

bool GrowthPoint::as_theory(bool ran) const {
  const auto near = [&](double found, double limit) { return std::abs(found - theory) <= limit * theory; };
  // A motion that decays fast can be followed over few windows, in which equal roots of the window's map are not told apart.
  const double limit = theory < 0.9 ? 5e-2 : 1e-2;
  return near(measured, limit) && (!ran || near(in_liggghts, limit));
}

double predicted_growth(const std::string& scheme, double omega_h, int n) {
  return predicted_growth(*make_scheme(scheme), omega_h, n);
}

double measured_growth(const std::string& name, double omega_h, int n) {
  constexpr int windows = 4000;
  // Of the initial motion; beyond, round-off or overflow dominates.
  constexpr double least = 1e-9, most = 1e150;
  const double K = omega_h * omega_h, dt = 1.0 / n;
  const std::unique_ptr<Scheme> scheme = make_scheme(name);
  const Body body("body", 1.0, Eigen::Matrix3d::Identity());
  BodyMotion state;
  state.r.z() = 1.0;
  state.dr.z() = 0.3 * omega_h;
  state.ddr.z() = -K;
  BoundaryPath path(*scheme, state);
  LoadAverage average(*scheme, 0);
  GeneralizedForce contact;
  const auto touch = [&] { contact.F_W.z() = -K * path.pose().r.z(); };
  touch();
  average.set_opening_force(contact, path.pose());
  BodyLoad received;
  received.contact_stiffness = K;
  if (scheme->requires_tangent()) received.tangent.emplace_back().K(2, 2) = K;
  BodyWindow window(*scheme, body, state, received);
  ExternalLoad applied;

  std::vector<std::pair<double, double>> logs;  // of the size, over windows
  // Everything on which the next window depends, so that the size does not vanish where position and velocity do.
  const auto size = [&] {
    return Eigen::Vector4d(omega_h * state.r.z(), state.dr.z(), state.ddr.z() / omega_h, omega_h * path.pose().r.z())
        .norm();
  };
  const double first = size();
  for (int k = 0; k < windows; ++k) {
    BodyMotion sent = state;
    window.begin(n, dt, sent);
    path.begin_window(sent, n, dt);
    average.begin_window(path.jump(), path.pose());
    for (int i = 0; i < n; ++i) {
      path.advance();
      touch();
      average.add_step(contact, path.pose(), path.last_step(), dt);
    }
    received.mean = average.finish();
    window.apply(received, applied);
    const double f = applied.F_W.z();
    const PointMotion start{state.r.z(), state.dr.z()};
    PointMotion end{start.x + start.v + 0.5 * f, start.v + f};
    state.ddr.z() = f;
    if (applied.tangent) {
      const TangentLoad& load = *applied.tangent;
      const double K_applied = load.K(2, 2), C_applied = load.C(2, 2);
      const double standing = f + K_applied * load.r_mean.z() + C_applied * load.v_mean[2];
      end = exact_flow(K_applied, C_applied, standing, start);
      state.ddr.z() = standing - K_applied * end.x - C_applied * end.v;
    }
    state.r.z() = end.x;
    state.dr.z() = end.v;
    const double share = size() / first;
    if (!(share > least && share < most)) break;
    logs.emplace_back(k, std::log(share));
  }
  // Slope over the second half, where the fastest-growing mode dominates.
  logs.erase(logs.begin(), logs.begin() + static_cast<std::ptrdiff_t>(logs.size() / 2));
  return logs.size() < 2 ? kNoRate : std::exp(slope(logs));
}

double growth_of_series(const std::vector<double>& v) {
  if (v.size() < 4) return kNoRate;
  const double last = std::abs(v.back() / v[v.size() - 2]), before = std::abs(v[v.size() - 2] / v[v.size() - 3]);
  if (last > kFast && std::abs(last / before - 1.0) < kSettled) return last;
  const std::size_t from = v.size() / 2, count = v.size() - from;
  if (count < 4) return kNoRate;
  Eigen::MatrixXd past(count - 2, 2);
  Eigen::VectorXd next(count - 2);
  for (std::size_t k = 0; k + 2 < count; ++k) {
    const double scale =
        1.0 / (std::abs(v[from + k]) + std::abs(v[from + k + 1]));  // equal weights for a decaying motion
    const auto row = static_cast<Eigen::Index>(k);
    past.row(row) << scale * v[from + k + 1], scale * v[from + k];
    next[row] = scale * v[from + k + 2];
  }
  const Eigen::Vector2d ab = past.colPivHouseholderQr().solve(next);
  const double half = 0.5 * ab[0], square = half * half + ab[1];
  return square < 0.0 ? std::sqrt(-ab[1]) : std::abs(half) + std::sqrt(square);
}

namespace {

// Calls visit(n, omega H, scheme) in the order of runs and points.
template <class Visit>
void for_each_point(const GrowthSpec& growth, const Visit& visit) {
  for (const double n : growth.substeps)
    for (const double omega_h : growth.omega_h)
      for (const std::string& scheme : scheme_names()) visit(static_cast<int>(n), omega_h, scheme);
}

}  // namespace

std::vector<RunRequest> growth_runs(const GrowthSpec& growth, const std::string& scene) {
  std::vector<RunRequest> requests;
  const auto text = [](double value) { return number_text(value, kDigits); };
  for_each_point(growth, [&](int n, double omega_h, const std::string& scheme) {
    const double dt = omega_h / (kOmega * n), H = n * dt;
    RunRequest request;
    request.name = scheme + "_" + std::to_string(n) + "_" + number_text(omega_h);
    request.scene = scene;
    request.settings = {"output.plots=false",
                        "output.vtk=false",
                        "coupling.scheme=" + scheme,
                        "coupling.stop_on_energy_gain=false",
                        "particles.variables.every=" + std::to_string(n),
                        "particles.variables.dt=" + text(dt),
                        "initial.velocity=[0,0," + text(-push(scheme, omega_h, n)) + "]",
                        "output.interval=" + text(0.5 * dt),  // a row per window
                        "end_time=" + text((grows(scheme, omega_h, n) ? kFewWindows : kWindows) * H),
                        "particles.max_time_step=" + text(2.0 * dt)};
    requests.push_back(request);
  });
  return requests;
}

std::vector<GrowthPoint> growth_of_schemes(const GrowthSpec& growth, const std::vector<RunResult>& runs) {
  std::vector<GrowthPoint> points;
  for_each_point(growth, [&](int n, double w, const std::string& scheme) {
    GrowthPoint point{scheme, n, w, predicted_growth(scheme, w, n), measured_growth(scheme, w, n)};
    if (!runs.empty()) point.in_liggghts = growth_in_liggghts(runs[points.size()].end.folder, scheme, w, n);
    points.push_back(point);
  });
  return points;
}

std::string growth_page(const SweepSpec& spec, const std::vector<GrowthPoint>& points) {
  std::vector<std::string> head = scheme_names();
  head.insert(head.begin(), "omega H");
  std::string page = "# " + spec.title +
                     "\n\nGrowth of the motion per window, one body on linear contacts with fixed grains, without "
                     "damping: in LIGGGHTS / coupling code only /\ntheory (theory 7.7). Above 1 the scheme creates "
                     "energy.\n";
  for (const double n : spec.growth->substeps) {
    Table table(head);
    std::vector<std::string> row;
    for (const GrowthPoint& p : points) {
      if (p.substeps != static_cast<int>(n)) continue;
      if (row.empty()) row.push_back(number_text(p.omega_h));
      row.push_back((std::isnan(p.in_liggghts) ? "-" : number_text(p.in_liggghts, 5)) + " / " +
                    number_text(p.measured, 5) + " / " + number_text(p.theory, 5));
      if (row.size() < head.size()) continue;
      table.add(row);
      row.clear();
    }
    page += "\nWindows of " + number_text(n) + (n == 1.0 ? " DEM step:\n\n" : " DEM steps:\n\n") + table.page();
  }
  return page;
}

}  // namespace footfall
