// Chooses the next set on the model.
#include "mbd_solver/studies/calibrate/surrogate.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "mbd_solver/studies/calibrate/optimum.h"
#include "mbd_solver/studies/campaign/sampling.h"

namespace footfall {
namespace {

constexpr int kCandidates = 2000, kMostDrawn = 20 * kCandidates;
constexpr std::array<double, 2> kWeights = {0.8, 0.5};        // a
constexpr std::array<double, 3> kReaches = {0.2, 0.1, 0.04};  // of candidates about the best set
constexpr double kDownWithin = 0.005;                         // precision of the minimum of the model
constexpr int kDownSets = 600;                                // of the model, down to its minimum
constexpr double kNotAllowed = 1e30;                          // Phi
constexpr double kLeastDistance = 0.01;                       // between sets

double nearest_distance(const UnitPoint& u, const std::vector<UnitPoint>& sets) {
  double least = std::numeric_limits<double>::infinity();
  for (const UnitPoint& set : sets) least = std::min(least, distance(u, set));
  return least;
}

// The model of Phi.
class MisfitModel {
 public:
  MisfitModel(const SurrogateQueries& queries, const std::vector<UnitPoint>& sets,
              const std::vector<std::vector<double>>& numbers)
      : queries_(queries) {
    for (std::size_t k = 0; k < queries.moved_by.size(); ++k) {
      std::vector<double> values;
      for (const std::vector<double>& of_set : numbers) values.push_back(of_set[k]);
      surfaces_.push_back(response_surface(coordinates(k, sets), values));
    }
  }

  std::vector<double> misfits(const std::vector<UnitPoint>& sets) const {
    std::vector<double> sums(sets.size(), 0.0);
    for (std::size_t k = 0; k < surfaces_.size(); ++k) {
      const std::vector<double> values = surfaces_[k](coordinates(k, sets));
      for (std::size_t j = 0; j < sets.size(); ++j) sums[j] += queries_.part(k, values[j]);
    }
    return sums;
  }
  double misfit(const UnitPoint& u) const { return queries_.allowed(u) ? misfits({u}).front() : kNotAllowed; }

  UnitPoint down(const UnitPoint& from) const {
    MinimumTask task{"LN_SBPLX", from, {UnitPoint(from.size(), 0.0), UnitPoint(from.size(), 1.0)}, kDownWithin};
    task.most = kDownSets;
    return minimum(task, [this](const UnitPoint& u) { return misfit(u); });
  }

 private:
  std::vector<std::vector<double>> coordinates(std::size_t k, const std::vector<UnitPoint>& sets) const {
    std::vector<std::vector<double>> all;
    for (const UnitPoint& u : sets) {
      all.emplace_back();
      for (const std::size_t i : queries_.moved_by[k]) all.back().push_back(u[i]);
    }
    return all;
  }

