// Writes a robot as a scene: one entry per link, joint, gear and motor, with its line in the file; meshes in the same
// folder. Numbers have as many digits as needed to be read back unchanged.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "coupler/base/files.h"
#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/robot.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

// Stops are so stiff that the supported mass swings at this frequency [Hz].
constexpr double kStopFrequency = 50.0;
// A motor of --hold: its loop swings at this frequency [Hz] with this damping ratio.
constexpr double kHoldFrequency = 5.0, kHoldDamping = 0.7;
constexpr double kGrains = 6000.0;        // of the bed of --ground, about
constexpr double kDepthInRadii = 10.0;    // of this bed
constexpr std::size_t kMostPairs = 1500;  // entries of bodies that do not touch each other
constexpr std::size_t kManyTriangles = 20000;
constexpr const char* kUnsetSignal = "W0667";  // the warning that no program sets a signal of kind host
constexpr std::size_t kMostLines = 6;          // of a group of the printed list

std::string number(double value) {
  if (value == 0.0) return "0";
  char text[40];
  const std::to_chars_result result = std::to_chars(text, text + sizeof text, value);
  return std::string(text, result.ptr);
}

template <class Vector>
std::string list(const Vector& values) {
  std::string text = "[", between;
  for (const double value : values) {
    text += between + number(value);
    between = ", ";
  }
  return text + "]";
}

std::string toml_text(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    const auto code = static_cast<unsigned char>(c);
    result += code < 32 || code == 127 ? ' ' : c;
  }
  return result + "\"";
}

// For a comment: one line.
std::string one_line(std::string text) {
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
  return text;
}

std::string orientation(const Eigen::Matrix3d& R) {
  const Eigen::Quaterniond q(R);
  return "{ quaternion = " + list(Eigen::Vector4d(q.w(), q.x(), q.y(), q.z())) + " }";
}
bool is_identity(const Eigen::Matrix3d& R) { return R == Eigen::Matrix3d::Identity(); }

// The edges of a box along the axes of L, if it lies along them.
std::optional<Eigen::Vector3d> aligned_size(const RobotGeometry& box) {
  const Eigen::Matrix3d R = box.X_LG.R.cwiseAbs();
  Eigen::Vector3d size;
  for (int r = 0; r < 3; ++r) {
    Eigen::Index largest = 0;
    if (R.row(r).maxCoeff(&largest) < 1.0 - 1e-12) return std::nullopt;
    size[r] = box.size[largest];
  }
  return size;
}

std::string obj_text(const TriangleMesh& mesh, const std::string& what) {
  std::string text = "# " + what + "\n";
  char line[128];
  for (const Eigen::Vector3d& x : mesh.vertices) {
    std::snprintf(line, sizeof line, "v %.9g %.9g %.9g\n", x[0], x[1], x[2]);
    text += line;
  }
  for (const Eigen::Vector3i& t : mesh.triangles) {
    std::snprintf(line, sizeof line, "f %d %d %d\n", t[0] + 1, t[1] + 1, t[2] + 1);
    text += line;
  }
  return text;
}

class Writer {
 public:
  Writer(Robot& robot, const ImportOptions& options, const std::optional<RobotBed>& bed)
      : robot_(robot), options_(options), bed_(bed), moved_(robot), mesh_bytes_(limit::kRobotMeshes, robot.file) {
    for (const RobotDrive& drive : robot_.drives) driven_.insert({drive.joint, drive.coordinate});
    for (const RobotGear& gear : robot_.gears)
      if (!gear.joints.empty()) driven_.insert({gear.joints[0], gear.coordinates[0]});
  }

  std::vector<SceneFile> write() {
    for (std::size_t k = 0; k < robot_.links.size(); ++k) add_body(static_cast<int>(k));
    for (std::size_t k = 0; k < robot_.joints.size(); ++k) add_joint(static_cast<int>(k));
    for (const RobotGear& gear : robot_.gears) add_gear(gear);
    add_drives();
    add_ground();
    add_start();
    // A run from the command line would warn of each such signal.
    if (!signals_.empty())
      rest_ += concat("\n[accepted]\n", kUnsetSignal,
                      " = \"a program that leads the run sets the commands of motors (--host)\"\n");
    std::vector<SceneFile> files = {{"scene.toml", head() + bodies_ + joints_ + gears_ + drives_ + signals_ +
                                                       boundaries_ + contacts() + rest_ + not_taken()}};
    for (auto& [name, content] : meshes_) files.push_back({name, std::move(content)});
    return files;
  }

