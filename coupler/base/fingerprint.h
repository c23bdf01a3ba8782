#pragma once
// A short name for a text that tells it from others.

#include <string>

namespace footfall {

// 32 hexadecimal digits: FNV-1a of 64 bits, twice with different starts.
std::string fingerprint(const std::string& text);

}  // namespace footfall
