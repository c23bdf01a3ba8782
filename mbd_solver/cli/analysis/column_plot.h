#pragma once
// footfall plot: columns of a run's history as a picture.

#include <string>
#include <vector>

namespace footfall {

struct ColumnPlot {
  std::string run;                   // folder of a run
  std::vector<std::string> columns;  // words for columns (column_choice.h); none: list the columns
  std::string out;                   // .png or .svg; empty: both, in RUN/plots, named by the words
  std::string title;                 // empty: that of the scene
};

// Draws them and returns what to tell the user: the pictures made, or the columns that there are. Throws InputError when
// the folder holds no history, a word means no column, or gnuplot fails.
std::vector<std::string> plot_columns(const ColumnPlot& plot);

}  // namespace footfall
