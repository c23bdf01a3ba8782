// The equations of every rig, and their evaluation from histories of runs.
//
// Plate and cone pressed into a bed.
//
//   plate  p(s) = (k_c / b + k_phi) s^n    Bekker, Introduction to Terrain-Vehicle Systems (1969)
//
// p is the mean pressure on the plate, s the sinkage of its lower face below the bed's mean surface, b its shorter side
// (its radius when it is round). n is common to all widths; log p is fitted at 20 depths, from two grain radii on.
//
//   cone   q(s) = F / A = q_0 + G s        A the largest section of the cone, s the depth of its tip
//
// G, the gradient of the cone index, is fitted from the depth of the whole cone on.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/bed/bed_measures.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/rig.h"

namespace footfall {
namespace {

constexpr int kBins = 20;
constexpr double kNoValue = std::numeric_limits<double>::quiet_NaN();
constexpr double kShallow = 2.0;  // sinkage that is left out [grain radii]

// Pressure over sinkage of a plate of width b [m].
struct Pressed {
  double b = 0.0, area = 0.0;
  Bins bins;
};

// Depth over time of the lowest point, `lowest` below its column z, under the mean surface [m].
std::vector<double> sinkage_of(const RigRun& run, const History& history, const std::string& body, double lowest) {
  std::vector<double> s = history.column(body + ".z");
  for (double& z : s) z = mean_surface(run) - (z - lowest);
  return s;
}

Eigen::VectorXd vector_of(const std::vector<double>& x) {
  return Eigen::Map<const Eigen::VectorXd>(x.data(), x.size());
}

std::vector<double> divided_by(std::vector<double> values, double divisor) {
  for (double& value : values) value /= divisor;
  return values;
}

// The rows 1, x of a line.
Eigen::MatrixXd line_of(const std::vector<double>& x) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Ones(x.size(), 2);
  A.col(1) = vector_of(x);
  return A;
}

// Width, or radius, and area; half: half its height [m].
Pressed plate_in(const Scene& scene, double& half) {
  const BodySpec& plate = body_of(scene, "plate");
  Pressed p;
  if (plate.shape && plate.shape->kind == ShapeKind::kBox) {
    p.b = std::min(plate.shape->size.x(), plate.shape->size.y());
    p.area = plate.shape->size.x() * plate.shape->size.y();
    half = 0.5 * plate.shape->size.z();
  } else if (plate.shape && plate.shape->kind == ShapeKind::kCylinder) {
    p.b = plate.shape->radius;
    p.area = kPi * p.b * p.b;
    half = 0.5 * plate.shape->length;
  } else {
    throw InputError(code::kRigScene, scene.file + ": body \"plate\": this rig requires a box or an upright cylinder");
  }
  return p;
}

Pressed plate_of(const RigRun& run) {
  double half = 0.0;
  Pressed p = plate_in(run.scene, half);
  const History history = history_of(run);
  const std::vector<double> s = sinkage_of(run, history, "plate", half);
  p.bins = binned(s, divided_by(history.column("plate.contact.fz"), p.area), -kShallow * mean_surface(run),
                  *std::max_element(s.begin(), s.end()), kBins);
  return p;
}

}  // namespace

void require_plate(const Scene& scene) {
  double half = 0.0;
  plate_in(scene, half);
}

RigSample evaluate_plate(const std::vector<RigRun>& runs) {
  RigSample sample;
  std::vector<Pressed> plates;
  Eigen::Index rows = 0;
  for (const RigRun& run : runs) {
    plates.push_back(plate_of(run));
    sample.curves.push_back({run.name, plates.back().bins.x, plates.back().bins.y});
    rows += std::count_if(plates.back().bins.y.begin(), plates.back().bins.y.end(), [](double p) { return p > 0.0; });
  }
  const auto count = static_cast<Eigen::Index>(plates.size());
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(rows, count + 1);
  Eigen::VectorXd log_p(rows);
  Eigen::Index row = 0;
  for (Eigen::Index k = 0; k < count; ++k) {
    const Bins& bins = plates[k].bins;
    for (std::size_t i = 0; i < bins.x.size(); ++i) {
      if (bins.y[i] <= 0.0) continue;
      A(row, k) = 1.0;
      A(row, count) = std::log(bins.x[i]);
      log_p(row++) = std::log(bins.y[i]);
    }
  }
  const LineFit fit = least_squares(A, log_p);
  // k_b = k_c / b + k_phi over the widths.
  Eigen::MatrixXd B(count, 2);
  Eigen::VectorXd k_b(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    B.row(k) << 1.0 / plates[k].b, 1.0;
    k_b(k) = std::exp(fit.c(k));
  }
  const Eigen::Vector2d k = two_coefficients(B, k_b);
  sample.answers = {
      {"n", "", fit.c(count)}, {"k_c", "N/m^(n+1)", k(0)}, {"k_phi", "N/m^(n+2)", k(1)}, {"R^2", "", fit.r_squared}};
  for (std::size_t i = 0; i < plates.size(); ++i) {
    const double depth = 0.25 * plates[i].b;
    sample.answers.push_back({"pressure at b / 4, b = " + number_text(plates[i].b) + " m", "Pa",
                              std::exp(fit.c(i) + fit.c(count) * std::log(depth))});
  }
  return sample;
}

