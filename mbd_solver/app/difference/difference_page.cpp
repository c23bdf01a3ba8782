// Tables of run_pair.h, and the curves that differ most, of both runs on one clock.
#include "mbd_solver/app/difference/difference_page.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/difference/pair_page.h"
#include "mbd_solver/app/difference/run_pair.h"
#include "mbd_solver/app/difference/sample_page.h"
#include "mbd_solver/app/difference/samples.h"
#include "mbd_solver/app/report.h"
#include "mbd_solver/session/output/summary.h"

namespace footfall {

namespace {

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

const nlohmann::ordered_json* requirement_of(const nlohmann::ordered_json& list, const std::string& name) {
  for (const nlohmann::ordered_json& one : list)
    if (one.value("name", "") == name) return &one;
  return nullptr;
}

void show_both_requirements(const RunPair& pair, HtmlPage& page) {
  const nlohmann::ordered_json none = nlohmann::ordered_json::array();
  const nlohmann::ordered_json first = pair.a.summary.value("requirements", none),
                               second = pair.b.summary.value("requirements", none);
  if (first.empty() && second.empty()) return;
  page.section("Requirements");
  TableRows rows = {{"requirement", pair.a.name, "verdict", pair.b.name, "verdict"}};
  std::vector<std::string> classes = {""};
  const auto cell = [](const nlohmann::ordered_json* one) {
    if (one == nullptr || !one->contains("value")) return std::string("-");
    const std::string unit = one->value("unit", "");
    return number_text(one->at("value").get<double>(), 4) + (unit == "-" ? "" : " " + unit);
  };
  const auto verdict = [](const nlohmann::ordered_json* one) {
    return one ? one->value("verdict", "-") : std::string("-");
  };
  std::vector<std::string> names;
  for (const nlohmann::ordered_json* list : {&first, &second})
    for (const nlohmann::ordered_json& one : *list)
      if (const std::string name = one.value("name", ""); std::find(names.begin(), names.end(), name) == names.end())
        names.push_back(name);
  for (const std::string& name : names) {
    const nlohmann::ordered_json *one = requirement_of(first, name), *other = requirement_of(second, name);
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

}  // namespace

std::string write_difference(const std::string& a, const std::string& b) {
  if (is_sweep(a) || is_sweep(b)) return write_sample_difference(a, b);
  const RunPair pair(a, b);
  HtmlPage page(pair.a.name + " and " + pair.b.name);
  page.paragraph("Two runs: " + pair.a.name + " (" + end_text(pair.a.summary) + ") and " + pair.b.name + " (" +
                 end_text(pair.b.summary) + ").");
  show_both_requirements(pair, page);
  show_keys(pair, page);
  show_figures(pair, page);
  show_curves(pair, page);
  const std::string file = (std::filesystem::path(a) / "difference.html").string();
  write_whole_file(file, page.text(), "is the disk full?");
  return file;
}

}  // namespace footfall
