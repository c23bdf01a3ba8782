// Reductions of columns, and statistics over an ensemble.
#include "mbd_solver/studies/metrics.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numeric>
#include <sstream>
#include <tuple>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/bed/bed_measures.h"
#include "mbd_solver/session/output/former_names.h"
#include "mbd_solver/session/output/peaks.h"
#include "mbd_solver/session/output/summary.h"
#include "mbd_solver/studies/codes.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kNone = std::numeric_limits<double>::quiet_NaN();
constexpr double kSteadyShare = 0.4;  // of the rows

std::vector<std::string> numbers_in(const nlohmann::ordered_json& summary) {
  std::vector<std::string> names;
  for (const auto& [key, value] : summary.items())
    if (value.is_number()) names.push_back(key);
  return names;
}

bool smaller_size(double a, double b) { return std::abs(a) < std::abs(b); }

double variation(const std::vector<double>& x) {
  double sum = 0.0;
  for (std::size_t i = 1; i < x.size(); ++i) sum += std::abs(x[i] - x[i - 1]);
  return sum;
}

double steady(const std::vector<double>& x) {
  const auto rows = static_cast<double>(x.size());
  const double last = std::max(1.0, std::floor(kSteadyShare * rows));
  return std::accumulate(x.end() - static_cast<std::ptrdiff_t>(last), x.end(), 0.0) / last;
}

double reduced(const MetricSpec& metric, const std::vector<double>& x) {
  switch (metric.reduction) {
    case Reduction::kMin: return *std::min_element(x.begin(), x.end());
    case Reduction::kFinal: return x.back();
    case Reduction::kLargest: return std::abs(*std::max_element(x.begin(), x.end(), smaller_size));
    case Reduction::kDrop: return x.front() - *std::min_element(x.begin(), x.end());
    case Reduction::kLoss: return (x.front() - x.back()) / x.front();
    case Reduction::kPeaks: return count_peaks(x, metric.prominence * *std::max_element(x.begin(), x.end()));
    case Reduction::kVariation: return variation(x);
    case Reduction::kSteady: return steady(x);
    case Reduction::kMax: break;
  }
  return *std::max_element(x.begin(), x.end());
}

// With the peaks between rows.
double reduced(const MetricSpec& metric, const std::vector<double>& x, const ColumnPeaks& peaks) {
  switch (metric.reduction) {
    case Reduction::kMax: return peaks.largest;
    case Reduction::kMin: return peaks.least;
    case Reduction::kLargest: return std::max(std::abs(peaks.least), std::abs(peaks.largest));
    case Reduction::kDrop: return x.front() - peaks.least;
    case Reduction::kFinal:
    case Reduction::kLoss:
    case Reduction::kPeaks:
    case Reduction::kVariation:
    case Reduction::kSteady: break;
  }
  return reduced(metric, x);
}

double of_history(const MetricSpec& metric, const History& history, const std::vector<ColumnPeaks>& peaks) {
  std::vector<double> values;  // of the columns
  for (const std::string& name : metric.columns) {
    const std::vector<double>& column = history.column(name);
    if (column.empty()) continue;
    const auto found = std::find_if(peaks.begin(), peaks.end(), [&](const ColumnPeaks& p) { return p.name == name; });
    values.push_back(found == peaks.end() ? reduced(metric, column) : reduced(metric, column, *found));
  }
  if (values.empty()) return kNone;
  if (metric.average) return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  if (metric.reduction == Reduction::kFinal) return values.back();
  return metric.reduction == Reduction::kMin ? *std::min_element(values.begin(), values.end())
                                             : *std::max_element(values.begin(), values.end());
}

double value_of_requirement(const nlohmann::ordered_json& summary, const std::string& name) {
  for (const auto& told : summary.value("requirements", nlohmann::ordered_json::array()))
    if (told.value("name", "") == name && told.contains("value") && told.at("value").is_number())
      return told.at("value").get<double>();
  return kNone;
}

double value_at(const std::vector<double>& times, const std::vector<double>& values, double t) {
  const auto after = std::upper_bound(times.begin(), times.end(), t);
  const std::size_t i = static_cast<std::size_t>(
      std::clamp<std::ptrdiff_t>(after - times.begin() - 1, 0, static_cast<std::ptrdiff_t>(times.size()) - 2));
  const double u = (t - times[i]) / (times[i + 1] - times[i]);
  return values[i] + u * (values[i + 1] - values[i]);
}

// Mean and standard deviation; 0 for one value.
std::pair<double, double> mean_and_spread(const std::vector<double>& values) {
  const Eigen::Map<const Eigen::ArrayXd> x(values.data(), values.size());
  const double mean = x.mean(), freedoms = std::max(1.0, static_cast<double>(values.size()) - 1.0);
  return {mean, std::sqrt((x - mean).square().sum() / freedoms)};
}

}  // namespace

int count_peaks(const std::vector<double>& values, double least) {
  // From valley to valley: a peak counts when the curve has risen by `least` to it and fallen by `least` from it.
  int peaks = 0;
  bool climbing = true;  // since `lowest`; else falling since `highest`
  double lowest = std::numeric_limits<double>::infinity(), highest = -lowest;
  for (const double value : values) {
    if (climbing) {
      lowest = std::min(lowest, value);
      highest = value - lowest >= least ? std::max(highest, value) : highest;
      if (highest - value >= least && std::isfinite(highest)) {
        ++peaks;
        climbing = false;
        lowest = value;
      }
    } else {
      lowest = std::min(lowest, value);
      if (value - lowest >= least) {
        climbing = true;
        highest = value;
      }
    }
  }
  return peaks + (climbing && std::isfinite(highest) ? 1 : 0);
}