void require_cone(const Scene& scene) { mesh_of(scene, "cone", "cone.stl"); }

RigSample evaluate_cone(const std::vector<RigRun>& runs) {
  RigSample sample;
  for (const RigRun& run : runs) {
    const double diameter = mesh_of(run.scene, "cone", "cone.stl").scale, area = 0.25 * kPi * diameter * diameter;
    const double length = 0.5 * diameter / std::tan(15.0 * kPi / 180.0);  // of the cone
    const History history = history_of(run);
    // The column is the height of the centre of mass; in the reference configuration the tip is at 0.
    const std::vector<double>& z = history.column("cone.z");
    const double clearance = run.scene.initial.clearance.value_or(0.0);
    std::vector<double> s = z;
    for (double& value : s) value = z.front() - value - clearance + mean_surface(run);
    const double deepest = *std::max_element(s.begin(), s.end());
    const Bins bins = binned(s, divided_by(history.column("cone.contact.fz"), area), 0.0, deepest, 2 * kBins);
    sample.curves.push_back({run.name, bins.x, bins.y});
    Bins deep;
    for (std::size_t i = 0; i < bins.x.size(); ++i)
      if (bins.x[i] >= length) deep.x.push_back(bins.x[i]), deep.y.push_back(bins.y[i]);
    const LineFit fit = least_squares(line_of(deep.x), vector_of(deep.y));
    const double at = 1.5 * length;
    sample.answers.push_back({"gradient G of the cone index", "Pa/m", fit.c(1)});
    sample.answers.push_back(
        {"cone index at 1.5 lengths of the cone", "Pa", deepest >= at ? fit.c(0) + fit.c(1) * at : kNoValue});
    sample.answers.push_back({"R^2", "", fit.r_squared});
  }
  return sample;
}

// Wheel and shear ring: steady means, over the last 40 % of a run.
//
//   wheel   slip i = 1 - v / (omega R); drawbar pull DP = F_x and torque T of the grains on the wheel; sinkage s of its
//           lowest point below the bed's mean surface. Reported are DP / W and T / (W R), W the mean upward force of the grains.
//
//   ring    sigma = F_z / (pi (r_o^2 - r_i^2)),  tau = 3 |M_z| / (2 pi (r_o^3 - r_i^3)),  tau = c + sigma tan(phi)
//           for uniform shear stress under the ring [Wong, Theory of Ground Vehicles, 2.4]

namespace {

constexpr double kSteady = 0.6;               // share of the time before the steady part
constexpr double kInner = 0.5, kOuter = 1.0;  // radii of ring.stl, in its scale

const MotionSpec& motion_of(const Scene& scene, const std::string& joint) {
  for (const JointSpec& j : scene.joints)
    if (j.name == joint && j.motion) return *j.motion;
  throw InputError(code::kRigScene, scene.file + ": this rig requires a joint named \"" + joint + "\" with a motion");
}

// The rate of a motion that is linear in time, so that the slip is constant.
double rate_of(const Scene& scene, const std::string& joint, const char* key,
               const std::optional<TimeFunctionSpec>& f) {
  if (f && f->table.empty() && f->amplitude == 0.0 && (f->polynomial.size() == 1 || f->polynomial.size() == 2))
    return f->polynomial.size() == 2 ? f->polynomial[1] : 0.0;
  throw InputError(code::kRigScene, scene.file + ": joint \"" + joint + "\": motion." + key +
                                        ": this rig requires polynomial = [0, RATE], for a constant slip");
}

struct Driven {
  double R, v, omega;  // radius [m], speeds of the hub [m/s] and about it [rad/s]
};

Driven wheel_of(const Scene& scene) {
  const BodySpec& wheel = body_of(scene, "wheel");
  if (!wheel.shape || wheel.shape->kind != ShapeKind::kCylinder)
    throw InputError(code::kRigScene, scene.file + ": body \"wheel\": this rig requires a cylinder");
  const Driven driven{wheel.shape->radius, rate_of(scene, "rig", "x", motion_of(scene, "rig").x),
                      rate_of(scene, "hub", "rotation", motion_of(scene, "hub").rotation)};
  if (driven.omega == 0.0)
    throw InputError(code::kRigScene, scene.file + ": joint \"hub\": motion.rotation: a wheel at rest has no slip");
  return driven;
}

}  // namespace

