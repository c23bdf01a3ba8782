#include "mbd_solver/cli/calibrate/misfit.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "mbd_solver/cli/experiments/experiment.h"
#include "mbd_solver/scene/field_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kCurveWithin = 1.5;  // tolerances, root mean square: noise of one tolerance alone makes about one

double mean_of(const std::vector<double>& values) {
  double sum = 0.0;
  for (const double value : values) sum += value;
  return sum / static_cast<double>(values.size());
}

double spread_of(const std::vector<double>& values) {
  if (values.size() < 2) return 0.0;
  const double mean = mean_of(values);
  double sum = 0.0;
  for (const double value : values) sum += (value - mean) * (value - mean);
  return std::sqrt(sum / static_cast<double>(values.size() - 1));
}

TargetResult failure(const CalibrationSpec& spec) {
  TargetResult result;
  result.failed = true;
  result.residuals = {spec.failed};
  return result;
}

}  // namespace

double residual_of(const TargetSpec& target, double y) {
  if (target.value) return (y - *target.value) / target.tolerance;
  if (y > target.most) return (y - target.most) / target.tolerance;
  return y < target.least ? (y - target.least) / target.tolerance : 0.0;
}

double capped(double residual, double cap) { return cap > 0.0 ? std::clamp(residual, -cap, cap) : residual; }

double TargetResult::misfit(const TargetSpec& target, double cap) const {
  double sum = 0.0;
  for (const double r : residuals) sum += target.weight * capped(r, cap) * capped(r, cap);
  return sum;
}

bool TargetResult::met(const std::vector<double>& residuals, bool band) {
  double squares = 0.0;
  for (const double r : residuals) squares += r * r;
  if (band) return squares == 0.0;
  return std::sqrt(squares / static_cast<double>(residuals.size())) <= (residuals.size() > 1 ? kCurveWithin : 1.0);
}

std::vector<double> first_crossings(const std::vector<double>& x, const std::vector<double>& y,
                                    const std::vector<double>& at) {
  const auto rows = static_cast<std::size_t>(std::max_element(x.begin(), x.end()) - x.begin()) + 1;
  std::vector<double> values;
  for (const double place : at) {
    std::size_t k = 0;
    while (k < rows && x[k] < place) ++k;
    if (k == 0 || k == rows)
      values.push_back(k == 0 ? y.front() : y[rows - 1]);
    else
      values.push_back(y[k - 1] + (y[k] - y[k - 1]) * (place - x[k - 1]) / (x[k] - x[k - 1]));
  }
  return values;
}

RunNumbers numbers_of(const CalibrationSpec& spec, const std::string& scene, const std::string& folder) {
  RunNumbers numbers;
  numbers.figures.assign(spec.figures.size(), std::nan(""));
  numbers.curves.resize(spec.targets.size());
  History history;
  for (std::size_t t = 0; t < spec.targets.size(); ++t) {
    const TargetSpec& target = spec.targets[t];
    if (target.scene != scene && target.against != scene) continue;
    if (!target.is_curve()) {
      const auto k = static_cast<std::size_t>(index_of(spec.figures, target.figure));
      if (std::isnan(numbers.figures[k]))
        numbers.figures[k] = figures_of_run({spec.figures[k]}, folder, spec.file).front();
      continue;
    }
    if (history.names.empty()) history = read_history((fs::path(folder) / "history.csv").string());
    std::vector<double> places;
    for (const Eigen::Vector2d& row : read_two_columns(target.file)) places.push_back(row.x());
    demand_columns({target.over, target.column}, history, folder, spec.file, "targets." + target.name);
    const std::vector<double>& x = history.column(target.over);
    if (!x.empty()) numbers.curves[t] = first_crossings(x, history.column(target.column), places);
  }
  return numbers;
}

TargetResult result_of(const CalibrationSpec& spec, std::size_t target,
                       const std::vector<std::vector<RunNumbers>>& runs) {
  const TargetSpec& t = spec.targets[target];
  const std::vector<RunNumbers>& mine = runs[static_cast<std::size_t>(index_of(spec.scenes, t.scene))];
  if (mine.empty()) return failure(spec);
  TargetResult result;
  if (t.is_curve()) {
    const std::vector<Eigen::Vector2d> rows = read_two_columns(t.file);
    for (const RunNumbers& run : mine) {
      if (run.curves[target].size() != rows.size()) return failure(spec);
      result.of_seed.push_back(run.curves[target]);
    }
    for (std::size_t k = 0; k < rows.size(); ++k) {
      std::vector<double> values;
      for (const RunNumbers& run : mine) values.push_back(run.curves[target][k]);
      result.values.push_back(mean_of(values));
      result.spread.push_back(spread_of(values));
      result.residuals.push_back((result.values.back() - rows[k].y()) / t.tolerance);
    }
    return result;
  }
  const auto k = static_cast<std::size_t>(index_of(spec.figures, t.figure));
  std::vector<double> values, others, ratios;
  for (const RunNumbers& run : mine) values.push_back(run.figures[k]);
  double y = mean_of(values);
  if (!t.against.empty()) {
    for (const RunNumbers& run : runs[static_cast<std::size_t>(index_of(spec.scenes, t.against))])
      others.push_back(run.figures[k]);
    if (others.size() != values.size()) return failure(spec);
    for (std::size_t s = 0; s < values.size(); ++s) values[s] /= others[s];
    y /= mean_of(others);
  }
  if (!std::isfinite(y)) return failure(spec);
  for (const double value : values) result.of_seed.push_back({value});
  result.values = {y};
  result.spread = {spread_of(values)};
  result.residuals = {residual_of(t, y)};
  result.band = t.is_band();
  return result;
}

}  // namespace footfall
