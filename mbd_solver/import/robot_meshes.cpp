// Meshes of a robot: found by their URI, read (STL, OBJ, PLY by the reader of scenes; COLLADA here), and cleaned of triangles
// without area and of copies, which the surface of a body cannot have.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/budget.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/fe/mesh_generator.h"
#include "mbd_solver/import/codes.h"
#include "mbd_solver/import/xml_source.h"
#include "mbd_solver/scene/mesh_reader.h"

namespace footfall {
namespace {

namespace fs = std::filesystem;

std::string ending_of(const std::string& file) {
  std::string ending = fs::path(file).extension().string();
  std::transform(ending.begin(), ending.end(), ending.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return ending;
}

std::string existing(const fs::path& path) {
  std::error_code error;
  return fs::is_regular_file(path, error) ? path.lexically_normal().string() : "";
}

// --- COLLADA: triangles of all instances of the scene, in m, z upwards.

class Collada {
 public:
  explicit Collada(const std::string& file)
      : xml_(file),
        instances_(limit::kMeshInstances, file),
        numbers_(limit::kMeshNumbers, file),
        triangles_(limit::kMeshTriangles, file) {
    for (const char* library : {"library_geometries", "library_nodes", "library_visual_scenes"})
      for (const pugi::xml_node& one : xml_.root().child(library).children()) by_id_[one.attribute("id").value()] = one;
  }

  TriangleMesh mesh() {
    const pugi::xml_node root = xml_.root();
    if (std::string(root.name()) != "COLLADA") xml_.fail(code::kRobotElement, root, "is no COLLADA file");
    const double metre = root.child("asset").child("unit").attribute("meter").as_double(1.0);
    if (!(metre > 0.0 && std::isfinite(metre)))
      xml_.fail(code::kRobotNumber, root, "has an asset unit that is no length");
    const std::string up = root.child("asset").child("up_axis").text().as_string("Y_UP");
    Eigen::Affine3d X = Eigen::Affine3d::Identity();
    // As the readers of ROS and Gazebo do: the unit counts, the upward axis counts where it is y.
    if (up == "Y_UP") X.linear() = Eigen::AngleAxisd(kPi / 2.0, Eigen::Vector3d::UnitX()).toRotationMatrix();
    X.linear() *= metre;
    const pugi::xml_node scene = referenced(root.child("scene").child("instance_visual_scene"));
    for (const pugi::xml_node& node : scene.children("node")) add_node(node, X, 0);
    return std::move(mesh_);
  }

 private:
  pugi::xml_node referenced(const pugi::xml_node& instance) const {
    const std::string url = instance.attribute("url").value();
    const auto found = url.empty() ? by_id_.end() : by_id_.find(url.substr(1));
    return found == by_id_.end() ? pugi::xml_node() : found->second;
  }

  // Numbers of a part that is there several times count each time.
  std::vector<double> list(const pugi::xml_node& node, std::size_t count) {
    const std::optional<std::vector<double>> values = numbers_of(node.text().get());
    if (values) numbers_.take(values->size());
    if (!values || (count > 0 && values->size() != count))
      xml_.fail(code::kRobotNumber, node, "has no list of " + (count > 0 ? std::to_string(count) : "") + " numbers");
    return *values;
  }

  void add_node(const pugi::xml_node& node, Eigen::Affine3d X, int depth) {
    if (depth > 50) xml_.fail(code::kRobotElement, node, "is within itself");
    instances_.take();
    for (const pugi::xml_node& part : node.children()) {
      numbers_.take();
      const std::string name = part.name();
      if (name == "matrix") {
        const std::vector<double> m = list(part, 16);
        Eigen::Affine3d M = Eigen::Affine3d::Identity();
        for (int r = 0; r < 3; ++r)
          for (int c = 0; c < 4; ++c) M(r, c) = m[4 * r + c];
        X = X * M;
      } else if (name == "translate") {
        const std::vector<double> v = list(part, 3);
        X = X * Eigen::Translation3d(v[0], v[1], v[2]);
      } else if (name == "scale") {
        const std::vector<double> v = list(part, 3);
        X = X * Eigen::Scaling(v[0], v[1], v[2]);
      } else if (name == "rotate") {
        const std::vector<double> v = list(part, 4);
        X = X * Eigen::AngleAxisd(v[3] * kPi / 180.0, Eigen::Vector3d(v[0], v[1], v[2]).normalized());
      }
    }
    for (const pugi::xml_node& instance : node.children("instance_geometry")) {
      instances_.take();
      add_geometry(referenced(instance).child("mesh"), X);
    }
    for (const pugi::xml_node& instance : node.children("instance_node")) add_node(referenced(instance), X, depth + 1);
    for (const pugi::xml_node& child : node.children("node")) add_node(child, X, depth + 1);
  }

  std::vector<Eigen::Vector3d> positions(const pugi::xml_node& mesh, const Eigen::Affine3d& X) {
    std::string id;
    for (const pugi::xml_node& input : mesh.child("vertices").children("input"))
      if (std::string(input.attribute("semantic").value()) == "POSITION") id = input.attribute("source").value();
    for (const pugi::xml_node& source : mesh.children("source")) {
      numbers_.take();
      if (id != "#" + std::string(source.attribute("id").value())) continue;
      const std::vector<double> v = list(source.child("float_array"), 0);
      const auto stride = static_cast<std::size_t>(
          std::max(3, source.child("technique_common").child("accessor").attribute("stride").as_int(3)));
      std::vector<Eigen::Vector3d> points;
      for (std::size_t k = 0; k + 3 <= v.size(); k += stride)
        points.push_back(X * Eigen::Vector3d(v[k], v[k + 1], v[k + 2]));
      return points;
    }
    return {};
  }

  void add_geometry(const pugi::xml_node& mesh, const Eigen::Affine3d& X) {
    const std::vector<Eigen::Vector3d> points = positions(mesh, X);
    const auto first = static_cast<int>(mesh_.vertices.size());
    mesh_.vertices.insert(mesh_.vertices.end(), points.begin(), points.end());
    const bool mirrored = X.linear().determinant() < 0.0;
    for (const pugi::xml_node& part : mesh.children()) {
      numbers_.take();
      const std::string name = part.name();
      if (name != "triangles" && name != "polylist" && name != "polygons") continue;
      std::size_t stride = 1, at = 0;
      for (const pugi::xml_node& input : part.children("input")) {
        const auto offset = static_cast<std::size_t>(std::clamp(input.attribute("offset").as_int(), 0, 100));
        stride = std::max(stride, offset + 1);
        if (std::string(input.attribute("semantic").value()) == "VERTEX") at = offset;
      }
      std::vector<double> counts;
      if (name == "polylist") counts = list(part.child("vcount"), 0);
      for (const pugi::xml_node& p : part.children("p")) {
        const std::vector<double> index = list(p, 0);
        std::size_t corner = 0;
        const auto add = [&](std::size_t corners) {
          std::vector<int> polygon;
          for (std::size_t k = 0; k < corners; ++k, ++corner) {
            const std::size_t entry = corner * stride + at;
            if (entry >= index.size() || !(index[entry] >= 0.0 && index[entry] < static_cast<double>(points.size())))
              xml_.fail(code::kRobotNumber, part, "names a corner that does not exist");
            polygon.push_back(first + static_cast<int>(index[entry]));
          }
          for (std::size_t k = 2; k < polygon.size(); ++k) {
            Eigen::Vector3i t(polygon[0], polygon[k - 1], polygon[k]);
            if (mirrored) std::swap(t[1], t[2]);
            triangles_.take();
            mesh_.triangles.push_back(t);
          }
        };
        if (name == "polygons") {
          add(index.size() / stride);
        } else if (name == "polylist") {
          for (const double count : counts) add(static_cast<std::size_t>(std::clamp(count, 0.0, 1e6)));
        } else {
          while ((corner + 3) * stride <= index.size()) add(3);
        }
      }
    }
  }

  XmlSource xml_;
  std::map<std::string, pugi::xml_node> by_id_;
  TriangleMesh mesh_;
  ReadBudget instances_, numbers_, triangles_;
};

// Without triangles that have no height, that are there twice, or whose two sides are.
TriangleMesh cleaned(const TriangleMesh& raw) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& x : raw.vertices) box.extend(x);
  const double across = box.diagonal().norm();
  if (!(across > 0.0) || !std::isfinite(across)) return {};
  TriangleMesh mesh = welded(raw, 1e-6 * across);
  std::set<std::array<int, 3>> seen;
  std::vector<Eigen::Vector3i> kept;
  for (const Eigen::Vector3i& t : mesh.triangles) {
    std::array<int, 3> key{t[0], t[1], t[2]};
    std::sort(key.begin(), key.end());
    const auto at = [&](int k) { return mesh.vertices[t[k]]; };
    const Eigen::Vector3d a = at(1) - at(0), b = at(2) - at(0), c = at(2) - at(1);
    const double longest = std::sqrt(std::max({a.squaredNorm(), b.squaredNorm(), c.squaredNorm()}));
    const bool needle = !(a.cross(b).norm() > 2e-6 * longest * longest);
    if (!needle && seen.insert(key).second) kept.push_back(t);
  }
  mesh.triangles = kept;
  return welded(mesh, 1e-6 * across);
}

// Folders that may hold packages and models: those that are named, of the environment, and all above the robot's own.
std::vector<fs::path> package_places(const fs::path& folder, const ImportOptions& options) {
  std::vector<fs::path> places(options.packages.begin(), options.packages.end());
  for (const char* name : {"ROS_PACKAGE_PATH", "GAZEBO_MODEL_PATH", "GZ_SIM_RESOURCE_PATH"})
    if (const char* list = std::getenv(name))
      for (const std::string& one : split(list, ':')) places.emplace_back(one);
  for (fs::path up = folder;; up = up.parent_path()) {
    places.push_back(up);
    if (!up.has_relative_path()) break;
  }
  return places;
}

}  // namespace

