#include "mbd_solver/fe/text_records.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>

#include "coupler/base/errors.h"

namespace footfall {

TextRecords::TextRecords(const std::string& path, char comment) : path_(path), comment_(comment), stream_(path) {
  if (!stream_)
    throw InputError(path + ": the file cannot be opened. Check the name; it is relative to the scene file.");
}

bool TextRecords::next() {
  std::string line;
  while (std::getline(stream_, line)) {
    ++line_;
    line.erase(std::find(line.begin(), line.end(), comment_), line.end());
    std::istringstream blanks(line);
    words_.clear();
    for (std::string word; blanks >> word;) words_.push_back(word);
    if (!words_.empty()) return true;
  }
  return false;
}

void TextRecords::require_next(const std::string& expected) {
  if (!next()) fail("the file ends here, expected " + expected + ".");
}

double TextRecords::number(std::size_t i) const {
  if (i >= words_.size())
    fail("expected at least " + std::to_string(i + 1) + " numbers, found " + std::to_string(words_.size()) + ".");
  char* end = nullptr;
  const double value = std::strtod(words_[i].c_str(), &end);
  if (end == words_[i].c_str() || *end != '\0' || !std::isfinite(value))
    fail("\"" + words_[i] + "\" is not a finite number.");
  return value;
}

int TextRecords::integer(std::size_t i, int low, int high) const {
  const double value = number(i);
  if (value != std::floor(value) || value < low || value > high)
    fail("\"" + words_[i] + "\", expected a whole number from " + std::to_string(low) + " to " + std::to_string(high) +
         ".");
  return static_cast<int>(value);
}

void TextRecords::fail(const std::string& message) const {
  throw InputError(path_ + ":" + std::to_string(line_) + ": " + message);
}

}  // namespace footfall
