#pragma once
// Pictures of an experiment's histories over time, one line per case.

#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/results.h"

namespace footfall {

// NAME.png and NAME.svg in `folder` for every plot; returns the PNG files. Throws InputError when gnuplot is missing or
// fails.
std::vector<std::string> draw_plots(const ExperimentSpec& spec, const Results& results, const std::string& folder);

}  // namespace footfall
