// Tables for programs, and the pictures drawn from them.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/calibrate/calibration_page.h"

namespace footfall {

namespace {

std::string drawn(const std::string& folder, const std::string& name, int height, const std::string& drawing) {
  return write_drawing(folder, name, {1000, height}, kCsv,
                       "unset logscale\nset autoscale\nunset ylabel\nset ytics noenhanced\nset grid\n" + drawing);
}

double off(const TargetResult& t) {
  double sum = 0.0;
  for (const double r : t.residuals) sum += r * r;
  return std::sqrt(sum / static_cast<double>(t.residuals.size()));
}

}  // namespace

Table way_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome) {
  std::vector<std::string> head = {"set", "stage"};
  append(head, names_in(spec.parameters));
  append(head, {"misfit", "least", "met"});
  append(head, names_in(spec.targets));
  append(head, {"message"});
  Table table(head);
  int number = 0;
  for (std::size_t k = 0; k < outcome.stages.size(); ++k) {
    double least = std::numeric_limits<double>::infinity();
    for (const Evaluation* e : outcome.stages[k].evaluations) {
      least = std::min(least, e->misfit);
      std::vector<std::string> row = {std::to_string(++number), std::to_string(k + 1)};
      for (std::size_t i = 0; i < e->shares.size(); ++i) row.push_back(spec.parameters[i].text(e->shares[i]));
      append(row, {number_text(e->misfit, 10), number_text(least, 10), std::to_string(e->met())});
      for (std::size_t t = 0; t < e->targets.size(); ++t)
        row.push_back(e->targets[t].failed         ? ""
                      : spec.targets[t].is_curve() ? number_text(off(e->targets[t]), 10)
                                                   : number_text(e->targets[t].values.front(), 10));
      row.push_back(e->message);
      table.add(row);
    }
  }
  return table;
}

Table parameter_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome) {
  Table table({"parameter", "best", "least", "most"});
  for (std::size_t i = 0; i < spec.parameters.size(); ++i) {
    const SoughtParameter& p = spec.parameters[i];
    const Interval& interval = outcome.determination.intervals[i];
    table.add({p.name, number_text(outcome.best->shares[i]), number_text(p.share(interval.least)),
               number_text(p.share(interval.most))});
  }
  return table;
}

Table target_table(const CalibrationSpec& spec, const CalibrationOutcome& outcome) {
  Table table({"target", "start", "best", "confirmed"});
  for (std::size_t t = 0; t < spec.targets.size(); ++t)
    table.add({spec.targets[t].name, number_text(off(outcome.start->targets[t])),
               number_text(off(outcome.best->targets[t])), number_text(off(outcome.confirmed->targets[t]))});
  return table;
}

std::vector<std::string> draw_calibration(const CalibrationSpec& spec, const CalibrationOutcome& outcome,
                                          const std::string& folder) {
  const std::string base = folder + "/";
  Table misfits({"set", "misfit", "least"});
  int number = 0;
  for (const StageOutcome& stage : outcome.stages) {
    double least = std::numeric_limits<double>::infinity();
    for (const Evaluation* e : stage.evaluations) {
      least = std::min(least, e->misfit);
      misfits.add({std::to_string(++number), number_text(std::max(e->misfit, 1e-12), 8),
                   number_text(std::max(least, 1e-12), 8)});
    }
  }
  write_whole_file(base + "misfit.csv", misfits.csv());
  write_whole_file(base + "parameters.csv", parameter_table(spec, outcome).csv());
  write_whole_file(base + "targets.csv", target_table(spec, outcome).csv());
  const int parameters = static_cast<int>(spec.parameters.size()), targets = static_cast<int>(spec.targets.size());
  return run_gnuplot(
      folder,
      {drawn(folder, "misfit", 500,
             "set logscale y\nset xlabel 'set'\nset ylabel 'misfit'\nset key outside right top\n"
             "plot 'misfit.csv' using 1:2 with points pt 7 ps 0.6 lc 'gray' title 'each set', "
             "'' using 1:3 with steps lw 2 lc 1 title 'least of the stage'\n"),
       drawn(folder, "parameters", 140 + 40 * parameters,
             "set xlabel 'share of the range'\nset xrange [0:1]\nset yrange [-0.7:" + fixed_text(parameters - 0.3, 1) +
                 "] reverse\nplot 'parameters.csv' using 2:0:3:4:ytic(1) with xerrorbars pt 7 lw 2 lc 1 notitle\n"),
       drawn(folder, "targets", 160 + 26 * targets,
             "set xlabel 'distance from the target [tolerances]'\nset key outside right top\nset yrange [-0.7:" +
                 fixed_text(targets - 0.3, 1) +
                 "] reverse\nplot 'targets.csv' using 2:0:ytic(1) with points pt 6 lc 'gray' title 'start', "
                 "'' using 3:0 with points pt 7 lc 1 title 'best', '' using 4:0 with points pt 2 lc 2 title "
                 "'confirmed'\n")});
}

}  // namespace footfall
