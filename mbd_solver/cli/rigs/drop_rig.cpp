// A sphere dropped on a bed: the law of its drag,
//
//   m a = -m g + k z + m v^2 / d1          Katsuragi and Durian, Nature Phys. 3, 420 (2007)
//
// z the depth of its lowest point below the bed's mean surface, downwards positive; a + g upwards. (a + g) is linear in z
// and v^2: k / m and 1 / d1 by least squares over all trajectories of a sample at once, from two grain radii of depth to
// the first stop. What comes before is the first contact, which the law leaves out. Means over 40 depths each.
//
//   d1 = (0.25 / mu) (rho_s / rho_b) D,   k = 12 mu (rho_b / rho_s)^(1/2) m g / D     PRE 87, 052208 (2013)
//
// At high speed the depth is linear in the speed of the impact, and the time to the stop the same for all [Goldman and
// Umbanhowar, PRE 77, 021308 (2008)]: told are R^2 of a line through the depths and the time at the largest speed over that
// at the next one.
//
// rho_s of the sphere, rho_b of the bed. Their product does not know the friction mu: it is 3.
#include <algorithm>
#include <array>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/rigs/rig_curves.h"

namespace footfall {

namespace {

constexpr int kDropBins = 40;
constexpr double kDropFirst = 2.0;  // grain radii
// A run's impact: speed [m/s], depth [m] and time [s] of its first stop.
struct Standstill {
  double speed = 0.0, depth = 0.0, time = 0.0;
};

// Of three speeds or more; else NaN.
std::vector<RigAnswer> linear_depth(std::vector<Standstill> stops) {
  std::sort(stops.begin(), stops.end(), [](const Standstill& a, const Standstill& b) { return a.speed < b.speed; });
  const auto count = static_cast<Eigen::Index>(stops.size());
  Eigen::MatrixXd A(count, 2);
  Eigen::VectorXd depth(count);
  for (Eigen::Index i = 0; i < count; ++i) {
    const Standstill& stop = stops[static_cast<std::size_t>(i)];
    A.row(i) << 1.0, stop.speed;
    depth(i) = stop.depth;
  }
  const double ratio = count < 3 ? std::nan("") : stops.back().time / stops[stops.size() - 2].time;
  return {{"R^2 of depth linear in speed", "", depth.allFinite() ? least_squares(A, depth).r_squared : std::nan("")},
          {"time to the stop, largest speed over the next", "", ratio}};
}

constexpr double kSolidLoose = 0.55, kSolidDense = 0.61;

const BodySpec& ball_of(const Scene& scene) {
  const BodySpec& ball = body_of(scene, "ball");
  if (!ball.shape || ball.shape->kind != ShapeKind::kSphere)
    throw InputError(scene.file + ": body \"ball\": the rig expects a sphere");
  return ball;
}

}  // namespace

void demand_sphere(const Scene& scene) { ball_of(scene); }

RigSample evaluate_sphere(const std::vector<RigRun>& runs) {
  RigSample sample;
  std::vector<std::array<double, 3>> rows;  // z, v^2, a + g
  std::vector<RigAnswer> depths;
  std::vector<Standstill> stops;
  for (const RigRun& run : runs) {
    const BodySpec& ball = ball_of(run.scene);
    const History history = history_of(run);
    std::vector<double> z = history.column("ball.z");
    for (double& value : z) value = mean_surface(run) - (value - ball.shape->radius);
    const std::vector<double>&v = history.column("ball.vz"), &f = history.column("ball.contact.fz");
    std::size_t stop = 0;
    while (stop < v.size() && v[stop] < 0.0) ++stop;
    std::vector<double> depth(z.begin(), z.begin() + static_cast<std::ptrdiff_t>(stop)), v2, drag;
    for (std::size_t i = 0; i < stop; ++i) v2.push_back(v[i] * v[i]), drag.push_back(f[i] / ball.mass);
    const double deepest = depth.empty() ? 0.0 : *std::max_element(depth.begin(), depth.end());
    const double from = -kDropFirst * mean_surface(run);
    const Bins a = binned(depth, drag, from, deepest, kDropBins), s = binned(depth, v2, from, deepest, kDropBins);
    RigCurve curve{run.name, a.x, a.y};
    for (double& value : curve.y) value /= gravity_of(run);
    sample.curves.push_back(curve);
    for (std::size_t i = 0; i < a.x.size(); ++i) rows.push_back({a.x[i], s.y[i], a.y[i]});
    const double speed = std::abs(run.scene.initial.velocity.z()), none = std::nan("");
    const bool stopped = stop < v.size();
    stops.push_back({speed, stopped ? deepest : none, stopped ? history.columns.front()[stop] : none});
    depths.push_back({"depth at its first stop, impact at " + number_text(speed, 3) + " m/s", "m", stops.back().depth});
  }
  Eigen::MatrixXd A(static_cast<Eigen::Index>(rows.size()), 2);
  Eigen::VectorXd y(A.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    A.row(static_cast<Eigen::Index>(i)) << rows[i][0], rows[i][1];
    y(static_cast<Eigen::Index>(i)) = rows[i][2];
  }
  const LineFit fit = least_squares(A, y);
  const RigRun& run = runs.front();
  const BodySpec& ball = ball_of(run.scene);
  const BoxSpec& box = *run.scene.particles->box;
  const double m = ball.mass, g = gravity_of(run), D = 2.0 * ball.shape->radius;
  const double rho_s = m / (kPi / 6.0 * D * D * D);
  const double rho_b = box.material.density * (box.packing == Packing::kDense ? kSolidDense : kSolidLoose);
  const double k = m * fit.c(0), d1 = 1.0 / fit.c(1);
  sample.answers = {{"k", "N/m", k},
                    {"d1", "m", d1},
                    {"R^2", "", fit.r_squared},
                    {"d1 / D", "", d1 / D},
                    {"k D / (m g)", "", k * D / (m * g)},
                    {"mu by d1", "", 0.25 * (rho_s / rho_b) * D / d1},
                    {"mu by k", "", k * D / (m * g) / (12.0 * std::sqrt(rho_b / rho_s))},
                    {"k d1 over its law", "", k * d1 / (m * g) * std::sqrt(rho_s / rho_b) * (rho_b / rho_s)}};
  for (const RigAnswer& more : linear_depth(stops)) sample.answers.push_back(more);
  for (const RigAnswer& depth : depths) sample.answers.push_back(depth);
  return sample;
}

}  // namespace footfall
