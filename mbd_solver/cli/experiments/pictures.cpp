#include "mbd_solver/cli/experiments/pictures.h"

#include <algorithm>
#include <filesystem>

#include "coupler/base/quote.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/experiments/error_page.h"
#include "mbd_solver/output/history.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// Some point of the curve has such an error, and a place over x; over run time all have.
bool has_points(const Results& results, int curve, std::size_t figure, bool over_time) {
  return std::any_of(results.cases.begin(), results.cases.end(), [&](const CaseResult& c) {
    return c.is_of(curve) && c.code == 0 && (over_time || c.plan.x > 0.0) && c.figures[figure].error > 0.0;
  });
}

// " every ::3::5": the rows of a curve.
std::string rows_of(const Results& results, int curve) {
  const std::vector<const CaseResult*> points = points_of(results);
  const auto mine = [&](const CaseResult* c) { return c->is_of(curve); };
  const auto first = std::find_if(points.begin(), points.end(), mine);
  const auto count = std::count_if(points.begin(), points.end(), mine), from = first - points.begin();
  return " every ::" + std::to_string(from) + "::" + std::to_string(from + count - 1);
}

// Columns go by their numbers: gnuplot does not know names with a comma.
std::string error_lines(const ExperimentSpec& spec, const Results& results, const std::string& file, const Table& table,
                        std::size_t figure, bool over_time) {
  const bool samples = results.members > 1;
  const auto column = [&](const std::string& name) { return "column(" + std::to_string(table.column(name)) + ")"; };
  const std::string x = !over_time ? column("x")
                        : samples  ? column("cpu_s")
                                   : column("mbd_wall_s") + "+" + column("exchange_wall_s");
  const std::string name = spec.figures[figure].name;
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < spec.curves.size(); ++k) {
    const int curve = static_cast<int>(k);
    if (!has_points(results, curve, figure, over_time)) continue;
    std::string title = spec.curves[k].name;
    if (const double order = over_time ? 0.0 : order_of(results.cases, curve, figure); order != 0.0)
      title += "  order " + fixed_text(order, 1);
    // On the right only of curves that have no place on the left, which are not over x.
    if (over_time && !samples && has_points(results, curve, figure, false)) title.clear();
    const std::string color = std::to_string(k + 1), points = gnuplot_text(file) + rows_of(results, curve) +
                                                              " using (" + x + "):(" + column("error." + name) + ")";
    lines.push_back(points + " with linespoints pt " + std::to_string(k + 4) + " lw 1.5 lc " + color + " title " +
                    gnuplot_text(title));
    if (samples)
      lines.push_back(points + ":(0):(" + column("standard_error." + name) + ") with vectors nohead lw 1.5 lc " +
                      color + " notitle");
  }
  return joined(lines, ", ");
}

}  // namespace

std::vector<std::string> draw_plots(const ExperimentSpec& spec, const Results& results, const std::string& folder) {
  std::vector<std::string> scripts;
  for (const PlotSpec& plot : spec.plots) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < results.cases.size(); ++k) {
      const CaseResult& c = results.cases[k];
      if (c.done.empty()) continue;
      // The first run of an ensemble stands for it.
      const fs::path file = fs::absolute(results.runs[c.done.front()].end.folder) / "history.csv";
      read_history(file.string()).column(plot.column);  // what is missing is told here
      lines.push_back(gnuplot_text(file.string()) + " using 1:" + gnuplot_text(plot.column) + " with lines lw 1.6 lc " +
                      std::to_string(k + 1) + " title " + gnuplot_text(c.plan.name));
    }
    if (lines.empty()) continue;
    const std::string label = plot.label.empty() ? plot.column : plot.label;
    scripts.push_back(write_drawing(folder, plot.name, {1000, 560}, kCsv,
                                    "set grid\nset title " + gnuplot_text(plot.title) +
                                        " noenhanced\nset xlabel 'time [s]'\nset ylabel " + gnuplot_text(label) +
                                        " noenhanced\nset key outside right top noenhanced\nplot " +
                                        joined(lines, ", ") + "\n"));
  }
  return run_gnuplot(folder, scripts);
}

std::vector<std::string> draw_errors(const ExperimentSpec& spec, const Results& results, const std::string& folder,
                                     const std::string& name, const Table& table) {
  const int rows = static_cast<int>(spec.figures.size());
  const std::string time = results.members > 1 ? "processor time [s]"
                           : results.grains()  ? "run time of mechanism and exchange [s]"
                                               : "run time [s]";
  std::string drawing = "set multiplot layout " + std::to_string(rows) + ",2 title " + gnuplot_text(spec.title) +
                        " font 'DejaVu Sans,13' noenhanced\nset logscale xy\nset format '%.0e'\nset grid\n" +
                        "set key below center samplen 2 noenhanced\n";
  for (std::size_t figure = 0; figure < spec.figures.size(); ++figure) {
    for (const bool over_time : {false, true}) {
      const std::string lines = error_lines(spec, results, name + ".csv", table, figure, over_time);
      drawing += "set ylabel " + gnuplot_text("error: " + spec.figures[figure].name) + " noenhanced\nset xlabel " +
                 gnuplot_text(over_time ? time : spec.x_name) + " noenhanced offset 0,0.6\n" +
                 (lines.empty() ? "set multiplot next\n" : "plot " + lines + "\n");
    }
  }
  return run_gnuplot(folder,
                     {write_drawing(folder, name, {1300, 490 * rows + 60}, kCsv, drawing + "unset multiplot\n")});
}

}  // namespace footfall