 private:
  std::string from(const Origin& origin, const std::string& what) const {
    return "  # " + one_line(concat(fs::path(origin.file).filename().string(), ":", origin.line, " ", what)) + "\n";
  }

  std::string head() const {
    std::ostringstream text;
    text << "# " << one_line(robot_.name) << ", a " << robot_.format << " robot of "
         << one_line(fs::path(robot_.file).filename().string())
         << ", as `footfall import` reads it. Edit it as any scene; FILE:LINE is where a part comes from.\n"
         << "# Bodies have the axes of their links. Coordinates are zero as drawn"
         << (robot_.drawn.empty() ? "" : " (" + robot_.drawn + ")") << ".\n"
         << "title = " << toml_text(robot_.name.empty() ? "robot" : robot_.name) << "\n"
         << "end_time = 1.0                        # s\n"
         << "gravity = " << list(robot_.gravity) << "\n";
    return text.str();
  }

  // --- Bodies, and their parts that touch something.

  void add_body(int index) {
    const RobotLink& link = robot_.links[index];
    const Eigen::Matrix3d& I = link.inertia;
    std::ostringstream text;
    text << "\n[[bodies]]"
         << from(link.origin, "link " + toml_text(link.label) + (link.remark.empty() ? "" : ": " + link.remark))
         << "name = " << toml_text(link.name) << "\nmass = " << number(link.mass)
         << "\ninertia = " << list(std::vector<double>{I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(1, 2), I(2, 0)})
         << "\nposition = " << list(Eigen::Vector3d(link.X_DL * link.centre)) << "\n";
    if (!is_identity(link.X_DL.R)) text << "orientation = " << orientation(link.X_DL.R) << "\n";
    std::vector<RobotGeometry> parts = options_.bare ? std::vector<RobotGeometry>() : with_files(link, link.collisions);
    const bool touches = !parts.empty();
    if (!touches && link.visuals.size() == 1 && link.visuals[0].kind != GeometryKind::kMesh) parts = link.visuals;
    const std::string shape = parts.size() == 1 ? shape_of(link, parts[0]) : "";
    if (!shape.empty())
      text << "shape = " << shape << (touches ? "" : from(parts[0].origin, "for pictures"))
           << (touches ? from(parts[0].origin, "collision") : "");
    bodies_ += text.str();
    if (touches) add_boundary(link, parts, !shape.empty());
  }

  // Without meshes that are not there, or cannot be read; each gets its triangles.
  std::vector<RobotGeometry> with_files(const RobotLink& link, const std::vector<RobotGeometry>& all) {
    std::vector<RobotGeometry> usable;
    for (const RobotGeometry& g : all)
      if (g.kind != GeometryKind::kMesh || !g.file.empty() || !g.mesh.triangles.empty())
        usable.push_back(g);
      else
        robot_.leave_out(
            g.origin,
            "collision mesh " + toml_text(g.name.empty() ? g.file : g.name) + " of link " + toml_text(link.label),
            "there is no such file; give its folder with --package");
    return usable;
  }

  std::string shape_of(const RobotLink& link, const RobotGeometry& g) const {
    const RigidFrame X = link.X_DL * g.X_LG;
    const Eigen::Vector3d half = X.R.col(2) * (0.5 * g.length);
    switch (g.kind) {
      case GeometryKind::kBox: {
        const std::optional<Eigen::Vector3d> size = aligned_size(g);
        if (!size) return "";
        return "{ kind = \"box\", size = " + list(*size) + ", centre = " + list(X.p) + " }";
      }
      case GeometryKind::kSphere:
        return "{ kind = \"sphere\", radius = " + number(g.radius) + ", centre = " + list(X.p) + " }";
      case GeometryKind::kCylinder:
        return "{ kind = \"cylinder\", radius = " + number(g.radius) + ", length = " + number(g.length) +
               ", centre = " + list(X.p) + ", axis = " + list(Eigen::Vector3d(X.R.col(2))) + " }";
      case GeometryKind::kCapsule:
        return "{ kind = \"capsule\", from = " + list(Eigen::Vector3d(X.p - half)) +
               ", to = " + list(Eigen::Vector3d(X.p + half)) + ", diameter = " + number(2.0 * g.radius) + " }";
      case GeometryKind::kMesh: break;
    }
    return "";
  }

