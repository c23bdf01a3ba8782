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

const MotionSpec& motion_of(const RigRun& run, const std::string& joint) {
  for (const JointSpec& j : run.scene.joints)
    if (j.name == joint && j.motion) return *j.motion;
  throw InputError(run.scene.file + ": this rig needs a joint named \"" + joint + "\"");
}

double rate_of(const std::optional<TimeFunctionSpec>& f) {
  return f && f->polynomial.size() > 1 ? f->polynomial[1] : 0.0;
}

}  // namespace

RigSample evaluate_wheel(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve pull{"drawbar pull", {}, {}}, torque{"torque / (load R)", {}, {}};
  for (const RigRun& run : runs) {
    const BodySpec& wheel = body_of(run, "wheel");
    if (!wheel.shape || !(wheel.shape->radius > 0.0))
      throw InputError(run.scene.file + ": body \"wheel\": the rig expects a cylinder");
    const double R = wheel.shape->radius;
    const double v = rate_of(motion_of(run, "rig").x), omega = rate_of(motion_of(run, "hub").rotation);
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

RigSample evaluate_shear(const std::vector<RigRun>& runs) {
  RigSample sample;
  RigCurve line{"steady stress", {}, {}};
  Eigen::MatrixXd A(static_cast<Eigen::Index>(runs.size()), 2);
  Eigen::VectorXd tau(A.rows());
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const BodySpec& ring = body_of(runs[i], "ring");
    if (!ring.shape || ring.shape->kind != ShapeKind::kMesh)
      throw InputError(runs[i].scene.file + ": body \"ring\": the rig expects the mesh ring.stl");
    const double a = kInner * ring.shape->scale, b = kOuter * ring.shape->scale;
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
