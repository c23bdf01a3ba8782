// A sweep writes which runs are samples of one case. Each history is read once, and only the drawn
// columns are stored.
#include "mbd_solver/app/difference/samples.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/difference/run_pair.h"
#include "mbd_solver/app/run_folder.h"
#include "mbd_solver/base/csv.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

std::string column_of(const std::string& name, std::size_t k, const char* edge = "") {
  return name + " (" + std::to_string(k + 1) + edge + ")";
}
constexpr const char *kLow = " low", *kHigh = " high";
constexpr const char *kLowEdge = " 5 %", *kHighEdge = " 95 %";  // as web/src/plots.js knows them

}  // namespace

bool is_sweep(const std::string& folder) {
  return fs::exists(fs::path(folder) / "runs.csv") && !fs::exists(fs::path(folder) / "history.csv");
}

std::vector<SampledCase> cases_in(const std::string& folder) {
  if (!is_sweep(folder)) {
    if (!fs::exists(fs::path(folder) / "history.csv"))
      throw InputError(
          code::kNoRun,
          without_summary(folder, "neither history.csv nor runs.csv; expected the folder of a run or a sweep"));
    return {{name_of_run(folder), {folder}}};
  }
  const fs::path file = fs::path(folder) / kSamplesFile;
  if (!fs::exists(file))
    throw InputError(code::kNoRun, folder + ": the sweep has no " + kSamplesFile +
                                       "; repeat its command, which writes the list of runs of each case");
  std::vector<SampledCase> cases;
  CsvReader csv(file.string(), "the runs of a sweep");
  csv.next();  // the head
  while (csv.next()) {
    csv.require_width(2);
    const std::string name = csv.text(0), run = (fs::path(folder) / csv.text(1)).string();
    const auto same = [&](const SampledCase& c) { return c.name == name; };
    auto found = std::find_if(cases.begin(), cases.end(), same);
    if (found == cases.end()) found = cases.insert(cases.end(), {name, {}});
    found->runs.push_back(run);
  }
  if (cases.empty()) throw InputError(code::kNoRun, folder + ": no run of the sweep is done");
  return cases;
}

std::vector<SampledCase> cases_in(const std::string& a, const std::string& b) {
  std::vector<SampledCase> first = cases_in(a), second = cases_in(b);
  const bool alike = name_of_run(a) == name_of_run(b);
  const auto prefix = [&](std::vector<SampledCase>& cases, const std::string& folder) {
    const std::string name = alike ? folder : name_of_run(folder);
    for (SampledCase& c : cases) c.name = cases.size() == 1 ? name : name + ": " + c.name;
  };
  prefix(first, a);
  prefix(second, b);
  first.insert(first.end(), second.begin(), second.end());
  return first;
}

