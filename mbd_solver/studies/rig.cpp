// The table of rigs, their checks as settings of a scene, and tools of the evaluations.
#include "mbd_solver/studies/rig.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

const std::vector<Rig>& all_rigs() {
  static const std::vector<Rig> rigs = {
      {"plate", "pressure over sinkage, Bekker's k_c, k_phi and n", "sinkage [m]", "pressure [Pa]", evaluate_plate,
       require_plate},
      {"cone", "cone index over depth, and its gradient", "depth of the tip [m]", "cone index [Pa]", evaluate_cone,
       require_cone},
      {"wheel", "drawbar pull, torque and sinkage over slip", "slip", "drawbar pull / load", evaluate_wheel,
       require_wheel},
      {"shear", "friction angle and cohesion under a ring with lugs", "normal stress [Pa]", "shear stress [Pa]",
       evaluate_shear, require_shear},
      {"box", "friction angle and cohesion in a direct shear box", "normal stress [Pa]", "shear stress [Pa]",
       evaluate_box, require_box, variations_of_holding_bodies},
      {"repose", "angle of repose", "x [m]", "height of the surface [m]", evaluate_repose, require_repose,
       variations_of_holding_bodies},
      {"sphere",
       "drag of a dropped sphere, k and d1 of Katsuragi and Durian",
       "depth [m]",
       "(a + g) / g",
       evaluate_sphere,
       require_sphere,
       variations_of,
       false,
       {{"force k z + m v^2 / d1 describes the trajectories: R^2 at least 0.9", "R^2", 0.9, 1.0,
         "Katsuragi and Durian, Nature Phys. 3, 420 (2007)"},
        {"k d1 / (m g) sqrt(rho_b / rho_s) = 3 whatever the friction, within a factor of 1.5", "k d1 over its law", 2.0,
         4.5, "Katsuragi and Durian, PRE 87, 052208 (2013)"},
        {"depth is linear in the speed of impact: R^2 at least 0.95", "R^2 of depth linear in speed", 0.95, 1.0,
         "Goldman and Umbanhowar, PRE 77, 021308 (2008)"},
        {"time to the stop is the same at high speeds, within 10 %", "time to the stop, largest speed over the next",
         0.9, 1.1, "Goldman and Umbanhowar, PRE 77, 021308 (2008)"}}},
      {"rft",
       "stress on a plate drawn at angles beta and gamma, against resistive force theory",
       "alpha of the theory",
       "measured stress per depth [Pa/m]",
       evaluate_rft,
       require_rft,
       variations_of,
       true,
       {{"the published coefficients and one scalar: R^2 at least 0.9", "R^2", 0.9, 1.0,
         "Li, Zhang and Goldman, Science 339, 1408 (2013)"}}},
  };
  return rigs;
}

const Rig& rig_named(const std::string& name) {
  std::vector<std::string> names;
  for (const Rig& rig : all_rigs()) {
    if (rig.name == name) return rig;
    names.emplace_back(rig.name);
  }
  throw InputError(code::kUnknownRig, "footfall rig " + name + ": unknown rig." + known_names("rigs", name, names));
}