void require_wheel(const Scene& scene) { wheel_of(scene); }

RigSample evaluate_wheel(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve pull{"drawbar pull", {}, {}}, torque{"torque / (load R)", {}, {}};
  for (const RigRun& run : runs) {
    const auto [R, v, omega] = wheel_of(run.scene);
    const double slip = 1.0 - v / (omega * R);
    const History history = history_of(run);
    const double W = late_mean(history, "wheel.contact.fz", kSteady);
    const double dp = late_mean(history, "wheel.contact.fx", kSteady) / W;
    const double t = std::abs(late_mean(history, "wheel.contact.my", kSteady)) / (W * R);
    const double s = mean_surface(run) - (late_mean(history, "wheel.z", kSteady) - R);
    const std::string at = " at slip " + number_text(std::abs(slip) < 1e-9 ? 0.0 : slip, 3);
    sample.answers.push_back({"drawbar pull / load" + at, "", dp});
    sample.answers.push_back({"torque / (load R)" + at, "", t});
    sample.answers.push_back({"sinkage" + at, "m", s});
    pull.x.push_back(slip), pull.y.push_back(dp);
    torque.x.push_back(slip), torque.y.push_back(t);
  }
  sample.curves = {pull, torque};
  return sample;
}

void require_shear(const Scene& scene) { mesh_of(scene, "ring", "ring.stl"); }

RigSample evaluate_shear(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve line{"steady stress", {}, {}};
  for (const RigRun& run : runs) {
    const double scale = mesh_of(run.scene, "ring", "ring.stl").scale;
    const double a = kInner * scale, b = kOuter * scale;
    const History history = history_of(run);
    line.x.push_back(late_mean(history, "ring.contact.fz", kSteady) / (kPi * (b * b - a * a)));
    line.y.push_back(3.0 * std::abs(late_mean(history, "ring.contact.mz", kSteady)) /
                     (2.0 * kPi * (b * b * b - a * a * a)));
  }
  const Eigen::Vector2d c = two_coefficients(line_of(line.x), vector_of(line.y));
  sample.curves = {line};
  sample.answers = {{"friction angle phi", "deg", std::atan(c(1)) * 180.0 / kPi}, {"cohesion c", "Pa", c(0)}};
  for (std::size_t i = 0; i < runs.size(); ++i)
    sample.answers.push_back({"tau / sigma, load " + std::to_string(i + 1), "", line.y[i] / line.x[i]});
  return sample;
}

// Shear box: means over the last 40 % of a run, in the plane between tray and frame, of area A.
//
//   tau = |F_x| / A,   sigma = (-F_z - W / 2) / A,   tau = c + sigma tan(phi)
//
// F: force of the grains on the tray. W: weight of the grains, half of it below the plane; it is -sum F_z of tray, frame and
// lid. A is not corrected for the displacement of the frame.

namespace {

constexpr double kDrawn = 0.6;   // share of the time before the part that counts
constexpr double kInside = 2.0;  // inner width of box_tray.stl, in its scale

double load_of(const Scene& scene) {
  for (const ForceSpec& force : scene.forces)
    if (force.name == "load" && force.force && !force.force->polynomial.empty()) return force.force->polynomial.front();
  throw InputError(code::kRigScene, scene.file + ": this rig requires a force named \"load\", a polynomial of time");
}

}  // namespace

void require_box(const Scene& scene) {
  mesh_of(scene, "tray", "box_tray.stl");
  body_of(scene, "frame");
  body_of(scene, "lid");
  load_of(scene);
}

