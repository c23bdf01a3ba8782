#include "mbd_solver/scene/findings.h"

#include <algorithm>

#include "coupler/base/errors.h"

namespace footfall {

int Source::line_of(const std::string& key) const {
  for (std::string k = key; !k.empty();) {
    const auto found = lines.find(k);
    if (found != lines.end()) return found->second;
    const std::size_t dot = k.rfind('.');
    k = dot == std::string::npos ? "" : k.substr(0, dot);
  }
  return line;
}

std::string Findings::format(int line, const std::string& path, const std::string& what) const {
  if (line == Source::kFromSet) return "--set " + path + ": " + what;
  const std::string where = line > 0 ? file_ + ":" + std::to_string(line) : file_;
  return where + ": " + (path.empty() ? "" : path + ": ") + what;
}

void Findings::error(int line, const std::string& path, const std::string& what) {
  const std::string text = format(line, path, what);
  for (const Finding& f : errors_) {
    if (f.text == text) return;
  }
  errors_.push_back({line, text});
}

namespace {
std::string join_path(const std::string& path, const std::string& key) {
  if (path.empty() || key.empty()) return path + key;
  return path + "." + key;
}
}  // namespace

void Findings::error(const Source& source, const std::string& key, const std::string& what) {
  error(source.line_of(key), join_path(source.path, key), what);
}

void Findings::warning(const Source& source, const std::string& key, const std::string& what) {
  warnings_.push_back(format(source.line_of(key), join_path(source.path, key), what));
}

void Findings::throw_if_errors() const {
  if (errors_.empty()) return;
  std::vector<Finding> sorted = errors_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Finding& a, const Finding& b) { return a.line < b.line; });
  std::string text;
  for (const Finding& f : sorted) text += (text.empty() ? "" : "\n") + f.text;
  throw InputError(text);
}

}  // namespace footfall
