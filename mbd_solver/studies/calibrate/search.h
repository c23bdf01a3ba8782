#pragma once
// Searches as functions of the known misfits. A search starts again whenever more misfits are known and repeats its path up to
// there, so the path depends neither on the number of runs at once nor on interruptions, and the runs are its only state.
//
// Where a misfit is not known yet, the search continues with that of the nearest known set, to find out which sets it will
// probably request next; these are run at the same time. Only the first of them is certain; those of a global search are
// nearly always right, because its first sets do not depend on misfits.

#include <functional>
#include <optional>
#include <vector>

#include "mbd_solver/studies/calibration.h"

namespace footfall {

struct SearchPath {
  std::vector<UnitPoint> requested;  // not known yet, the certain one first; empty: the stage has ended
  UnitPoint best;                    // of the known ones
  double misfit = std::numeric_limits<double>::infinity();
  std::vector<UnitPoint> sets;  // in the order of the search, each once
  std::string end;              // reason of the end
};

struct SearchQueries {
  std::function<std::optional<double>(const UnitPoint&)> misfit;  // none: not known yet
  // Of gauss_newton, whose misfit is their sum of squares; of known sets only. Empty: a run failed.
  std::function<std::vector<double>(const UnitPoint&)> residuals;
  std::function<bool(const UnitPoint&)> may_continue;  // called before each set that is known or certain
};

// `most_requested`: number of sets requested at once. `start`: first set of a local search. `step`: of the differences of
// gauss_newton, whose sets are requested together. Method listed takes its sets in order.
SearchPath search_path(const StageSpec& stage, const UnitPoint& start, double step, const SearchQueries& queries,
                       std::size_t most_requested);

}  // namespace footfall
