// Lines of the LIGGGHTS script that couple: their words, and the bodies and meshes that they name.
#include "coupler/base/text.h"
#include "coupler/couple_mbd_arguments.h"
#include "mbd_solver/scene/check_script.h"
#include "mbd_solver/scene/scene_check.h"

namespace footfall {

using namespace code;
namespace {

using Names = std::vector<std::string>;

bool is_computed_word(const std::string& word) { return word.find('$') != std::string::npos; }

// By the reader of the fix itself.
void check_words(const ScriptCommand& command, const EntryFindings& at) {
  if (command.is_computed()) return;
  std::vector<const char*> words;
  for (std::size_t i = 1; i < command.words.size(); ++i) words.push_back(command.words[i].c_str());
  try {
    const CoupleMbdArguments arguments(static_cast<int>(words.size()), words.data());
  } catch (const InputError& error) {
    at.all().coded_error(at.source(), "script", command.place() + ": " + error.what());
  }
}

// The words that a line names after a keyword, as far as they are plain: `body NAME`, or the `distance`-th word of
// `mesh MESH BODY`.
Names named_after(const std::string& keyword, std::size_t distance, const ScriptCommand& command) {
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

// A jump may skip the lines of other scenes.
void check_bodies_named(const ScriptCommand& command, bool straight, const Names& known, const EntryFindings& at) {
  Names named;
  if (command.is_fix("couple/mbd/geometry") || command.is_fix("wall/gran/beam"))
    named = named_after("body", 1, command);
  if (command.is_fix("couple/mbd") && straight) named = named_after("mesh", 2, command);
  for (const std::string& body : named)
    if (!is_in(known, body))
      at.error(kScriptName, "script",
               command.place() + " names the body \"" + body + "\", which has no boundary in this scene." +
                   known_names("boundaries", body, known));
}

// A mesh that no line before this one makes. A loop, or a file that is not read, may make any.
void check_meshes_named(const ScriptText& script, const EntryFindings& at) {
  Names meshes;
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (w[0] != "fix" || w.size() < 4) continue;
    if (is_computed_word(w[1]) || is_computed_word(w[3])) return;
    if (w[3].rfind("mesh/surface", 0) == 0) meshes.push_back(w[1]);
    if (!command.is_fix("couple/mbd") || command.conditional) continue;
    for (const std::string& mesh : named_after("mesh", 1, command))
      if (!is_in(meshes, mesh))
        at.error(kScriptName, "script",
                 command.place() + " couples the mesh \"" + mesh +
                     "\", but no line above it is a fix mesh/surface of this id." +
                     known_names("meshes", mesh, meshes));
  }
}

bool may_run(const ScriptCommand& command) {
  return is_computed_word(command.words[0]) || command.words[0] == "partition" || command.words[0] == "run";
}

// The mechanism moves during the run. A loop may lead back to a line above.
void check_run_follows(const ScriptText& script, const EntryFindings& at) {
  const ScriptCommand* coupling = nullptr;
  for (const ScriptCommand& command : script.commands()) {
    if (command.is_fix("couple/mbd")) coupling = &command;
    if (coupling != nullptr && may_run(command)) return;
  }
  if (coupling != nullptr)
    at.error(kScriptNoRun, "script",
             coupling->place() +
                 " couples, but no run follows this line, so nothing would move; add a last line  run 1000000000  (the "
                 "scene ends it)");
}

// LIGGGHTS refuses it while a fix counts steps, as the coupling does.
void check_steps_continue(const ScriptText& script, const EntryFindings& at) {
  const ScriptCommand* coupling = nullptr;
  for (const ScriptCommand& command : script.commands()) {
    const Names& w = command.words;
    if (command.is_fix("couple/mbd")) coupling = command.conditional ? nullptr : &command;
    if (w[0] == "clear" || w[0] == "unfix") coupling = nullptr;
    if (w[0] == "reset_timestep" && coupling != nullptr && !command.conditional)
      at.error(kScriptResetsSteps, "script",
               command.place() + " resets the steps that the coupling (" + coupling->place() +
                   ") counts, which LIGGGHTS refuses; move reset_timestep above fix couple/mbd");
  }
}

}  // namespace

void check_coupling(const ScriptText& script, const Scene& scene, Findings& findings) {
  const EntryFindings at(findings, scene.particles->source);
  for (const ScriptCommand& command : script.commands()) {
    if (command.conditional) continue;
    if (command.is_fix("couple/mbd")) check_words(command, at);
    check_bodies_named(command, script.straight(), boundary_names(scene), at);
  }
  if (!script.straight()) return;
  if (script.whole()) {
    check_meshes_named(script, at);
    check_run_follows(script, at);
  }
  check_steps_continue(script, at);
}

}  // namespace footfall
