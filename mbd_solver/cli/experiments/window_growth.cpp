#include "mbd_solver/cli/experiments/window_growth.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <unsupported/Eigen/MatrixFunctions>

#include "coupler/base/errors.h"
#include "coupler/load_average.h"
#include "mbd_solver/cli/experiments/window_growth_run.h"
#include "mbd_solver/coupling/predicted_window.h"
#include "mbd_solver/coupling/tangent.h"

namespace footfall {
namespace {

using Vector5d = Eigen::Matrix<double, 5, 1>;
using Matrix5d = Eigen::Matrix<double, 5, 5>;

// m = 1, H = 1, so that K = (omega H)^2.
struct Flow {
  double x = 0.0, v = 0.0;
};

// Exact solution after a time 1 of x'' = -K x - D v + f.
Flow flow(double K, double D, double f, const Flow& start) {
  Eigen::Matrix3d A;
  A << 0.0, 1.0, 0.0, -K, -D, f, 0.0, 0.0, 0.0;
  const Eigen::Vector3d end = A.exp() * Eigen::Vector3d(start.x, start.v, 1.0);
  return {end[0], end[1]};
}

double window_damping(double omega_h) {
  const double w6 = std::pow(0.5 * omega_h, 6);
  return 0.5 * w6 / (1.0 + w6) * omega_h * omega_h;
}

// Mean velocity of the path of `tangent`: two equal implicit stages of g.
double softened_velocity(double K, double v, double a) {
  const double g = 1.0 - std::sqrt(0.5);
  const auto stage = [&](double d_0, double v_0) { return (v_0 + g * (a - K * d_0)) / (1.0 + g * g * K); };
  const double V_1 = stage(0.0, v);
  const double d_2 = (1.0 - g) * V_1, v_2 = v + (1.0 - g) / g * (V_1 - v);
  return d_2 + g * stage(d_2, v_2);
}

// One window: z = [x, v, a (last acceleration sent), s (where the boundary stands), p (its velocity there)].
Vector5d window_map(const std::string& scheme, double omega_h, int n, const Vector5d& z) {
  const double K = omega_h * omega_h, x = z[0], v = z[1], a = z[2], gap = z[3] - z[0], p = z[4];
  const double end_step =
      scheme == "css" ? 0.5 / n : 0.0;  // the end step counts whole: mean f = trapezoid + (f(1) - f(0)) / 2n
  const double mean_tau = 0.5 + end_step, mean_g = 0.5 / (n * n) - end_step,
               mean_tau2 = 1.0 / 3.0 + 1.0 / (6.0 * n * n) + end_step;
  Vector5d out;
  if (scheme == "tangent") {
    const double D = window_damping(omega_h), path = softened_velocity(K, v, a);
    const double v_mean = path - gap + 0.5 / n * (p - (path - 4.0 * gap));
    const Flow end = flow(K, D, D * v_mean, {x, v});
    out << end.x, end.v, -K * end.x - D * (end.v - v_mean), x + path, path + 2.0 * gap;
    return out;
  }
  const bool frozen = scheme == "frozen";
  const double velocity = frozen ? 0.0 : v, acceleration = scheme == "quadratic" ? a : 0.0;
  const double standing = frozen ? 0.5 / n : mean_g;  // a frozen boundary jumps after the force that opens the window
  const double f = -K * (x + mean_tau * velocity + 0.5 * mean_tau2 * acceleration + standing * gap);
  out << x + v + 0.5 * f, v + f, f, x + velocity + 0.5 * acceleration, velocity + acceleration + 2.0 * gap;
  return out;
}

}  // namespace

double predicted_growth(const std::string& scheme, double omega_h, int n) {
  Matrix5d map;
  for (int k = 0; k < 5; ++k) map.col(k) = window_map(scheme, omega_h, n, Vector5d::Unit(k));
  return map.eigenvalues().cwiseAbs().maxCoeff();
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
  PredictedWindow predicted(*scheme, state);
  LoadAverage average(*scheme, 0);
  GeneralizedForce contact;
  const auto touch = [&] { contact.F_W.z() = -K * path.pose().r.z(); };
  touch();
  average.set_standing(contact, path.pose());
  ContactTangent slope;
  slope.K(2, 2) = K;

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
    if (scheme->wants_tangent()) {
      const Vector6d v = mean_velocity(body, state, slope, 1.0);
      sent.dr = v.head<3>();
    }
    predicted.begin(sent, n, dt);
    path.begin_window(sent, n, dt);
    average.begin_window(path.jump(), path.pose());
    for (int i = 0; i < n; ++i) {
      path.advance();
      touch();
      average.add_step(contact, path.pose(), path.last_step(), dt);
    }
    const double f = average.finish().F_W.z();
    const Flow start{state.r.z(), state.dr.z()};
    Flow end;
    if (scheme->wants_tangent()) {
      const TangentLoad load = tangent_load(slope, predicted, omega_h, 1.0);
      const double standing = f + load.K(2, 2) * load.r_mean.z() + load.C(2, 2) * load.v_mean[2];
      end = flow(load.K(2, 2), load.C(2, 2), standing, start);
      state.ddr.z() = standing - load.K(2, 2) * end.x - load.C(2, 2) * end.v;
    } else {
      end = {start.x + start.v + 0.5 * f, start.v + f};
      state.ddr.z() = f;
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
  std::ofstream out(path);
  if (!out) throw InputError(path + ": cannot be written");
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
}

}  // namespace footfall