RigSample evaluate_box(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve line{"stress in the plane", {}, {}};
  std::vector<RigAnswer> ratios;
  for (const RigRun& run : runs) {
    const double area = std::pow(kInside * mesh_of(run.scene, "tray", "box_tray.stl").scale, 2);
    const History history = history_of(run);
    const double down = -late_mean(history, "tray.contact.fz", kDrawn);
    const double weight =
        down - late_mean(history, "frame.contact.fz", kDrawn) - late_mean(history, "lid.contact.fz", kDrawn);
    const double sigma = (down - 0.5 * weight) / area;
    const double tau = std::abs(late_mean(history, "tray.contact.fx", kDrawn)) / area;
    line.x.push_back(sigma), line.y.push_back(tau);
    const std::string at = ", load of " + number_text(load_of(run.scene), 4) + " N";
    ratios.push_back({"sigma" + at, "Pa", sigma});
    ratios.push_back({"tau / sigma" + at, "", tau / sigma});
  }
  const Eigen::Vector2d c = two_coefficients(line_of(line.x), vector_of(line.y));
  const LineFit fit = least_squares(line_of(line.x), vector_of(line.y));
  sample.curves = {line};
  sample.answers = {{"friction angle phi", "deg", std::atan(c(1)) * 180.0 / kPi}, {"cohesion c", "Pa", c(0)}};
  if (fit.valid) sample.answers.push_back({"R^2", "", fit.r_squared});
  sample.answers.insert(sample.answers.end(), ratios.begin(), ratios.end());
  return sample;
}

// Angle of repose: the slope (bed_slope) that a retreating wall leaves, between a fifth and four fifths of the height of
// the step.

namespace {

constexpr double kLowerPart = 0.2, kUpperPart = 0.8;

}  // namespace

void require_repose(const Scene& scene) {
  const BoxSpec& box = box_of(scene);
  if (box.pit.empty()) throw InputError(code::kRigScene, scene.file + ": this rig requires particles.box.pit");
  if (!(box.frames > 0.0))
    throw InputError(code::kRigScene, scene.file + ": this rig requires particles.box.frame_interval");
}

RigSample evaluate_repose(const std::vector<RigRun>& runs) {
  RigSample sample;
  for (const RigRun& run : runs) {
    const double r = -mean_surface(run);
    require_repose(run.scene);
    const BoxSpec& box = box_of(run.scene);
    const auto frames = find_bed_frames(run.folder);
    if (frames.empty()) throw InputError(code::kRigRuns, run.folder + ": no dumps of grains");
    const double half = 0.5 * box.size[0], step = box.pit_depth;
    const BedSlope slope = bed_slope(
        read_bed_frame(frames.rbegin()->second),
        {box.centre[0] - half, box.centre[0] + half, r, (kLowerPart - 1.0) * step, (kUpperPart - 1.0) * step});
    sample.answers.push_back({"angle of repose", "deg", slope.angle});
    sample.answers.push_back({"R^2 of the slope", "", slope.r_squared});
    sample.curves.push_back({run.name, slope.x, slope.height});
  }
  return sample;
}

// A sphere dropped on a bed: the law of its drag,
//
//   m a = -m g + k z + m v^2 / d1          Katsuragi and Durian, Nature Phys. 3, 420 (2007)
//
// z the depth of its lowest point below the bed's mean surface, downwards positive; a + g upwards. (a + g) is linear in z
// and v^2: k / m and 1 / d1 by least squares over all trajectories of a sample, from two grain radii of depth (the law
// excludes the first contact) to the first stop. Means over 40 depths each.
//
//   d1 = (0.25 / mu) (rho_s / rho_b) D,   k = 12 mu (rho_b / rho_s)^(1/2) m g / D     PRE 87, 052208 (2013)
//
// At high speed the depth is linear in the impact speed, and the time to the stop constant [Goldman and Umbanhowar, PRE 77,
// 021308 (2008)]: reported are R^2 of a line through the depths, and the time at the largest speed over that at the next one.
//
// rho_s of the sphere, rho_b of the bed. The product k d1 does not depend on the friction mu: it is 3 in this law.

