// Runs a search until a set with unknown misfit is requested; an exception leaves the search there.
#include "mbd_solver/campaign/calibrate/search.h"

#include <algorithm>

#include "mbd_solver/campaign/optimum.h"

namespace footfall {

SearchPath search_path(const StageSpec& stage, const UnitPoint& start, double step, const SearchQueries& queries,
                       std::size_t most_requested) {
  struct Left {};  // the search stops: sets are requested, or all evaluations are done
  SearchPath path;
  std::vector<double> misfits;  // of path.sets
  bool left = false;
  const auto leave = [&](const std::string& why) {
    left = true;
    path.end = why;
    throw Left();
  };
  // The misfit, none: not known, and requested. The set is on the path unless others were requested before.
  const auto reach = [&](const UnitPoint& set) -> std::optional<double> {
    if (left) throw Left();  // some methods continue before they stop
    const auto place = std::find(path.sets.begin(), path.sets.end(), set);
    if (place != path.sets.end()) return misfits[place - path.sets.begin()];
    if (std::find(path.requested.begin(), path.requested.end(), set) != path.requested.end()) return {};
    if (static_cast<int>(path.sets.size() + path.requested.size()) >= stage.evaluations) leave("all evaluations done");
    const std::optional<double> misfit = queries.misfit(set);
    if (!misfit) path.requested.push_back(set);
    if (!path.requested.empty()) return misfit;
    path.sets.push_back(set);
    misfits.push_back(*misfit);
    if (*misfit < path.misfit) path.misfit = *misfit, path.best = set;
    return misfit;
  };
  const auto value = [&](const UnitPoint& set) {
    if (const std::optional<double> misfit = reach(set)) return *misfit;
    if (path.requested.size() >= std::max<std::size_t>(1, most_requested)) leave("");
    double least = std::numeric_limits<double>::infinity(), nearest = 1.0;  // misfit of the nearest set
    for (std::size_t k = 0; k < path.sets.size(); ++k)
      if (const double d = distance(set, path.sets[k]); d < least) least = d, nearest = misfits[k];
    return nearest;
  };
  const auto residuals = [&](const std::vector<UnitPoint>& sets) {
    std::vector<std::vector<double>> all;
    for (const UnitPoint& set : sets)
      if (reach(set)) all.push_back(queries.residuals(set));
    if (!path.requested.empty()) leave("");
    return all;
  };
  OptimumTask task{start, UnitPoint(start.size(), 0.0), UnitPoint(start.size(), 1.0)};
  task.precision = stage.precision;
  try {
    if (stage.method == SearchMethod::kListed) {
      for (const UnitPoint& set : stage.sets) value(set);
    } else if (stage.method == SearchMethod::kGaussNewton) {
      task.step = step;
      least_squares(task, residuals);
    } else {
      task.evaluations = 20 * stage.evaluations + 100;  // repeated sets cost nothing
      minimum(stage.method == SearchMethod::kDirect ? "GN_DIRECT_L" : "LN_SBPLX", task, value);
    }
    path.end = stage.method == SearchMethod::kListed ? "all sets of the file done" : "within its precision";
  } catch (const Left&) {
  }
  return path;
}

}  // namespace footfall
