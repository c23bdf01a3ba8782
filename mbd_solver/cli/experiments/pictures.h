#pragma once
// Pictures of an experiment, drawn by gnuplot from the CSV files of its folder and of its runs.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/results.h"
#include "mbd_solver/cli/experiments/table.h"

namespace footfall {

// Each draws NAME.png and NAME.svg in `folder` and returns the PNG files. Throws InputError when gnuplot is missing or
// fails.

// The histories of [[plots]] over time, one line per case.
std::vector<std::string> draw_plots(const ExperimentSpec& spec, const Results& results, const std::string& folder);
// From NAME.csv, which holds `table` (error_page.h): one row per figure, error over x on the left (slopes: observed
// orders), over run time on the right, all axes logarithmic. Of an ensemble, whose runs often share the machine, errors
// are over the processor time of all programs, and bars go up by the standard error.
std::vector<std::string> draw_errors(const ExperimentSpec& spec, const Results& results, const std::string& folder,
                                     const std::string& name, const Table& table);

}  // namespace footfall
