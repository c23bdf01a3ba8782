#include "mbd_solver/cli/experiments/sweep_table.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>

#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/analysis/gnuplot.h"
#include "mbd_solver/cli/experiments/csv_field.h"
#include "mbd_solver/output/history.h"
#include "mbd_solver/output/summary.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

std::string number(double value) { return std::isfinite(value) ? number_text(value) : ""; }

// As in a table that people read.
std::string rounded(double value) {
  return std::isfinite(value) ? number_text(std::abs(value) < 1e-9 ? 0.0 : value, 3) : "";
}

int figure_index(const SweepSpec& sweep, const std::string& name) {
  int k = 0;
  while (sweep.figures[static_cast<std::size_t>(k)].name != name) ++k;
  return k;
}

}  // namespace

SweepResult result_of(const SweepSpec& sweep, const std::string& folder) {
  SweepResult result;
  result.figures.assign(sweep.figures.size(), std::numeric_limits<double>::quiet_NaN());
  const fs::path summary_file = fs::path(folder) / "summary.json";
  if (!fs::exists(summary_file)) {
    result.status = "missing";
    return result;
  }
  const nlohmann::ordered_json summary = read_summary(summary_file.string());
  result.status = summary.value("status", "");
  result.done = result.status == "done";
  if (!result.done) return result;
  result.figures = figures_of_run(sweep.figures, folder, sweep.file);
  return result;
}

std::vector<SweepCase> cases_of(const SweepSpec& sweep, const std::vector<SweepRun>& runs,
                                const std::vector<SweepResult>& results) {
  std::vector<SweepCase> cases;
  for (std::size_t i = 0; i < runs.size(); ++i) {
    auto found = std::find_if(cases.begin(), cases.end(), [&](const SweepCase& c) { return c.name == runs[i].group; });
    if (found == cases.end()) found = cases.insert(cases.end(), SweepCase{runs[i].group, {}, {}, {}, true});
    if (results[i].done) found->runs.push_back(static_cast<int>(i));
  }
  for (SweepCase& c : cases) {
    const double n = static_cast<double>(c.runs.size());
    for (std::size_t k = 0; k < sweep.figures.size(); ++k) {
      double sum = 0.0, squares = 0.0;
      for (const int run : c.runs) sum += results[static_cast<std::size_t>(run)].figures[k];
      const double mean = n > 0.0 ? sum / n : std::numeric_limits<double>::quiet_NaN();
      for (const int run : c.runs) squares += std::pow(results[static_cast<std::size_t>(run)].figures[k] - mean, 2);
      c.mean.push_back(mean);
      c.spread.push_back(n > 1.0 ? std::sqrt(squares / (n - 1.0)) : 0.0);
    }
    for (const SweepLimit& limit : sweep.limits)
      c.within_limits =
          c.within_limits && c.mean[static_cast<std::size_t>(figure_index(sweep, limit.figure))] <= limit.most;
  }
  return cases;
}

void write_run_table(const std::string& path, const SweepSpec& sweep, const std::vector<SweepRun>& runs,
                     const std::vector<SweepResult>& results) {
  std::ofstream out = open_to_write(path);
  out << "run";
  for (const SweepParameter& parameter : sweep.parameters) out << ',' << csv_field(parameter.name);
  out << ",status";
  for (const SweepFigure& figure : sweep.figures) out << ',' << csv_field(figure.name);
  out << '\n';
  for (std::size_t i = 0; i < runs.size(); ++i) {
    out << i;
    for (const std::string& value : runs[i].values) out << ',' << csv_field(value);
    out << ',' << results[i].status;
    for (const double value : results[i].figures) out << ',' << number(value);
    out << '\n';
  }
}

void write_case_table(const std::string& path, const SweepSpec& sweep, const std::vector<SweepCase>& cases) {
  std::ofstream out = open_to_write(path);
  out << "case,runs,within_limits";
  for (const SweepFigure& figure : sweep.figures)
    out << ',' << csv_field(figure.name) << ',' << csv_field("spread of " + figure.name);
  out << '\n';
  for (const SweepCase& c : cases) {
    out << csv_field(c.name) << ',' << c.runs.size() << ',' << (c.within_limits ? "yes" : "no");
    for (std::size_t k = 0; k < c.mean.size(); ++k) out << ',' << number(c.mean[k]) << ',' << number(c.spread[k]);
    out << '\n';
  }
}

void write_case_page(const std::string& path, const SweepSpec& sweep, const std::vector<SweepCase>& cases) {
  std::ofstream out = open_to_write(path);
  out << "Made by `./footfall sweep " << sweep.file << "`.\n\n| " << sweep.title << " |";
  for (const SweepFigure& figure : sweep.figures) out << ' ' << figure.name << " |";
  out << (sweep.limits.empty() ? "\n|---|" : " within the limits |\n|---|");
  for (std::size_t k = 0; k < sweep.figures.size(); ++k) out << "---|";
  out << (sweep.limits.empty() ? "\n" : "---|\n");
  for (const SweepPrinted& printed : sweep.printed) {
    out << "| " << printed.name << " |";
    for (const double value : printed.values) out << ' ' << rounded(value) << " |";
    out << (sweep.limits.empty() ? "\n" : " |\n");
  }
  for (const SweepCase& c : cases) {
    out << "| " << c.name << " |";
    for (std::size_t k = 0; k < c.mean.size(); ++k) {
      out << ' ' << rounded(c.mean[k]);
      if (c.runs.size() > 1) out << " +- " << rounded(c.spread[k]);
      out << " |";
    }
    out << (sweep.limits.empty() ? "\n" : c.within_limits ? " yes |\n" : " no |\n");
  }
}

