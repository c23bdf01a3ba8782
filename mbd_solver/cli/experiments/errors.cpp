#include "mbd_solver/cli/experiments/errors.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <tuple>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

double value_at(const std::vector<double>& times, const std::vector<double>& values, double t) {
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  const std::size_t i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - times.begin() - 1, 0, static_cast<std::ptrdiff_t>(times.size()) - 2));
  const double u = (t - times[i]) / (times[i + 1] - times[i]);
  return values[i] + u * (values[i + 1] - values[i]);
}

// Mean and standard deviation (0 for one value).
std::pair<double, double> mean_and_spread(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::ArrayXd> x(values.data(), static_cast<Eigen::Index>(values.size()));
  const double mean = x.mean(), freedoms = std::max(1.0, static_cast<double>(values.size()) - 1.0);
  return {mean, std::sqrt((x - mean).square().sum() / freedoms)};
}

}  // namespace

double history_error(const History& run, const History& reference, const std::vector<std::string>& columns, bool at_end,
                     double until) {
  const std::vector<double>& times = run.column("time");
  const std::vector<double>& reference_times = reference.column("time");
  if (reference_times.size() < 2 || times.empty()) throw InputError("figures: a run without rows cannot be compared");
  const auto end = until > 0.0 ? std::upper_bound(times.begin(), times.end(), until * (1.0 + 1e-9)) : times.end();
  const std::size_t count = std::max<std::size_t>(1, static_cast<std::size_t>(end - times.begin()));
  double sum = 0.0;
  for (const std::string& name : columns) {
    const std::vector<double>& mine = run.column(name);
    const std::vector<double>& theirs = reference.column(name);
    const auto [low, high] = std::minmax_element(theirs.begin(), theirs.end());
    const double swing = *high > *low ? *high - *low : 1.0;
    double square = 0.0;
    const std::size_t first = at_end ? count - 1 : 0;
    for (std::size_t i = first; i < count; ++i) {
      const double difference = (mine[i] - value_at(reference_times, theirs, times[i])) / swing;
      square += difference * difference;
    }
    sum += square / static_cast<double>(count - first);
  }
  return std::sqrt(sum / static_cast<double>(columns.size()));
}

std::vector<double> curve_errors(const std::vector<FigureSpec>& figures, const std::string& folder,
                                 const std::string& reference) {
  std::vector<double> errors(figures.size(), SampledFigure::kNone);
  History mine, theirs;
  for (std::size_t k = 0; k < figures.size(); ++k) {
    if (!figures[k].compares_curves()) continue;
    if (mine.names.empty()) {
      mine = read_history(folder + "/history.csv");
      theirs = read_history(reference + "/history.csv");
    }
    errors[k] =
        history_error(mine, theirs, figures[k].columns, figures[k].error == ErrorKind::kFinal, figures[k].until);
  }
  return errors;
}

SampledFigure sampled_figure(const std::vector<double>& figures) {
  SampledFigure sampled;
  if (!figures.empty()) std::tie(sampled.mean, sampled.spread) = mean_and_spread(figures);
  return sampled;
}

SampledFigure sampled_figure(const std::vector<double>& figures, const std::vector<double>& reference) {
  std::vector<double> differences;
  for (std::size_t k = 0; k < figures.size(); ++k) differences.push_back(figures[k] - reference[k]);
  const auto [mean, spread] = mean_and_spread(figures);
  const auto [difference, scatter] = mean_and_spread(differences);
  const double expected = mean_and_spread(reference).first, size = expected != 0.0 ? std::abs(expected) : 1.0;
  return {mean, spread, std::abs(difference) / size, scatter / std::sqrt(static_cast<double>(figures.size())) / size};
}

double slope(const std::vector<std::pair<double, double>>& points) {
  double sx = 0.0, sy = 0.0, sxx = 0.0, sxy = 0.0;
  for (const auto& [x, y] : points) {
    sx += x;
    sy += y;
    sxx += x * x;
    sxy += x * y;
  }
  const double n = static_cast<double>(points.size()), spread = n * sxx - sx * sx;
  return n < 2.0 || spread <= 0.0 ? 0.0 : (n * sxy - sx * sy) / spread;
}

double observed_order(const std::vector<std::pair<double, double>>& points) {
  std::vector<std::pair<double, double>> logs;
  for (const auto& [x, y] : points)
    if (x > 0.0 && y > 0.0) logs.emplace_back(std::log(x), std::log(y));
  return slope(logs);
}

}  // namespace footfall