  // Its triangles in L, of all parts that can be read; the box of the robot grows by them.
  TriangleMesh joined_parts(const RobotLink& link, const std::vector<RobotGeometry>& parts) {
    TriangleMesh all;
    for (const RobotGeometry& g : parts) {
      TriangleMesh mesh;
      std::error_code none;
      const std::uintmax_t bytes = g.file.empty() ? 0 : fs::file_size(g.file, none);
      if (!none) mesh_bytes_.take(bytes);
      try {
        mesh = geometry_mesh(g);
      } catch (const InputError& error) {
        robot_.leave_out(g.origin, "collision mesh of link " + toml_text(link.label), error.what());
        continue;
      }
      const auto first = static_cast<int>(all.vertices.size());
      for (const Eigen::Vector3d& x : mesh.vertices) {
        all.vertices.push_back(g.X_LG * x);
        box_.extend(link.X_DL * all.vertices.back());
      }
      for (const Eigen::Vector3i& t : mesh.triangles) all.triangles.emplace_back(t.array() + first);
      for (const std::string& note : mesh.notes)
        robot_.leave_out(g.origin, "collision mesh of link " + toml_text(link.label) + ": " + note, "are left out");
    }
    return all;
  }

  void add_boundary(const RobotLink& link, const std::vector<RobotGeometry>& parts, bool shaped) {
    const std::size_t before = robot_.not_taken.size();
    const TriangleMesh mesh = joined_parts(link, parts);
    if (mesh.triangles.empty()) return;
    const std::string remark =
        from(parts[0].origin, parts.size() == 1 ? "collision" : concat(parts.size(), " collisions"));
    bounded_.push_back(static_cast<int>(&link - robot_.links.data()));
    boundaries_ += "\n[[boundaries]]" + remark + "body = " + toml_text(link.name) + "\n";
    if (shaped) {
      boundaries_ += "surface = {}\n";
      return;
    }
    if (mesh.triangles.size() > kManyTriangles)
      robot_.leave_out(
          parts[0].origin, "collision meshes of link " + toml_text(link.label),
          concat("are taken, but have ", mesh.triangles.size(), " triangles; a coarser mesh makes runs faster"));
    const RobotGeometry& g = parts[0];
    const bool whole = robot_.not_taken.size() == before && g.mesh.triangles.empty();
    const std::string ending = fs::path(g.file).extension().string();
    const bool even = g.scale[0] > 0.0 && g.scale[0] == g.scale[1] && g.scale[0] == g.scale[2];
    if (parts.size() == 1 && g.kind == GeometryKind::kMesh && whole && even &&
        (ending == ".stl" || ending == ".obj" || ending == ".ply")) {
      const RigidFrame X = link.X_DL * g.X_LG;
      add_surface(copied(g.file), g.scale[0], X);
      return;
    }
    const std::string name = "meshes/" + link.name + ".obj";
    meshes_[name] = obj_text(mesh, "surface of " + link.name + " in the axes of the link, in m");
    add_surface(name, 1.0, link.X_DL);
  }

  void add_surface(const std::string& file, double scale, const RigidFrame& X) {
    boundaries_ += "[boundaries.surface]\nfile = " + toml_text(file) + "\n";
    if (scale != 1.0) boundaries_ += "scale = " + number(scale) + "\n";
    if (!X.p.isZero(0.0)) boundaries_ += "position = " + list(X.p) + "\n";
    if (!is_identity(X.R)) boundaries_ += "orientation = " + orientation(X.R) + "\n";
  }

