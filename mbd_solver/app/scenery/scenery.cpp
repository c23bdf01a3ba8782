// The script is read as the checks of a scene read it; what cannot be read is left out with a note.
#include "mbd_solver/app/scenery/scenery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <filesystem>
#include <set>

#include "coupler/base/errors.h"
#include "mbd_solver/app/packed_series.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {

namespace {

constexpr std::size_t kMostTriangles = 200000;  // of all meshes of a page

// Where LIGGGHTS puts the mesh of this command: scale, move and rotate in their order. Nothing where only LIGGGHTS can compute it.
std::optional<Eigen::Affine3d> placement_of(const ScriptCommand& command) {
  Eigen::Affine3d place = Eigen::Affine3d::Identity();
  const std::vector<std::string>& words = command.words;
  const auto numbers = [&](std::size_t from, std::size_t count, std::vector<double>& values) {
    values.clear();
    for (std::size_t k = from; k < from + count; ++k) {
      const std::optional<double> value = k < words.size() ? as_number(words[k]) : std::nullopt;
      if (!value) return false;
      values.push_back(*value);
    }
    return true;
  };
  std::vector<double> v;
  for (std::size_t i = 6; i < words.size(); ++i) {
    if (words[i] == "scale") {
      if (!numbers(i + 1, 1, v)) return std::nullopt;
      place = Eigen::Scaling(v[0]) * place;
    } else if (words[i] == "move") {
      if (!numbers(i + 1, 3, v)) return std::nullopt;
      place = Eigen::Translation3d(v[0], v[1], v[2]) * place;
    } else if (words[i] == "rotate") {
      // rotate axis X Y Z angle DEGREES, or the angle first
      std::vector<double> axis, angle;
      for (std::size_t k = i + 1; k < std::min(i + 7, words.size()); ++k) {
        if (words[k] == "axis" && !numbers(k + 1, 3, axis)) return std::nullopt;
        if (words[k] == "angle" && !numbers(k + 1, 1, angle)) return std::nullopt;
      }
      if (axis.size() != 3 || angle.size() != 1) return std::nullopt;
      const Eigen::Vector3d direction = Eigen::Vector3d(axis[0], axis[1], axis[2]).normalized();
      place = Eigen::AngleAxisd(angle[0] * kPi / 180.0, direction) * place;
    }
  }
  return place;
}

// The meshes that move: coupled meshes, and meshes of fix move/mesh.
std::set<std::string> moving_meshes(const ScriptText& script) {
  std::set<std::string> moving;
  for (const ScriptCommand& command : script.commands()) {
    if (!command.is_fix("couple/mbd") && !command.is_fix("move/mesh")) continue;
    for (std::size_t i = 4; i + 1 < command.words.size(); ++i)
      if (command.words[i] == "mesh") moving.insert(command.words[i + 1]);
  }
  return moving;
}

}  // namespace

void add_static_meshes(const nlohmann::ordered_json& scene, PageParts& parts, std::vector<std::string>& notes) {
  using Variables = std::map<std::string, std::string>;
  nlohmann::ordered_json& names = parts.run["meshes"] = nlohmann::ordered_json::array();
  const nlohmann::ordered_json particles = scene.value("particles", nlohmann::ordered_json());
  if (!particles.is_object() || !particles.contains("script") || !particles.at("script").is_string()) return;
  const std::string file = particles.at("script");
  if (!std::filesystem::exists(file)) return;
  std::size_t triangles = 0;
  const ScriptText script(file, particles.value("variables", Variables()));
  const std::set<std::string> moving = moving_meshes(script);
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& words = command.words;
    if (words[0] != "fix" || words.size() < 6 || words[3].rfind("mesh/surface", 0) != 0 || words[4] != "file") continue;
    if (moving.count(words[1]) > 0) continue;
    try {
      const std::optional<Eigen::Affine3d> place = placement_of(command);
      if (!place) throw InputError(command.place() + ": only LIGGGHTS can compute where it is");
      const TriangleMesh mesh = read_mesh(words[5]);
      triangles += mesh.triangles.size();
      if (triangles > kMostTriangles) throw InputError(command.place() + ": it has too many triangles for a page");
      std::vector<float> corners;
      for (const Eigen::Vector3i& triangle : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
          const Eigen::Vector3d x = *place * mesh.vertices[triangle(k)];
          for (int axis = 0; axis < 3; ++axis) corners.push_back(static_cast<float>(x(axis)));
        }
      parts.chunks.emplace_back("mesh-" + std::to_string(names.size()), packed_numbers(corners));
      names.push_back(words[1]);
    } catch (const InputError& error) {
      notes.push_back("The mesh " + words[1] + " of the script is not shown: " + error.what());
    }
  }
}

void add_bed_block(const nlohmann::ordered_json& scene, PageParts& parts) {
  const nlohmann::ordered_json particles = scene.value("particles", nlohmann::ordered_json());
  if (!particles.is_object() || !particles.contains("box") || !particles.at("box").is_object()) return;
  const nlohmann::ordered_json& box = particles.at("box");
  const std::vector<double> size = box.value("size", std::vector<double>());
  std::vector<double> centre = box.value("centre", std::vector<double>());
  centre.resize(2, 0.0);
  if (size.size() != 2) return;
  parts.run["bed"] = {{"low", {centre[0] - 0.5 * size[0], centre[1] - 0.5 * size[1], -box.value("depth", 0.0)}},
                      {"high", {centre[0] + 0.5 * size[0], centre[1] + 0.5 * size[1], 0.0}}};
}

}  // namespace footfall
