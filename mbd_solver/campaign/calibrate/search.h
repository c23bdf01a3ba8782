#pragma once
// Searches as functions of the known results: they repeat their path up to the first unknown set and request it, so the path
// depends neither on the number of runs at once nor on interruptions, and the runs are its only state.

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
  // Residuals for gauss_newton, whose misfit is their sum of squares; for known sets only. Empty: a run failed.
  std::function<std::vector<double>(const UnitPoint&)> residuals;
};

// For all methods but surrogate. `start`: first set of a local search. `step`: of the differences of gauss_newton,
// whose sets are requested together. Otherwise, where a misfit is not known yet, the search continues with the misfit
// of the nearest known set, and requests as many as `most_requested` at once: only the first set is certain; the sets
// of a global search are nearly always right, because its first sets do not depend on misfits.
SearchPath search_path(const StageSpec& stage, const UnitPoint& start, double step, const SearchQueries& queries,
                       std::size_t most_requested);

struct SurrogateQueries {
  // The numbers k of a set; none: not known yet; empty: a run failed.
  std::function<std::optional<std::vector<double>>(const UnitPoint&)> numbers;
  std::function<double(std::size_t, double)> part;  // of number k with this value in Phi
  std::vector<std::vector<std::size_t>> moved_by;   // the parameters that affect number k
  std::vector<UnitPoint> earlier;                   // sets known before
  std::function<bool(const UnitPoint&)> allowed = [](const UnitPoint&) { return true; };  // constraints hold
};

// The method surrogate, for expensive runs, many parameters, and targets that depend on a few of them each. Every number k
// of a target has a response surface s_k over the parameters that affect it (Kriging, campaign/sampling.h), and so
// the misfit has the model
//
//   Phi(u) = sum over numbers k of part_k(s_k(u)),
//
// with exact bounds and caps. The surfaces are renewed after every set. The next set is, in turn, the minimum of the model,
// or, among random sets, half of them about the best set, the set with the least a Phi + (1 - a) (1 - d), a = 0.8 and 0.5, with Phi
// and the distance d to the nearest known set scaled to 0..1 [Regis, Shoemaker 2007]. After the first set, `start`, comes a
// Latin hypercube of two sets more than parameters.
SearchPath surrogate_path(const StageSpec& stage, const UnitPoint& start, const SurrogateQueries& queries);

}  // namespace footfall
