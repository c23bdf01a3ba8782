#pragma once
// footfall report A B of which one is a sweep: one page about the difference of ensembles.

#include <string>

namespace footfall {

// Writes A/difference.html and returns its path: a section per case that both folders have; two
// folders with a single case each are compared whatever its name. Throws InputError for folders
// without results, or without a common case.
std::string write_sample_difference(const std::string& a, const std::string& b);

}  // namespace footfall