std::string find_model(const std::string& uri, const std::string& robot_file, const ImportOptions& options) {
  const fs::path folder = fs::absolute(robot_file).parent_path();
  const std::size_t scheme = uri.find("://");
  const fs::path path = scheme == std::string::npos ? uri : uri.substr(scheme + 3);
  std::error_code error;
  for (const fs::path& place : package_places(folder, options))
    for (const fs::path& candidate : {place / path, place / "share" / path}) {
      if (fs::is_regular_file(candidate, error)) return candidate.string();
      for (const char* config : {"model.config", "manifest.xml", "model.sdf"})
        if (fs::is_regular_file(candidate / config, error)) return candidate.string();
    }
  return "";
}

std::string find_mesh(const std::string& uri, const std::string& robot_file, const ImportOptions& options) {
  const fs::path folder = fs::absolute(robot_file).parent_path();
  const std::size_t scheme = uri.find("://");
  if (scheme == std::string::npos) return existing(fs::path(uri).is_absolute() ? fs::path(uri) : folder / uri);
  const std::string kind = uri.substr(0, scheme), path = uri.substr(scheme + 3);
  if (kind == "file") {
    const std::string found = existing(path);
    return found.empty() ? existing(folder / path) : found;
  }
  if (kind != "package" && kind != "model") return "";
  const std::string package = path.substr(0, path.find('/'));
  const std::string inside = package.size() < path.size() ? path.substr(package.size() + 1) : "";
  for (const fs::path& place : package_places(folder, options)) {
    for (const fs::path& candidate : {place / path, place / "share" / path})
      if (const std::string found = existing(candidate); !found.empty()) return found;
    if (place.filename() == package || fs::exists(place / "package.xml") || fs::exists(place / "model.config"))
      if (const std::string found = existing(place / inside); !found.empty()) return found;
  }
  return "";
}

