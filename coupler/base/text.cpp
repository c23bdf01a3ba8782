#include "coupler/base/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <sstream>

#include "coupler/base/quick_number.h"

namespace footfall {

void append_number(std::string& text, double value, int digits) {
  std::array<char, 64> written;
  if (char* const end = write_quickly(written.data(), value, digits)) {
    text.append(written.data(), end);
    return;
  }
  const std::to_chars_result result =
      std::to_chars(written.data(), written.data() + written.size(), value, std::chars_format::general, digits);
  text.append(written.data(), result.ptr);
}

std::string number_text(double value, int digits) {
  std::string text;
  append_number(text, value, digits);
  return text;
}

std::string fixed_text(double value, int decimals) {
  char text[400];  // the largest double has 309 digits before the point
  std::snprintf(text, sizeof text, "%.*f", decimals, value);
  return text;
}

std::string share_text(double share) {
  return (std::abs(share) < 0.995 ? number_text(100.0 * share, 2) : fixed_text(100.0 * share, 0)) + " %";
}

std::string joined(const std::vector<std::string>& texts, const std::string& between) {
  std::string all;
  for (const std::string& text : texts) all += (&text == &texts.front() ? "" : between) + text;
  return all;
}

std::vector<std::string> split(const std::string& line, char mark) {
  std::vector<std::string> cells;
  std::istringstream stream(line);
  for (std::string cell; std::getline(stream, cell, mark);) cells.push_back(cell);
  return cells;
}

bool is_plain_name(const std::string& text) {
  if (text.empty() || text.front() == '.' || text.size() > kLongestName) return false;
  return std::all_of(text.begin(), text.end(), [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_' || c == '-' ||
           c == '.';
  });
}

std::string trimmed(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r");
  if (first == std::string::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t\r") - first + 1);
}

bool ends_with(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

}  // namespace footfall
