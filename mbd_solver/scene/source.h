#pragma once
// Where an entry of a scene came from, so that a finding about it can name file and line.

#include <map>
#include <set>
#include <string>

namespace footfall {

struct Source {
  std::string path;  // "bodies.cabin", "struts.primary_1", "solver": for messages and --set
  int line = 0;      // of the entry; 0: not in the file (a default)
  std::map<std::string, int>
      lines;                      // of each key given in it: "mass", "gas.exponent"; a key from --set has line kFromSet
  std::set<std::string> refused;  // those keys whose value was reported when it was read, and is not in the scene

  static constexpr int kFromSet = -1;
  // Line of a key, or of the nearest key around it that was given.
  int line_of(const std::string& key) const;
  bool given(const std::string& key) const { return lines.count(key) > 0; }
  // Given, and the scene has its value.
  bool good(const std::string& key) const { return given(key) && refused.count(key) == 0; }
  // Both keys stand in the scene file itself. Where one came from --set or from a base, what the other says may be left
  // over on purpose.
  bool written_together(const std::string& a, const std::string& b) const {
    return given(a) && given(b) && lines.at(a) > 0 && lines.at(b) > 0;
  }
};

}  // namespace footfall
