#include "mbd_solver/scene/script_text.h"

#include <filesystem>
#include <fstream>
#include <sstream>

namespace footfall {

namespace {
constexpr int kDeepestInclude = 10;
}

ScriptText::ScriptText(const std::string& file, const std::map<std::string, std::string>& variables)
    : fixed_(variables) {
  fixed_["here"] = std::filesystem::path(file).parent_path().string();
  read(file, 0);
}

// Commands of one file: `&` joins lines, `#` starts a comment, ${name} is replaced where its value is plain.
void ScriptText::read(const std::string& file, int depth) {
  std::ifstream stream(file);
  int number = 0, start = 0;
  std::string text, line;
  while (std::getline(stream, line)) {
    ++number;
    contents_ += line + "\n";
    if (text.empty()) start = number;
    line = line.substr(0, line.find('#'));
    line.erase(line.find_last_not_of(" \t\r") + 1);
    const bool more = !line.empty() && line.back() == '&';
    if (more) line.pop_back();
    text += line + " ";
    if (more) continue;
    add(file, start, substitute(text), depth);
    text.clear();
  }
}

void ScriptText::add(const std::string& file, int line, const std::string& text, int depth) {
  std::istringstream stream(text);
  ScriptCommand command{file, line, {}};
  for (std::string word; stream >> word;) command.words.push_back(word);
  const std::vector<std::string>& w = command.words;
  if (w.empty()) return;
  if (w[0] == "variable" && w.size() >= 4 && (w[2] == "index" || w[2] == "string" || w[2] == "equal"))
    own_.emplace(w[1], w[3]);
  const bool include = w[0] == "include" && w.size() >= 2 && depth < kDeepestInclude;
  const std::string included = include ? (std::filesystem::path(fixed_.at("here")) / w[1]).string() : "";
  commands_.push_back(std::move(command));
  if (include) read(included, depth + 1);
}

std::string ScriptText::substitute(std::string text) const {
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", at + 1)) {
    const std::size_t end = text.find('}', at);
    if (end == std::string::npos) break;
    const std::string name = text.substr(at + 2, end - at - 2);
    const auto fixed = fixed_.find(name);
    const auto own = own_.find(name);
    if (fixed != fixed_.end()) {
      text.replace(at, end - at + 1, fixed->second);
    } else if (own != own_.end() && own->second.find("${") == std::string::npos) {
      text.replace(at, end - at + 1, own->second);
    }
  }
  return text;
}

}  // namespace footfall
