// The same in every locale.

#include "mbd_solver/base/exact_number.h"

#include <charconv>
#include <cmath>

namespace footfall {

std::string shortest_text(double value) {
  char text[40];
  return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

double exact_number(const std::string& text) {
  double value = std::nan("");
  std::from_chars(text.data(), text.data() + text.size(), value);
  return value;
}

}  // namespace footfall
