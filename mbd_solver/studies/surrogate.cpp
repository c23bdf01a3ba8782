// Solves for all smoothings by one inverse each, and chooses the next set on the model.
#include "mbd_solver/studies/surrogate.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>

#include "mbd_solver/studies/search.h"

namespace footfall {
namespace {

double cube(double r) { return r * r * r; }

// P: with a plane if the points span it and at least two more determine its error.
Eigen::MatrixXd tail_of(const Eigen::MatrixXd& points) {
  const Eigen::Index n = points.cols(), m = points.rows();
  Eigen::MatrixXd p(n, m + 1);
  p << Eigen::VectorXd::Ones(n), points.transpose();
  return n >= m + 3 && p.colPivHouseholderQr().rank() == m + 1 ? p : p.leftCols(1);
}

}  // namespace

ResponseSurfaces::ResponseSurfaces(const Eigen::MatrixXd& points, const Eigen::MatrixXd& values) : points_(points) {
  const Eigen::Index n = points.cols(), numbers = values.cols();
  const Eigen::MatrixXd p = tail_of(points);
  const Eigen::Index all = n + p.cols();
  Eigen::MatrixXd matrix = Eigen::MatrixXd::Zero(all, all);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) matrix(i, j) = cube((points.col(i) - points.col(j)).norm());
  matrix.topRightCorner(n, p.cols()) = p;
  matrix.bottomLeftCorner(p.cols(), n) = p.transpose();
  Eigen::MatrixXd right = Eigen::MatrixXd::Zero(all, numbers);
  right.topRows(n) = values;
  weights_ = Eigen::MatrixXd::Zero(all, numbers);  // of a single point: its value everywhere
  weights_.row(n) = values.colwise().mean();
  left_out_errors_ = Eigen::VectorXd::Constant(numbers, std::numeric_limits<double>::infinity());
  for (const double smoothing : kSmoothings) {
    Eigen::MatrixXd smoothed = matrix;
    smoothed.topLeftCorner(n, n).diagonal().array() += smoothing;
    const Eigen::MatrixXd inverse = smoothed.partialPivLu().inverse();
    const Eigen::MatrixXd solution = inverse * right;
    for (Eigen::Index k = 0; k < numbers; ++k) {
      const double error =
          std::sqrt((solution.col(k).head(n).array() / inverse.diagonal().head(n).array()).square().mean());
      if (!(error < left_out_errors_[k])) continue;  // also if not a number
      left_out_errors_[k] = error;
      weights_.col(k) = solution.col(k);
    }
  }
}

Eigen::VectorXd ResponseSurfaces::at(const Eigen::VectorXd& x) const {
  const Eigen::Index n = points_.cols();
  Eigen::VectorXd base(weights_.rows());
  for (Eigen::Index j = 0; j < n; ++j) base[j] = cube((x - points_.col(j)).norm());
  base[n] = 1.0;
  if (base.size() > n + 1) base.tail(x.size()) = x;
  return weights_.transpose() * base;
}

namespace {

constexpr std::size_t kCandidates = 2000, kMostDrawn = 20 * kCandidates;
constexpr std::array<double, 2> kWeights = {0.8, 0.5};            // a
constexpr std::array<double, 3> kReaches = {0.2, 0.1, 0.04};      // of candidates about the best set
const std::vector<double> kSteps = {0.2, 0.1, 0.05, 0.02, 0.01};  // down the model
constexpr double kLeastDistance = 0.01;                           // between sets

double nearest_distance(const UnitPoint& u, const std::vector<UnitPoint>& sets) {
  double least = std::numeric_limits<double>::infinity();
  for (const UnitPoint& set : sets) least = std::min(least, distance(u, set));
  return least;
}

// The model of Phi: a group of surfaces for all numbers that the same parameters affect.
class KrigingModel {
 public:
  KrigingModel(const SurrogateQueries& queries, const std::vector<UnitPoint>& sets,
               const std::vector<std::vector<double>>& numbers)
      : queries_(queries) {
    std::map<std::vector<std::size_t>, std::vector<std::size_t>> numbers_moved_by;
    for (std::size_t k = 0; k < queries.moved_by.size(); ++k) numbers_moved_by[queries.moved_by[k]].push_back(k);
    for (const auto& [by, moved] : numbers_moved_by) {
      Eigen::MatrixXd points(static_cast<Eigen::Index>(by.size()), static_cast<Eigen::Index>(sets.size()));
      Eigen::MatrixXd values(points.cols(), static_cast<Eigen::Index>(moved.size()));
      for (std::size_t j = 0; j < sets.size(); ++j) {
        points.col(static_cast<Eigen::Index>(j)) = coordinates(by, sets[j]);
        for (std::size_t k = 0; k < moved.size(); ++k)
          values(static_cast<Eigen::Index>(j), static_cast<Eigen::Index>(k)) = numbers[j][moved[k]];
      }
      groups_.push_back({by, moved, ResponseSurfaces(points, values)});
    }
  }

