#pragma once
// Parts of a scene as text, for tests that read scenes. Numbers have 17 digits: they are read back as they were.

#include <cstdio>
#include <string>

namespace footfall::test {

inline std::string word(const std::string& text) { return text; }
inline std::string word(double number) {
  char out[40];
  std::snprintf(out, sizeof out, "%.17g", number);
  return out;
}
// Texts and numbers, one behind the other.
template <class... Words>
std::string lines(const Words&... words) {
  return (word(words) + ... + std::string());
}

// inertia: "[1, 2, 3]" [kg m2], or the number of all three; position: "[x, y, z]" [m].
inline std::string body(const std::string& name, double mass, const std::string& position,
                        const std::string& inertia = "[0.1, 0.1, 0.1]") {
  return lines("[[bodies]]\nname = \"", name, "\"\nmass = ", mass, "\ninertia = ", inertia, "\nposition = ", position,
               "\n");
}
inline std::string body(const std::string& name, double mass, double inertia, const std::string& position) {
  return body(name, mass, position, lines("[", inertia, ", ", inertia, ", ", inertia, "]"));
}

// Between the bodies a and b; point: "[x, y, z]" [m]; axis: "x", or "[1, 1, 0]"; more: further lines.
inline std::string joint(const std::string& name, const std::string& kind, const std::string& a, const std::string& b,
                         const std::string& point, const std::string& axis = "", const std::string& more = "") {
  const std::string direction = axis.empty() || axis[0] == '[' || axis[0] == '"' ? axis : "\"" + axis + "\"";
  return "[[joints]]\nname = \"" + name + "\"\nkind = \"" + kind + "\"\nbodies = [\"" + a + "\", \"" + b +
         "\"]\npoint = " + point + (axis.empty() ? "" : "\naxis = " + direction) + "\n" + more;
}

}  // namespace footfall::test
