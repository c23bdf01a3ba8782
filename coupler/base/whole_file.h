#pragma once
// A text file that is there whole or not at all: written beside the target and renamed, so that neither a reader nor a
// kill meets half of it.

#include <string>

namespace footfall {

// Throws InputError when the file cannot be written; what stood there before is then kept.
void write_whole_file(const std::string& path, const std::string& text);

}  // namespace footfall
