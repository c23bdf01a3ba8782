#include "mbd_solver/studies/search.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <nlopt.hpp>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr double kFirstStep = 0.15;  // of a local search, as a share of the ranges

nlopt::algorithm algorithm_of(SearchMethod method) {
  switch (method) {
    case SearchMethod::kDirect: return nlopt::GN_DIRECT_L;
    case SearchMethod::kCrs2: return nlopt::GN_CRS2_LM;
    case SearchMethod::kIsres: return nlopt::GN_ISRES;
    case SearchMethod::kBobyqa: return nlopt::LN_BOBYQA;
    case SearchMethod::kSbplx: return nlopt::LN_SBPLX;
    case SearchMethod::kGaussNewton:
    case SearchMethod::kSurrogate: break;  // not of NLopt
  }
  return nlopt::LN_SBPLX;
}

double squared_distance(const Shares& a, const Shares& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return sum;
}

// What NLopt asks, and what it is told.
class Walker {
 public:
  Walker(const SearchQuestions& questions, int evaluations, std::size_t most_wanted)
      : questions_(questions), evaluations_(evaluations), most_wanted_(most_wanted) {}

  double misfit(const Shares& set) {
    if (ended_) throw nlopt::forced_stop();  // some methods ask on before they stop
    const auto seen = std::find(way.sets.begin(), way.sets.end(), set);
    if (seen != way.sets.end()) return misfits_[static_cast<std::size_t>(seen - way.sets.begin())];
    const auto guessed = std::find(way.wanted.begin(), way.wanted.end(), set);
    if (guessed != way.wanted.end()) return nearest(set);
    if (static_cast<int>(way.sets.size() + way.wanted.size()) >= evaluations_) end("all evaluations done");
    if (way.wanted.empty() && !questions_.may_go_on(set)) end("limit reached");
    const std::optional<double> known = questions_.misfit(set);
    if (way.wanted.empty() && known) {
      way.sets.push_back(set);
      misfits_.push_back(*known);
      if (*known < way.misfit) way.misfit = *known, way.best = set;
      return *known;
    }
    if (known) return *known;  // behind a guess: on no way yet
    way.wanted.push_back(set);
    if (way.wanted.size() >= most_wanted_) end("");
    return nearest(set);
  }

  StageWay way;

 private:
  [[noreturn]] void end(const std::string& why) {
    ended_ = true;
    way.end = why;
    throw nlopt::forced_stop();
  }

  double nearest(const Shares& set) const {
    double distance = std::numeric_limits<double>::infinity(), value = 1.0;
    for (std::size_t k = 0; k < way.sets.size(); ++k)
      if (const double d = squared_distance(set, way.sets[k]); d < distance) distance = d, value = misfits_[k];
    return value;
  }

  const SearchQuestions& questions_;
  int evaluations_;
  std::size_t most_wanted_;
  std::vector<double> misfits_;  // of way.sets
  bool ended_ = false;
};

double asked(const Shares& set, Shares&, void* walker) { return static_cast<Walker*>(walker)->misfit(set); }

}  // namespace

StageWay walk(const StageSpec& stage, const Shares& start, const SearchQuestions& questions, std::size_t most_wanted) {
  Walker walker(questions, stage.evaluations, std::max<std::size_t>(1, most_wanted));
  nlopt::srand(static_cast<unsigned long>(stage.seed));
  nlopt::opt search(algorithm_of(stage.method), static_cast<unsigned>(start.size()));
  search.set_lower_bounds(0.0);
  search.set_upper_bounds(1.0);
  search.set_min_objective(asked, &walker);
  search.set_maxeval(20 * stage.evaluations + 100);  // sets that it asks for again cost nothing
  search.set_xtol_abs(stage.precision);
  if (goes_one_by_one(stage.method)) search.set_initial_step(kFirstStep);
  Shares at = start;
  double least = 0.0;
  try {
    search.optimize(at, least);
    walker.way.end = "within its precision";
  } catch (const nlopt::forced_stop&) {
  } catch (const nlopt::roundoff_limited&) {
    walker.way.end = "as precise as numbers are";
  } catch (const std::exception& e) {
    throw InputError("the search " + std::string(name_of(stage.method)) + " was refused by NLopt: " + e.what());
  }
  return walker.way;
}

