#pragma once
// Runs gnuplot.

#include <string>
#include <vector>

namespace footfall {

// What a script begins with that draws columns of CSV files by their names.
inline constexpr const char* kCsv = "set datafile separator ','\nset datafile columnheaders\nset encoding utf8\n";

struct PictureSize {
  int width, height;  // [pixels]
};

// Writes NAME.gp into `folder`, which draws NAME.png and NAME.svg: `setup` once, then `drawing` for each. Returns
// NAME.gp.
std::string write_drawing(const std::string& folder, const std::string& name, const PictureSize& size,
                          const std::string& setup, const std::string& drawing);

// Runs the scripts in `folder`, where each makes NAME.png; returns these pictures. Throws InputError when gnuplot is
// missing or fails.
std::vector<std::string> run_gnuplot(const std::string& folder, const std::vector<std::string>& scripts);

}  // namespace footfall
