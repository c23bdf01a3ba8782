#pragma once
// Where an entry of a scene was given, so that a finding can name file and line.

#include <map>
#include <set>
#include <string>

namespace footfall {

struct Source {
  std::string path;  // "bodies.cabin", "struts.primary_1", "solver": for messages and --set
  int line = 0;      // of the entry; 0: not in the file (a default)
  std::map<std::string, int>
      lines;                      // of each key given in it: "mass", "gas.exponent"; a key from --set has line kFromSet
  std::set<std::string> refused;  // keys whose value was reported by the reader, and is not in the scene

  static constexpr int kFromSet = -1;
  // Line of a key, or of the innermost given key around it.
  int line_of(const std::string& key) const;
  bool given(const std::string& key) const { return lines.count(key) > 0; }
  // Given, and its value was accepted.
  bool good(const std::string& key) const { return given(key) && refused.count(key) == 0; }
  // Both keys are in the scene file itself. If one came from --set or a base, the other may remain on purpose.
  bool written_together(const std::string& a, const std::string& b) const {
    return given(a) && given(b) && lines.at(a) > 0 && lines.at(b) > 0;
  }
};

}  // namespace footfall
