#include "mbd_solver/cli/experiments/window_growth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <sstream>

#include "coupler/base/whole_file.h"
#include "coupler/load_average.h"
#include "coupler/schemes/registry.h"
#include "mbd_solver/cli/experiments/window_growth_run.h"
#include "mbd_solver/coupling/body_window.h"

namespace footfall {

double predicted_growth(const std::string& scheme, double omega_h, int n) {
  return predicted_growth(*make_scheme(scheme), omega_h, n);
}

double measured_growth(const std::string& name, double omega_h, int n) {
  constexpr int windows = 4000;
  // of the initial motion: beyond, round-off or overflow would be measured
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
  average.set_standing(contact, path.pose());
  BodyLoad answer;
  answer.contact_stiffness = K;
  if (scheme->wants_tangent()) answer.tangent.emplace_back().K(2, 2) = K;
  BodyWindow window(*scheme, body, state, answer);
  ExternalLoad felt;

  std::vector<double> logs;
  // All that the next window depends on, so that the size does not dip where position and velocity pass through zero
  // together.
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
    answer.mean = average.finish();
    window.answer(answer, felt);
    const double f = felt.F_W.z();
    const PointMotion start{state.r.z(), state.dr.z()};
    PointMotion end{start.x + start.v + 0.5 * f, start.v + f};
    state.ddr.z() = f;
    if (felt.tangent) {
      const TangentLoad& load = *felt.tangent;
      const double K_felt = load.K(2, 2), C_felt = load.C(2, 2);
      const double standing = f + K_felt * load.r_mean.z() + C_felt * load.v_mean[2];
      end = exact_flow(K_felt, C_felt, standing, start);
      state.ddr.z() = standing - K_felt * end.x - C_felt * end.v;
    }
    state.r.z() = end.x;
    state.dr.z() = end.v;
    const double share = size() / first;
    if (!(share > least && share < most)) break;
    logs.push_back(std::log(share));
  }
  // Slope of log size over the second half, where the fastest-growing mode is alone.
  const std::size_t from = logs.size() / 2;
  double sk = 0.0, sl = 0.0, skk = 0.0, skl = 0.0;
  const double count = static_cast<double>(logs.size() - from);
  for (std::size_t i = from; i < logs.size(); ++i) {
    const double at = static_cast<double>(i);
    sk += at;
    sl += logs[i];
    skk += at * at;
    skl += at * logs[i];
  }
  return std::exp((count * skl - sk * sl) / (count * skk - sk * sk));
}

std::vector<GrowthPoint> growth_of_schemes(const std::vector<double>& omega_h, int n, const std::string& runs) {
  std::vector<GrowthPoint> points;
  for (const double w : omega_h)
    for (const std::string& scheme : scheme_names()) {
      GrowthPoint point{scheme, w, predicted_growth(scheme, w, n), measured_growth(scheme, w, n)};
      if (!runs.empty()) point.in_liggghts = growth_in_liggghts(runs, scheme, w, n);
      points.push_back(point);
    }
  return points;
}

void write_growth(const std::string& path, const std::string& title, const std::vector<GrowthPoint>& points, int n) {
  std::ostringstream out;
  out << "# " << title << "\n\nGrowth of the motion per window of " << n
      << " substeps, one body on linear contacts with grains that stand, no damping: in LIGGGHTS / by the coupling "
         "code\n"
      << "alone / theory ([window maps](theory.md)). Above 1 the scheme makes energy.\n\n| omega H |";
  for (const std::string& scheme : scheme_names()) out << ' ' << scheme << " |";
  out << "\n|---|";
  for (std::size_t i = 0; i < scheme_names().size(); ++i) out << "---|";
  double last = -1.0;
  char text[64];
  for (const GrowthPoint& point : points) {
    if (point.omega_h != last) {
      std::snprintf(text, sizeof text, "\n| %g |", point.omega_h);
      out << text;
      last = point.omega_h;
    }
    std::snprintf(text, sizeof text, " %.5g", point.in_liggghts);
    out << (std::isnan(point.in_liggghts) ? " -" : text);
    std::snprintf(text, sizeof text, " / %.5g / %.5g |", point.measured, point.theory);
    out << text;
  }
  out << '\n';
  write_whole_file(path, out.str());
}

}  // namespace footfall
