#include "mbd_solver/cli/launch/script_trace.h"

#include <sstream>
#include <vector>

#include "mbd_solver/cli/launch/liggghts_log.h"
#include "mbd_solver/scene/script_text.h"

namespace footfall {
namespace {

std::vector<std::string> blank_words(const std::string& line) {
  std::istringstream in(line);
  std::vector<std::string> words;
  for (std::string word; in >> word;) words.push_back(word);
  return words;
}

// The same line with values for its variables: LIGGGHTS repeats a line for every one.
bool is_filled_in(const std::vector<std::string>& line, const std::vector<std::string>& written) {
  for (std::size_t i = 0; i < written.size(); ++i) {
    if (written[i].find('$') != std::string::npos) return true;  // a value may be several words
    if (i >= line.size() || line[i] != written[i]) return false;
  }
  return false;
}

}  // namespace

std::string why_liggghts_stopped(const std::string& log, const std::string& script,
                                 const std::map<std::string, std::string>& variables) {
  const std::string errors = liggghts_errors(log);
  std::string meaning;
  // The header is LIGGGHTS' own, or that of its package, whichever compiler has made the function.
  const std::size_t internal = errors.find("Internal error (");
  if (internal != std::string::npos && errors.find("/tri_mesh_I.h", internal) != std::string::npos)
    meaning =
        "\nThe place of a grain at a mesh is no number. Mostly its centre lay exactly on the mesh, where stock "
        "LIGGGHTS ends "
        "likewise: start the body a little higher (initial.clearance), or move the grain. Else look for a time step "
        "that "
        "is too large.";
  return where_liggghts_stopped(log, script, variables) + "\n" + errors + meaning;
}

std::string where_liggghts_stopped(const std::string& log, const std::string& script,
                                   const std::map<std::string, std::string>& variables) {
  const ScriptText text(script, variables);
  std::vector<const ScriptCommand*> commands;
  std::vector<std::vector<std::string>> written;
  for (const ScriptCommand& command : text.commands()) {
    if (command.conditional) continue;
    commands.push_back(&command);
    written.push_back(blank_words(command.text));
  }
  const std::size_t none = commands.size();
  std::size_t at = none;
  for (const std::string& said : log_lines(log)) {
    if (said.rfind("ERROR", 0) == 0) break;
    const std::vector<std::string> line = blank_words(said);
    if (line.empty() || (at != none && is_filled_in(line, written[at]))) continue;
    // Mostly the next one; behind a loop one that stands before.
    const std::size_t first = at == none ? 0 : at + 1;
    for (std::size_t k = 0; k < none; ++k) {
      const std::size_t candidate = (first + k) % none;
      if (written[candidate] != line) continue;
      at = candidate;
      break;
    }
  }
  if (at == none) return script;
  std::string command;
  for (const std::string& word : written[at]) command += (command.empty() ? "" : " ") + word;
  return commands[at]->place() + ": " + command;
}

}  // namespace footfall