namespace {

constexpr int kRigDigits = 12;

std::string list_text(const std::vector<double>& values, double factor) {
  std::vector<std::string> texts;
  for (const double value : values) texts.push_back(number_text(factor * value, kRigDigits));
  return "[" + joined(texts, ",") + "]";
}

// c_k / 2^k.
std::string slower(std::vector<double> polynomial) {
  double factor = 1.0;
  for (double& c : polynomial) c *= factor, factor *= 0.5;
  return list_text(polynomial, 1.0);
}

RigVariation half_speed(const Scene& scene) {
  RigVariation half{"half speed", {"end_time=" + number_text(2.0 * scene.end_time, kRigDigits)}};
  const bool box = scene.particles && scene.particles->box;
  if (box && scene.particles->box->frames > 0.0)
    half.settings.push_back("particles.box.frame_interval=" +
                            number_text(2.0 * scene.particles->box->frames, kRigDigits));
  for (const JointSpec& joint : scene.joints) {
    if (!joint.motion) continue;
    const MotionSpec& motion = *joint.motion;
    const std::pair<const char*, const std::optional<TimeFunctionSpec>&> parts[] = {
        {"x", motion.x}, {"y", motion.y}, {"z", motion.z}, {"rotation", motion.rotation}};
    for (const auto& [key, f] : parts) {
      if (!f) continue;
      if (!f->table.empty() || f->amplitude != 0.0)
        throw InputError(code::kRigCheck, scene.file + ": joint \"" + joint.name +
                                              "\": --checks requires a motion that is a polynomial of time");
      if (f->polynomial.size() > 1)
        half.settings.push_back("joints." + joint.name + ".motion." + key + ".polynomial=" + slower(f->polynomial));
    }
  }
  return half;
}

std::string times(const Eigen::Vector3d& v, double factor) { return list_text({v.x(), v.y(), v.z()}, factor); }

// Throws InputError for a bed from a script.
const BoxSpec& box_to_change(const Scene& scene) {
  if (!scene.particles || !scene.particles->box)
    throw InputError(code::kRigCheck,
                     "--checks: " + scene.file + " has no [particles.box], whose bed and grains the checks change");
  return *scene.particles->box;
}

RigVariation half_grains(const BoxSpec& box) {
  return {"half grains", {"particles.box.radius=" + list_text(box.radius, 0.5)}};
}

std::vector<std::string> twice_the_bed(const BoxSpec& box) {
  std::vector<std::string> settings = {"particles.box.size=" + list_text(box.size, 2.0),
                                       "particles.box.depth=" + number_text(2.0 * box.depth, kRigDigits)};
  if (!box.pit.empty())
    append(settings, {"particles.box.pit=" + list_text(box.pit, 2.0),
                      "particles.box.pit_depth=" + number_text(2.0 * box.pit_depth, kRigDigits)});
  return settings;
}

}  // namespace

std::vector<RigVariation> variations_of(const Scene& scene, bool slow) {
  const BoxSpec& box = box_to_change(scene);
  std::vector<RigVariation> checks = {{"double box", twice_the_bed(box)}, half_grains(box)};
  if (slow) checks.push_back(half_speed(scene));
  return checks;
}

std::vector<RigVariation> variations_of_holding_bodies(const Scene& scene, bool slow) {
  const BoxSpec& box = box_to_change(scene);
  RigVariation twice{"double box", {"end_time=" + number_text(2.0 * scene.end_time, kRigDigits)}};
  for (const BodySpec& body : scene.bodies) {
    if (!body.shape) continue;
    const ShapeSpec& shape = *body.shape;
    const std::string key = "bodies." + body.name + ".";
    if (shape.kind == ShapeKind::kMesh)
      append(twice.settings, {key + "shape.scale=" + number_text(2.0 * shape.scale, kRigDigits),
                              key + "shape.position=" + times(shape.position, 2.0)});
    else  // the lid, whose weight is a part of the pressure
      append(twice.settings,
             {key + "shape.size=" + times(shape.size, 2.0), key + "shape.centre=" + times(shape.centre, 2.0),
              key + "mass=" + number_text(4.0 * body.mass, kRigDigits)});
  }
  for (const JointSpec& joint : scene.joints)
    twice.settings.push_back("joints." + joint.name + ".point=" + times(joint.point_a, 2.0));
  for (const ForceSpec& force : scene.forces)
    if (force.force)
      twice.settings.push_back("forces." + force.name + ".force.polynomial=" + list_text(force.force->polynomial, 4.0));
  append(twice.settings, twice_the_bed(box));
  for (const auto& [name, room] : {std::pair("margin", box.margin), std::pair("headroom", box.headroom)})
    if (room)
      twice.settings.push_back(std::string("particles.box.") + name + "=" + number_text(2.0 * *room, kRigDigits));
  std::vector<RigVariation> checks = {twice, half_grains(box)};
  if (slow) checks.push_back(half_speed(scene));
  return checks;
}

