// Lines to commands: joins and comments, quotes, plain variables, includes and branches.
#include "mbd_solver/scene/script_text.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <fstream>

#include "mbd_solver/base/csv.h"

namespace footfall {
namespace {

bool is_name(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

// As LIGGGHTS splits a line: outside of quotes blanks separate words, and `#` begins a comment.
std::vector<std::string> words_of(const std::string& text) {
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

}  // namespace

std::optional<double> as_number(const std::string& text) {
  double value = 0.0;
  return read_number(text, value) ? std::optional<double>(value) : std::nullopt;
}

bool ScriptCommand::is_computed() const {
  return std::any_of(words.begin(), words.end(), [](const std::string& w) { return w.find('$') != std::string::npos; });
}

bool ScriptText::straight() const {
  return std::none_of(commands_.begin(), commands_.end(),
                      [](const ScriptCommand& c) { return c.words[0] == "jump" || c.words[0] == "next"; });
}

ScriptText::ScriptText(const std::string& file, const std::map<std::string, std::string>& variables)
    : fixed_(variables) {
  fixed_["here"] = std::filesystem::path(file).parent_path().string();
  read(file, file);
}

std::string ScriptText::value(const std::string& name) const {
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
  std::ifstream stream(path);
  if (!stream) {
    whole_ = false;
    return;
  }
  open_.push_back(path);
  int number = 0, start = 0;
  std::string text, line;
  while (std::getline(stream, line)) {
    ++number;
    contents_ += line + "\n";
    if (text.empty()) start = number;
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool more = !line.empty() && line.back() == '&';
    if (more) line.pop_back();
    text += line + " ";
    if (more) continue;
    note_names(text);
    add({file, start, text, words_of(substitute(text)), false});
    text.clear();
  }
  open_.pop_back();
}

void ScriptText::add(ScriptCommand command) {
  if (command.words.empty()) return;
  commands_.push_back(command);
  const std::vector<std::string>& w = command.words;
  if (w[0] == "variable" && w.size() >= 4 && (w[2] == "index" || w[2] == "string" || w[2] == "equal"))
    own_.emplace(w[1], w[3]);
  if (w[0] == "include" && w.size() >= 2) include(w[1], command.place());
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
    add({command.file, command.line, command.text, words_of(words[i]), true});
  }
}

// LIGGGHTS includes relative to its working folder; scripts write ${here} for their own.
void ScriptText::include(const std::string& name, const std::string& included_at) {
  const std::filesystem::path near = std::filesystem::path(fixed_.at("here")) / name;
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
  const std::vector<std::string> words = words_of(text);
  for (std::size_t i = 0; i + 1 < words.size(); ++i)
    if (words[i] == "variable" || words[i] == "next") names_.insert(words[i + 1]);
}

// A value is inserted once and not expanded again: a variable may name itself.
std::string ScriptText::substitute(std::string text) const {
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", at)) {
    const std::size_t end = text.find('}', at);
    if (end == std::string::npos) break;
    const std::string name = text.substr(at + 2, end - at - 2), plain = value(name);
    if (plain.empty()) {
      at = end;
      continue;
    }
    text.replace(at, end - at + 1, plain);
    at += plain.size();
  }
  return text;
}

}  // namespace footfall
