#include "mbd_solver/cli/experiments/study_plot.h"

#include <cmath>
#include <filesystem>
#include <fstream>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/experiments/csv_field.h"
#include "mbd_solver/cli/experiments/study_error.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// The block of data of one curve, inline in the script.
void write_data(std::ofstream& out, const std::string& name, const std::vector<std::pair<double, double>>& points) {
  out << name << " << EOD\n";
  for (const auto& [x, y] : points) out << number_text(x) << ' ' << number_text(y) << '\n';
  out << "EOD\n";
}

}  // namespace

double cost_of(const StudyPoint& point, bool grains) { return grains ? point.mbd + point.exchange : point.mbd; }

double StudyTable::cost(const StudyPoint& point) const { return members > 1 ? point.cpu : cost_of(point, grains); }

std::vector<std::pair<double, double>> StudyTable::line(const std::string& curve, std::size_t measure,
                                                        bool over_cost) const {
  std::vector<std::pair<double, double>> result;
  for (const StudyPoint& point : points) {
    if (point.curve != curve || point.code != 0) continue;
    const double x = over_cost ? cost(point) : point.x, error = point.errors[measure];
    if (x > 0.0 && error > 0.0) result.emplace_back(x, error);
  }
  return result;
}

std::vector<std::array<double, 3>> StudyTable::bars(const std::string& curve, std::size_t measure,
                                                    bool over_cost) const {
  std::vector<std::array<double, 3>> result;
  for (const StudyPoint& point : points) {
    if (point.curve != curve || point.code != 0 || point.sampled.empty()) continue;
    const double x = over_cost ? cost(point) : point.x, error = point.errors[measure],
                 bar = point.sampled[measure].standard_error;
    if (x > 0.0 && error > 0.0 && bar > 0.0) result.push_back({x, error, bar});
  }
  return result;
}

void write_study_csv(const std::string& path, const StudyTable& table) {
  std::ofstream out = open_to_write(path);
  out << "curve,value,x,exit_code,wall_s,dem_wall_s,mbd_wall_s,exchange_wall_s,cpu_s,steps,windows";
  for (const std::string& measure : table.measures)
    out << ',' << csv_field("error." + measure) << ',' << csv_field("order." + measure);
  if (table.members > 1)
    for (const std::string& measure : table.measures)
      for (const char* what : {"mean.", "spread.", "standard_error."}) out << ',' << csv_field(what + measure);
  out << '\n';
  const auto finite = [](double value) { return std::isfinite(value) ? number_text(value) : std::string(); };
  const auto write = [&](const StudyPoint& point, const StudyPoint* before) {
    out << csv_field(point.curve) << ',' << csv_field(point.value) << ',' << number_text(point.x) << ',' << point.code;
    for (const double time : {point.wall, point.dem, point.mbd, point.exchange, point.cpu})
      out << ',' << number_text(time, 4);
    out << ',' << number_text(point.steps) << ',' << number_text(point.windows);
    for (std::size_t m = 0; m < table.measures.size(); ++m) {
      out << ',' << finite(point.errors[m]) << ',';
      if (before && before->code == 0 && point.code == 0) {
        const double order = observed_order({{before->x, before->errors[m]}, {point.x, point.errors[m]}});
        if (order != 0.0) out << fixed_text(order, 2);
      }
    }
    for (const SampledFigure& f : point.sampled)
      out << ',' << finite(f.mean) << ',' << finite(f.spread) << ',' << finite(f.standard_error);
    out << '\n';
  };
  if (table.members > 1)
    for (const StudyPoint& reference : table.references) write(reference, nullptr);
  const StudyPoint* before = nullptr;
  for (const StudyPoint& point : table.points) {
    if (before && before->curve != point.curve) before = nullptr;
    write(point, before);
    before = &point;
  }
}

std::string draw_study(const std::string& folder, const std::string& name, const StudyTable& table) {
  const std::string script = name + ".gp";
  std::ofstream out(fs::path(folder) / script);
  if (!out) throw InputError((fs::path(folder) / script).string() + ": cannot be written");
  const std::size_t rows = table.measures.size();
  out << "set terminal pngcairo size 1300," << 430 * rows + 60 << " font 'sans,10' noenhanced\nset output '" << name
      << ".png'\n"
      << "set multiplot layout " << rows << ",2 title \"" << table.title << "\" font 'sans,13'\n"
      << "set logscale xy\nset format y '%.0e'\nset format x '%.0e'\nset grid\n\n";
  for (std::size_t m = 0; m < rows; ++m) {
    for (const bool over_cost : {false, true}) {
      std::string plot;
      int k = 0;
      for (const std::string& curve : table.curves) {
        ++k;
        const auto points = table.line(curve, m, over_cost);
        if (points.empty()) continue;
        const std::string data = "$d" + std::to_string(m) + (over_cost ? "c" : "x") + std::to_string(k);
        write_data(out, data, points);
        std::string title = curve;
        if (const double order = over_cost ? 0.0 : observed_order(points); order != 0.0)
          title += "  order " + fixed_text(order, 1);
        // On the right only of curves that have no place on the left, which are not over x.
        if (over_cost && table.members == 1 && !table.line(curve, m, false).empty()) title.clear();
        plot += (plot.empty() ? "plot " : ", ") + data + " using 1:2 with linespoints pt " + std::to_string(k + 3) +
                " lw 1.5 lc " + std::to_string(k) + (title.empty() ? " notitle" : " title \"" + title + "\"");
        const auto bars = table.bars(curve, m, over_cost);
        if (bars.empty()) continue;
        out << data << "b << EOD\n";
        for (const auto& [x, y, bar] : bars)
          out << number_text(x) << ' ' << number_text(y) << ' ' << number_text(bar) << '\n';
        out << "EOD\n";
        plot += ", " + data + "b using 1:2:(0):3 with vectors nohead lw 1.5 lc " + std::to_string(k) + " notitle";
      }
      if (plot.empty()) {
        out << "set multiplot next\n";
        continue;
      }
      out << "set key inside left top samplen 2 font 'sans,9'\nset ylabel \"error: " << table.measures[m]
          << "\"\nset xlabel \""
          << (over_cost ? (table.members > 1 ? "processor time [s]"
                           : table.grains    ? "run time of mechanism and exchange [s]"
                                             : "run time [s]")
                        : table.x_name)
          << "\"\n"
          << plot << '\n';
    }
  }
  out << "unset multiplot\n";
  out.close();
  return run_gnuplot(folder, {script}).front();
}

}  // namespace footfall
