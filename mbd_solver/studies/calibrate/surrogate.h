#pragma once
// The method surrogate, for expensive runs, many parameters, and targets that depend on a few of them each. Every number k
// of a target has a response surface s_k over the parameters that affect it (Kriging, campaign/sampling.h), and so
// the misfit has the model
//
//   Phi(u) = sum over numbers k of part_k(s_k(u)),
//
// with exact bounds and caps. The surfaces are renewed after every set. The next set is, in turn, the minimum of the model,
// and of random sets, half of them about the best one, that with the least a Phi + (1 - a) (1 - d), a = 0.8 and 0.5, with Phi
// and the distance d to the nearest known set scaled to 0..1 [Regis, Shoemaker 2007]. The first sets, two more than
// parameters, are a Latin hypercube.

#include <random>

#include "mbd_solver/studies/calibrate/search.h"

namespace footfall {

struct SurrogateQueries {
  // The numbers k of a set; none: not known yet; empty: a run failed.
  std::function<std::optional<std::vector<double>>(const UnitPoint&)> numbers;
  std::function<double(std::size_t, double)> part;  // of number k with this value in Phi
  std::vector<std::vector<std::size_t>> moved_by;   // the parameters that affect number k
  std::vector<UnitPoint> earlier;                   // sets known before
  std::function<bool(const UnitPoint&)> allowed = [](const UnitPoint&) { return true; };  // constraints hold
  std::function<bool(const UnitPoint&)> may_continue;
};

// Continues whenever more sets are known. Its path depends on the numbers only.
class SurrogateSearch {
 public:
  // The first set of the path is `start`.
  SurrogateSearch(const StageSpec& stage, const UnitPoint& start, SurrogateQueries queries);

  const SearchPath& go();

 private:
  UnitPoint next();
  double uniform();
  double normal();
  double misfit_of(const std::vector<double>& numbers) const;  // Phi
  void learn(const UnitPoint& set, const std::vector<double>& numbers);

  const StageSpec stage_;
  const SurrogateQueries queries_;
  const UnitPoint start_;
  std::mt19937_64 random_;
  std::vector<UnitPoint> hypercube_;
  std::vector<UnitPoint> tried_;                    // all sets, including failed ones
  std::vector<UnitPoint> known_;                    // sets with numbers
  std::vector<std::vector<double>> known_numbers_;  // of known_
  UnitPoint best_;                                  // of known_
  double best_misfit_ = std::numeric_limits<double>::infinity();
  std::size_t designed_ = 0, modelled_ = 0;  // sets of either kind so far
  SearchPath path_;
};

}  // namespace footfall
