// Of two runs: tables of run_pair.h, and the curves that differ most, on one clock. Of two ensembles: means of the figures, their
// difference in standard errors, and the curves with their bands.
#include "mbd_solver/app/difference/difference_page.h"

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
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;
using TableRows = std::vector<std::vector<std::string>>;

constexpr std::size_t kMostKeys = 200, kMostCurves = 25, kDrawnCurves = 4;

std::string change_text(double a, double b) {
  return a != 0.0 ? number_text(100.0 * (b - a) / std::abs(a), 3) + " %" : "-";
}

void show_keys(const RunPair& pair, HtmlPage& page) {
  page.section("Scenes");
  const std::vector<KeyDifference> found = scene_differences(pair.a.scene, pair.b.scene);
  if (found.empty()) return page.paragraph("Both runs have the same scene, with all defaults.");
  TableRows rows = {{"key", pair.a.name, pair.b.name}};
  for (const KeyDifference& one : found)
    if (rows.size() <= kMostKeys) rows.push_back({one.key, one.a, one.b});
  page.table(rows);
  if (found.size() > kMostKeys)
    page.paragraph("and " + std::to_string(found.size() - kMostKeys) +
                   " further keys; the scenes have little in common.");
}

const Json* requirement_of(const Json& list, const std::string& name) {
  for (const Json& one : list)
    if (one.value("name", "") == name) return &one;
  return nullptr;
}

void show_both_requirements(const RunPair& pair, HtmlPage& page) {
  const Json none = Json::array();
  const Json first = pair.a.summary.value("requirements", none), second = pair.b.summary.value("requirements", none);
  if (first.empty() && second.empty()) return;
  page.section("Requirements");
  TableRows rows = {{"requirement", pair.a.name, "verdict", pair.b.name, "verdict"}};
  std::vector<std::string> classes = {""};
  const auto cell = [](const Json* one) {
    if (one == nullptr || !one->contains("value")) return std::string("-");
    const std::string unit = one->value("unit", "");
    return number_text(one->at("value").get<double>(), 4) + (unit == "-" ? "" : " " + unit);
  };
  const auto verdict = [](const Json* one) { return one ? one->value("verdict", "-") : std::string("-"); };
  std::vector<std::string> names;
  for (const Json* list : {&first, &second})
    for (const Json& one : *list)
      if (const std::string name = one.value("name", ""); std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  for (const std::string& name : names) {
    const Json *one = requirement_of(first, name), *other = requirement_of(second, name);
    rows.push_back({name, cell(one), verdict(one), cell(other), verdict(other)});
    classes.push_back(verdict(one) == "missed" || verdict(other) == "missed" ? "missed" : "met");
  }
  page.table(rows, true, classes);
}

void show_figures(const RunPair& pair, HtmlPage& page) {
  page.section("Figures");
  const std::vector<FigureDifference> found = figure_differences(pair.a.summary, pair.b.summary);
  if (found.empty()) return page.paragraph("All peaks, margins and errors of the two runs are equal.");
  TableRows rows = {{"figure", pair.a.name, pair.b.name, "difference", "change"}};
  for (const FigureDifference& one : found)
    rows.push_back({one.name, readable(one.a, one.unit), readable(one.b, one.unit), readable(one.b - one.a, one.unit),
                    change_text(one.a, one.b)});
  page.table(rows);
}

void show_curves(const RunPair& pair, HtmlPage& page) {
  const std::string kBeyond = " by more than a millionth of the largest value with its unit.";
  page.section("Curves");
  const std::vector<CurveDifference> found = curve_differences(pair.a.history, pair.b.history);
  const double end = std::min(pair.a.history.columns.front().back(), pair.b.history.columns.front().back());
  const std::string over = "Over the first " + number_text(end, 4) + " s, which both runs cover: ";
  if (found.empty()) return page.paragraph(over + "no column of the histories differs" + kBeyond);
  page.paragraph(over + std::to_string(found.size()) + " of " + std::to_string(pair.a.history.names.size() - 1) +
                 " columns differ" + kBeyond +
                 " Share: root mean square of the difference over the range of both curves.");
  TableRows rows = {{"column", "largest difference", "at", "share"}};
  for (std::size_t i = 0; i < std::min(found.size(), kMostCurves); ++i)
    rows.push_back({found[i].name, readable(found[i].largest, found[i].unit), number_text(found[i].at, 4) + " s",
                    number_text(100.0 * found[i].share, 3) + " %"});
  page.table(rows);
  if (found.size() > kMostCurves)
    page.paragraph("The other " + std::to_string(found.size() - kMostCurves) + " columns differ by a smaller share.");
  // Those that a page shows at first, or else the ones that differ most.
  std::vector<std::string> shown;
  for (const std::string& name : first_columns(pair.a.history, pair.a.summary.value("observed_body", "")))
    if (shown.size() < kDrawnCurves &&
        std::any_of(found.begin(), found.end(), [&](const auto& c) { return c.name == name; }))
      shown.push_back(name);
  for (const CurveDifference& one : found)
    if (shown.size() < kDrawnCurves && std::find(shown.begin(), shown.end(), one.name) == shown.end())
      shown.push_back(one.name);
  page.data() = plots_of_pair(pair, shown);
  page.plots();
}

// ---- two ensembles ----

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

// The page of two folders of which one is a sweep: a section per case that both have; two folders with a single case each are
// compared whatever its name.
std::string page_of_ensembles(const std::string& a, const std::string& b) {
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
  return page.text();
}

std::string page_of_runs(const std::string& a, const std::string& b) {
  const RunPair pair(a, b);
  HtmlPage page(pair.a.name + " and " + pair.b.name);
  page.paragraph("Two runs: " + pair.a.name + " (" + end_text(pair.a.summary) + ") and " + pair.b.name + " (" +
                 end_text(pair.b.summary) + ").");
  show_both_requirements(pair, page);
  show_keys(pair, page);
  show_figures(pair, page);
  show_curves(pair, page);
  return page.text();
}

}  // namespace

std::string write_difference(const std::string& a, const std::string& b) {
  const std::string text = is_sweep(a) || is_sweep(b) ? page_of_ensembles(a, b) : page_of_runs(a, b);
  const std::string file = (fs::path(a) / "difference.html").string();
  write_whole_file(file, text, "is the disk full?");
  return file;
}

}  // namespace footfall
