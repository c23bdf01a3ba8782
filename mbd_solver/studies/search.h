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
  std::function<bool(const UnitPoint&)> may_continue;             // called before each set that is known or certain
};

// A search by NLopt. `most_requested`: number of sets requested at once. `start`: first set of a local search. Throws
// InputError when NLopt refuses.
// Of a local or global search; of method listed its sets in order.
SearchPath search_path(const StageSpec& stage, const UnitPoint& start, const SearchQueries& queries,
                       std::size_t most_requested);

// Coordinate descent for cheap functions with kinks: steps of every parameter in both directions as long as one of them
// improves the value, then shorter ones. `steps`: from long to short. `value`: infinite where a set is not allowed.
struct DescentBounds {
  UnitPoint least, most;
};
UnitPoint descend(UnitPoint u, const DescentBounds& bounds, const std::vector<double>& steps,
                  const std::function<double(const UnitPoint&)>& value);

// The method gauss_newton (Levenberg-Marquardt). From a set u with residuals r, and derivatives J by central differences of
// `step`, whose sets are run at the same time,
//
//   (J^T J + lambda I) d = -J^T r,   u + d limited to the ranges
//
// lambda falls to a tenth after a better set, and grows ten times otherwise. Ends when d is within the stage's precision, or
// lambda at its largest value.

struct LeastSquaresQueries {
  std::function<std::optional<std::vector<double>>(const UnitPoint&)> residuals;  // none: not known yet; empty: failed
  std::function<bool(const UnitPoint&)> may_continue;
};

SearchPath least_squares_path(const StageSpec& stage, const UnitPoint& start, double step,
                              const LeastSquaresQueries& queries);

}  // namespace footfall
