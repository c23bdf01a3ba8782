#pragma once
// Numbers and names in tables, and the files that take them.

#include <cmath>
#include <cstdlib>
#include <optional>
#include <string>

#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"

namespace footfall {

// A cell of a table: empty where there is no number.
inline std::string cell(double value, int digits = 6) { return std::isfinite(value) ? number_text(value, digits) : ""; }

inline std::string percent(double share) { return number_text(100.0 * share, 2); }

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

}  // namespace footfall