namespace {

constexpr int kDropBins = 40;
constexpr double kDropFirst = 2.0;  // grain radii
// Impact speed [m/s], depth [m] and time [s] of the first stop.
struct FirstStop {
  double speed = 0.0, depth = 0.0, time = 0.0;
};

// For three speeds or more; otherwise NaN.
std::vector<RigAnswer> linear_depth(std::vector<FirstStop> stops) {
  std::sort(stops.begin(), stops.end(), [](const FirstStop& a, const FirstStop& b) { return a.speed < b.speed; });
  std::vector<double> speeds, depths;
  for (const FirstStop& stop : stops) speeds.push_back(stop.speed), depths.push_back(stop.depth);
  const Eigen::VectorXd depth = vector_of(depths);
  const double r_squared = depth.allFinite() ? least_squares(line_of(speeds), depth).r_squared : std::nan("");
  const double ratio = stops.size() < 3 ? std::nan("") : stops.back().time / stops[stops.size() - 2].time;
  return {{"R^2 of depth linear in speed", "", r_squared},
          {"time to the stop, largest speed over the next", "", ratio}};
}

const BodySpec& ball_of(const Scene& scene) {
  const BodySpec& ball = body_of(scene, "ball");
  if (!ball.shape || ball.shape->kind != ShapeKind::kSphere)
    throw InputError(code::kRigScene, scene.file + ": body \"ball\": this rig requires a sphere");
  return ball;
}

}  // namespace

void require_sphere(const Scene& scene) { ball_of(scene); }

RigSample evaluate_sphere(const std::vector<RigRun>& runs) {
  RigSample sample;
  std::vector<std::array<double, 3>> rows;  // z, v^2, a + g
  std::vector<RigAnswer> depths;
  std::vector<FirstStop> stops;
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
  Eigen::MatrixXd A(rows.size(), 2);
  Eigen::VectorXd y(A.rows());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    A.row(i) << rows[i][0], rows[i][1];
    y(i) = rows[i][2];
  }
  const LineFit fit = least_squares(A, y);
  const RigRun& run = runs.front();
  const BodySpec& ball = ball_of(run.scene);
  const BoxSpec& box = *run.scene.particles->box;
  const double m = ball.mass, g = gravity_of(run), D = 2.0 * ball.shape->radius;
  const double rho_s = m / (kPi / 6.0 * D * D * D);
  const double rho_b = density_of_bed(box);
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

// Resistive force theory (RFT). The stress on a plate drawn slowly through a bed is proportional to its depth,
//
//   sigma_x,z = alpha_x,z(beta, gamma) |z|
//   alpha_z = zeta sum_m,n [ A_mn cos 2 pi (m beta / pi + n gamma / (2 pi)) + B_mn sin 2 pi (m beta / pi + n gamma / (2 pi)) ]
//   alpha_x = zeta sum_m,n [ C_mn cos(...) + D_mn sin(...) ]           m = -1, 0, 1, n = 0, 1
//
// with the nine coefficients of generic media in N/cm^3 and one scalar zeta for the medium: Li, Zhang and Goldman,
// Science 339, 1408 (2013). beta is the angle of the plate to the horizontal, gamma the angle of its motion below the
// horizontal, both in [-pi/2, pi/2]; a plate of positive beta leans against a motion to the side that alpha_x counts.
//
// In each run alpha is the slope of F / A over the depth of the plate's middle, through zero at the bed's mean
// surface, from one plate width on. zeta is fitted by least squares to all alpha_x and alpha_z of a sample;
// R^2 = 1 - sum (measured - zeta theory)^2 / sum (measured - mean)^2.
//
// 3D-RFT has xi = rho_c g (894 mu^3 - 386 mu^2 + 89 mu), Agarwal, Goldman and Kamrin, PNAS 120 (2023); reported is the mu
// at which it equals the fitted scalar.

namespace {

constexpr double kPerCubicMetre = 1e6;  // N/cm^3 -> N/m^3
constexpr double kMeasuredFrom = 1.0;   // plate widths of depth

const BodySpec& drawn_plate_of(const Scene& scene) {
  const BodySpec& plate = body_of(scene, "plate");
  if (!plate.shape || plate.shape->kind != ShapeKind::kBox)
    throw InputError(code::kRigScene, scene.file + ": body \"plate\": this rig requires a box");
  return plate;
}

}  // namespace