History history_of(const RigRun& run) {
  return read_history((std::filesystem::path(run.folder) / "history.csv").string());
}

const BodySpec& body_of(const Scene& scene, std::string_view name) {
  for (const BodySpec& body : scene.bodies)
    if (body.name == name) return body;
  throw InputError(code::kRigScene, scene.file + ": this rig requires a body named \"" + std::string(name) + "\"");
}

const ShapeSpec& mesh_of(const Scene& scene, const std::string& name, const std::string& file) {
  const BodySpec& body = body_of(scene, name);
  if (body.shape && body.shape->kind == ShapeKind::kMesh && std::filesystem::path(body.shape->file).filename() == file)
    return *body.shape;
  throw InputError(code::kRigScene, scene.file + ": body \"" + name + "\": this rig requires the mesh " + file +
                                        ", whose dimensions its pressures assume");
}

const BoxSpec& box_of(const Scene& scene) {
  if (!scene.particles || !scene.particles->box)
    throw InputError(code::kRigScene, scene.file + ": a rig requires a bed by [particles.box]");
  return *scene.particles->box;
}

double mean_surface(const RigRun& run) {
  const std::vector<double>& radius = box_of(run.scene).radius;
  return -*std::max_element(radius.begin(), radius.end());
}

double gravity_of(const RigRun& run) { return run.scene.gravity.norm(); }

double density_of_bed(const BoxSpec& box) {
  constexpr double kSolidLoose = 0.55, kSolidDense = 0.61;
  return box.material.density * (box.packing == Packing::kDense ? kSolidDense : kSolidLoose);
}

Bins binned(const std::vector<double>& x, const std::vector<double>& y, double from, double to, int count) {
  Bins bins;
  if (!(to > from)) return bins;
  std::vector<double> sum_x(count), sum_y = sum_x;
  std::vector<int> rows(count);
  for (std::size_t i = 0; i < x.size(); ++i) {
    if (x[i] < from || x[i] > to) continue;
    const auto k =
        std::min(static_cast<std::size_t>(count - 1), static_cast<std::size_t>(count * (x[i] - from) / (to - from)));
    sum_x[k] += x[i], sum_y[k] += y[i], ++rows[k];
  }
  for (std::size_t k = 0; k < rows.size(); ++k) {
    if (rows[k] == 0) continue;
    bins.x.push_back(sum_x[k] / rows[k]);
    bins.y.push_back(sum_y[k] / rows[k]);
  }
  return bins;
}

double late_mean(const History& history, const std::string& column, double from) {
  const std::vector<double>&time = history.columns.front(), &y = history.column(column);
  double sum = 0.0;
  int rows = 0;
  for (std::size_t i = 0; i < y.size(); ++i)
    if (time[i] >= from * time.back()) sum += y[i], ++rows;
  return rows > 0 ? sum / rows : std::numeric_limits<double>::quiet_NaN();
}

LineFit least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& y) {
  LineFit fit;
  fit.c = Eigen::VectorXd::Constant(A.cols(), std::numeric_limits<double>::quiet_NaN());
  fit.r_squared = std::numeric_limits<double>::quiet_NaN();
  if (A.rows() <= A.cols()) return fit;
  const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> qr(A);
  if (qr.rank() < A.cols()) return fit;
  fit.valid = true;
  fit.c = qr.solve(y);
  const double total = (y.array() - y.mean()).square().sum();
  fit.r_squared = total > 0.0 ? 1.0 - (y - A * fit.c).squaredNorm() / total : 1.0;
  return fit;
}

Eigen::Vector2d two_coefficients(const Eigen::MatrixXd& A, const Eigen::VectorXd& y) {
  if (A.rows() == 2) return A.colPivHouseholderQr().solve(y);
  const LineFit fit = least_squares(A, y);
  return fit.valid ? Eigen::Vector2d(fit.c) : Eigen::Vector2d::Constant(std::numeric_limits<double>::quiet_NaN());
}

}  // namespace footfall