double quantile_of(std::vector<double> values, double share) {
  FOOTFALL_DEMAND(!values.empty());
  std::sort(values.begin(), values.end());
  const double place = share * static_cast<double>(values.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  if (below + 1 >= values.size()) return values.back();
  return values[below] + (place - static_cast<double>(below)) * (values[below + 1] - values[below]);
}

namespace {

// The time and the drawn columns of one run.
History drawn_part(const std::string& run, const std::vector<std::string>& columns) {
  const History all = read_history((fs::path(run) / "history.csv").string());
  History part{{"time"}, {"s"}, {all.column("time")}};
  for (const std::string& name : columns) {
    const int k = all.find(name);
    if (k < 0)
      throw InputError(code::kUnknownColumn,
                       "\"" + name + "\" is no column of " + run + "." + known_names("columns", name, all.names));
    part.names.push_back(name);
    part.units.push_back(all.units[k]);
    part.columns.push_back(all.columns[k]);
  }
  return part;
}

// Rows of the first run in the time that all cover.
std::vector<double> common_times(const std::vector<std::vector<History>>& parts) {
  double begin = -HUGE_VAL, end = HUGE_VAL;
  for (const std::vector<History>& runs : parts)
    for (const History& run : runs) {
      if (run.columns.front().empty()) return {};
      begin = std::max(begin, run.columns.front().front());
      end = std::min(end, run.columns.front().back());
    }
  std::vector<double> times;
  for (const double t : parts.front().front().columns.front())
    if (t >= begin && t <= end) times.push_back(t);
  return times;
}

void add_band(const std::vector<History>& runs, std::size_t column, std::size_t of_case, History& bands) {
  const History& first = runs.front();
  std::vector<double> mean, low, high;
  for (const double t : bands.columns.front()) {
    std::vector<double> values;
    for (const History& run : runs) values.push_back(value_at(run, run.columns[column], t));
    double sum = 0.0;
    for (const double value : values) sum += value;
    mean.push_back(sum / static_cast<double>(values.size()));
    low.push_back(quantile_of(values, kBeyondBand));
    high.push_back(quantile_of(values, 1.0 - kBeyondBand));
  }
  const auto add = [&](const char* edge, std::vector<double> values) {
    bands.names.push_back(column_of(first.names[column], of_case, edge));
    bands.units.push_back(first.units[column]);
    bands.columns.push_back(std::move(values));
  };
  add("", std::move(mean));
  if (runs.size() < 2) return;
  add(kLow, std::move(low));
  add(kHigh, std::move(high));
}

}  // namespace

History bands_on_one_clock(const std::vector<SampledCase>& cases, const std::vector<std::string>& columns) {
  std::vector<std::vector<History>> parts;
  for (const SampledCase& c : cases) {
    parts.emplace_back();
    for (const std::string& run : c.runs) parts.back().push_back(drawn_part(run, columns));
  }
  History bands{{"time"}, {"s"}, {common_times(parts)}};
  if (bands.columns.front().size() < 2)
    throw InputError(code::kNotComparable, cases.back().runs.back() + ": its rows and the rows of " +
                                               cases.front().runs.front() +
                                               " have no time in common; compare runs of the same span");
  for (std::size_t column = 1; column <= columns.size(); ++column)
    for (std::size_t k = 0; k < cases.size(); ++k) add_band(parts[k], column, k, bands);
  return bands;
}

History curves_of(const SampledCase& sampled) {
  History all = read_history((fs::path(sampled.runs.front()) / "history.csv").string());
  if (sampled.runs.size() < 2) return all;
  const std::vector<std::string> columns(all.names.begin() + 1, all.names.end());
  History curves = bands_on_one_clock({sampled}, columns);
  for (std::size_t k = 0; k < columns.size(); ++k)
    for (std::size_t edge = 0; edge < 3; ++edge)
      curves.names[1 + 3 * k + edge] = columns[k] + (edge == 0 ? "" : edge == 1 ? kLowEdge : kHighEdge);
  return curves;
}

std::vector<Figure> figures_of_bands(const std::vector<SampledCase>& cases, const History& bands,
                                     const std::vector<std::string>& columns) {
  if (cases.size() > kSeriesColours)
    throw InputError(code::kNotComparable, std::to_string(cases.size()) + " cases, expected at most " +
                                               std::to_string(kSeriesColours) + " in one picture");
  std::vector<Figure> figures;
  for (const std::string& name : columns) {
    Figure figure;
    figure.title = name;
    double largest = 0.0;
    const auto one = [&](std::size_t k, const char* edge) {
      const std::string column = column_of(name, k, edge);
      for (const double value : bands.column(column)) largest = std::max(largest, std::abs(value));
      return Formula{{{1.0, column}}, 0.0, 1.0};
    };
    for (std::size_t k = 0; k < cases.size(); ++k) {
      const std::size_t count = cases[k].runs.size();
      const std::string of = count > 1 ? ": mean and " + std::string(kBandWords) + " of " + std::to_string(count) : "";
      Curve curve{cases[k].name + of, one(k, ""), "", static_cast<int>(k)};
      if (count > 1) curve.band = {one(k, kLow), one(k, kHigh)};
      figure.curves.push_back(std::move(curve));
    }
    const DrawnUnit unit = drawn_unit(bands.units[bands.find(column_of(name, 0))], largest);
    for (Curve& curve : figure.curves) {
      curve.formula.factor = unit.factor;
      for (Formula& edge : curve.band) edge.factor = unit.factor;
    }
    figure.axis = "[" + unit.name + "]";
    figures.push_back(std::move(figure));
  }
  return figures;
}

}  // namespace footfall
