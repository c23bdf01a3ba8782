#pragma once
// A reader that is not ours, in a process of its own: what a damaged file does to it ends that process alone.

#include <functional>
#include <string>

namespace footfall {

// What `read` returns. It runs in a copy of this process, with bounded memory and processor time for a file of so many
// bytes. Throws InputError with the message of what `read` throws; `file` and why, when the reader crashes or takes
// too much.
std::string read_apart(const std::string& file, std::size_t bytes, const std::function<std::string()>& read);

}  // namespace footfall
