// Lines of the LIGGGHTS script that couple. mbd_solver/scene/check_script.h.
#include <algorithm>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/couple_mbd_arguments.h"
#include "mbd_solver/scene/check_script.h"

namespace footfall {
namespace {

using Names = std::vector<std::string>;

bool holds_name(const Names& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool is_computed_word(const std::string& word) { return word.find('$') != std::string::npos; }

// By the reader of the fix itself.
void check_words(const ScriptCommand& command, const Scene& scene, Findings& findings) {
  if (command.is_computed()) return;
  std::vector<const char*> words;
  for (std::size_t i = 1; i < command.words.size(); ++i) words.push_back(command.words[i].c_str());
  try {
    const CoupleMbdArguments arguments(static_cast<int>(words.size()), words.data());
  } catch (const InputError& error) {
    findings.error(scene.particles->source, "script", command.place() + ": " + error.what());
  }
}

// What a line names: `body NAME`, or the `distance`-th word of `mesh MESH BODY`; those that are plain.
Names named_behind(const std::string& keyword, std::size_t distance, const ScriptCommand& command) {
  const std::size_t values = keyword == "mesh" ? 2 : 1;
  Names names;
  const Names& w = command.words;
  for (std::size_t i = 4; i + values < w.size(); ++i) {
    if (w[i] != keyword) continue;
    if (!is_computed_word(w[i + distance])) names.push_back(w[i + distance]);
    i += values;
  }
  return names;
}

// A jump may pass by the lines of other scenes.
void check_bodies_named(const ScriptCommand& command, bool straight, const Scene& scene, Findings& findings) {
  Names named;
  if (command.is_fix("couple/mbd/geometry") || command.is_fix("wall/gran/beam"))
    named = named_behind("body", 1, command);
  if (command.is_fix("couple/mbd") && straight) named = named_behind("mesh", 2, command);
  Names known;
  for (const BoundarySpec& b : scene.boundaries) known.push_back(b.body);
  for (const std::string& body : named)
    if (!holds_name(known, body))
      findings.error(scene.particles->source, "script",
                     command.place() + " asks for the body \"" + body + "\", which has no boundary in this scene." +
                         known_names("boundaries", body, known));
}

// A mesh that no line before this one makes. A loop, or a file that is not read, may make any.
void check_meshes_named(const ScriptText& script, const Scene& scene, Findings& findings) {
  if (!script.straight() || !script.whole()) return;
  Names meshes;
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (w[0] != "fix" || w.size() < 4) continue;
    if (is_computed_word(w[1]) || is_computed_word(w[3])) return;
    if (w[3].rfind("mesh/surface", 0) == 0) meshes.push_back(w[1]);
    if (!command.is_fix("couple/mbd") || command.conditional) continue;
    for (const std::string& mesh : named_behind("mesh", 1, command))
      if (!holds_name(meshes, mesh))
        findings.error(scene.particles->source, "script",
                       command.place() + " couples the mesh \"" + mesh +
                           "\", but no fix mesh/surface of this id stands before this line." +
                           known_names("meshes", mesh, meshes));
  }
}

bool may_run(const ScriptCommand& command) {
  return is_computed_word(command.words[0]) || command.words[0] == "partition" || command.words[0] == "run";
}

// The run is what moves the mechanism. A loop may lead back to a line that stands before.
void check_run_follows(const ScriptText& script, const Scene& scene, Findings& findings) {
  if (!script.straight() || !script.whole()) return;
  const ScriptCommand* coupling = nullptr;
  for (const ScriptCommand& command : script.commands()) {
    if (command.is_fix("couple/mbd")) coupling = &command;
    if (coupling != nullptr && may_run(command)) return;
  }
  if (coupling != nullptr)
    findings.error(scene.particles->source, "script",
                   coupling->place() +
                       " couples, but no run stands behind this line, so nothing would move; add a last line  "
                       "run 1000000000  (the scene ends it)");
}

// LIGGGHTS refuses it while a fix counts steps, as the coupling does.
void check_steps_go_on(const ScriptText& script, const Scene& scene, Findings& findings) {
  if (!script.straight()) return;
  const ScriptCommand* coupling = nullptr;
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (command.is_fix("couple/mbd")) coupling = command.conditional ? nullptr : &command;
    if (w[0] == "clear" || w[0] == "unfix") coupling = nullptr;
    if (w[0] == "reset_timestep" && coupling != nullptr && !command.conditional)
      findings.error(scene.particles->source, "script",
                     command.place() + " resets the steps that the coupling (" + coupling->place() +
                         ") counts, which LIGGGHTS refuses; reset_timestep must stand above fix couple/mbd");
  }
}

}  // namespace

void check_coupling(const ScriptText& script, const Scene& scene, Findings& findings) {
  for (const ScriptCommand& command : script.commands()) {
    if (command.conditional) continue;
    if (command.is_fix("couple/mbd")) check_words(command, scene, findings);
    check_bodies_named(command, script.straight(), scene, findings);
  }
  check_meshes_named(script, scene, findings);
  check_run_follows(script, scene, findings);
  check_steps_go_on(script, scene, findings);
}

}  // namespace footfall