  // A copy in the folder of meshes, made once.
  std::string copied(const std::string& file) {
    const auto known = copies_.find(file);
    if (known != copies_.end()) return known->second;
    std::string stem;
    for (const char c : fs::path(file).stem().string().substr(0, 80))
      stem += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
    const std::string ending = fs::path(file).extension().string();
    std::string name = "meshes/" + stem + ending;
    for (int k = 2; meshes_.count(name) > 0; ++k) name = concat("meshes/", stem, "_", k, ending);
    meshes_[name] = read_whole_file(file).value_or("");
    return copies_[file] = name;
  }

  // --- Joints.

  void add_joint(int index) {
    const RobotJoint& joint = robot_.joints[index];
    const auto body = [&](int link) { return link < 0 ? std::string("ground") : robot_.links[link].name; };
    constexpr const char* kTypes[] = {"fixed",  "revolute",  "prismatic", "cylindrical",
                                      "planar", "spherical", "universal"};
    std::ostringstream text;
    text << "\n[[joints]]"
         << from(joint.origin, "joint " + toml_text(joint.label) + (joint.remark.empty() ? "" : ": " + joint.remark))
         << "name = " << toml_text(joint.name) << "\nkind = \"" << kTypes[static_cast<int>(joint.kind)]
         << "\"\nbodies = [" << toml_text(body(joint.parent)) << ", " << toml_text(body(joint.child))
         << "]\npoint = " << list(joint.point) << "\n";
    if (joint.kind != RobotJointKind::kFixed && joint.kind != RobotJointKind::kSpherical)
      text << "axis = " << list(joint.axis) << "\n";
    if (joint.kind == RobotJointKind::kPlanar || joint.kind == RobotJointKind::kUniversal)
      text << "axis2 = " << list(joint.axis2) << "\n";
    for (const RobotCoordinate& q : joint.coordinates) {
      const std::string laws = laws_of(joint, q);
      if (!laws.empty()) text << "[joints." << q.name << "]\n" << laws;
    }
    joints_ += text.str();
  }

  double inertia_of(const RobotJoint& joint, const RobotCoordinate& q) const {
    return std::max(1e-9, moved_.beyond(joint, q.name != "angle") + q.armature);
  }

  // Angles beyond one turn in degrees: a scene warns of so many radians.
  static std::string coordinate_entry(const std::string& key, const RobotCoordinate& q, double value) {
    const double x = value - q.zero;
    if (q.name != "angle" || std::abs(x) <= 2.0 * kPi) return key + " = " + number(x);
    return key + "_deg = " + number(x * 180.0 / kPi);
  }

  std::string laws_of(const RobotJoint& joint, const RobotCoordinate& q) const {
    std::string text;
    if (q.lower || q.upper) {
      const double omega = 2.0 * kPi * kStopFrequency;
      const double stiffness = std::max(inertia_of(joint, q) * omega * omega, 100.0 * q.effort);
      text += "stops = {";
      if (q.lower) text += " " + coordinate_entry("min", q, *q.lower) + ",";
      if (q.upper) text += " " + coordinate_entry("max", q, *q.upper) + ",";
      text += " stiffness = " + number_text(stiffness, 3) + " }\n";
    }
    if (q.friction > 0.0) {
      text += "friction = { coulomb = " + number(q.friction);
      if (q.damping > 0.0) text += ", viscous = " + number(q.damping);
      text += " }\n";
    }
    const bool damper = q.damping > 0.0 && !(q.friction > 0.0);
    if (q.stiffness > 0.0 || damper) {
      text += "spring = {";
      if (q.stiffness > 0.0) text += " stiffness = " + number(q.stiffness) + ", " + coordinate_entry("rest", q, q.rest);
      if (damper) text += concat(q.stiffness > 0.0 ? "," : "", " damping = ", number(q.damping));
      text += " }\n";
    }
    return text;
  }

