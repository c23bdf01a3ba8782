#pragma once
// What a run says at its end.

#include <string>
#include <vector>

namespace footfall {

// The summary table and the paths of the files in `out`, on standard output.
void print_results(const std::string& out, const std::vector<std::string>& pictures);

// Writes ledger.csv (output/energy_ledger.h) of the run in `out` and its end figures into summary.json, under "ledger".
// False when the run left too little to make one; what is wrong with its files is a warning on standard error.
bool write_ledger(const std::string& out);

// Writes the gnuplot scripts of the run in `out` and runs them; returns the pictures made. A gnuplot that is missing or
// fails is a warning on standard error, not an end.
std::vector<std::string> make_pictures(const std::string& out);

}  // namespace footfall
