#pragma once
// A checksum that serves as a short name of a text.

#include <string>

namespace footfall {

// 32 hexadecimal digits: FNV-1a of 64 bits with two start values.
std::string fingerprint(const std::string& text);

}  // namespace footfall
