#pragma once
// Runs gnuplot.

#include <string>
#include <vector>

namespace footfall {

// Runs the scripts in `folder`, where each makes NAME.png; returns these pictures. Throws InputError when gnuplot is
// missing or fails.
std::vector<std::string> run_gnuplot(const std::string& folder, const std::vector<std::string>& scripts);

}  // namespace footfall