  void add_gear(const RobotGear& gear) {
    std::ostringstream text;
    text << "\n[[gears]]" << from(gear.origin, toml_text(gear.label)) << "name = " << toml_text(gear.name)
         << "\njoints = [";
    for (std::size_t k = 0; k < gear.joints.size(); ++k)
      text << (k > 0 ? ", " : "") << toml_text(robot_.joints[gear.joints[k]].name);
    text << "]\ncoordinates = [";
    for (std::size_t k = 0; k < gear.coordinates.size(); ++k)
      text << (k > 0 ? ", " : "") << toml_text(gear.coordinates[k]);
    text << "]\nfactors = " << list(gear.factors) << "\n";
    if (!gear.curve.empty()) {
      text << "curve = [";
      for (std::size_t k = 0; k < gear.curve.size(); ++k) text << (k > 0 ? ", " : "") << list(gear.curve[k]);
      text << "]\n";
    }
    gears_ += text.str();
  }

  // --- Motors.

  const RobotCoordinate* coordinate(int joint, const std::string& name) const {
    for (const RobotCoordinate& q : robot_.joints[joint].coordinates)
      if (q.name == name) return &q;
    return nullptr;
  }

  void add_drives() {
    std::set<std::pair<int, std::string>> with_rotor;
    for (RobotDrive& drive : robot_.drives) {
      const RobotCoordinate* q = coordinate(drive.joint, drive.coordinate);
      if (q == nullptr) continue;
      if (with_rotor.insert({drive.joint, drive.coordinate}).second) drive.rotor_inertia += q->armature;
      if (drive.kind == RobotDriveKind::kPosition) drive.command -= q->zero;
      add_drive(drive, "motor " + toml_text(drive.label) + (drive.remark.empty() ? "" : ": " + drive.remark));
    }
    for (std::size_t k = 0; k < robot_.joints.size(); ++k)
      for (const RobotCoordinate& q : robot_.joints[k].coordinates) {
        const int joint = static_cast<int>(k);
        const bool held = options_.hold && !q.without_effort && driven_.count({joint, q.name}) == 0;
        const bool rotor = q.armature > 0.0 && with_rotor.count({joint, q.name}) == 0;
        if (!held && !rotor) continue;
        RobotDrive drive;
        drive.origin = robot_.joints[k].origin;
        drive.name = robot_.joints[k].name + (held ? "_hold" : "_rotor") +
                     (robot_.joints[k].coordinates.size() > 1 ? "_" + q.name : "");
        drive.joint = joint;
        drive.coordinate = q.name;
        drive.rotor_inertia = q.armature;
        if (held) {
          const double omega = 2.0 * kPi * kHoldFrequency, moved = inertia_of(robot_.joints[k], q);
          drive.kind = RobotDriveKind::kPosition;
          drive.command = q.start.value_or(q.zero) - q.zero;
          drive.kp = read_number(number_text(std::max(moved * omega * omega, 20.0 * q.effort), 3).c_str(), nullptr);
          drive.kd = read_number(number_text(2.0 * kHoldDamping * std::sqrt(drive.kp * moved), 3).c_str(), nullptr);
          if (q.effort > 0.0) drive.max_torque = q.effort;
        }
        add_drive(drive, held ? "held where it starts: gains assumed by --hold" : "armature of the joint");
      }
  }

  void add_drive(const RobotDrive& drive, const std::string& remark) {
    constexpr const char* kNames[] = {"torque", "speed", "position"};
    std::ostringstream text;
    text << "\n[[drives]]" << from(drive.origin, remark) << "name = " << toml_text(drive.name) << "\nkind = \""
         << kNames[static_cast<int>(drive.kind)] << "\"\njoint = " << toml_text(robot_.joints[drive.joint].name)
         << "\n";
    if (robot_.joints[drive.joint].coordinates.size() > 1)
      text << "coordinate = " << toml_text(drive.coordinate) << "\n";
    if (options_.host) {
      text << "command = { signal = " << toml_text(drive.name) << " }\n";
      signals_ += "\n[[signals]]\nname = " + toml_text(drive.name) + "\nkind = \"host\"\n";
      if (drive.command != 0.0) signals_ += "initial = " + number(drive.command) + "\n";
    } else {
      text << "command = { polynomial = [" << number(drive.command) << "] }\n";
    }
    if (drive.kp > 0.0) text << "kp = " << number(drive.kp) << "\n";
    if (drive.kd > 0.0) text << "kd = " << number(drive.kd) << "\n";
    if (drive.max_torque)
      text << (drive.coordinate == "angle" ? "max_torque = " : "max_force = ") << number(*drive.max_torque) << "\n";
    if (drive.max_speed > 0.0 && drive.max_torque) text << "max_speed = " << number(drive.max_speed) << "\n";
    if (drive.rotor_inertia > 0.0) text << "rotor_inertia = " << number(drive.rotor_inertia) << "\n";
    drives_ += text.str();
  }

