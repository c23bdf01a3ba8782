// The line of a fix mesh/surface as one scale, turn and displacement, and the boundaries that take it.
#include "mbd_solver/scene/script_mesh.h"

#include <algorithm>
#include <filesystem>

#include "coupler/base/text.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/scene/codes.h"

namespace footfall {

using namespace code;

namespace {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

[[noreturn]] void fail(const std::string& what) { throw InputError(kScriptMesh, what); }

// Word `at` as a number. Throws InputError.
double number_at(const Words& words, std::size_t at) {
  const std::string word = at < words.size() ? words[at] : "";
  const std::optional<double> value = as_number(word);
  if (!value) fail("has \"" + word + "\", expected a number");
  return *value;
}

Eigen::Vector3d vector_at(const Words& words, std::size_t at) {
  return {number_at(words, at), number_at(words, at + 1), number_at(words, at + 2)};
}

bool is_mesh(const ScriptCommand& command) {
  return command.words.size() > 3 && command.words[0] == "fix" && command.words[3].rfind("mesh/surface", 0) == 0;
}

}  // namespace

SurfaceSpec mesh_in_script(const ScriptCommand& command, const std::string& here) {
  const Words& w = command.words;
  double scale = 1.0;
  Eigen::Quaterniond R = Eigen::Quaterniond::Identity();
  Eigen::Vector3d p = Eigen::Vector3d::Zero();
  std::string file;
  for (std::size_t i = 4; i < w.size(); ++i) {
    if (w[i] == "file" && i + 1 < w.size()) file = w[++i];
    if (w[i] == "fix") fail("takes its triangles from another fix, expected a file");
    if (w[i] == "scale") {
      const double factor = number_at(w, ++i);
      if (!(factor > 0.0)) fail("has a scale that is not positive");
      scale *= factor;
      p *= factor;
    } else if (w[i] == "move") {
      p += vector_at(w, i + 1);
      i += 3;
    } else if (w[i] == "rotate") {
      if (i + 6 >= w.size() || w[i + 1] != "axis" || w[i + 5] != "angle")
        fail("has a malformed rotate, expected: rotate axis x y z angle phi");
      const Eigen::Vector3d axis = vector_at(w, i + 2);
      if (axis.isZero(0.0)) fail("has an axis of rotation that is zero");
      const Eigen::Quaterniond Q(Eigen::AngleAxisd(number_at(w, i + 6) * kPi / 180.0, axis.normalized()));
      R = (Q * R).normalized();
      p = Q * p;
      i += 6;
    }
  }
  if (file.empty()) fail("names no file");
  std::error_code ignored;
  const fs::path near = fs::path(here) / file;
  const fs::path found = fs::exists(near, ignored) ? near : fs::path(file);
  if (!fs::is_regular_file(found, ignored))
    fail("has the file \"" + file + "\", which is neither in the script's folder nor in the current one");
  SurfaceSpec surface;
  surface.file = fs::absolute(found, ignored).lexically_normal().string();
  surface.scale = scale;
  surface.orientation = R;
  surface.position = p;
  return surface;
}

void resolve_script_meshes(Scene& scene, Findings& findings) {
  for (BoundarySpec& boundary : scene.boundaries) {
    if (!boundary.surface || boundary.surface->from_script.empty()) continue;
    const std::string &id = boundary.surface->from_script, key = "surface.from_script";
    const EntryFindings at(findings, boundary.source);
    for (const char* other :
         {"surface.file", "surface.scale", "surface.position", "surface.orientation", "surface.element_size"})
      at.given_twice_if(at.given(other), other, "from_script");
    if (!scene.particles || !scene.particles->source.given("script")) {
      at.error(kNeedsOtherKey, key, "names the mesh \"" + id + "\" of a script, which particles.script must name");
      continue;
    }
    const std::string& file = scene.particles->script;
    const ScriptText script(file, scene.particles->variables);
    Words known;
    const ScriptCommand* found = nullptr;
    for (const ScriptCommand& command : script.commands()) {
      if (!is_mesh(command)) continue;
      known.push_back(command.words[1]);
      if (command.words[1] == id) found = &command;
    }
    if (!found) {
      at.error(kUnknownMesh, key, "unknown fix mesh/surface \"" + id + "\"." + known_names("meshes", id, known));
      continue;
    }
    try {
      const SurfaceSpec mesh = mesh_in_script(*found, fs::path(file).parent_path().string());
      boundary.surface->file = mesh.file;
      boundary.surface->scale = mesh.scale;
      boundary.surface->orientation = mesh.orientation;
      boundary.surface->position = mesh.position;
    } catch (const InputError& e) {
      findings.coded_error(boundary.source, key, "mesh \"" + id + "\" (" + found->place() + ") " + e.what());
    }
  }
}

}  // namespace footfall