  double misfit(const UnitPoint& u) const {
    double sum = 0.0;
    for (const Group& group : groups_) {
      const Eigen::VectorXd values = group.surfaces.at(coordinates(group.by, u));
      for (std::size_t k = 0; k < group.moved.size(); ++k)
        sum += queries_.part(group.moved[k], values[static_cast<Eigen::Index>(k)]);
    }
    return sum;
  }

  UnitPoint down(const UnitPoint& from) const {
    return descend(from, {UnitPoint(from.size(), 0.0), UnitPoint(from.size(), 1.0)}, kSteps,
                   [this](const UnitPoint& u) {
                     return queries_.allowed(u) ? misfit(u) : std::numeric_limits<double>::infinity();
                   });
  }

 private:
  struct Group {
    std::vector<std::size_t> by, moved;  // parameters, and the numbers that they affect
    ResponseSurfaces surfaces;
  };

  static Eigen::VectorXd coordinates(const std::vector<std::size_t>& by, const UnitPoint& u) {
    Eigen::VectorXd x(static_cast<Eigen::Index>(by.size()));
    for (std::size_t i = 0; i < by.size(); ++i) x[static_cast<Eigen::Index>(i)] = u[by[i]];
    return x;
  }

  const SurrogateQueries& queries_;
  std::vector<Group> groups_;
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
  const std::size_t rows = start.size() + 2;
  for (std::size_t i = 0; i < start.size(); ++i) {
    std::vector<double> places(rows);
    std::iota(places.begin(), places.end(), 0.0);
    for (std::size_t j = rows - 1; j > 0; --j)
      std::swap(places[j], places[static_cast<std::size_t>(uniform() * static_cast<double>(j + 1))]);
    for (double& place : places) place = (place + uniform()) / static_cast<double>(rows);
    hypercube_.push_back(places);
  }
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

UnitPoint SurrogateSearch::latin(std::size_t row) {
  UnitPoint set;
  for (const std::vector<double>& places : hypercube_) set.push_back(places[row]);
  return set;
}

UnitPoint SurrogateSearch::next() {
  if (known_.size() < start_.size() + 2 && designed_ < start_.size() + 2) return latin(designed_++);
  if (known_.empty()) return latin(modelled_++ % (start_.size() + 2));
  const KrigingModel model(queries_, known_, known_numbers_);
  std::vector<UnitPoint> candidates;
  for (std::size_t drawn = 0; candidates.size() < kCandidates && drawn < kMostDrawn; ++drawn) {
    UnitPoint u = best_;
    const bool anywhere = drawn % 2 == 0;
    const double reach = kReaches[drawn / 2 % kReaches.size()];
    const double moved = std::max(0.2, 1.0 / static_cast<double>(u.size()));  // share of the parameters
    for (double& share : u)
      if (anywhere)
        share = uniform();
      else if (uniform() < moved)
        share = std::clamp(share + reach * normal(), 0.0, 1.0);
    if (queries_.allowed(u)) candidates.push_back(u);
  }
  if (candidates.empty()) return latin(modelled_++ % (start_.size() + 2));  // hardly any set satisfies the constraints
  std::vector<double> misfits, distances;
  for (const UnitPoint& u : candidates) {
    misfits.push_back(model.misfit(u));
    distances.push_back(nearest_distance(u, tried_));
  }
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