  // --- Pairs of bodies that pass through each other.

  // The first ones of the list; how many there are follows from their numbers, as there may be millions.
  std::string contacts() {
    std::vector<char> bounded(robot_.links.size(), 0);
    for (const int link : bounded_) bounded[link] = 1;
    const auto meet = [&](int a, int b) { return a >= 0 && b >= 0 && a != b && bounded[a] && bounded[b]; };
    std::set<std::pair<int, int>> jointed;
    for (const RobotJoint& joint : robot_.joints)
      if (meet(joint.parent, joint.child)) jointed.insert(std::minmax(joint.parent, joint.child));
    std::string text;
    std::size_t pairs = 0;
    const auto write = [&](const std::pair<int, int>& pair) {
      if (jointed.count(pair) > 0 || ++pairs > kMostPairs) return;
      text += "\n[[contacts]]\nbetween = [" + toml_text(robot_.links[pair.first].name) + ", " +
              toml_text(robot_.links[pair.second].name) + "]\nignore = true\n";
    };
    if (robot_.touches_itself) {
      std::vector<std::pair<int, int>> apart;
      for (const auto& [a, b] : robot_.apart)
        if (meet(a, b)) apart.push_back(std::minmax(a, b));
      std::sort(apart.begin(), apart.end());
      apart.erase(std::unique(apart.begin(), apart.end()), apart.end());
      for (const auto& pair : apart) write(pair);
    } else {
      for (std::size_t i = 0; i < bounded_.size() && pairs <= kMostPairs; ++i)
        for (std::size_t k = i + 1; k < bounded_.size() && pairs <= kMostPairs; ++k)
          write(std::minmax(bounded_[i], bounded_[k]));
      if (pairs > kMostPairs) pairs = bounded_.size() * (bounded_.size() - 1) / 2 - jointed.size();
    }
    if (pairs > kMostPairs) {
      robot_.leave_out({robot_.file, 1}, concat(pairs, " pairs of links that do not touch each other"),
                       concat("are too many for a scene: the first ", kMostPairs, " are there"));
    }
    return text.empty() ? "" : "\n# Links that pass through each other" + text;
  }

  // --- Ground and start.

  // A bed below the whole robot.
  RobotBed first_bed(double longer) const {
    RobotBed bed;
    const Eigen::Vector3d extent = box_.sizes();
    for (int axis = 0; axis < 2; ++axis) {
      bed.size[axis] = 1.3 * std::max(extent[axis], 0.4 * longer);
      bed.centre[axis] = box_.center()[axis];
    }
    bed.depth = std::sqrt(0.6 * kDepthInRadii * bed.size.prod() / (4.0 / 3.0 * kPi * kGrains)) * kDepthInRadii;
    return bed;
  }

  // The heights of the file, counted from its origin, with their map in the folder of meshes.
  std::string terrain(const RobotMap& map) {
    std::string points = "# x y z of " + one_line(map.label) + " [m]\n";
    for (Eigen::Index row = 0; row < map.y.size(); ++row)
      for (Eigen::Index column = 0; column < map.x.size(); ++column)
        points += number_text(map.x[column], 9) + " " + number_text(map.y[row], 9) + " " +
                  number_text(map.heights(row, column), 9) + "\n";
    meshes_["meshes/heights.xyz"] = std::move(points);
    return "[ground.terrain.map]" + from(map.origin, map.label) + "file = \"meshes/heights.xyz\"\norigin = [0, 0, 0]\n";
  }

