#include "coupler/words.h"

#include <cstdlib>

namespace footfall {

std::optional<int> whole_number(const std::string& word, int least, int most) {
  char* rest = nullptr;
  const long number = std::strtol(word.c_str(), &rest, 10);
  if (word.empty() || *rest != '\0' || number < least || number > most) return std::nullopt;
  return static_cast<int>(number);
}

std::optional<double> positive_number(const std::string& word) {
  char* rest = nullptr;
  const double number = std::strtod(word.c_str(), &rest);
  if (word.empty() || *rest != '\0' || !(number > 0.0)) return std::nullopt;
  return number;
}

}  // namespace footfall