TriangleMesh geometry_mesh(const RobotGeometry& g) {
  const double edge = g.radius > 0.0 ? 0.6 * g.radius : 0.0;
  switch (g.kind) {
    case GeometryKind::kBox: return box_mesh(g.size, g.size.maxCoeff());
    case GeometryKind::kSphere: return sphere_mesh(g.radius, edge);
    case GeometryKind::kCylinder: {
      const Eigen::Vector3d end(0.0, 0.0, 0.5 * g.length);
      return cylinder_mesh(-end, end, 2.0 * g.radius, std::max(edge, g.length));
    }
    case GeometryKind::kCapsule: {
      BodySpec body;
      ShapeSpec shape;
      shape.kind = ShapeKind::kCapsule;
      shape.from = Eigen::Vector3d(0.0, 0.0, -0.5 * g.length);
      shape.to = -shape.from;
      shape.diameter = 2.0 * g.radius;
      body.shape = shape;
      SurfaceSpec surface;
      surface.element_size = edge;
      return shape_surface(body, surface);
    }
    case GeometryKind::kMesh: break;
  }
  TriangleMesh mesh = g.mesh;
  if (mesh.triangles.empty()) mesh = ending_of(g.file) == ".dae" ? Collada(g.file).mesh() : read_mesh(g.file);
  for (Eigen::Vector3d& x : mesh.vertices) x = x.cwiseProduct(g.scale);
  if (g.scale.prod() < 0.0)
    for (Eigen::Vector3i& t : mesh.triangles) std::swap(t[1], t[2]);
  const std::size_t before = mesh.triangles.size();
  TriangleMesh result = cleaned(mesh);
  if (result.triangles.empty())
    throw InputError(code::kRobotElement, g.file + ": has no triangles of a surface; export it again");
  if (result.triangles.size() < before)
    result.notes.push_back(std::to_string(before - result.triangles.size()) + " triangles without area or given twice");
  return result;
}

}  // namespace footfall
