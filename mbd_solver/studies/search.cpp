// Runs NLopt, or Gauss-Newton steps, until a set with unknown misfit is requested; exceptions leave the search there.
#include "mbd_solver/studies/search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "coupler/base/errors.h"
#include "mbd_solver/studies/codes.h"

namespace footfall {
namespace {

constexpr double kFirstStep = 0.15;  // of a local search, as a share of the ranges

// The objective of NLopt.
class NloptSearch {
 public:
  NloptSearch(const SearchQueries& queries, int evaluations, std::size_t most_requested)
      : queries_(queries), evaluations_(evaluations), most_requested_(most_requested) {}

  double misfit(const UnitPoint& set) {
    if (ended_) throw nlopt::forced_stop();  // some methods continue before they stop
    const auto coordinates = std::find(path.sets.begin(), path.sets.end(), set);
    if (coordinates != path.sets.end()) return misfits_[static_cast<std::size_t>(coordinates - path.sets.begin())];
    const auto guessed = std::find(path.requested.begin(), path.requested.end(), set);
    if (guessed != path.requested.end()) return nearest(set);
    if (static_cast<int>(path.sets.size() + path.requested.size()) >= evaluations_) end("all evaluations done");
    if (path.requested.empty() && !queries_.may_continue(set)) end("limit reached");
    const std::optional<double> known = queries_.misfit(set);
    if (path.requested.empty() && known) {
      path.sets.push_back(set);
      misfits_.push_back(*known);
      if (*known < path.misfit) path.misfit = *known, path.best = set;
      return *known;
    }
    if (known) return *known;  // after a guess: not on the path yet
    path.requested.push_back(set);
    if (path.requested.size() >= most_requested_) end("");
    return nearest(set);
  }

  SearchPath path;

 private:
  [[noreturn]] void end(const std::string& why) {
    ended_ = true;
    path.end = why;
    throw nlopt::forced_stop();
  }

  double nearest(const UnitPoint& set) const {
    double least = std::numeric_limits<double>::infinity(), value = 1.0;
    for (std::size_t k = 0; k < path.sets.size(); ++k)
      if (const double d = distance(set, path.sets[k]); d < least) least = d, value = misfits_[k];
    return value;
  }

  const SearchQueries& queries_;
  int evaluations_;
  std::size_t most_requested_;
  std::vector<double> misfits_;  // of path.sets
  bool ended_ = false;
};

double objective(const UnitPoint& set, UnitPoint&, void* search_state) {
  return static_cast<NloptSearch*>(search_state)->misfit(set);
}

}  // namespace

SearchPath search_path(const StageSpec& stage, const UnitPoint& start, const SearchQueries& queries,
                       std::size_t most_requested) {
  NloptSearch search_state(queries, stage.evaluations, std::max<std::size_t>(1, most_requested));
  if (stage.method == SearchMethod::kListed) {
    try {
      for (const UnitPoint& set : stage.sets) search_state.misfit(set);
      search_state.path.end = "all sets of the file done";
    } catch (const nlopt::forced_stop&) {
    }
    return search_state.path;
  }
  nlopt::opt search(stage.method == SearchMethod::kDirect ? nlopt::GN_DIRECT_L : nlopt::LN_SBPLX,
                    static_cast<unsigned>(start.size()));
  search.set_lower_bounds(0.0);
  search.set_upper_bounds(1.0);
  search.set_min_objective(objective, &search_state);
  search.set_maxeval(20 * stage.evaluations + 100);  // repeated sets cost nothing
  search.set_xtol_abs(stage.precision);
  if (is_sequential(stage.method)) search.set_initial_step(kFirstStep);
  UnitPoint at = start;
  double least = 0.0;
  try {
    search.optimize(at, least);
    search_state.path.end = "within its precision";
  } catch (const nlopt::forced_stop&) {
  } catch (const nlopt::roundoff_limited&) {
    search_state.path.end = "limited by round-off";
  } catch (const std::exception& e) {
    throw InputError(code::kSearchRefused,
                     "NLopt refused the search " + std::string(name_of(stage.method)) + ": " + e.what());
  }
  return search_state.path;
}

namespace {

constexpr double kBetter = 1e-9;  // smaller improvements are round-off

}  // namespace

UnitPoint descend(UnitPoint u, const DescentBounds& bounds, const std::vector<double>& steps,
                  const std::function<double(const UnitPoint&)>& value) {
  double least = value(u);
  for (const double step : steps)
    for (bool better = true; better;) {
      better = false;
      for (std::size_t i = 0; i < u.size(); ++i)
        for (const double move : {step, -step}) {
          const double from = u[i];
          u[i] = std::clamp(from + move, bounds.least[i], bounds.most[i]);
          const double tried = value(u);
          if (tried < least - kBetter)
            least = tried, better = true;
          else
            u[i] = from;
        }
    }
  return u;
}

namespace {

constexpr double kFirstDamping = 1.0, kLeastDamping = 1e-6, kMostDamping = 1e8;  // lambda

struct OutOfSets {};  // the stage stops: sets are requested, or a limit is reached

class LeastSquares {
 public:
  LeastSquares(const StageSpec& stage, double step, const LeastSquaresQueries& queries)
      : stage_(stage), step_(step), queries_(queries) {}

