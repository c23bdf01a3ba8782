#pragma once
// footfall report A B: one page about the difference of two runs, or of the samples of two sweeps.

#include <string>

namespace footfall {

// Writes A/difference.html and returns its path. Throws InputError for folders without a run, and for sweeps without results or
// without a common case.
std::string write_difference(const std::string& a, const std::string& b);

}  // namespace footfall
