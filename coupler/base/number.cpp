// Reading by strtod with a locale of its own, because from_chars reads neither signs nor numbers beyond the range of
// a double; writing by to_chars.

#include "coupler/base/number.h"

#include <charconv>
#include <clocale>
#include <cmath>
#include <cstdlib>

#include <locale.h>

#include "coupler/base/text.h"

namespace footfall {

double read_number(const char* text, char** rest) {
  static const locale_t plain = newlocale(LC_ALL_MASK, "C", nullptr);
  return strtod_l(text, rest, plain);
}

std::string hexadecimal(double value) {
  char digits[64];
  const auto end = std::to_chars(digits, digits + sizeof digits, std::abs(value), std::chars_format::hex).ptr;
  const std::string sign = std::signbit(value) ? "-" : "";
  return sign + (std::isfinite(value) ? "0x" : "") + std::string(digits, end);
}

std::string plain_text(double value) { return fixed_text(value, 6); }

}  // namespace footfall
