// Chooses the next set on the model.
#include <algorithm>
#include <cmath>
#include <random>

#include "mbd_solver/campaign/calibrate/search.h"
#include "mbd_solver/campaign/optimum.h"
#include "mbd_solver/campaign/sampling.h"

namespace footfall {
namespace {

constexpr int kCandidates = 2000, kMostDrawn = 20 * kCandidates;
constexpr double kWeights[] = {0.8, 0.5};        // a
constexpr double kReaches[] = {0.2, 0.1, 0.04};  // of candidates about the best set
constexpr double kDownWithin = 0.005;            // precision of the minimum of the model
constexpr int kDownSets = 600;                   // of the model, down to its minimum
constexpr double kNotAllowed = 1e30;             // Phi
constexpr double kLeastDistance = 0.01;          // between sets

double nearest_distance(const UnitPoint& u, const std::vector<UnitPoint>& sets) {
  double least = std::numeric_limits<double>::infinity();
  for (const UnitPoint& set : sets) least = std::min(least, distance(u, set));
  return least;
}

std::size_t least_of(const std::vector<double>& values) {
  return static_cast<std::size_t>(std::min_element(values.begin(), values.end()) - values.begin());
}

std::vector<double> scaled(std::vector<double> values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double from = *least, range = *most - *least;
  for (double& value : values) value = range > 0.0 ? (value - from) / range : 0.0;
  return values;
}

class SurrogateSearch {
 public:
  SurrogateSearch(const StageSpec& stage, const UnitPoint& start, const SurrogateQueries& queries)
      : queries_(queries),
        random_(static_cast<std::mt19937_64::result_type>(stage.seed)),
        hypercube_(latin_hypercube(start.size() + 2, start.size(), static_cast<std::uint64_t>(stage.seed))) {}

  // Its misfit; infinite where a run failed.
  double learn(const UnitPoint& set, const std::vector<double>& numbers) {
    double misfit = 0.0;
    for (std::size_t k = 0; k < numbers.size(); ++k) misfit += queries_.part(k, numbers[k]);
    if (numbers.empty()) misfit = std::numeric_limits<double>::infinity();
    if (std::find(tried_.begin(), tried_.end(), set) != tried_.end()) return misfit;
    tried_.push_back(set);
    if (numbers.empty()) return misfit;
    known_.push_back(set);
    numbers_.push_back(numbers);
    if (misfit < least_) least_ = misfit, best_ = set;
    return misfit;
  }

  UnitPoint next() {
    if (known_.size() < hypercube_.size() && designed_ < hypercube_.size()) return hypercube_[designed_++];
    const std::size_t turn = modelled_++;
    const std::vector<UnitPoint> sets = known_.empty() ? std::vector<UnitPoint>() : candidates();
    if (sets.empty()) return hypercube_[turn % hypercube_.size()];  // hardly any set satisfies the constraints
    surfaces_.clear();
    for (std::size_t k = 0; k < queries_.moved_by.size(); ++k) {
      std::vector<double> values;
      for (const std::vector<double>& of_set : numbers_) values.push_back(of_set[k]);
      surfaces_.push_back(response_surface(coordinates(k, known_), values));
    }
    const std::vector<double> misfits = modelled(sets);
    const std::size_t kind = turn % (std::size(kWeights) + 1);
    if (kind == 0) {
      const UnitPoint ends[] = {minimum_from(sets[least_of(misfits)]), minimum_from(best_)};
      const UnitPoint& u = modelled(ends[0]) < modelled(ends[1]) ? ends[0] : ends[1];
      if (nearest_distance(u, tried_) >= kLeastDistance) return u;
    }
    const double a = kWeights[kind == 0 ? 0 : kind - 1];
    std::vector<double> merits = scaled(misfits), distances;
    for (const UnitPoint& u : sets) distances.push_back(nearest_distance(u, tried_));
    distances = scaled(distances);
    for (std::size_t j = 0; j < sets.size(); ++j) merits[j] = a * merits[j] + (1.0 - a) * (1.0 - distances[j]);
    return sets[least_of(merits)];
  }

 private:
  double uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }
  double normal() { return std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * M_PI * uniform()); }

  // Half of them anywhere, half about the best set.
  std::vector<UnitPoint> candidates() {
    std::vector<UnitPoint> sets;
    for (int drawn = 0; sets.size() < kCandidates && drawn < kMostDrawn; ++drawn) {
      UnitPoint u = best_;
      const double reach = kReaches[static_cast<std::size_t>(drawn) / 2 % std::size(kReaches)];
      const double moved = std::max(0.2, 1.0 / static_cast<double>(u.size()));  // share of the parameters
      for (double& share : u)
        if (drawn % 2 == 0)
          share = uniform();
        else if (uniform() < moved)
          share = std::clamp(share + reach * normal(), 0.0, 1.0);
      if (queries_.allowed(u)) sets.push_back(u);
    }
    return sets;
  }

  std::vector<std::vector<double>> coordinates(std::size_t k, const std::vector<UnitPoint>& sets) const {
    std::vector<std::vector<double>> all(sets.size());
    for (std::size_t j = 0; j < sets.size(); ++j)
      for (const std::size_t i : queries_.moved_by[k]) all[j].push_back(sets[j][i]);
    return all;
  }

  // Phi of the model.
  std::vector<double> modelled(const std::vector<UnitPoint>& sets) const {
    std::vector<double> sums(sets.size(), 0.0);
    for (std::size_t k = 0; k < surfaces_.size(); ++k) {
      const std::vector<double> values = surfaces_[k](coordinates(k, sets));
      for (std::size_t j = 0; j < sets.size(); ++j) sums[j] += queries_.part(k, values[j]);
    }
    return sums;
  }
  double modelled(const UnitPoint& u) const {
    return queries_.allowed(u) ? modelled(std::vector<UnitPoint>{u}).front() : kNotAllowed;
  }
  UnitPoint minimum_from(const UnitPoint& start) const {
    OptimumTask task{start, UnitPoint(start.size(), 0.0), UnitPoint(start.size(), 1.0)};
    task.precision = kDownWithin;
    task.evaluations = kDownSets;
    return minimum("LN_SBPLX", task, [this](const UnitPoint& u) { return modelled(u); });
  }

  const SurrogateQueries& queries_;
  std::mt19937_64 random_;
  std::vector<UnitPoint> hypercube_, tried_, known_;  // tried_: also sets whose runs failed
  std::vector<std::vector<double>> numbers_;          // of known_
  std::vector<Surface> surfaces_;
  UnitPoint best_;  // of known_
  double least_ = std::numeric_limits<double>::infinity();
  std::size_t designed_ = 0, modelled_ = 0;  // sets of either kind so far
};

}  // namespace

SearchPath surrogate_path(const StageSpec& stage, const UnitPoint& start, const SurrogateQueries& queries) {
  SurrogateSearch search(stage, start, queries);
  for (const UnitPoint& set : queries.earlier)
    if (const auto numbers = queries.numbers(set)) search.learn(set, *numbers);
  SearchPath path;
  while (static_cast<int>(path.sets.size()) < stage.evaluations) {
    const UnitPoint set = path.sets.empty() ? start : search.next();
    const auto numbers = queries.numbers(set);
    if (!numbers) {
      path.requested = {set};
      return path;
    }
    path.sets.push_back(set);
    if (const double misfit = search.learn(set, *numbers); misfit < path.misfit) path.misfit = misfit, path.best = set;
  }
  path.end = "all evaluations done";
  return path;
}

}  // namespace footfall