  void add_ground() {
    std::ostringstream text;
    std::string kind = options_.ground;
    if (kind.empty() && (robot_.plane || robot_.map) && !bounded_.empty()) kind = "plane";
    if (kind.empty()) return;
    if (bounded_.empty())
      throw InputError(code::kRobotGround, robot_.file,
                       ":1: nothing of the robot can touch a ground: it has no collision geometry that can be read; "
                       "import it without --ground");
    const bool of_file = options_.ground.empty();
    if (kind == "plane") {
      double friction = robot_.plane_friction.value_or(0.0);
      if (!robot_.plane_friction)
        for (const RobotLink& link : robot_.links) friction = std::max(friction, link.friction.value_or(0.0));
      text << "\n[ground]\nkind = \"plane\"\n[ground.plane]\n";
      if (of_file && !robot_.map && robot_.plane_height != 0.0)
        text << "point = [0, 0, " << number(robot_.plane_height) << "]\n";
      text << "young_MPa = 10                        # assumed\nrestitution = 0.3                     # assumed\n"
              "impact_speed = 1.0                    # m/s, assumed\n";
      if (friction > 0.0) text << "friction = " << number(friction) << "\n";
      if (of_file && robot_.map) text << terrain(*robot_.map);
    } else {
      const Eigen::Vector3d extent = box_.sizes();
      const double longer = std::max({extent[0], extent[1], 0.3 * extent[2]});
      const RobotBed bed = bed_.value_or(first_bed(longer));
      // The simulation box contains the parts of the robot outside the bed.
      double margin = 0.5 * longer;
      for (int axis = 0; axis < 2; ++axis) {
        const double farthest = std::max(box_.max()[axis] - bed.centre[axis], bed.centre[axis] - box_.min()[axis]);
        margin = std::max(margin, farthest - 0.5 * bed.size[axis] + 0.2 * longer);
      }
      text << "\n[ground]\nkind = \"particles\"\n";
      if (kind != "grains") text << "[particles]\nsoil = " << toml_text(kind) << "\n";
      text << "[particles.box]                       # below the robot, of about " << number_text(kGrains)
           << " grains: as small as the bodies allow that touch it where they start\nsize = ["
           << number_text(bed.size[0], 3) << ", " << number_text(bed.size[1], 3)
           << "]\ndepth = " << number_text(bed.depth, 3) << "\nradius = " << number_text(bed.radius(), 3)
           << "\ncentre = [" << number_text(bed.centre[0], 3) << ", " << number_text(bed.centre[1], 3)
           << "]\nheadroom = " << number_text(1.5 * extent[2] + 0.5 * longer, 3)
           << "\nmargin = " << number_text(margin, 3) << "\nframe_interval = 0.05\n";
    }
    rest_ += text.str();
    if (of_file) return;
    const double gap = 1e-3 * box_.sizes().maxCoeff();
    const bool held = std::any_of(robot_.joints.begin(), robot_.joints.end(), [](const RobotJoint& joint) {
      return joint.parent < 0 && joint.kind == RobotJointKind::kFixed;
    });
    if (held)  // A base remains where it is while its joints start elsewhere. z = 0 is the ground.
      initial_ += "position = [0, 0, " + number_text(gap - box_.min().z(), 4) +
                  "]             # m: the lowest point as drawn is above the ground\n";
    else
      initial_ += "clearance = " + number_text(gap, 2) + "\n";
  }

  void add_start() {
    std::string joints, velocities;
    for (const RobotLink& link : robot_.links) {
      if (!link.velocity || !link.angular_velocity) continue;
      const Eigen::Vector3d v = *link.velocity + link.angular_velocity->cross(link.X_DL.R * link.centre);
      velocities += "[[initial.bodies]]\nbody = " + toml_text(link.name) + "\nvelocity = " + list(v) +
                    "\nangular_velocity = " + list(*link.angular_velocity) + "\n";
    }
    // A coordinate that is not given is free: where one starts elsewhere, those at zero are given, too.
    bool moved = false;
    for (const RobotJoint& joint : robot_.joints)
      for (const RobotCoordinate& q : joint.coordinates) moved = moved || (q.start && *q.start != q.zero);
    for (const RobotJoint& joint : robot_.joints) {
      std::string values;
      for (const RobotCoordinate& q : joint.coordinates)
        if (q.start && moved) values += q.name + " = " + number(*q.start - q.zero) + "\n";
      if (!values.empty()) joints += "[initial.joints." + joint.name + "]\n" + values;
    }
    if (!initial_.empty() || !joints.empty() || !velocities.empty())
      rest_ += "\n[initial]\n" + initial_ + joints + velocities;
  }

