#pragma once
// What a run says at its end.

#include <string>
#include <vector>

namespace footfall {

// The summary table and the paths of the files in `out`, on standard output.
void print_results(const std::string& out, const std::vector<std::string>& pictures);

// Writes the gnuplot scripts of the run in `out` and runs them; returns the pictures made. A gnuplot that is missing or fails is a
// warning on standard error, not an end.
std::vector<std::string> make_pictures(const std::string& out);

}  // namespace footfall
