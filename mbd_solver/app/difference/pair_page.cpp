// The second run is made into the parts of a page of its own, which become parts of the first one under other names; its curves
// are added to the panels of the first.
#include "mbd_solver/app/difference/pair_page.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/view_page.h"

namespace footfall {

namespace {

constexpr const char* kOther = "other-";
constexpr std::size_t kMostListed = 40;  // keys of scenes in the page

// Makes the parts of a page of its own into parts of another one.
void add_other(PageParts theirs, const std::string& name, const std::string& other, PageParts& parts) {
  theirs.run["name"] = other;
  parts.run["name"] = name;
  parts.run["other"] = theirs.run;
  const auto renamed = [](const PageParts::Chunk& chunk) {
    return PageParts::Chunk(kOther + chunk.first, chunk.second);
  };
  for (const PageParts::Chunk& chunk : theirs.chunks) parts.chunks.push_back(renamed(chunk));
  for (const auto& [k, frame] : theirs.later)
    for (const PageParts::Chunk& chunk : frame) parts.later[k].push_back(renamed(chunk));
}

}  // namespace

void add_second_run(const RunPair& pair, bool shapes, PageParts& parts) {
  PageParts theirs;
  FrameLimits limits;
  add_history(pair.b.history, {}, theirs);
  if (shapes) add_bodies(pair.b.folder, pair.b.summary, limits, theirs);
  add_other(std::move(theirs), pair.a.name, pair.b.name, parts);
  parts.run["differences"] = nlohmann::ordered_json::array();
  for (const KeyDifference& one : scene_differences(pair.a.scene, pair.b.scene))
    if (parts.run["differences"].size() < kMostListed) parts.run["differences"].push_back({one.key, one.a, one.b});
}

PageParts plots_of_histories(const NamedHistory& first, const NamedHistory& second,
                             const std::vector<std::string>& shown) {
  PageParts parts, theirs;
  add_history(first.history, shown, parts);
  add_history(second.history, {}, theirs);
  add_other(std::move(theirs), first.name, second.name, parts);
  return parts;
}

PageParts plots_of_pair(const RunPair& pair, const std::vector<std::string>& shown) {
  PageParts parts;
  add_history(pair.a.history, shown, parts);
  add_second_run(pair, false, parts);
  return parts;
}

PairPlots plots_of_columns(const RunPair& pair, const std::vector<std::string>& columns) {
  for (const std::string& name : columns)
    if (pair.b.history.find(name) < 0)
      throw InputError(code::kUnknownColumn, "\"" + name + "\" is no column of " + pair.b.folder + ", only of " +
                                                 pair.a.folder + "." +
                                                 known_names("columns", name, pair.b.history.names));
  PairPlots plots{on_one_clock(pair, columns), panels_of(pair.a.history, columns)};
  plots.panels.multiples = false;
  std::vector<Figure> all;
  for (Figure& figure : plots.panels.figures) {
    const std::vector<Curve> own = figure.curves;
    Figure difference = figure;
    difference.curves.clear();
    difference.title = pair.b.name + " minus " + pair.a.name;
    difference.low = difference.high = figure.low = figure.high = 0.0;
    double largest = 0.0;
    figure.curves.clear();
    for (std::size_t i = 0; i < own.size(); ++i) {
      const std::string column = own[i].formula.columns.front().second;
      const std::string first = column + kFirstRun, second = column + kSecondRun;
      const int series = own[i].series >= 0 ? own[i].series : static_cast<int>(i);
      const double factor = own[i].formula.factor;
      figure.curves.push_back({own[i].title + ", " + pair.a.name, {{{1.0, first}}, 0.0, factor}, "", series});
      figure.curves.push_back({own[i].title + ", " + pair.b.name, {{{1.0, second}}, 0.0, factor}, "", series, true});
      difference.curves.push_back({own[i].title, {{{1.0, second}, {-1.0, first}}, 0.0, 1.0}, "", series});
      for (const double value : difference.curves.back().formula.values(plots.history))
        largest = std::max(largest, std::abs(value));
    }
    // Their own unit by size.
    const std::string unit = pair.a.history.units[pair.a.history.find(own.front().formula.columns.front().second)];
    const DrawnUnit drawn = drawn_unit(unit, largest);
    for (Curve& curve : difference.curves) curve.formula.factor = drawn.factor;
    difference.axis = "difference [" + drawn.name + "]";
    if (figure.title.empty()) figure.title = pair.a.name + " and " + pair.b.name;
    all.push_back(std::move(figure));
    all.push_back(std::move(difference));
  }
  plots.panels.figures = std::move(all);
  return plots;
}

}  // namespace footfall
