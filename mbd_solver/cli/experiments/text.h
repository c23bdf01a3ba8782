#pragma once
// Numbers and names in tables, and the files that take them.

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <string>

#include "coupler/base/errors.h"

namespace footfall {

inline std::string number(double value, const char* format = "%.6g") {
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

// A cell of a table: empty where there is no number.
inline std::string cell(double value, const char* format = "%.6g") {
  return std::isfinite(value) ? number(value, format) : "";
}

inline std::string percent(double share) { return number(100.0 * share, "%.2g"); }

// The number that a text is; none when it is more or less than one.
inline std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

// `text` as one field of a CSV file (RFC 4180): in quotes, its own doubled, where it holds a comma or a quote.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string(2, '"') : std::string(1, c);
  return field + '"';
}

// Throws InputError when it cannot be written.
inline std::ofstream open_output(const std::string& path) {
  std::ofstream out(path);
  if (!out) throw InputError(path + ": cannot be written");
  return out;
}

}  // namespace footfall
