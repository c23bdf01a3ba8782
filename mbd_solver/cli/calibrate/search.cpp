#include "mbd_solver/cli/calibrate/search.h"

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

}  // namespace footfall
