// A LIGGGHTS script as text: commands, variables, includes and branches; and its meshes as surfaces of boundaries.

#include <algorithm>
#include <cctype>
#include <cstring>
#include <filesystem>
#include <string_view>

#include "coupler/base/input_file.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/csv.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/base/text_reader.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/particle_script.h"

namespace footfall {
// The line of a fix mesh/surface as one scale, turn and displacement, and the boundaries that take it.
using namespace code;

namespace {

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// The path of the script's folder is one word, whatever is in it, and so is the path of a file: LIGGGHTS gets them from the
// current folder, and `run` refuses what would be split there. Until the words of a line are known, control characters
// stand for those that split.
constexpr std::string_view kSplitting = " \t\r\n\"'#";

std::string hidden(std::string path) {
  for (char& c : path)
    if (const std::size_t k = kSplitting.find(c); k != std::string_view::npos) c = static_cast<char>(k + 1);
  return path;
}

std::string shown(std::string word) {
  for (char& c : word)
    if (c > 0 && static_cast<std::size_t>(c) <= kSplitting.size()) c = kSplitting[c - 1];
  return word;
}

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

std::vector<std::string> script_words(const std::string& text) {
  std::vector<std::string> words;
  bool inside = false;
  char quote = '\0';
  for (const char c : text) {
    if (quote != '\0') {
      if (c == quote)
        quote = '\0';
      else
        words.back() += c;
      continue;
    }
    if (c == '#') break;
    if (std::isspace(static_cast<unsigned char>(c)) != 0) {
      inside = false;
      continue;
    }
    if (!inside) words.emplace_back();
    inside = true;
    if (c == '"' || c == '\'')
      quote = c;
    else
      words.back() += c;
  }
  return words;
}

std::optional<double> as_number(const std::string& text) {
  double value = 0.0;
  return read_number(text, value) ? std::optional<double>(value) : std::nullopt;
}

std::string fault_of_variable(const std::string& name, const std::string& value) {
  const auto has_only = [](const std::string& text, const char* others) {
    return std::all_of(text.begin(), text.end(), [&](char c) {
      return static_cast<unsigned char>(c) >= 0x80 || std::isalnum(static_cast<unsigned char>(c)) != 0 ||
             (c != '\0' && std::strchr(others, c) != nullptr);
    });
  };
  if (name.empty() || !has_only(name, "_"))
    return "a variable is named \"" + visible(name) + "\", expected letters, digits and _";
  for (const std::string& word : split(value, '\n')) {
    std::string what;
    if (!has_only(word, " _.,+-*/^=()[]<>!%@~${}:&|'\""))
      what = "has a character that no number, name or path has";
    else if (word == ":")
      what = "would begin another program";
    else if (word.size() > 1 && word[0] == '-' && std::strchr("0123456789.", word[1]) == nullptr)
      what = "would be read as an option";
    if (!what.empty())
      return "the variable " + name + " has the value \"" + visible(value) + "\": \"" + visible(word) + "\" " + what +
             "; expected a number, a name, an expression or a path";
  }
  return "";
}

bool names_file(const std::string& value) {
  std::error_code ignored;
  return !value.empty() && value.front() == '/' && std::filesystem::is_regular_file(value, ignored);
}

bool ScriptCommand::is_computed() const {
  return std::any_of(words.begin(), words.end(), [](const std::string& w) { return w.find('$') != std::string::npos; });
}

bool ScriptText::straight() const {
  return std::none_of(commands_.begin(), commands_.end(),
                      [](const ScriptCommand& c) { return c.words[0] == "jump" || c.words[0] == "next"; });
}

ScriptText::ScriptText(const std::string& file, const std::map<std::string, std::string>& variables)
    : fixed_(variables),
      files_(limit::kIncludedFiles, file),
      bytes_(limit::kIncludedText, file),
      words_(limit::kScriptWords, file) {
  for (auto& [name, value] : fixed_)
    if (names_file(value)) value = hidden(value);
  const std::string folder = std::filesystem::path(file).parent_path().string();
  fixed_["here"] = hidden(folder.empty() ? "." : folder);
  read(file, file);
}

std::string ScriptText::value(const std::string& name) const { return shown(hidden_value(name)); }

std::string ScriptText::hidden_value(const std::string& name) const {
  if (const auto fixed = fixed_.find(name); fixed != fixed_.end()) return fixed->second;
  const auto own = own_.find(name);
  return own != own_.end() && own->second.find("${") == std::string::npos ? own->second : "";
}

// Commands of one file: `&` joins lines, ${name} is replaced where its value is plain.
void ScriptText::read(const std::string& file, const std::string& included_at) {
  const std::string path = std::filesystem::path(file).lexically_normal().string();
  if (std::find(open_.begin(), open_.end(), path) != open_.end()) {
    circle_ = included_at;
    return;
  }
  require_regular_file(path, kLargestText);
  TextReader lines = TextReader::if_there(path, TextReader::Ends::kNewline);
  if (!lines.opened()) {
    whole_ = false;
    return;
  }
  files_.take();
  open_.push_back(path);
  int start = 0;
  std::string text;
  while (lines.next()) {
    std::string line = lines.line();
    bytes_.take(line.size() + 1);
    contents_ += line + "\n";
    if (text.empty()) start = lines.number_of_line();
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool more = !line.empty() && line.back() == '&';
    if (more) line.pop_back();
    text += line;  // LIGGGHTS joins them without a blank
    if (more) continue;
    note_names(text);
    add({file, start, text, script_words(substitute(text)), false});
    text.clear();
  }
  open_.pop_back();
}

void ScriptText::add(const ScriptCommand& command) {
  if (command.words.empty()) return;
  words_.take(command.words.size());
  commands_.push_back(command);
  for (std::string& word : commands_.back().words) word = shown(word);
  const std::vector<std::string>& w = command.words;
  if (w[0] == "variable" && w.size() >= 4 && (w[2] == "index" || w[2] == "string" || w[2] == "equal"))
    own_.emplace(w[1], w[3]);
  if (w[0] == "include" && w.size() >= 2) include(shown(w[1]), command.place());
  if (w[0] == "jump" && w.size() >= 2 && w[1] != "SELF") whole_ = false;
  if (w[0] == "if") add_branches(command);
}

// if CONDITION then COMMAND... elif CONDITION COMMAND... else COMMAND...
void ScriptText::add_branches(const ScriptCommand& command) {
  const std::vector<std::string>& words = command.words;
  for (std::size_t i = 2; i < words.size(); ++i) {
    if (words[i] == "then" || words[i] == "else") continue;
    if (words[i] == "elif") {
      ++i;
      continue;
    }
    add({command.file, command.line, command.text, script_words(words[i]), true});
  }
}

// LIGGGHTS includes relative to its working folder; scripts write ${here} for their own.
void ScriptText::include(const std::string& name, const std::string& included_at) {
  const std::filesystem::path near = std::filesystem::path(value("here")) / name;
  std::error_code ignored;
  read(std::filesystem::exists(near, ignored) ? near.string() : name, included_at);
}

// ${name}, $c, v_name, and the names of the commands `variable` and `next`.
void ScriptText::note_names(const std::string& text) {
  for (std::size_t at = 0; at + 1 < text.size(); ++at) {
    const bool begins = at == 0 || !is_name(text[at - 1]);
    if (text[at] == '$' && text[at + 1] == '{') {
      const std::size_t end = text.find('}', at);
      if (end != std::string::npos) names_.insert(text.substr(at + 2, end - at - 2));
    } else if (text[at] == '$') {
      names_.insert(text.substr(at + 1, 1));
    } else if (begins && text.compare(at, 2, "v_") == 0) {
      std::size_t end = at + 2;
      while (end < text.size() && is_name(text[end])) ++end;
      names_.insert(text.substr(at + 2, end - at - 2));
    }
  }
  const std::vector<std::string> words = script_words(text);
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == "variable" || words[i] == "next") names_.insert(words[i + 1]);
}

// A value is inserted once and not expanded again: a variable may name itself.
std::string ScriptText::substitute(const std::string& text) {
  std::string result;
  std::size_t from = 0;  // of what is not in the result yet
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", from)) {
    const std::size_t end = text.find('}', at);
    if (end == std::string::npos) break;
    const std::string plain = hidden_value(text.substr(at + 2, end - at - 2));
    bytes_.take(plain.size());
    result.append(text, from, plain.empty() ? end - from : at - from).append(plain);
    from = plain.empty() ? end : end + 1;
  }
  return result.append(text, from);
}

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
  std::optional<ScriptText> script;  // read once
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
    if (!script) script.emplace(file, scene.particles->variables);
    Words known;
    const ScriptCommand* found = nullptr;
    for (const ScriptCommand& command : script->commands()) {
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