  std::string not_taken() const {
    if (robot_.not_taken.empty()) return "";
    std::string text = "\n# Not in this scene, or otherwise than in the file:\n";
    for (const std::string& line : not_taken_lines(robot_, true, true)) text += "#   " + one_line(line) + "\n";
    return text;
  }

  Robot& robot_;
  const ImportOptions& options_;
  const std::optional<RobotBed> bed_;
  const MovedInertias moved_;
  std::set<std::pair<int, std::string>> driven_;  // coordinates that a motor or gear moves
  std::string bodies_, joints_, gears_, drives_, signals_, boundaries_, rest_, initial_;
  std::vector<int> bounded_;  // links with a boundary
  Eigen::AlignedBox3d box_;   // of all surfaces in D
  std::map<std::string, std::string> meshes_, copies_;
  ReadBudget mesh_bytes_;  // that are read
};

}  // namespace

// 60 % of the bed are grains.
double RobotBed::radius() const { return std::cbrt(0.6 * size.prod() * depth / (4.0 / 3.0 * kPi * kGrains)); }

std::vector<std::string> not_taken_lines(const Robot& robot, bool looks, bool names_only) {
  std::vector<const NotTaken*> all;
  for (const NotTaken& one : robot.not_taken)
    if (looks || !one.looks) all.push_back(&one);
  std::stable_sort(all.begin(), all.end(), [](const NotTaken* a, const NotTaken* b) {
    return std::tie(a->origin.file, a->origin.line) < std::tie(b->origin.file, b->origin.line);
  });
  const auto file_of = [&](const NotTaken& one) {
    return names_only ? fs::path(one.origin.file).filename().string() : one.origin.file;
  };
  // Two remarks are of the same kind if they differ in names and values alone, for the same reason.
  const auto kind_of = [](const NotTaken& one) {
    std::string kind;
    bool quoted = false;
    for (const char c : one.what) {
      if (c == '"') quoted = !quoted;
      if (!quoted) kind += c;
    }
    return kind + "\n" + one.why;
  };
  std::map<std::string, std::size_t> places;
  std::vector<std::vector<const NotTaken*>> groups;
  for (const NotTaken* one : all) {
    const auto [place, added] = places.try_emplace(file_of(*one) + "\n" + kind_of(*one), groups.size());
    if (added) groups.emplace_back();
    groups[place->second].push_back(one);
  }
  std::vector<std::string> lines;
  for (const std::vector<const NotTaken*>& group : groups) {
    const NotTaken& first = *group.front();
    std::string line = concat(file_of(first), ":", first.origin.line, ": ", first.what, ": ", first.why);
    std::string more;
    for (std::size_t k = 1; k < group.size(); ++k)
      if (names_only || k <= kMostLines) more += (k > 1 ? ", " : "") + std::to_string(group[k]->origin.line);
    if (group.size() > 1)
      line += concat(" (and ", group.size() - 1, " more, in ", group.size() > 2 ? "lines " : "line ", more,
                     !names_only && group.size() > kMostLines + 1 ? " ..." : "", ")");
    lines.push_back(std::move(line));
  }
  return lines;
}

std::vector<SceneFile> write_robot_scene(Robot& robot, const ImportOptions& options,
                                         const std::optional<RobotBed>& bed) {
  if (!options.ground.empty() && options.ground != "plane" && options.ground != "grains") {
    std::vector<std::string> soils = shipped_tables("inputs/soils");
    soils.insert(soils.end(), {"plane", "grains"});
    std::sort(soils.begin(), soils.end());
    if (std::find(soils.begin(), soils.end(), options.ground) == soils.end())
      throw InputError(code::kRobotGround, "--ground ", options.ground, ": expected a plane, grains or a soil.",
                       known_names("grounds", options.ground, soils));
  }
  return Writer(robot, options, bed).write();
}

}  // namespace footfall
