// Wheel and shear ring: steady means, over the last 40 % of a run.
//
//   wheel   slip i = 1 - v / (omega R); drawbar pull DP = F_x and torque T of the grains on the wheel; sinkage s of its
//           lowest point below the bed's mean surface. Told are DP / W, T / (W R), W the mean force of the grains upwards.
//
//   ring    sigma = F_z / (pi (r_o^2 - r_i^2)),  tau = 3 |M_z| / (2 pi (r_o^3 - r_i^3)),  tau = c + sigma tan(phi)
//           the stress that a ring of even shear stress brings its moment by [Wong, Theory of Ground Vehicles, 2.4]
#include <algorithm>
#include <cmath>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/rigs/rig_curves.h"

namespace footfall {

namespace {

constexpr double kSteady = 0.6;               // of the time: what follows is the steady part
constexpr double kInner = 0.5, kOuter = 1.0;  // radii of ring.stl, in its scale

const MotionSpec& motion_of(const Scene& scene, const std::string& joint) {
  for (const JointSpec& j : scene.joints)
    if (j.name == joint && j.motion) return *j.motion;
  throw InputError(scene.file + ": this rig needs a joint named \"" + joint + "\" with a motion");
}

// Of a motion that is a straight line over time: the slip is one number then.
double rate_of(const Scene& scene, const std::string& joint, const char* key,
               const std::optional<TimeFunctionSpec>& f) {
  if (f && f->table.empty() && f->amplitude == 0.0 && (f->polynomial.size() == 1 || f->polynomial.size() == 2))
    return f->polynomial.size() == 2 ? f->polynomial[1] : 0.0;
  throw InputError(scene.file + ": joint \"" + joint + "\": motion." + key +
                   ": the rig expects polynomial = [0, RATE], as the slip is told by two steady rates");
}

struct Driven {
  double R, v, omega;  // radius [m], speeds of the hub [m/s] and about it [rad/s]
};

Driven wheel_of(const Scene& scene) {
  const BodySpec& wheel = body_of(scene, "wheel");
  if (!wheel.shape || wheel.shape->kind != ShapeKind::kCylinder)
    throw InputError(scene.file + ": body \"wheel\": the rig expects a cylinder");
  const Driven driven{wheel.shape->radius, rate_of(scene, "rig", "x", motion_of(scene, "rig").x),
                      rate_of(scene, "hub", "rotation", motion_of(scene, "hub").rotation)};
  if (driven.omega == 0.0)
    throw InputError(scene.file + ": joint \"hub\": motion.rotation: the wheel does not turn, and has no slip");
  return driven;
}

}  // namespace

void demand_wheel(const Scene& scene) { wheel_of(scene); }

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

void demand_shear(const Scene& scene) { mesh_of(scene, "ring", "ring.stl"); }

RigSample evaluate_shear(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve line{"steady stress", {}, {}};
  Eigen::MatrixXd A(static_cast<Eigen::Index>(runs.size()), 2);
  Eigen::VectorXd tau(A.rows());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const double scale = mesh_of(runs[i].scene, "ring", "ring.stl").scale;
    const double a = kInner * scale, b = kOuter * scale;
    const History history = history_of(runs[i]);
    const double sigma = late_mean(history, "ring.contact.fz", kSteady) / (kPi * (b * b - a * a));
    const auto row = static_cast<Eigen::Index>(i);
    tau(row) = 3.0 * std::abs(late_mean(history, "ring.contact.mz", kSteady)) / (2.0 * kPi * (b * b * b - a * a * a));
    A.row(row) << 1.0, sigma;
    line.x.push_back(sigma), line.y.push_back(tau(row));
  }
  Eigen::Vector2d c = Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
  if (A.rows() == 2)
    c = A.colPivHouseholderQr().solve(tau);
  else if (const LineFit fit = least_squares(A, tau); fit.valid)
    c = fit.c;
  sample.curves = {line};
  sample.answers = {{"friction angle phi", "deg", std::atan(c(1)) * 180.0 / kPi}, {"cohesion c", "Pa", c(0)}};
  for (Eigen::Index i = 0; i < A.rows(); ++i)
    sample.answers.push_back({"tau / sigma, load " + std::to_string(i + 1), "", tau(i) / A(i, 1)});
  return sample;
}

}  // namespace footfall