void require_columns(const std::vector<std::string>& columns, const History& history, const std::string& folder,
                     const std::string& file, const std::string& who) {
  for (const std::string& name : columns)
    if (history.find(name) < 0)
      throw InputError(code::kMetricMissing, file + ": " + who + ": " + folder + "/history.csv has no column \"" +
                                                 name + "\"." + known_names("columns", name, history.names));
}

std::string metric_recipe(const MetricSpec& f) {
  std::ostringstream text;
  text.precision(17);
  text << f.name << '\n' << f.key << '\n' << joined(f.columns, ",") << '\n' << name_of(f.reduction) << ' ';
  text << f.average << ' ' << f.prominence << ' ' << f.over;
  for (const double height : f.slope) text << ' ' << height;
  if (!f.requirement.empty()) text << " requirement " << f.requirement;
  return text.str();
}

std::vector<double> metrics_of_run(const std::vector<MetricSpec>& metrics, const std::string& folder,
                                   const std::string& file) {
  const std::string summary_file = (fs::path(folder) / "summary.json").string();
  const nlohmann::ordered_json summary = read_summary(summary_file);
  const auto of_summary = [&](const std::string& given) {
    const std::string& key = present_name(given);
    if (!summary.contains(key) || !summary[key].is_number())
      throw InputError(code::kMetricMissing, file + ": figures: " + summary_file + " has no number \"" + key + "\"." +
                                                 known_names("numbers", key, numbers_in(summary)));
    return summary[key].get<double>();
  };
  History history;
  std::vector<ColumnPeaks> peaks;
  std::vector<double> values;
  for (const MetricSpec& metric : metrics) {
    if (!metric.requirement.empty()) {
      values.push_back(value_of_requirement(summary, metric.requirement));
      continue;
    }
    if (!metric.columns.empty()) {
      if (history.names.empty()) {
        history = read_history((fs::path(folder) / "history.csv").string());
        peaks = read_peaks((fs::path(folder) / "peaks.csv").string());
      }
      require_columns(metric.columns, history, folder, file, "figures." + metric.name + ".columns");
    }
    if (metric.compares_curves()) {
      values.push_back(kNone);
      continue;
    }
    values.push_back(!metric.key.empty()    ? of_summary(metric.key)
                     : metric.slope.empty() ? of_history(metric, history, peaks)
                                            : last_slope(folder, metric.slope[0], metric.slope[1]).angle);
    if (!metric.over.empty()) values.back() /= of_summary(metric.over);
  }
  return values;
}

double history_error(const History& run, const History& reference, const std::vector<std::string>& columns, bool at_end,
                     double until) {
  const std::vector<double>& times = run.column("time");
  const std::vector<double>& reference_times = reference.column("time");
  if (reference_times.size() < 2 || times.empty())
    throw InputError(code::kRunWithoutRows, "figures: a run without rows cannot be compared");
  const auto end = until > 0.0 ? std::upper_bound(times.begin(), times.end(), until * (1.0 + 1e-9)) : times.end();
  const std::size_t count = std::max<std::size_t>(1, end - times.begin());
  double sum = 0.0;
  for (const std::string& name : columns) {
    const std::vector<double>& mine = run.column(name);
    const std::vector<double>& theirs = reference.column(name);
    const auto [low, high] = std::minmax_element(theirs.begin(), theirs.end());
    const double range = *high > *low ? *high - *low : 1.0;
    double square = 0.0;
    const std::size_t first = at_end ? count - 1 : 0;
    for (std::size_t i = first; i < count; ++i) {
      const double difference = (mine[i] - value_at(reference_times, theirs, times[i])) / range;
      square += difference * difference;
    }
    sum += square / static_cast<double>(count - first);
  }
  return std::sqrt(sum / static_cast<double>(columns.size()));
}

std::vector<double> curve_errors(const std::vector<MetricSpec>& metrics, const std::string& folder,
                                 const std::string& reference) {
  std::vector<double> errors(metrics.size(), SampledMetric::kNone);
  History mine, theirs;
  for (std::size_t k = 0; k < metrics.size(); ++k) {
    if (!metrics[k].compares_curves()) continue;
    if (mine.names.empty()) {
      mine = read_history(folder + "/history.csv");
      theirs = read_history(reference + "/history.csv");
    }
    errors[k] =
        history_error(mine, theirs, metrics[k].columns, metrics[k].error == ErrorKind::kFinal, metrics[k].until);
  }
  return errors;
}

SampledMetric sampled_metric(const std::vector<double>& metrics) {
  SampledMetric sampled;
  if (!metrics.empty()) std::tie(sampled.mean, sampled.spread) = mean_and_spread(metrics);
  return sampled;
}

SampledMetric sampled_metric(const std::vector<double>& metrics, const std::vector<double>& reference) {
  std::vector<double> differences;
  for (std::size_t k = 0; k < metrics.size(); ++k) differences.push_back(metrics[k] - reference[k]);
  const auto [mean, spread] = mean_and_spread(metrics);
  const auto [difference, scatter] = mean_and_spread(differences);
  const double expected = mean_and_spread(reference).first, size = expected != 0.0 ? std::abs(expected) : 1.0;
  return {mean, spread, std::abs(difference) / size, scatter / std::sqrt(static_cast<double>(metrics.size())) / size};
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