  void search(UnitPoint at) {
    Eigen::VectorXd r = residuals(at);
    double damping = kFirstDamping;
    for (;;) {
      const Eigen::MatrixXd j = derivatives(at, r.size());
      for (bool better = false; !better;) {
        const UnitPoint next = stepped(at, j, r, damping);
        if (distance_of(at, next) < stage_.precision || damping > kMostDamping) {
          path.end = "within its precision";
          return;
        }
        const Eigen::VectorXd tried = residuals(next);
        better = tried.size() == r.size() && tried.squaredNorm() < r.squaredNorm();
        damping = better ? std::max(kLeastDamping, 0.1 * damping) : 10.0 * damping;
        if (better) at = next, r = tried;
      }
    }
  }

  SearchPath path;

 private:
  Eigen::VectorXd residuals(const UnitPoint& set) { return residuals(std::vector<UnitPoint>{set}).front(); }

  // Of all sets; leaves the search if one is not known.
  std::vector<Eigen::VectorXd> residuals(const std::vector<UnitPoint>& sets) {
    std::vector<Eigen::VectorXd> all;
    for (const UnitPoint& set : sets) {
      const bool fresh = std::find(path.sets.begin(), path.sets.end(), set) == path.sets.end();
      if (fresh && static_cast<int>(path.sets.size() + path.requested.size()) >= stage_.evaluations)
        stop("all evaluations done");
      if (fresh && path.requested.empty() && !queries_.may_continue(set)) stop("limit reached");
      const auto known = queries_.residuals(set);
      if (!known) {
        path.requested.push_back(set);
        continue;
      }
      const Eigen::VectorXd r =
          Eigen::Map<const Eigen::VectorXd>(known->data(), static_cast<Eigen::Index>(known->size()));
      all.push_back(r);
      if (!fresh || !path.requested.empty()) continue;
      path.sets.push_back(set);
      if (r.size() > 0 && r.squaredNorm() < path.misfit) path.misfit = r.squaredNorm(), path.best = set;
    }
    if (!path.requested.empty()) throw OutOfSets();
    return all;
  }

  [[noreturn]] void stop(const std::string& why) {
    path.end = why;
    throw OutOfSets();
  }

  Eigen::MatrixXd derivatives(const UnitPoint& at, Eigen::Index rows) {
    std::vector<UnitPoint> sets;
    for (std::size_t i = 0; i < at.size(); ++i)
      for (const double sign : {1.0, -1.0}) {
        sets.push_back(at);
        sets.back()[i] = std::clamp(at[i] + sign * step_, 0.0, 1.0);
      }
    const std::vector<Eigen::VectorXd> r = residuals(sets);
    Eigen::MatrixXd j = Eigen::MatrixXd::Zero(rows, static_cast<Eigen::Index>(at.size()));
    for (std::size_t i = 0; i < at.size(); ++i)
      if (r[2 * i].size() == rows && r[2 * i + 1].size() == rows)
        j.col(static_cast<Eigen::Index>(i)) = (r[2 * i] - r[2 * i + 1]) / (sets[2 * i][i] - sets[2 * i + 1][i]);
    return j;
  }

  // Parameters that the step would move out of their ranges stop at the end, and the others are solved for again.
  static UnitPoint stepped(const UnitPoint& at, const Eigen::MatrixXd& j, const Eigen::VectorXd& r, double damping) {
    const auto n = static_cast<Eigen::Index>(at.size());
    Eigen::VectorXd d = Eigen::VectorXd::Zero(n);
    std::vector<Eigen::Index> open(at.size());
    for (Eigen::Index i = 0; i < n; ++i) open[static_cast<std::size_t>(i)] = i;
    for (bool cut = true; cut && !open.empty();) {
      cut = false;
      const auto m = static_cast<Eigen::Index>(open.size());
      Eigen::MatrixXd of_open(j.rows(), m);
      Eigen::VectorXd rest = r;
      for (Eigen::Index k = 0; k < m; ++k) of_open.col(k) = j.col(open[static_cast<std::size_t>(k)]);
      for (Eigen::Index i = 0; i < n; ++i)
        if (std::find(open.begin(), open.end(), i) == open.end()) rest += j.col(i) * d[i];
      const Eigen::MatrixXd normal = of_open.transpose() * of_open + damping * Eigen::MatrixXd::Identity(m, m);
      const Eigen::VectorXd step = normal.ldlt().solve(-of_open.transpose() * rest);
      for (Eigen::Index k = m - 1; k >= 0; --k) {
        const Eigen::Index i = open[static_cast<std::size_t>(k)];
        const double from = at[static_cast<std::size_t>(i)];
        d[i] = std::clamp(step[k], -from, 1.0 - from);
        if (d[i] == step[k]) continue;
        open.erase(open.begin() + k);
        cut = true;
      }
    }
    UnitPoint next = at;
    for (std::size_t i = 0; i < at.size(); ++i) next[i] = std::clamp(at[i] + d[static_cast<Eigen::Index>(i)], 0.0, 1.0);
    return next;
  }

  static double distance_of(const UnitPoint& a, const UnitPoint& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  }

  const StageSpec& stage_;
  double step_;
  const LeastSquaresQueries& queries_;
};

}  // namespace

SearchPath least_squares_path(const StageSpec& stage, const UnitPoint& start, double step,
                              const LeastSquaresQueries& queries) {
  LeastSquares search(stage, step, queries);
  try {
    search.search(start);
  } catch (const OutOfSets&) {
  }
  return search.path;
}

}  // namespace footfall
