#pragma once
// footfall report A B: one page about the difference of two runs, or of the samples of two sweeps (sample_page.h).

#include <string>

namespace footfall {

// Writes A/difference.html and returns its path. Throws InputError for folders without a run.
std::string write_difference(const std::string& a, const std::string& b);

}  // namespace footfall