  const SurrogateQueries& queries_;
  std::vector<Surface> surfaces_;
};

std::vector<double> scaled(std::vector<double> values) {
  const auto [least, most] = std::minmax_element(values.begin(), values.end());
  const double from = *least, range = *most - *least;
  for (double& value : values) value = range > 0.0 ? (value - from) / range : 0.0;
  return values;
}

}  // namespace

SurrogateSearch::SurrogateSearch(const StageSpec& stage, const UnitPoint& start, SurrogateQueries queries)
    : stage_(stage),
      queries_(std::move(queries)),
      start_(start),
      random_(static_cast<std::mt19937_64::result_type>(stage.seed)) {
  for (const UnitPoint& set : queries_.earlier)
    if (const auto numbers = queries_.numbers(set)) learn(set, *numbers);
  hypercube_ = latin_hypercube(start.size() + 2, start.size(), static_cast<std::uint64_t>(stage.seed));
}

double SurrogateSearch::uniform() { return static_cast<double>(random_() >> 11) * 0x1p-53; }

double SurrogateSearch::normal() {
  return std::sqrt(-2.0 * std::log(1.0 - uniform())) * std::cos(2.0 * M_PI * uniform());
}

void SurrogateSearch::learn(const UnitPoint& set, const std::vector<double>& numbers) {
  if (std::find(tried_.begin(), tried_.end(), set) != tried_.end()) return;
  tried_.push_back(set);
  if (numbers.empty()) return;
  known_.push_back(set);
  known_numbers_.push_back(numbers);
  const double misfit = misfit_of(numbers);
  if (misfit < best_misfit_) best_misfit_ = misfit, best_ = set;
}

double SurrogateSearch::misfit_of(const std::vector<double>& numbers) const {
  double sum = 0.0;
  for (std::size_t k = 0; k < numbers.size(); ++k) sum += queries_.part(k, numbers[k]);
  return sum;
}

UnitPoint SurrogateSearch::next() {
  if (known_.size() < start_.size() + 2 && designed_ < start_.size() + 2) return hypercube_[designed_++];
  if (known_.empty()) return hypercube_[modelled_++ % hypercube_.size()];
  const MisfitModel model(queries_, known_, known_numbers_);
  std::vector<UnitPoint> candidates;
  for (int drawn = 0; candidates.size() < kCandidates && drawn < kMostDrawn; ++drawn) {
    UnitPoint u = best_;
    const bool anywhere = drawn % 2 == 0;
    const double reach = kReaches[static_cast<std::size_t>(drawn) / 2 % kReaches.size()];
    const double moved = std::max(0.2, 1.0 / static_cast<double>(u.size()));  // share of the parameters
    for (double& share : u)
      if (anywhere)
        share = uniform();
      else if (uniform() < moved)
        share = std::clamp(share + reach * normal(), 0.0, 1.0);
    if (queries_.allowed(u)) candidates.push_back(u);
  }
  if (candidates.empty())
    return hypercube_[modelled_++ % hypercube_.size()];  // hardly any set satisfies the constraints
  const std::vector<double> misfits = model.misfits(candidates);
  std::vector<double> distances;
  for (const UnitPoint& u : candidates) distances.push_back(nearest_distance(u, tried_));
  const std::size_t kind = modelled_++ % (kWeights.size() + 1);
  if (kind == 0) {
    const UnitPoint low =
        candidates[static_cast<std::size_t>(std::min_element(misfits.begin(), misfits.end()) - misfits.begin())];
    const UnitPoint ends[2] = {model.down(low), model.down(best_)};
    const UnitPoint& u = model.misfit(ends[0]) < model.misfit(ends[1]) ? ends[0] : ends[1];
    if (nearest_distance(u, tried_) >= kLeastDistance) return u;
  }
  const double a = kWeights[kind == 0 ? 0 : kind - 1];
  const std::vector<double> m = scaled(misfits), d = scaled(distances);
  std::size_t chosen = 0;
  const auto merit = [&](std::size_t j) { return a * m[j] + (1.0 - a) * (1.0 - d[j]); };
  for (std::size_t j = 1; j < candidates.size(); ++j)
    if (merit(j) < merit(chosen)) chosen = j;
  return candidates[chosen];
}

const SearchPath& SurrogateSearch::go() {
  for (;;) {
    if (path_.requested.empty()) {
      if (static_cast<int>(path_.sets.size()) >= stage_.evaluations) {
        path_.end = "all evaluations done";
        return path_;
      }
      const UnitPoint set = path_.sets.empty() ? start_ : next();
      if (!queries_.may_continue(set)) {
        path_.end = "limit reached";
        return path_;
      }
      path_.requested = {set};
    }
    const UnitPoint set = path_.requested.front();
    const auto numbers = queries_.numbers(set);
    if (!numbers) return path_;
    learn(set, *numbers);
    path_.requested.clear();
    path_.sets.push_back(set);
    if (numbers->empty()) continue;
    const double misfit = misfit_of(*numbers);
    if (misfit < path_.misfit) path_.misfit = misfit, path_.best = set;
  }
}

}  // namespace footfall
