#pragma once
// Numbers with all their digits, between programs and in files that are read again; the same in every locale. Here in full, so that the
// library of an FMU can use them without other code.

#include <charconv>
#include <cmath>
#include <string>

namespace footfall {

// The shortest text that is read as this number.
inline std::string shortest_text(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

// NaN: the text is no number.
inline double exact_number(const std::string& text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace footfall
