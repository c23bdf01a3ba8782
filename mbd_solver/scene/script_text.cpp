#include "mbd_solver/scene/script_text.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "coupler/base/errors.h"

namespace footfall {

namespace {

std::string joined_by_arrows(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text += (text.empty() ? "" : " -> ") + name;
  return text;
}

}  // namespace

ScriptText::ScriptText(const std::string& file, const std::map<std::string, std::string>& variables)
    : fixed_(variables) {
  fixed_["here"] = std::filesystem::path(file).parent_path().string();
  read(file);
}

// Commands of one file: `&` joins lines, `#` starts a comment, ${name} is replaced where its value is plain.
void ScriptText::read(const std::string& file) {
  open_.push_back(std::filesystem::path(file).lexically_normal().string());
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
    try {
      text = substitute(text);
    } catch (const InputError& error) {
      throw InputError(file + ":" + std::to_string(start) + ": " + error.what());
    }
    add(file, start, text);
    text.clear();
  }
  open_.pop_back();
}

void ScriptText::add(const std::string& file, int line, const std::string& text) {
  std::istringstream stream(text);
  ScriptCommand command{file, line, {}};
  for (std::string word; stream >> word;) command.words.push_back(word);
  const std::vector<std::string>& w = command.words;
  if (w.empty()) return;
  if (w[0] == "variable" && w.size() >= 4 && (w[2] == "index" || w[2] == "string" || w[2] == "equal"))
    own_.emplace(w[1], w[3]);
  const bool include = w[0] == "include" && w.size() >= 2;
  const std::string included = include ? (std::filesystem::path(fixed_.at("here")) / w[1]).string() : "";
  commands_.push_back(std::move(command));
  if (!include) return;
  std::vector<std::string> around = open_;
  around.push_back(std::filesystem::path(included).lexically_normal().string());
  if (std::find(open_.begin(), open_.end(), around.back()) != open_.end())
    throw InputError(file + ":" + std::to_string(line) + ": the script includes itself: " + joined_by_arrows(around) +
                     "; remove one of these includes");
  read(included);
}

std::string ScriptText::substitute(std::string text, const std::vector<std::string>& inside) const {
  std::size_t next = 0;
  for (std::size_t at = text.find("${"); at != std::string::npos; at = text.find("${", next)) {
    next = at + 1;
    const std::size_t end = text.find('}', at);
    if (end == std::string::npos) break;
    const std::string name = text.substr(at + 2, end - at - 2);
    const auto fixed = fixed_.find(name);
    const auto own = own_.find(name);
    if (fixed != fixed_.end()) {
      std::vector<std::string> within = inside;
      within.push_back(name);
      if (std::find(inside.begin(), inside.end(), name) != inside.end())
        throw InputError("the variable \"" + name + "\" of the scene names itself: " + joined_by_arrows(within) +
                         "; give it a value");
      const std::string value = substitute(fixed->second, within);
      text.replace(at, end - at + 1, value);
      next = at + value.size();
    } else if (own != own_.end() && own->second.find("${") == std::string::npos) {
      text.replace(at, end - at + 1, own->second);
    }
  }
  return text;
}

}  // namespace footfall
