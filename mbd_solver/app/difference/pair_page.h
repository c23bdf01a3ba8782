#pragma once
// A second run in the page of a first one: as a ghost in the picture, dashed in the plots, and as a difference. And `plot A B`.

#include <string>
#include <vector>

#include "mbd_solver/app/difference/run_pair.h"
#include "mbd_solver/app/plots.h"
#include "mbd_solver/app/report.h"

namespace footfall {

// run.name of the first run; run.other of the second: name, history, and with `shapes` its bodies, whose chunks begin with "other-";
// and run.differences: [key, value, value] of both scenes.
void add_second_run(const RunPair& pair, bool shapes, PageParts& parts);

// Plots of two histories on a page, with the names of both: these columns at first.
struct NamedHistory {
  std::string name;
  const History& history;
};
PageParts plots_of_histories(const NamedHistory& first, const NamedHistory& second,
                             const std::vector<std::string>& shown);

// Plots of both runs for a report: the histories, and these columns at first.
PageParts plots_of_pair(const RunPair& pair, const std::vector<std::string>& shown);

// footfall plot A B COLUMN...: the curves of two runs over each other, and their difference below.
struct PairPlots {
  History history;  // on_one_clock; the figures name its columns
  Panels panels;    // per unit: the curves, dashed for the second run; then second minus first
};
// Throws InputError for a column that the second run does not have.
PairPlots plots_of_columns(const RunPair& pair, const std::vector<std::string>& columns);

}  // namespace footfall
