#pragma once
// Files to be read: regular ones of a plausible size. A pipe would wait for ever, a device has no end.

#include <cstdint>
#include <string>

namespace footfall {

inline constexpr std::uint64_t kLargestFile = std::uint64_t{4} << 30;   // [bytes]
inline constexpr std::uint64_t kLargestText = std::uint64_t{64} << 20;  // [bytes] of a scene or script

// Throws InputError where the path names a pipe, a device or a socket, or a larger file. Folders and missing files are
// left to the caller.
void require_regular_file(const std::string& path, std::uint64_t largest = kLargestFile);

}  // namespace footfall