RftAlpha rft_alpha(double beta, double gamma) {
  constexpr double A00 = 0.206, A10 = 0.169, B11 = 0.212, B01 = 0.358, Bm11 = 0.055;
  constexpr double C11 = -0.124, C01 = 0.253, Cm11 = 0.007, D10 = 0.088;
  const auto angle = [&](int m, int n) { return 2.0 * m * beta + n * gamma; };
  return {A00 + A10 * std::cos(angle(1, 0)) + B11 * std::sin(angle(1, 1)) + B01 * std::sin(angle(0, 1)) +
              Bm11 * std::sin(angle(-1, 1)),
          C11 * std::cos(angle(1, 1)) + C01 * std::cos(angle(0, 1)) + Cm11 * std::cos(angle(-1, 1)) +
              D10 * std::sin(angle(1, 0))};
}

void require_rft(const Scene& scene) { drawn_plate_of(scene); }

RigSample evaluate_rft(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve z_curve{"alpha_z", {}, {}}, x_curve{"alpha_x", {}, {}};
  std::vector<double> theory, measured;
  for (const RigRun& run : runs) {
    const BodySpec& plate = drawn_plate_of(run.scene);
    const Eigen::Vector3d size = plate.shape->size;
    const History history = history_of(run);
    const std::vector<double>&x = history.column("plate.x"), &z = history.column("plate.z");
    const std::vector<double>&fx = history.column("plate.contact.fx"), &fz = history.column("plate.contact.fz");
    const double gamma = std::atan2(-(z.back() - z.front()), x.back() - x.front());
    // The plate's plane from its body x axis, in W, in the reference configuration.
    const Eigen::Vector3d along = plate.orientation * Eigen::Vector3d::UnitX();
    double beta = std::atan2(along.z(), along.x());
    if (beta > 0.5 * kPi + 1e-9) beta -= kPi;
    if (beta < -0.5 * kPi - 1e-9) beta += kPi;
    double sum_zz = 0.0, sum_x = 0.0, sum_z = 0.0;
    const double area = size.x() * size.y();
    for (std::size_t i = 0; i < z.size(); ++i) {
      const double depth = mean_surface(run) - z[i];
      if (depth < kMeasuredFrom * size.x()) continue;
      sum_zz += depth * depth;
      sum_x -= depth * fx[i] / area;  // against the motion
      sum_z += depth * fz[i] / area;
    }
    if (!(sum_zz > 0.0))
      throw InputError(code::kRigRuns, run.folder + ": the plate does not reach a depth of its width");
    const RftAlpha alpha = rft_alpha(beta, gamma);
    for (const auto& [mine, theirs, curve] :
         {std::tuple{sum_z / sum_zz, alpha.z, &z_curve}, {sum_x / sum_zz, alpha.x, &x_curve}}) {
      measured.push_back(mine), theory.push_back(theirs * kPerCubicMetre);
      curve->x.push_back(theirs), curve->y.push_back(mine);
    }
  }
  const Eigen::Map<const Eigen::VectorXd> t(theory.data(), theory.size());
  const Eigen::Map<const Eigen::VectorXd> m(measured.data(), t.size());
  const double zeta = t.dot(m) / t.squaredNorm();
  const double r2 = 1.0 - (m - zeta * t).squaredNorm() / (m.array() - m.mean()).square().sum();
  const BoxSpec& box = *runs.front().scene.particles->box;
  const double rho = density_of_bed(box);
  sample.answers = {
      {"scalar zeta", "", zeta},
      {"R^2", "", r2},
      {"alpha_z of a flat plate, beta = 0, gamma = 90 deg", "N/m^3",
       zeta * kPerCubicMetre * rft_alpha(0.0, 0.5 * kPi).z},
      {"mu at which 3D-RFT's xi is as large", "",
       friction_of_xi(zeta * kPerCubicMetre * rft_alpha(0.0, 0.5 * kPi).z, rho * gravity_of(runs.front()))}};
  sample.curves = {z_curve, x_curve};
  return sample;
}

double friction_of_xi(double xi, double weight) {
  const auto at = [&](double mu) { return weight * ((894.0 * mu - 386.0) * mu + 89.0) * mu; };
  double low = 0.0, high = 2.0;
  if (!(xi > 0.0) || at(high) < xi) return std::nan("");
  for (int k = 0; k < 60; ++k) {
    const double middle = 0.5 * (low + high);
    (at(middle) < xi ? low : high) = middle;
  }
  return high;
}

}  // namespace footfall
