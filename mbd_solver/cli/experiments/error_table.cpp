#include "mbd_solver/cli/experiments/error_table.h"

#include <cmath>
#include <filesystem>
#include <sstream>

#include "coupler/base/quote.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/experiments/text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// The block of data of one curve, inline in the script.
void write_data(std::ostream& out, const std::string& name, const std::vector<std::array<double, 3>>& points,
                bool bars) {
  out << name << " << EOD\n";
  for (const auto& [x, y, bar] : points)
    if (!bars) {
      out << number_text(x) << ' ' << number_text(y) << '\n';
    } else if (bar > 0.0) {
      out << number_text(x) << ' ' << number_text(y) << ' ' << number_text(bar) << '\n';
    }
  out << "EOD\n";
}

double order_of(const std::vector<std::array<double, 3>>& points) {
  std::vector<std::pair<double, double>> line;
  for (const auto& [x, y, bar] : points) line.emplace_back(x, y);
  return observed_order(line);
}

}  // namespace

std::string ErrorTable::curve_of(const CaseResult& point) const {
  return point.plan.curve < 0 ? "reference" : curves[static_cast<std::size_t>(point.plan.curve)];
}

double ErrorTable::run_time(const CaseResult& point) const {
  return grains ? point.cost.mbd + point.cost.exchange : point.cost.mbd;
}

double ErrorTable::cost(const CaseResult& point) const { return members > 1 ? point.cost.cpu : run_time(point); }

std::vector<std::array<double, 3>> ErrorTable::line(std::size_t curve, std::size_t figure, bool over_cost) const {
  std::vector<std::array<double, 3>> result;
  for (const CaseResult& point : points) {
    if (point.plan.curve != static_cast<int>(curve) || point.code != 0) continue;
    const double x = over_cost ? cost(point) : point.plan.x;
    const SampledFigure& f = point.figures[figure];
    if (x > 0.0 && f.error > 0.0) result.push_back({x, f.error, f.standard_error});
  }
  return result;
}

ErrorTable error_table_of(const ExperimentSpec& spec, const Plan& plan, const Results& results) {
  ErrorTable table;
  table.title = spec.title;
  table.x_name = spec.x_name;
  table.members = plan.members;
  for (const FigureSpec& figure : spec.figures) table.figures.push_back(figure.name);
  for (const CurveSpec& curve : spec.curves) {
    table.curves.push_back(curve.name);
    table.defaults.push_back(curve.default_value);
  }
  for (const CaseResult& c : results.cases) {
    (c.plan.is_reference ? table.references : table.points).push_back(c);
    table.grains = table.grains || (!c.plan.is_reference && c.cost.dem > 0.0);
  }
  return table;
}

void write_error_csv(const std::string& path, const ErrorTable& table) {
  std::ostringstream out;
  out << "curve,value,x,exit_code,wall_s,dem_wall_s,mbd_wall_s,exchange_wall_s,cpu_s,steps,windows";
  for (const std::string& figure : table.figures)
    out << ',' << csv_field("error." + figure) << ',' << csv_field("order." + figure);
  if (table.members > 1)
    for (const std::string& figure : table.figures)
      for (const char* what : {"mean.", "spread.", "standard_error."}) out << ',' << csv_field(what + figure);
  out << '\n';
  const auto write = [&](const CaseResult& point, const CaseResult* before) {
    out << csv_field(table.curve_of(point)) << ',' << csv_field(point.plan.value) << ',' << number_text(point.plan.x)
        << ',' << point.code;
    const RunCost& cost = point.cost;
    for (const double time : {cost.wall, cost.dem, cost.mbd, cost.exchange, cost.cpu})
      out << ',' << number_text(time, 4);
    out << ',' << number_text(point.steps) << ',' << number_text(point.windows);
    for (std::size_t m = 0; m < table.figures.size(); ++m) {
      const double error = point.figures[m].error;
      out << ',' << cell(error) << ',';
      if (!before || before->code != 0 || point.code != 0) continue;
      const double order = observed_order({{before->plan.x, before->figures[m].error}, {point.plan.x, error}});
      if (order != 0.0) out << fixed_text(order, 2);
    }
    if (table.members > 1)
      for (const SampledFigure& f : point.figures)
        out << ',' << cell(f.mean) << ',' << cell(f.spread) << ',' << cell(f.standard_error);
    out << '\n';
  };
  if (table.members > 1)
    for (const CaseResult& reference : table.references) write(reference, nullptr);
  const CaseResult* before = nullptr;
  for (const CaseResult& point : table.points) {
    if (before && before->plan.curve != point.plan.curve) before = nullptr;
    write(point, before);
    before = &point;
  }
  write_whole_file(path, out.str());
}

std::string draw_errors(const std::string& folder, const std::string& name, const ErrorTable& table) {
  const std::string script = name + ".gp";
  std::ostringstream out;
  const std::size_t rows = table.figures.size();
  out << "set terminal pngcairo size 1300," << 430 * rows + 60 << " font 'sans,10' noenhanced\nset output "
      << gnuplot_text(name + ".png") << "\n"
      << "set multiplot layout " << rows << ",2 title " << gnuplot_text(table.title) << " font 'sans,13'\n"
      << "set logscale xy\nset format y '%.0e'\nset format x '%.0e'\nset grid\n\n";
  for (std::size_t m = 0; m < rows; ++m) {
    for (const bool over_cost : {false, true}) {
      std::string plot;
      for (std::size_t c = 0; c < table.curves.size(); ++c) {
        const auto points = table.line(c, m, over_cost);
        if (points.empty()) continue;
        const std::string k = std::to_string(c + 1), data = "$d" + std::to_string(m) + (over_cost ? "c" : "x") + k;
        write_data(out, data, points, false);
        std::string title = table.curves[c];
        if (const double order = over_cost ? 0.0 : order_of(points); order != 0.0)
          title += "  order " + fixed_text(order, 1);
        // On the right only of curves that have no place on the left, which are not over x.
        if (over_cost && table.members == 1 && !table.line(c, m, false).empty()) title.clear();
        plot += (plot.empty() ? "plot " : ", ") + data + " using 1:2 with linespoints pt " + std::to_string(c + 4) +
                " lw 1.5 lc " + k + (title.empty() ? " notitle" : " title " + gnuplot_text(title));
        if (table.members == 1) continue;
        write_data(out, data + "b", points, true);
        plot += ", " + data + "b using 1:2:(0):3 with vectors nohead lw 1.5 lc " + k + " notitle";
      }
      if (plot.empty()) {
        out << "set multiplot next\n";
        continue;
      }
      const std::string cost = table.members > 1 ? "processor time [s]"
                               : table.grains    ? "run time of mechanism and exchange [s]"
                                                 : "run time [s]";
      out << "set key inside left top samplen 2 font 'sans,9'\nset ylabel "
          << gnuplot_text("error: " + table.figures[m]) << "\nset xlabel "
          << gnuplot_text(over_cost ? cost : table.x_name) << "\n"
          << plot << '\n';
    }
  }
  out << "unset multiplot\n";
  write_whole_file((fs::path(folder) / script).string(), out.str());
  return run_gnuplot(folder, {script}).front();
}

}  // namespace footfall
