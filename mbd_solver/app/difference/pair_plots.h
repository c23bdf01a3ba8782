#pragma once
// footfall plot A B COLUMN...: the curves of two runs over each other, and their difference below.

#include <string>
#include <vector>

#include "mbd_solver/app/difference/run_pair.h"
#include "mbd_solver/app/plots.h"

namespace footfall {

struct PairPlots {
  History history;  // on_one_clock; the figures name its columns
  Panels panels;    // per unit: the curves, dashed for the second run; then second minus first
};
// Throws InputError for a column that the second run does not have.
PairPlots plots_of_columns(const RunPair& pair, const std::vector<std::string>& columns);

}  // namespace footfall
