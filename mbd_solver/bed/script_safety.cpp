// Looks at every command of a script for what it runs and which files it writes; commands inside `if`, `run every` and
// `partition` count as well.
#include "mbd_solver/bed/script_safety.h"

#include <algorithm>
#include <vector>

#include "coupler/base/errors.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {
namespace {

using Words = std::vector<std::string>;

// Quoted words may hold commands, as in: if ... then "shell rm".
Words without_quotes(Words words) {
  for (std::string& word : words)
    word.erase(std::remove_if(word.begin(), word.end(), [](char c) { return c == '"' || c == '\''; }), word.end());
  return words;
}

std::string word_after(const Words& w, std::size_t from, const std::string& key) {
  for (std::size_t i = from; i + 1 < w.size(); ++i)
    if (w[i] == key) return w[i + 1];
  return "";
}

// The files that one command writes; it begins at word `at`.
Words files_written(const Words& w, std::size_t at) {
  const auto word = [&](std::size_t k) { return at + k < w.size() ? w[at + k] : std::string(); };
  const std::string command = word(0);
  if (command == "dump") return {word(5)};
  if (command == "write_dump") return {word(3)};
  if (command == "write_restart" || command == "write_data" || command == "log") return {word(1)};
  if (command == "restart" && word(1) != "0") return {word(2), word(3)};
  if (command == "print") return {word_after(w, at + 1, "file"), word_after(w, at + 1, "append")};
  if (command == "run") return {};
  if (command != "fix") return {};
  // Other fixes only read files: meshes, particle templates.
  const std::string style = word(3);
  if (style != "print" && style.rfind("ave/", 0) != 0 && style.rfind("massflow/", 0) != 0) return {};
  return {word_after(w, at + 4, "file"), word_after(w, at + 4, "append")};
}

bool is_allowed(const std::string& file) {
  if (file.empty() || file == "none" || file == "NULL" || file == "&") return true;
  const bool out = file.rfind("${out}/", 0) == 0, bed = file.rfind("${bed}", 0) == 0;
  if (!out && !bed) return false;
  const std::string rest = file.substr(6);
  // Only a plain path: LIGGGHTS passes the names of compressed files to a shell.
  const bool plain = rest.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+*%/") ==
                     std::string::npos;
  return plain && rest.find("..") == std::string::npos;
}

}  // namespace

void require_safe_script(const std::string& script, const std::map<std::string, std::string>& variables) {
  std::string findings;
  // The command line gives both; values that the script itself gives do not count.
  std::map<std::string, std::string> given = variables;
  given["out"] = "${out}";
  given["bed"] = "${bed}";
  const ScriptText text(script, given);
  for (const ScriptCommand& command : text.commands()) {
    const Words w = without_quotes(command.words);
    const auto complain = [&](const std::string& what) {
      findings += (findings.empty() ? "" : "\n") + command.file + ":" + std::to_string(command.line) + ": " + what;
    };
    if (std::find(w.begin(), w.end(), "shell") != w.end())
      complain("`shell` runs programs, which a script may not do; run them before");
    if (w[0] == "dump" && w.size() > 3 && w[3] == "movie")
      complain("`dump movie` runs a program, which a script may not do; make the film after the run");
    // Commands inside these may begin at any word.
    const bool nested = w[0] == "if" || w[0] == "run" || w[0] == "partition";
    for (std::size_t at = 0; at < (nested ? w.size() : 1); ++at)
      for (const std::string& file : files_written(w, at))
        if (!is_allowed(file))
          complain("writes \"" + file + "\", expected a file in the folder of results: ${out}/NAME");
  }
  if (!findings.empty())
    throw InputError(code::kUnsafeScript, findings + "\nIf you trust this script, add --trust-script.");
}

}  // namespace footfall
