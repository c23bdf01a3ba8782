// Findings: places, order, number and the final error. A finding that repeats another word for word is dropped.

#include <algorithm>

#include "coupler/base/concat.h"
#include "mbd_solver/scene/findings.h"

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

namespace {

std::string join_path(const std::string& path, const std::string& key) {
  return path + (path.empty() || key.empty() ? "" : ".") + key;
}

}  // namespace

std::string place_of(const std::string& file, int line, const std::string& path) {
  if (line == Source::kFromSet) return "--set " + path + ": ";
  const std::string where = line > 0 ? concat(file, ":", line) : file;
  return where + ": " + (path.empty() ? "" : path + ": ");
}

std::string place_of(const std::string& file, const Source& source, const std::string& key) {
  return place_of(file, source.line_of(key), join_path(source.path, key));
}

bool names_a_place(const std::string& file, const std::string& message) {
  return message.rfind(file + ":", 0) == 0 || message.rfind("--set ", 0) == 0;
}

void Findings::coded_error(int line, const std::string& path, const std::string& what) {
  if (is_full()) return skip_error();
  const std::string text = place_of(file_, line, path) + what;
  if (texts_.insert(text).second) errors_.push_back({line, text});
}

void Findings::coded_error(const Source& source, const std::string& key, const std::string& what) {
  coded_error(source.line_of(key), join_path(source.path, key), what);
}

void Findings::coded_warning(const Source& source, const std::string& key, const std::string& what) {
  if (warnings_.size() == kMost) {
    ++more_warnings_;
  } else {
    warnings_.push_back(place_of(file_, source, key) + what);
  }
}

std::vector<std::string> Findings::warnings() const {
  std::vector<std::string> all = warnings_;
  if (more_warnings_ > 0)
    all.push_back(with_code(code::kMoreWarnings, file_, ": and ", more_warnings_,
                            " more warnings; mend the first ones, and check again"));
  return all;
}

void Findings::throw_if_errors() const {
  if (errors_.empty()) return;
  std::vector<Finding> sorted = errors_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Finding& a, const Finding& b) { return a.line < b.line; });
  std::string text;
  for (const Finding& f : sorted) text += (text.empty() ? "" : "\n") + f.text;
  if (more_errors_ > 0)
    text += "\n" + with_code(code::kMoreErrors, file_, ": and ", more_errors_,
                             " more errors; correct the first ones, and check again");
  throw InputError(text);
}

}  // namespace footfall
