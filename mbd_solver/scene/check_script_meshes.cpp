// Meshes of the LIGGGHTS script against its simulation box: drawn in millimetres, they are a thousand times too large.
#include <algorithm>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/scene/check_script.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/mesh_reader.h"
#include "mbd_solver/scene/script_mesh.h"

namespace footfall {
namespace {

using Box = Eigen::AlignedBox3d;

// region ID block xlo xhi ylo yhi zlo zhi, in plain numbers.
std::optional<Box> block(const ScriptCommand& command) {
  const std::vector<std::string>& w = command.words;
  if (w.size() < 9 || w[2] != "block") return std::nullopt;
  Box box;
  for (Eigen::Index c = 0; c < 3; ++c) {
    const std::optional<double> low = as_number(w[static_cast<std::size_t>(3 + 2 * c)]),
                                high = as_number(w[static_cast<std::size_t>(4 + 2 * c)]);
    if (!low || !high || !(*low < *high)) return std::nullopt;
    box.min()[c] = *low;
    box.max()[c] = *high;
  }
  return box;
}

// The simulation box, if the text gives it: one create_box of a block, in metres.
std::optional<Box> simulation_box(const ScriptText& script) {
  std::map<std::string, std::optional<Box>> regions;
  std::optional<Box> box;
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (w[0] == "lattice" || w[0] == "change_box" || w[0] == "displace_box") return std::nullopt;
    if (w[0] == "region" && w.size() > 2) regions[w[1]] = command.conditional ? std::nullopt : block(command);
    if (w[0] != "create_box" || w.size() < 3) continue;
    const auto region = regions.find(w[2]);
    if (box || command.conditional || region == regions.end() || !region->second) return std::nullopt;
    box = region->second;
  }
  return box;
}

bool all_sides_are_fixed(const ScriptText& script) {
  bool fixed = false;
  for (const ScriptCommand& command : script.commands())
    if (command.words[0] == "boundary")
      fixed = !command.conditional && command.words == std::vector<std::string>{"boundary", "f", "f", "f"};
  return fixed;
}

std::optional<Box> extent_of(const ScriptCommand& command, const std::string& here) {
  try {
    const SurfaceSpec surface = mesh_in_script(command, here);
    Box box;
    for (const Eigen::Vector3d& x : read_mesh(surface.file, surface.scale).vertices)
      box.extend(surface.orientation * x + surface.position);
    return box;
  } catch (const InputError&) {
    return std::nullopt;  // reported where the mesh is used
  }
}

std::string size_text(const Box& box) {
  const Eigen::Vector3d size = box.sizes();
  return number_text(size[0], 3) + " x " + number_text(size[1], 3) + " x " + number_text(size[2], 3) + " m";
}

}  // namespace

void check_script_meshes(const ScriptText& script, const Scene& scene, Findings& findings) {
  const ParticlesSpec& particles = *scene.particles;
  std::optional<Box> box = simulation_box(script);
  if (!box && particles.bed && std::filesystem::is_regular_file(particles.bed->script))
    box = simulation_box(ScriptText(particles.bed->script, particles.bed->variables));
  if (!box) return;
  constexpr double kSuspicious = 20.0;  // of the box's diagonal; a thousandth of it fits in
  const double room = box->diagonal().norm();
  for (const ScriptCommand& command : script.commands()) {
    const std::vector<std::string>& w = command.words;
    if (command.conditional || w[0] != "fix" || w.size() < 4 || w[3].rfind("mesh/surface", 0) != 0) continue;
    const std::optional<Box> mesh = extent_of(command, std::filesystem::path(particles.script).parent_path().string());
    if (!mesh || mesh->diagonal().norm() < kSuspicious * room || 1e-3 * mesh->diagonal().norm() > room) continue;
    const std::string what = command.place() + ": mesh " + w[1] + " measures " + size_text(*mesh) +
                             ", the simulation box " + size_text(*box) +
                             "; if it is drawn in millimetres, add  scale 0.001";
    // LIGGGHTS stops when it has lost all triangles of a mesh.
    if (!mesh->intersects(*box) && script.straight() && all_sides_are_fixed(script))
      findings.error(code::kMeshOutsideBox, particles.source, "script", what);
    else
      findings.warning(code::kMeshLargerThanBox, particles.source, "script", what);
  }
}

}  // namespace footfall