std::vector<StatementVerdict> verdicts_of(const SweepSpec& sweep, const std::vector<SweepCase>& cases) {
  std::vector<StatementVerdict> verdicts;
  for (const SweepStatement& s : sweep.statements) {
    const auto k = static_cast<std::size_t>(figure_index(sweep, s.figure));
    const auto figure = [&](const std::string& name) {
      return std::find_if(cases.begin(), cases.end(), [&](const SweepCase& c) { return c.name == name; })->mean[k];
    };
    StatementVerdict v;
    v.value = figure(s.of_case);
    if (!s.against.empty()) v.reference = figure(s.against);
    v.judged = s.against.empty() ? v.value : v.value / v.reference;
    v.came_out = v.judged >= s.least && v.judged <= s.most;
    verdicts.push_back(v);
  }
  return verdicts;
}

void write_statements(const std::string& folder, const SweepSpec& sweep,
                      const std::vector<StatementVerdict>& verdicts) {
  std::ofstream csv = open_to_write((fs::path(folder) / "statements.csv").string()),
                page = open_to_write((fs::path(folder) / "statements.md").string());
  csv << "statement,figure,case,value,against,reference,judged,least,most,came_out\n";
  page << "| statement | numbers | expected | came out |\n|---|---|---|---|\n";
  for (std::size_t i = 0; i < verdicts.size(); ++i) {
    const SweepStatement& s = sweep.statements[i];
    const StatementVerdict& v = verdicts[i];
    csv << csv_field(s.text) << ',' << csv_field(s.figure) << ',' << csv_field(s.of_case) << ',' << number(v.value)
        << ',' << csv_field(s.against) << ',' << number(v.reference) << ',' << number(v.judged) << ','
        << number(s.least) << ',' << number(s.most) << ','
        << (std::isnan(v.judged) ? "not run"
            : v.came_out         ? "yes"
                                 : "no")
        << '\n';
    page << "| " << s.text << " | " << s.figure << ": " << s.of_case << " " << rounded(v.value);
    if (!s.against.empty()) page << ", " << s.against << " " << rounded(v.reference) << ", ratio " << rounded(v.judged);
    page << " |";
    if (std::isfinite(s.least)) page << " at least " << rounded(s.least);
    if (std::isfinite(s.most)) page << " at most " << rounded(s.most);
    page << " | "
         << (!std::isfinite(v.judged) ? "not run"
             : v.came_out             ? "yes"
             : s.why.empty()          ? "no"
                                      : "no: " + s.why)
         << " |\n";
  }
}

std::vector<int> ranking(const SweepSpec& sweep, const std::vector<SweepCase>& cases) {
  std::vector<int> order;
  if (sweep.minimise.empty()) return order;
  const auto k = static_cast<std::size_t>(figure_index(sweep, sweep.minimise));
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].within_limits && !cases[i].runs.empty()) order.push_back(static_cast<int>(i));
  std::sort(order.begin(), order.end(), [&](int a, int b) {
    return cases[static_cast<std::size_t>(a)].mean[k] < cases[static_cast<std::size_t>(b)].mean[k];
  });
  return order;
}

std::vector<std::string> draw_sweep(const SweepSpec& sweep, const std::vector<SweepCase>& cases,
                                    const std::vector<std::string>& folders, const std::string& folder) {
  std::vector<std::string> scripts;
  for (const SweepPlot& plot : sweep.plots) {
    std::ofstream script = open_to_write((fs::path(folder) / (plot.name + ".gp")).string());
    std::string curves;
    int color = 0;
    for (const SweepCase& c : cases) {
      ++color;
      if (c.runs.empty()) continue;
      // The first run of an ensemble stands for it.
      const History history =
          read_history((fs::path(folders[static_cast<std::size_t>(c.runs.front())]) / "history.csv").string());
      const std::vector<double>&time = history.column("time"), &values = history.column(plot.column);
      const std::string data = "$d" + std::to_string(color);
      script << data << " << EOD\n";
      for (std::size_t i = 0; i < time.size(); ++i) script << number(time[i]) << ' ' << number(values[i]) << '\n';
      script << "EOD\n";
      curves += (curves.empty() ? "plot " : ", ") + data + " using 1:2 with lines lw 1.6 lc " + std::to_string(color) +
                " title \"" + c.name + "\"";
    }
    if (curves.empty()) continue;
    script << "set grid\nset title \"" << plot.title << "\" noenhanced\nset xlabel \"time [s]\"\nset ylabel \""
           << (plot.label.empty() ? plot.column : plot.label) << "\" noenhanced\nset key outside right top noenhanced\n"
           << "set terminal pngcairo size 1000,560 font 'sans,11'\nset output '" << plot.name << ".png'\n"
           << curves << "\nset terminal svg size 1000,560 font 'sans,11'\nset output '" << plot.name
           << ".svg'\nreplot\n";
    scripts.push_back(plot.name + ".gp");
  }
  return scripts.empty() ? scripts : run_gnuplot(folder, scripts);
}

}  // namespace footfall
