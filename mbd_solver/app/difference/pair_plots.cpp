// Panels of the first run, to which the curves of the second are added.
#include "mbd_solver/app/difference/pair_plots.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"

namespace footfall {

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
