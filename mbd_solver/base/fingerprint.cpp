// FNV-1a with two start values: 128 bits.

#include "mbd_solver/base/fingerprint.h"

#include <cstdint>
#include <cstdio>

namespace footfall {

std::string fingerprint(const std::string& text) {
  std::string hex;
  for (std::uint64_t value : {0xcbf29ce484222325ull, 0x84222325cbf29ce4ull}) {
    for (const char c : text) value = (value ^ static_cast<unsigned char>(c)) * 0x100000001b3ull;
    char digits[17];
    std::snprintf(digits, sizeof digits, "%016llx", static_cast<unsigned long long>(value));
    hex += digits;
  }
  return hex;
}

}  // namespace footfall
