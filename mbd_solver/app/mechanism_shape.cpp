// Reads drawings (VTU) or recorded rigid motions of surfaces (CSV and STL), and returns points, triangles and lines.
#include "mbd_solver/app/mechanism_shape.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

constexpr double kThinLine = 0.006;  // radius of a line whose body has no diameter [m]

double radius_of(const Json& body) {
  const bool shaped = body.contains("shape") && body.at("shape").is_object();
  const double diameter = shaped ? body.at("shape").value("diameter", 0.0) : 0.0;
  return diameter > 0.0 ? 0.5 * diameter : kThinLine;
}

}  // namespace

RecordedMotion read_motion(const std::string& folder, const std::string& body) {
  const History history = read_history((fs::path(folder) / (body + ".csv")).string());
  RecordedMotion motion;
  motion.body = body;
  motion.time = history.column("time");
  motion.bend = history.column("bend");
  for (std::size_t k = 0; k < motion.time.size(); ++k) {
    std::vector<double>& pose = motion.pose.emplace_back();
    for (const char* name : {"x", "y", "z", "rx", "ry", "rz"}) pose.push_back(history.column(name)[k]);
    std::vector<double>& force = motion.force.emplace_back();
    for (const char* name : {"fx", "fy", "fz"}) force.push_back(history.column(name)[k]);
  }
  if (motion.time.size() < 2) throw InputError(code::kRunDamaged, folder + "/" + body + ".csv: fewer than two windows");
  return motion;
}

std::vector<std::string> recorded_bodies(const std::string& folder) {
  std::vector<std::string> bodies;
  std::error_code ignored;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, ignored))
    if (entry.path().extension() == ".csv") bodies.push_back(entry.path().stem().string());
  std::sort(bodies.begin(), bodies.end());
  return bodies;
}

Eigen::Matrix3d rotation_of(const std::vector<double>& pose) {
  const Eigen::Vector3d r(pose[3], pose[4], pose[5]);
  return r.norm() > 0.0 ? Eigen::AngleAxisd(r.norm(), r.normalized()).toRotationMatrix()
                        : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
}

std::size_t nearest(const std::vector<double>& times, double t) {
  std::size_t best = 0;
  for (std::size_t k = 1; k < times.size(); ++k)
    if (std::abs(times[k] - t) < std::abs(times[best] - t)) best = k;
  return best;
}

MechanismShapes::MechanismShapes(const std::string& run, const Json& summary) : folder_(run) {
  const std::string pvd = (fs::path(run) / "bodies.pvd").string();
  if (fs::exists(pvd)) frames_ = read_vtk_series(pvd);
  if (drawn()) {
    for (const auto& [time, file] : frames_) times_.push_back(time);
    const Json bodies = summary.contains("scene") ? summary.at("scene").value("bodies", Json::array()) : Json::array();
    for (const Json& body : bodies) {
      radii_.push_back(radius_of(body));
      names_.push_back(body.value("name", ""));
    }
    return;
  }
  const fs::path motion = fs::path(run) / "motion";
  for (const std::string& body : recorded_bodies(motion.string())) {
    Surface surface{read_motion(motion.string(), body), read_mesh((motion / (body + ".stl")).string())};
    if (surface.record.time.empty()) continue;
    if (surfaces_.empty()) times_ = surface.record.time;
    surfaces_.push_back(std::move(surface));
    names_.push_back(body);
  }
}

MechanismShape MechanismShapes::near(double t) const {
  FOOTFALL_DEMAND(!empty());
  return drawn() ? drawn_near(t) : recorded_near(t);
}

MechanismShape MechanismShapes::drawn_near(double t) const {
  MechanismShape shape;
  shape.frame = read_vtk_frame((fs::path(folder_) / frames_[nearest(times_, t)].second).string());
  Eigen::VectorXd body;
  for (const auto& [name, values] : shape.frame.cell_numbers)
    if (name == "body") body = values;
  const std::size_t triangles = shape.frame.triangles.size();
  for (std::size_t k = 0; k < shape.frame.lines.size(); ++k) {
    const auto cell = static_cast<Eigen::Index>(triangles + k);
    const std::size_t i = cell < body.size() ? static_cast<std::size_t>(body(cell)) : radii_.size();
    shape.line_radius.push_back(i < radii_.size() ? radii_[i] : kThinLine);
  }
  return shape;
}

MechanismShape MechanismShapes::recorded_near(double t) const {
  MechanismShape shape;
  std::vector<Eigen::Vector3d> points;
  std::vector<double> body;
  for (std::size_t i = 0; i < surfaces_.size(); ++i) {
    const auto& [record, mesh] = surfaces_[i];
    const std::vector<double>&from = record.pose.front(), &to = record.pose[nearest(record.time, t)];
    const Eigen::Vector3d x0(from[0], from[1], from[2]), x(to[0], to[1], to[2]);
    const Eigen::Matrix3d R = rotation_of(to);
    for (const Eigen::Vector3i& triangle : mesh.triangles) {
      shape.frame.triangles.emplace_back(triangle.array() + static_cast<int>(points.size()));
      body.push_back(static_cast<double>(i));
    }
    for (const Eigen::Vector3d& vertex : mesh.vertices) points.push_back(x + R * (vertex - x0));
  }
  shape.frame.points.resize(3, points.size());
  for (std::size_t j = 0; j < points.size(); ++j) shape.frame.points.col(j) = points[j];
  shape.frame.cell_numbers = {{"body", Eigen::Map<const Eigen::VectorXd>(body.data(), body.size())}};
  return shape;
}

}  // namespace footfall
