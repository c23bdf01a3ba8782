#pragma once
// Names in CSV files.

#include <string>

namespace footfall {

// `text` as one field of a CSV file (RFC 4180): in quotes, its own doubled, where it holds a comma or a quote.
inline std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string(2, '"') : std::string(1, c);
  return field + '"';
}

}  // namespace footfall
