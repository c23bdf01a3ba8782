#pragma once
// A reader of a library in a process of its own: a damaged file that crashes it ends that process only.

#include <functional>
#include <string>

namespace footfall {

// The result of `read`, which runs in a copy of this process with bounded memory and processor time for a file of so many
// bytes. Throws InputError with the message of what `read` throws, or that names `file` when the reader crashes or exceeds
// its limits.
std::string read_apart(const std::string& file, std::size_t bytes, const std::function<std::string()>& read);

}  // namespace footfall
