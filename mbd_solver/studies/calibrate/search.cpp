// Runs a search until a set with unknown misfit is requested; an exception leaves the search there.
#include "mbd_solver/studies/calibrate/search.h"

#include <algorithm>

#include "mbd_solver/studies/calibrate/optimum.h"

namespace footfall {
namespace {

struct Left {};  // the search stops: sets are requested, or a limit is reached

class Walk {
 public:
  Walk(const SearchQueries& queries, int evaluations) : queries_(queries), evaluations_(evaluations) {}

  // The misfit, none: not known, and requested. The set is on the path unless others were requested before.
  std::optional<double> reach(const UnitPoint& set) {
    if (left_) throw Left();  // some methods continue before they stop
    const auto place = std::find(path.sets.begin(), path.sets.end(), set);
    if (place != path.sets.end()) return misfits_[static_cast<std::size_t>(place - path.sets.begin())];
    if (std::find(path.requested.begin(), path.requested.end(), set) != path.requested.end()) return {};
    if (static_cast<int>(path.sets.size() + path.requested.size()) >= evaluations_) leave("all evaluations done");
    if (path.requested.empty() && !queries_.may_continue(set)) leave("limit reached");
    const std::optional<double> misfit = queries_.misfit(set);
    if (!misfit) path.requested.push_back(set);
    if (!path.requested.empty()) return misfit;
    path.sets.push_back(set);
    misfits_.push_back(*misfit);
    if (*misfit < path.misfit) path.misfit = *misfit, path.best = set;
    return misfit;
  }

  // Of the nearest set on the path.
  double nearest_misfit(const UnitPoint& set) const {
    double least = std::numeric_limits<double>::infinity(), value = 1.0;
    for (std::size_t k = 0; k < path.sets.size(); ++k)
      if (const double d = distance(set, path.sets[k]); d < least) least = d, value = misfits_[k];
    return value;
  }

  [[noreturn]] void leave(const std::string& why) {
    left_ = true;
    path.end = why;
    throw Left();
  }

  SearchPath path;

 private:
  const SearchQueries& queries_;
  int evaluations_;
  std::vector<double> misfits_;  // of path.sets
  bool left_ = false;
};

}  // namespace

SearchPath search_path(const StageSpec& stage, const UnitPoint& start, double step, const SearchQueries& queries,
                       std::size_t most_requested) {
  Walk walk(queries, stage.evaluations);
  const auto value = [&](const UnitPoint& set) {
    if (const std::optional<double> misfit = walk.reach(set)) return *misfit;
    if (walk.path.requested.size() >= std::max<std::size_t>(1, most_requested)) walk.leave("");
    return walk.nearest_misfit(set);
  };
  const auto residuals = [&](const std::vector<UnitPoint>& sets) {
    std::vector<std::vector<double>> all;
    for (const UnitPoint& set : sets)
      if (walk.reach(set)) all.push_back(queries.residuals(set));
    if (!walk.path.requested.empty()) walk.leave("");
    return all;
  };
  OptimumTask task{start, UnitPoint(start.size(), 0.0), UnitPoint(start.size(), 1.0)};
  task.precision = stage.precision;
  try {
    if (stage.method == SearchMethod::kListed) {
      for (const UnitPoint& set : stage.sets) value(set);
      walk.path.end = "all sets of the file done";
    } else if (stage.method == SearchMethod::kGaussNewton) {
      task.step = step;
      least_squares(task, residuals);
      walk.path.end = "within its precision";
    } else {
      task.evaluations = 20 * stage.evaluations + 100;  // repeated sets cost nothing
      minimum(stage.method == SearchMethod::kDirect ? "GN_DIRECT_L" : "LN_SBPLX", task, value);
      walk.path.end = "within its precision";
    }
  } catch (const Left&) {
  }
  return walk.path;
}

}  // namespace footfall
