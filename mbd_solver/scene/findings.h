#pragma once
// Everything that is wrong with a scene, collected, so that the user sees all of it at once.

#include <string>
#include <vector>

#include "mbd_solver/scene/source.h"

namespace footfall {

// "scene.toml:40: signals.s.input: " or "--set signals.s.input: "; the line and the path come from `source`, the key may be
// empty.
std::string place_of(const std::string& file, const Source& source, const std::string& key = "");
// The same from the parts: line kFromSet means "--set", 0 that it is not known.
std::string place_of(const std::string& file, int line, const std::string& path);
// A message that begins with a place in this file or in --set.
bool names_a_place(const std::string& file, const std::string& message);

class Findings {
 public:
  explicit Findings(std::string file) : file_(std::move(file)) {}

  // `key` within the entry; the path of the entry and the line come from `source`.
  void error(const Source& source, const std::string& key, const std::string& what);
  void warning(const Source& source, const std::string& key, const std::string& what);
  // The same from the parts: line kFromSet means "--set".
  void error(int line, const std::string& path, const std::string& what);

  bool has_errors() const { return !errors_.empty(); }
  int error_count() const { return static_cast<int>(errors_.size()); }
  const std::vector<std::string>& warnings() const { return warnings_; }
  // Throws InputError with one finding per line, ordered by line, if there is any error.
  void throw_if_errors() const;

 private:
  struct Finding {
    int line;
    std::string text;
  };

  std::string file_;
  std::vector<Finding> errors_;
  std::vector<std::string> warnings_;
};

}  // namespace footfall
