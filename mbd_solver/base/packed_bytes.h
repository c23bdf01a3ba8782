#pragma once
// Bytes compressed by zlib (RFC 1950), and bytes as base64.

#include <optional>
#include <string>
#include <string_view>

namespace footfall {

std::string deflated(const std::string& bytes);
// The `size` bytes that were compressed; nothing for damaged data or another size.
std::optional<std::string> inflated(const std::string& packed, std::size_t size);

std::string base64(const std::string& bytes);
// Up to the first "="; nothing where another character is no digit of base64.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace footfall
