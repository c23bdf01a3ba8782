// Means of the figures of two ensembles, their difference in standard errors, and the curves with
// their bands.
#include "mbd_solver/app/difference/sample_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/difference/pair_page.h"
#include "mbd_solver/app/difference/run_pair.h"
#include "mbd_solver/app/difference/samples.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using TableRows = std::vector<std::vector<std::string>>;

constexpr double kWithinScatter = 2.0;  // standard errors: below, the samples do not show a difference

// The summaries of one case, and the means of their numbers.
struct Ensemble {
  explicit Ensemble(const SampledCase& sampled) : name(sampled.name) {
    for (const std::string& run : sampled.runs) all.push_back(read_summary((fs::path(run) / "summary.json").string()));
    for (const auto& [key, value] : all.front().items())
      if (value.is_number()) mean[key] = mean_of(key);
  }
  std::vector<double> values_of(const std::string& key) const {
    std::vector<double> values;
    for (const Json& summary : all)
      if (summary.contains(key) && summary.at(key).is_number()) values.push_back(summary.at(key).get<double>());
    return values;
  }
  double mean_of(const std::string& key) const {
    double sum = 0.0;
    const std::vector<double> values = values_of(key);
    for (const double value : values) sum += value;
    return sum / static_cast<double>(values.size());
  }
  // Variance of the mean, s^2 / n; 0 of a single run.
  double variance_of_mean(const std::string& key) const {
    const std::vector<double> values = values_of(key);
    const double m = mean_of(key), n = static_cast<double>(values.size());
    double squares = 0.0;
    for (const double value : values) squares += (value - m) * (value - m);
    return n > 1.0 ? squares / (n * (n - 1.0)) : 0.0;
  }
  double spread_of(const std::string& key) const {
    return std::sqrt(variance_of_mean(key) * static_cast<double>(values_of(key).size()));
  }
  Json scene() const { return all.front().value("scene", Json::object()); }
  // Keys of scenes in which the samples differ, such as the seed of the bed.
  std::set<std::string> keys_of_samples() const {
    std::set<std::string> keys;
    for (const Json& summary : all)
      for (const KeyDifference& one : scene_differences(scene(), summary.value("scene", Json::object())))
        keys.insert(one.key);
    return keys;
  }
  std::string heading() const { return name + (all.size() > 1 ? " (" + std::to_string(all.size()) + " samples)" : ""); }

  std::string name;
  std::vector<Json> all;
  Json mean = Json::object();
};

void show_scenes(const Ensemble& a, const Ensemble& b, HtmlPage& page) {
  std::set<std::string> chance = a.keys_of_samples();
  for (const std::string& key : b.keys_of_samples()) chance.insert(key);
  TableRows rows = {{"key", a.heading(), b.heading()}};
  for (const KeyDifference& one : scene_differences(a.scene(), b.scene()))
    if (chance.count(one.key) == 0) rows.push_back({one.key, one.a, one.b});
  page.subsection("Scenes");
  if (rows.size() == 1) return page.paragraph("Both have the same scene, but for what distinguishes samples.");
  page.table(rows);
}

void show_figures(const Ensemble& a, const Ensemble& b, HtmlPage& page) {
  page.subsection("Figures");
  const std::vector<FigureDifference> found = figure_differences(a.mean, b.mean);
  if (found.empty()) return page.paragraph("All means of peaks, margins and errors are equal.");
  page.paragraph("Mean and spread (standard deviation). A difference below " + number_text(kWithinScatter) +
                 " standard errors of the difference of the means is within scatter.");
  TableRows rows = {
      {"figure", a.heading(), "spread", b.heading(), "spread", "difference", "standard errors", "verdict"}};
  for (const FigureDifference& one : found) {
    const double error = std::sqrt(a.variance_of_mean(one.key) + b.variance_of_mean(one.key));
    const double errors = error > 0.0 ? std::abs(one.b - one.a) / error : HUGE_VAL;
    rows.push_back({one.name, readable(one.a, one.unit), readable(a.spread_of(one.key), one.unit),
                    readable(one.b, one.unit), readable(b.spread_of(one.key), one.unit),
                    readable(one.b - one.a, one.unit), error > 0.0 ? number_text(errors, 2) : "-",
                    errors < kWithinScatter ? "within scatter" : "differs"});
  }
  page.table(rows);
}

// Those columns that a page shows at first, of both.
void show_curves(const SampledCase& a, const SampledCase& b, HtmlPage& page) {
  const History first = curves_of(a), second = curves_of(b);
  const std::string observed =
      read_summary((fs::path(a.runs.front()) / "summary.json").string()).value("observed_body", "");
  page.subsection("Curves");
  page.paragraph("Means over the samples; bands hold " + std::string(kBandWords) + " of them.");
  page.data() = plots_of_histories({a.name, first}, {b.name, second}, first_columns(first, observed));
  page.plots();
}

// The pairs of cases to compare.
std::vector<std::pair<SampledCase, SampledCase>> common_cases(const std::string& a, const std::string& b) {
  std::vector<SampledCase> first = cases_in(a), second = cases_in(b);
  const auto name_in_title = [](std::vector<SampledCase>& cases, const std::string& folder) {
    for (SampledCase& c : cases) c.name = name_of_run(folder);
  };
  std::vector<std::pair<SampledCase, SampledCase>> pairs;
  if (first.size() == 1 && second.size() == 1) {
    name_in_title(first, a);
    name_in_title(second, b);
    return {{first.front(), second.front()}};
  }
  for (const SampledCase& one : first)
    for (const SampledCase& other : second)
      if (one.name == other.name) pairs.emplace_back(one, other);
  if (pairs.empty())
    throw InputError(code::kNotComparable, a + " and " + b + ": the two have no case of the same name");
  return pairs;
}

}  // namespace

std::string write_sample_difference(const std::string& a, const std::string& b) {
  HtmlPage page(name_of_run(a) + " and " + name_of_run(b));
  const auto pairs = common_cases(a, b);
  for (const auto& [one, other] : pairs) {
    const Ensemble first(one), second(other);
    page.section(one.name == other.name ? one.name : first.heading() + " and " + second.heading());
    show_scenes(first, second, page);
    show_figures(first, second, page);
    if (pairs.size() == 1) show_curves(one, other, page);
  }
  if (pairs.size() > 1) page.paragraph("footfall plot draws curves of several cases over each other.");
  const std::string file = (fs::path(a) / "difference.html").string();
  write_whole_file(file, page.text(), "is the disk full?");
  return file;
}

}  // namespace footfall
