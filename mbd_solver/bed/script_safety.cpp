// Looks at every command of a script for what it runs and which files it writes; commands inside `if`, `run every` and
// `partition` count as well. Only the text itself is certain: known commands and styles, and files whose names
// hold no variables but numbers.
#include "mbd_solver/bed/script_safety.h"

#include <algorithm>
#include <filesystem>
#include <functional>
#include <set>
#include <vector>

#include "coupler/base/confinement.h"
#include "coupler/base/errors.h"
#include "mbd_solver/bed/codes.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {
namespace {

using Words = std::vector<std::string>;
using Variables = std::map<std::string, std::string>;

// Quoted words may hold commands, as in: if ... then "shell rm".
std::string without_quotes(std::string word) {
  word.erase(std::remove_if(word.begin(), word.end(), [](char c) { return c == '"' || c == '\''; }), word.end());
  return word;
}

// The command, and those that its words hold: each word of `if` and `run ... every N` may be one.
std::vector<Words> with_nested(const ScriptCommand& command) {
  Words plain;
  for (const std::string& word : command.words) plain.push_back(without_quotes(word));
  std::vector<Words> all = {plain};
  if (plain[0] != "if" && plain[0] != "run" && plain[0] != "partition") return all;
  for (std::size_t at = 1; at < plain.size(); ++at) {
    all.emplace_back(plain.begin() + at, plain.end());
    if (Words words = script_words(plain[at]); words.size() > 1) all.push_back(words);
  }
  return all;
}

std::string word_after(const Words& w, const std::string& key) {
  for (std::size_t i = 1; i + 1 < w.size(); ++i)
    if (w[i] == key) return w[i + 1];
  return "";
}

bool begins(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

bool is_writing_fix(const std::string& style) {
  return style == "print" || begins(style, "ave/") || begins(style, "massflow/");
}

// The files that one command writes.
Words files_written(const Words& w) {
  const auto word = [&](std::size_t k) { return k < w.size() ? w[k] : std::string(); };
  if (w.empty()) return {};
  const std::string& command = w[0];
  if (command == "dump") return {word(5)};
  if (command == "write_dump") return {word(3)};
  if (command == "write_restart" || command == "write_data" || command == "log") return {word(1)};
  if (command == "restart" && word(1) != "0") return {word(2), word(3)};
  if (command == "print") return {word_after(w, "file"), word_after(w, "append")};
  // Other fixes only read files: meshes, particle templates.
  if (command != "fix" || !is_writing_fix(word(3))) return {};
  return {word_after(w, "file"), word_after(w, "append")};
}

bool is_allowed(const std::string& file) {
  if (file.empty() || file == "none" || file == "NULL" || file == "&") return true;
  const bool out = begins(file, "${out}/"), bed = begins(file, "${bed}");
  if (!out && !bed) return false;
  const std::string rest = file.substr(6);
  // Only a plain path: LIGGGHTS passes the names of compressed files to a shell.
  const bool plain = rest.find_first_not_of("abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.+*%/") ==
                     std::string::npos;
  return plain && rest.find("..") == std::string::npos;
}

// The command line gives both; values that the script itself gives do not count.
ScriptText read_script(const std::string& script, Variables variables) {
  variables["out"] = "${out}";
  variables["bed"] = "${bed}";
  return ScriptText(script, variables);
}

void complain(std::string& findings, const ScriptCommand& command, const std::string& what) {
  findings += (findings.empty() ? "" : "\n") + command.place() + ": " + what;
}

std::string unsafe_lines(const ScriptText& text) {
  std::string findings;
  for (const ScriptCommand& command : text.commands()) {
    std::set<std::string> said;
    const auto say = [&](const std::string& what) {
      if (said.insert(what).second) complain(findings, command, what);
    };
    for (const Words& w : with_nested(command)) {
      if (std::find(w.begin(), w.end(), "shell") != w.end())
        say("`shell` runs programs, which a script may not do; run them before");
      if (w[0] == "dump" && w.size() > 3 && w[3] == "movie")
        say("`dump movie` runs a program, which a script may not do; make the film after the run");
      for (const std::string& file : files_written(w))
        if (!is_allowed(file)) say("writes \"" + file + "\", expected a file in the folder of results: ${out}/NAME");
    }
  }
  return findings;
}

// ---- What is certain ----

std::set<std::string> names_in(const char* text) {
  const Words words = script_words(text);
  return {words.begin(), words.end()};
}

// Commands that write no file and run no program, whatever follows them. Those that write are judged by files_written.
const std::set<std::string> kHarmless = names_in(
    "atom_modify atom_style boundary bond_coeff bond_style clear communicate compute create_atoms create_box "
    "delete_atoms delete_bonds dielectric displace_atoms dump_modify echo fix_modify group hard_particles if "
    "include jump label lattice mass neigh_modify neigh_settings neighbor newton next orient origin "
    "pair_coeff pair_style processors quit read_data read_restart region reset_timestep run run_style set "
    "soft_particles special_bonds thermo thermo_modify thermo_style timestep uncompute undump unfix units "
    "variable velocity modify_timing coarsegraining min_style change_box");
const std::set<std::string> kWriting = names_in("dump fix log print restart write_data write_dump write_restart");
const Words kHarmlessFixes = script_words(
    "property/ mesh/ wall/gran nve gravity particletemplate/ particledistribution/ insert/ remove/region "
    "bed/follow move/ couple/mbd rigid multisphere freeze setforce addforce drag viscous momentum limit/ "
    "check/timestep/gran adapt store/ cfd/none");
const Words kDumps = script_words("atom custom image local xyz mesh/ atom/vtk custom/vtk local/gran euler/");

bool begins_as_one_of(const std::string& style, const Words& known) {
  return std::any_of(known.begin(), known.end(), [&](const std::string& start) { return begins(style, start); });
}

// `if CONDITION then COMMAND...` and `run N ... every M COMMAND...`: the words that are commands.
Words commands_within(const Words& w) {
  Words commands;
  if (w[0] == "if")
    for (std::size_t i = 2; i < w.size(); ++i) {
      if (w[i] == "then" || w[i] == "else") continue;
      if (w[i] == "elif")
        ++i;
      else
        commands.push_back(w[i]);
    }
  const auto every = std::find(w.begin(), w.end(), "every");
  if (w[0] == "run" && every != w.end() && every + 1 != w.end()) commands.assign(every + 2, w.end());
  commands.erase(std::remove(commands.begin(), commands.end(), "NULL"), commands.end());
  return commands;
}

// The commands of the scripts as they are written, with those within them; or the latter alone.
std::vector<Words> written_commands(const std::vector<ScriptText>& texts, bool only_within = false) {
  std::vector<Words> all;
  for (const ScriptText& text : texts)
    for (const ScriptCommand& command : text.commands())
      if (!command.conditional) all.push_back(script_words(command.text));
  all.erase(std::remove_if(all.begin(), all.end(), [](const Words& w) { return w.empty(); }), all.end());
  const auto outer = static_cast<std::ptrdiff_t>(all.size());
  for (std::size_t i = 0; i < all.size(); ++i)
    for (const std::string& within : commands_within(Words(all[i])))
      if (Words words = script_words(within); !words.empty()) all.push_back(std::move(words));
  if (only_within) all.erase(all.begin(), all.begin() + outer);
  return all;
}

// Numbers, and variables of which `numeric` is true, which are not in it yet.
bool is_numeric(const std::string& text, const std::map<std::string, bool>& numeric) {
  const Words words = script_words(text);
  return !words.empty() && std::all_of(words.begin(), words.end(), [&](const std::string& word) {
    if (as_number(word)) return true;
    if (!begins(word, "${") || word.back() != '}') return false;
    const auto known = numeric.find(word.substr(2, word.size() - 3));
    return known != numeric.end() && known->second;
  });
}

// Variables whose value is a number at every time, as all commands that define them say.
std::set<std::string> numeric_variables(const std::vector<Words>& commands, const Variables& given) {
  std::map<std::string, bool> numeric;
  for (const Words& w : commands)
    if (w.size() > 2 && w[0] == "variable") numeric[w[1]] = true;
  for (const auto& [name, value] : given) numeric[name] = is_numeric(value, {});
  for (bool changed = true; changed;) {
    changed = false;
    for (const Words& w : commands) {
      if (w.size() < 3 || w[0] != "variable" || !numeric[w[1]]) continue;
      bool number = w[2] == "equal" || w[2] == "loop" || w[2] == "delete";
      if (w[2] == "index" || w[2] == "string")
        number = w.size() > 3 && std::all_of(w.begin() + 3, w.end(),
                                             [&](const std::string& value) { return is_numeric(value, numeric); });
      if (number) continue;
      numeric[w[1]] = false;
      changed = true;
    }
  }
  std::set<std::string> names;
  for (const auto& [name, number] : numeric)
    if (number) names.insert(name);
  return names;
}

// The variable that the text names at this place: its name, and the place behind it; empty for a syntax that is not known.
std::pair<std::string, std::size_t> variable_at(const std::string& text, std::size_t at) {
  if (at + 1 >= text.size()) return {"", at + 1};
  if (text[at + 1] != '{') return {text.substr(at + 1, 1), at + 2};
  const std::size_t end = text.find('}', at);
  if (end == std::string::npos) return {"", text.size()};
  return {text.substr(at + 2, end - at - 2), end + 1};
}

// True when the text names no variables but these.
bool is_plain(const std::string& text, const std::set<std::string>& known) {
  for (std::size_t at = text.find('$'); at != std::string::npos; at = text.find('$', at + 1))
    if (known.count(variable_at(text, at).first) == 0) return false;
  return true;
}

// All texts that a word may become, by the values that the scripts and the command line give to its variables; nothing
// where one of them is computed, or there are too many.
std::set<std::string> possible_texts(const std::string& word, const std::vector<Words>& commands,
                                     const Variables& given) {
  constexpr std::size_t kMost = 16;
  std::set<std::string> open = {word}, texts;
  for (int round = 0; !open.empty(); ++round) {
    if (round > 4 || open.size() > kMost) return {};
    std::set<std::string> next;
    for (const std::string& text : open) {
      const std::size_t at = text.find('$');
      if (at == std::string::npos) {
        texts.insert(text);
        continue;
      }
      const auto [name, behind] = variable_at(text, at);
      std::set<std::string> values;
      if (const auto value = given.find(name); value != given.end()) values.insert(value->second);
      for (const Words& w : commands) {
        if (w.size() < 2 || w[0] != "variable" || w[1] != name) continue;
        if (w.size() != 4 || (w[2] != "index" && w[2] != "string")) return {};
        if (name != "here") values.insert(w[3]);
      }
      if (values.empty()) return {};
      for (const std::string& value : values) next.insert(text.substr(0, at) + value + text.substr(behind));
    }
    open = next;
  }
  return texts;
}

// The script with all files that it may include.
std::vector<ScriptText> with_includes(const std::string& script, const Variables& variables, std::string& findings) {
  std::vector<ScriptText> texts = {read_script(script, variables)};
  Variables given = variables;
  given["here"] = std::filesystem::path(script).parent_path().string();
  std::set<std::string> read;
  for (std::size_t k = 0; k < texts.size(); ++k) {
    const std::vector<Words> commands = written_commands(texts), within = written_commands(texts, true);
    for (const Words& w : commands) {
      if (w[0] != "include" || w.size() < 2) continue;
      const bool has_been_read = is_plain(w[1], {"here"}) && std::find(within.begin(), within.end(), w) == within.end();
      if (has_been_read) continue;
      const std::set<std::string> files = possible_texts(w[1], commands, given);
      if (files.empty()) findings += script + ": includes " + w[1] + ", a name that only LIGGGHTS can compute\n";
      for (const std::string& file : files)
        if (read.insert(file).second) texts.push_back(read_script(file, variables));
    }
    if (texts.size() > 50) return texts;
  }
  return texts;
}

// The word with which a mesh writes a list of its elements.
constexpr const char* kElementList = "element_exclusion_list";

// True when no value of the variables in these words, which are all known, names a list of elements.
bool cannot_list_elements(const Words& w, const std::vector<Words>& commands, const Variables& variables) {
  return std::all_of(w.begin(), w.end(), [&](const std::string& word) {
    const std::set<std::string> texts = possible_texts(word, commands, variables);
    return !texts.empty() && std::none_of(texts.begin(), texts.end(), [](const std::string& text) {
      return text.find(kElementList) != std::string::npos;
    });
  });
}

// Why it is not certain that this command is safe; empty when it is. w: its words as they are written; known: variables
// that are numbers or of the command line; given: the latter; commands, variables: all others of the script.
std::string doubt(const Words& w, const std::string& text, const std::set<std::string>& known,
                  const std::set<std::string>& given, const std::vector<Words>& commands, const Variables& variables) {
  const auto word = [&](std::size_t k) { return k < w.size() ? w[k] : std::string(); };
  if (kHarmless.count(w[0]) == 0 && kWriting.count(w[0]) == 0) return "`" + w[0] + "` is not known to be harmless";
  if (w[0] == "processors" && word_after(w, "file") != "") return "writes a file";
  if (std::find(w.begin(), w.end(), kElementList) != w.end()) return "writes or reads a list of elements";
  if (w[0] == "jump" && word(1) != "SELF") return "jumps into another file";
  if (w[0] == "include" && !begins(word(1), "$") && !begins(word(1), "/"))
    return "includes a file by a name that may mean two files, expected ${here}/NAME";
  if (w[0] == "variable") {
    // LIGGGHTS keeps the value of the command line where the script says `index`.
    if (given.count(word(1)) > 0 && word(2) != "index") return "defines ${" + word(1) + "} anew";
    return word(1).find('$') == std::string::npos ? "" : "defines a variable with a computed name";
  }
  if (w[0] == "fix" && !is_writing_fix(word(3)) && !begins_as_one_of(word(3), kHarmlessFixes))
    return "fix " + word(3) + " is not known to be harmless";
  if (w[0] == "dump" && !begins_as_one_of(word(3), kDumps)) return "dump " + word(3) + " is not known to be harmless";
  // A mesh may write its elements, and `processors` its grid, by further words.
  if (w[0] == "fix" && begins(word(3), "mesh/") && cannot_list_elements(w, commands, variables)) return "";
  const bool writes = w[0] == "fix" ? is_writing_fix(word(3)) || begins(word(3), "mesh/")
                                    : kWriting.count(w[0]) > 0 || w[0] == "processors";
  if (writes && !is_plain(text, known)) return "writes files with words that only LIGGGHTS can compute";
  return "";
}

}  // namespace

std::string uncertain_lines(const std::string& script, const Variables& variables, const std::set<std::string>& given) {
  std::string findings;
  const std::vector<ScriptText> texts = with_includes(script, variables, findings);
  const std::vector<Words> written = written_commands(texts);
  std::set<std::string> known = numeric_variables(written, variables);
  for (const char* place : {"out", "bed", "here"}) known.erase(place);
  known.insert(given.begin(), given.end());
  for (const std::string& name : given)
    if (variables.count(name) > 0) findings += script + ": the scene has a variable \"" + name + "\" of its own\n";
  std::vector<ScriptCommand> commands;
  for (const ScriptText& text : texts) {
    findings += unsafe_lines(text);
    if (!text.whole()) findings += script + ": not all files that it includes can be read\n";
    commands.insert(commands.end(), text.commands().begin(), text.commands().end());
  }
  for (const ScriptCommand& command : commands) {
    if (command.conditional) continue;  // comes with its `if`
    const std::function<void(const std::string&, int)> judge = [&](const std::string& line, int depth) {
      const Words w = script_words(line);
      if (w.empty()) return;
      const std::string why = w[0].find('$') != std::string::npos || depth > 3
                                  ? "only LIGGGHTS knows which command this is"
                                  : doubt(w, line, known, given, written, variables);
      if (!why.empty()) complain(findings, command, why);
      for (const std::string& within : commands_within(w)) judge(within, depth + 1);
    };
    judge(command.text, 0);
  }
  return findings;
}

void require_safe_script(const std::string& script, const Variables& variables, const std::set<std::string>& given) {
  std::string findings = unsafe_lines(read_script(script, variables));
  const bool confined = kernel_confines_files();
  if (findings.empty() && !confined) findings = uncertain_lines(script, variables, given);
  if (findings.empty()) return;
  throw InputError(code::kUnsafeScript, findings,
                   confined ? "" : "\nThis kernel has no Landlock (Linux 5.13), which would confine the script.",
                   "\nIf you trust this script, add --trust-script.");
}

}  // namespace footfall