namespace {

constexpr double kBetter = 1e-9;  // less than this is rounding

}  // namespace

Shares down_from(Shares u, const DescentBounds& bounds, const std::vector<double>& steps,
                 const std::function<double(const Shares&)>& value) {
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

struct OutOfSets {};  // the stage stops here: sets are wanted, or a limit is reached

class LeastSquares {
 public:
  LeastSquares(const StageSpec& stage, double step, const LeastSquaresQuestions& questions)
      : stage_(stage), step_(step), questions_(questions) {}

  void search(Shares at) {
    Eigen::VectorXd r = residuals(at);
    double damping = kFirstDamping;
    for (;;) {
      const Eigen::MatrixXd j = derivatives(at, r.size());
      for (bool better = false; !better;) {
        const Shares next = stepped(at, j, r, damping);
        if (distance_of(at, next) < stage_.precision || damping > kMostDamping) {
          way.end = "within its precision";
          return;
        }
        const Eigen::VectorXd tried = residuals(next);
        better = tried.size() == r.size() && tried.squaredNorm() < r.squaredNorm();
        damping = better ? std::max(kLeastDamping, 0.1 * damping) : 10.0 * damping;
        if (better) at = next, r = tried;
      }
    }
  }

  StageWay way;

 private:
  Eigen::VectorXd residuals(const Shares& set) { return residuals(std::vector<Shares>{set}).front(); }

  // Of all sets, or none where one is not known.
  std::vector<Eigen::VectorXd> residuals(const std::vector<Shares>& sets) {
    std::vector<Eigen::VectorXd> all;
    for (const Shares& set : sets) {
      const bool fresh = std::find(way.sets.begin(), way.sets.end(), set) == way.sets.end();
      if (fresh && static_cast<int>(way.sets.size() + way.wanted.size()) >= stage_.evaluations)
        stop("all evaluations done");
      if (fresh && way.wanted.empty() && !questions_.may_go_on(set)) stop("limit reached");
      const auto known = questions_.residuals(set);
      if (!known) {
        way.wanted.push_back(set);
        continue;
      }
      const Eigen::VectorXd r =
          Eigen::Map<const Eigen::VectorXd>(known->data(), static_cast<Eigen::Index>(known->size()));
      all.push_back(r);
      if (!fresh || !way.wanted.empty()) continue;
      way.sets.push_back(set);
      if (r.size() > 0 && r.squaredNorm() < way.misfit) way.misfit = r.squaredNorm(), way.best = set;
    }
    if (!way.wanted.empty()) throw OutOfSets();
    return all;
  }

  [[noreturn]] void stop(const std::string& why) {
    way.end = why;
    throw OutOfSets();
  }

  Eigen::MatrixXd derivatives(const Shares& at, Eigen::Index rows) {
    std::vector<Shares> sets;
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

  // Parameters that the step would take out of their ranges stay at the end, and the others are solved for anew.
  static Shares stepped(const Shares& at, const Eigen::MatrixXd& j, const Eigen::VectorXd& r, double damping) {
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
    Shares next = at;
    for (std::size_t i = 0; i < at.size(); ++i) next[i] = std::clamp(at[i] + d[static_cast<Eigen::Index>(i)], 0.0, 1.0);
    return next;
  }

  static double distance_of(const Shares& a, const Shares& b) {
    double most = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) most = std::max(most, std::abs(a[i] - b[i]));
    return most;
  }

  const StageSpec& stage_;
  double step_;
  const LeastSquaresQuestions& questions_;
};

}  // namespace

StageWay walk_least_squares(const StageSpec& stage, const Shares& start, double step,
                            const LeastSquaresQuestions& questions) {
  LeastSquares search(stage, step, questions);
  try {
    search.search(start);
  } catch (const OutOfSets&) {
  }
  return search.way;
}

}  // namespace footfall
