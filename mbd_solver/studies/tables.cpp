// Rows are built from the spec and the results; the right half of error pictures is over run time.
#include "mbd_solver/studies/tables.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "coupler/base/number.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/difference/samples.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/session/output/history.h"

namespace footfall {
namespace {

std::string csv_field(const std::string& text) {
  if (text.find_first_of(",\"#\n\r") == std::string::npos) return text;
  std::string field = "\"";
  for (const char c : text) field += c == '"' ? std::string(2, '"') : std::string(1, c);
  return field + '"';
}

// Marks of Markdown, which the page in HTML would show.
std::string unmarked(std::string text) {
  text.erase(std::remove(text.begin(), text.end(), '`'), text.end());
  return text;
}

}  // namespace

int Table::column(const std::string& name) const {
  const auto found = std::find(rows_.front().begin(), rows_.front().end(), name);
  return found == rows_.front().end() ? 0 : static_cast<int>(found - rows_.front().begin()) + 1;
}

std::string Table::csv() const {
  std::string text;
  for (std::vector<std::string> row : rows_) {
    for (std::string& field : row) field = csv_field(field);
    text += joined(row, ",") + "\n";
  }
  return text;
}

std::string Table::page() const {
  std::string text;
  for (const std::vector<std::string>& row : rows_) {
    text += "| " + joined(row, " | ") + " |\n";
    if (&row == &rows_.front()) text += "|" + joined(std::vector<std::string>(row.size(), "---"), "|") + "|\n";
  }
  return text;
}

void StudyPage::section(const std::string& heading) {
  markdown_ += "\n## " + heading + "\n";
  html_.section(heading);
}

void StudyPage::paragraph(const std::string& text) {
  markdown_ += "\n" + text + "\n";
  html_.paragraph(unmarked(text));
}

void StudyPage::table(const Table& table) {
  markdown_ += "\n" + table.page();
  std::vector<std::vector<std::string>> rows = table.rows();
  for (std::vector<std::string>& row : rows)
    for (std::string& one : row) one = unmarked(one);
  html_.table(rows);
}

void StudyPage::picture(const std::string& file) {
  const std::filesystem::path path(file);
  markdown_ += "\n![" + path.stem().string() + "](" + path.filename().string() + ")\n";
  html_.picture(file);
}

void append(std::vector<std::string>& row, const std::vector<std::string>& more) {
  row.insert(row.end(), more.begin(), more.end());
}

std::string cell(double value, int digits) { return std::isfinite(value) ? number_text(value, digits) : ""; }

std::string rounded(double value) { return cell(std::abs(value) < 1e-9 ? 0.0 : value, 3); }

std::string percent(double share) { return number_text(100.0 * share, 2); }

std::optional<double> number_in(const std::string& text) {
  char* end = nullptr;
  const double value = read_number(text.c_str(), &end);
  return !text.empty() && *end == '\0' && std::isfinite(value) ? std::optional<double>(value) : std::nullopt;
}

namespace {

std::string word_of(const CheckResult& check_result) {
  return std::isnan(check_result.judged) ? "not run" : check_result.reproduced ? "yes" : "no";
}

const std::string& about(const CheckSpec& s) { return s.curve.empty() ? s.of_case : s.curve; }

// Is a case within the limits of the sweep file? No claim is made about runs that did not finish.
std::string limits_text(const CaseResult& c) {
  if (c.done.empty()) return c.code == 0 ? "not run" : "failed";
  if (!c.within_limits) return "no";
  return c.done.size() < c.plan.runs.size() ? "incomplete" : "yes";
}

}  // namespace

Table run_table(const SweepSpec& spec, const Plan& plan, const Results& results) {
  const bool named = !spec.curves.empty();
  std::vector<std::string> head = {"run"};
  if (named) head.push_back("name");
  append(head, names_in(spec.parameters));
  head.push_back("status");
  append(head, names_in(spec.metrics));
  Table table(head);
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    std::vector<std::string> row = {std::to_string(i)};
    if (named) row.push_back(plan.runs[i].name);
    append(row, plan.runs[i].values);
    row.push_back(results.runs[i].end.status);
    for (const double value : results.runs[i].metrics) row.push_back(cell(value));
    table.add(row);
  }
  return table;
}

Table sample_table(const Results& results, const std::string& folder) {
  Table table({"case", "run"});
  for (const CaseResult& c : results.cases)
    for (const std::size_t run : c.done)
      table.add({c.plan.name, std::filesystem::relative(results.runs[run].end.folder, folder).string()});
  return table;
}

Table case_table(const SweepSpec& spec, const std::vector<CaseResult>& cases) {
  std::vector<std::string> head = {"case", "runs", "within_limits"};
  for (const MetricSpec& metric : spec.metrics) append(head, {metric.name, "spread of " + metric.name});
  Table table(head);
  for (const CaseResult& c : cases) {
    std::vector<std::string> row = {c.plan.name, std::to_string(c.done.size()), limits_text(c)};
    for (const SampledMetric& f : c.metrics) append(row, {cell(f.mean), cell(f.spread)});
    table.add(row);
  }
  return table;
}

std::string case_page(const SweepSpec& spec, const std::vector<CaseResult>& cases) {
  const bool limits = !spec.limits.empty();
  std::vector<std::string> head = {spec.title};
  append(head, names_in(spec.metrics));
  if (limits) head.push_back("within the limits");
  Table table(head);
  for (const CaseResult& c : cases) {
    std::vector<std::string> row = {c.plan.name};
    for (const SampledMetric& f : c.metrics)
      row.push_back(rounded(f.mean) + (c.done.size() > 1 ? " +- " + rounded(f.spread) : ""));
    if (limits) row.push_back(limits_text(c));
    table.add(row);
  }
  return "Made by `./footfall sweep " + spec.file + "`.\n\n" + table.page();
}

Table check_table(const SweepSpec& spec, const std::vector<CheckResult>& results_of_checks) {
  Table table({"statement", "figure", "case", "value", "against", "reference", "judged", "least", "most", "came_out"});
  for (std::size_t i = 0; i < results_of_checks.size(); ++i) {
    const CheckSpec& s = spec.checks[i];
    const CheckResult& o = results_of_checks[i];
    table.add({s.text, s.metric, about(s), cell(o.value), s.against, cell(o.reference), cell(o.judged), cell(s.least),
               cell(s.most), word_of(o)});
  }
  return table;
}

std::string check_page(const SweepSpec& spec, const std::vector<CheckResult>& results_of_checks) {
  Table table({"check", "numbers", "expected", "reproduced"});
  for (std::size_t i = 0; i < results_of_checks.size(); ++i) {
    const CheckSpec& s = spec.checks[i];
    const CheckResult& o = results_of_checks[i];
    std::string numbers = s.metric + ": " + about(s) + " " + rounded(o.value);
    if (!s.against.empty())
      numbers += ", " + s.against + " " + rounded(o.reference) + (s.difference ? ", difference " : ", ratio ") +
                 rounded(o.judged);
    std::vector<std::string> bounds;
    if (std::isfinite(s.least)) bounds.push_back("at least " + rounded(s.least));
    if (std::isfinite(s.most)) bounds.push_back("at most " + rounded(s.most));
    const std::string why = word_of(o) == "no" && !s.why.empty() ? ": " + s.why : "";
    table.add({s.text, numbers, joined(bounds, " "), word_of(o) + why});
  }
  return table.page();
}

namespace {

std::string curve_of(const SweepSpec& spec, const CaseResult& point) {
  return point.plan.curve < 0 ? "reference" : spec.curves[point.plan.curve].name;
}

// The beginning of a message, for a cell.
std::string one_line(const std::string& message) {
  constexpr std::size_t kMost = 90;
  const std::string line = message.substr(0, message.find('\n'));
  return line.size() <= kMost ? line : line.substr(0, kMost) + "...";
}

// "12 ± 3 %"
std::string error_text(const SampledMetric& f) {
  return percent(f.error) + (f.standard_error > 0.0 ? " ± " + percent(f.standard_error) : "") + " %";
}

std::string error_cell(const Results& results, const CaseResult& point, const SampledMetric& f) {
  if (!std::isfinite(f.error)) return "";
  if (results.members == 1) return percent(f.error);
  if (!std::isfinite(f.mean)) return percent(f.error) + " %";  // of whole curves
  const std::string metric = number_text(f.mean, 4) + " ± " + number_text(f.spread, 2);
  return point.plan.is_reference ? metric : metric + "; " + error_text(f);
}

std::vector<std::string> page_row(const SweepSpec& spec, const Results& results, const CaseResult& point) {
  std::vector<std::string> row = {curve_of(spec, point), point.plan.value};
  if (point.code != 0) {
    row.push_back("exit code " + std::to_string(point.code) + ": " + one_line(point.message));
    return row;
  }
  const bool grains = results.grains();
  row.push_back(number_text(grains ? point.windows : point.steps));
  for (const SampledMetric& f : point.metrics) row.push_back(error_cell(results, point, f));
  if (grains) row.push_back(number_text(point.own_time(), 3));
  row.push_back(number_text(results.members > 1 ? point.cost.cpu : point.cost.wall, 3));
  return row;
}

// Value, its largest error and its run time.
std::vector<std::string> recommendation_cells(const SweepSpec& spec, const Recommendation& a) {
  if (!a.point) return {"none is done", "", ""};
  std::string value = (a.within ? "" : "none; best: ") + a.point->plan.value;
  if (a.excepted != kNoMetric)
    value += ", without " + spec.metrics[a.excepted].name + " (" + percent(a.point->metrics[a.excepted].error) + " %)";
  if (!a.resolved) value += " (not resolved)";
  return {value, error_text(a.largest()) + ", " + spec.metrics[a.worst].name,
          a.time_ratio > 0.0 ? fixed_text(a.time_ratio, 2) : ""};
}

std::string errors_with_defaults(const SweepSpec& spec, const Results& results) {
  const std::vector<Recommendation> defaults = errors_of_defaults(spec, results);
  if (defaults.empty()) return "";
  std::vector<std::string> errors;
  for (const Recommendation& a : defaults)
    errors.push_back((errors.empty() ? "" : "\"" + curve_of(spec, *a.point) + "\": ") + error_text(a.largest()) +
                     " of " + spec.metrics[a.worst].name + " at " + a.point->plan.value);
  return "\nWith the scene's own values the largest error occurs for \"" + curve_of(spec, *defaults.front().point) +
         "\": " + joined(errors, "; ") + ".\n";
}

std::string scatter_of_reference(const SweepSpec& spec, const Results& results) {
  const CaseResult& reference = *points_of(results).front();
  if (results.members == 1 || !reference.plan.is_reference) return "";
  std::vector<std::string> scatters;
  for (std::size_t m = 0; m < spec.metrics.size(); ++m) {
    const SampledMetric& f = reference.metrics[m];
    if (std::isfinite(f.mean) && f.mean != 0.0)
      scatters.push_back(percent(f.spread / std::abs(f.mean)) + " % (" + spec.metrics[m].name + ")");
  }
  const double share = 1.0 / std::sqrt(static_cast<double>(results.members));
  return "\nThe metrics of the reference vary from sample to sample by " + joined(scatters) + ";\nmeans of " +
         std::to_string(results.members) + " by " + fixed_text(share, 2) +
         " times that. Errors are known more precisely because run and reference start from the same samples.\n";
}

}  // namespace

std::vector<const CaseResult*> points_of(const Results& results) {
  std::vector<const CaseResult*> references, points;
  for (const CaseResult& c : results.cases) (c.plan.is_reference ? references : points).push_back(&c);
  if (results.members > 1) points.insert(points.begin(), references.begin(), references.end());
  return points;
}

Table error_table(const SweepSpec& spec, const Results& results) {
  const bool samples = results.members > 1;
  std::vector<std::string> head = {"curve", "value", "x", "exit_code"};
  for (const auto& [name, time] : kTimes) head.push_back(name);
  append(head, {"steps", "windows"});
  for (const MetricSpec& metric : spec.metrics) append(head, {"error." + metric.name, "order." + metric.name});
  if (samples)
    for (const MetricSpec& metric : spec.metrics)
      append(head, {"mean." + metric.name, "spread." + metric.name, "standard_error." + metric.name});
  Table table(head);
  const CaseResult* before = nullptr;  // of the same curve
  for (const CaseResult* point : points_of(results)) {
    if (before && (before->plan.curve != point->plan.curve || before->plan.is_reference)) before = nullptr;
    std::vector<std::string> row = {curve_of(spec, *point), point->plan.value, number_text(point->plan.x),
                                    std::to_string(point->code)};
    for (const auto& [name, time] : kTimes) row.push_back(number_text(point->cost.*time, 4));
    append(row, {number_text(point->steps), number_text(point->windows)});
    for (std::size_t m = 0; m < spec.metrics.size(); ++m) {
      const double error = point->metrics[m].error;
      double order = 0.0;
      if (before && before->code == 0 && point->code == 0)
        order = observed_order({{before->plan.x, before->metrics[m].error}, {point->plan.x, error}});
      append(row, {cell(error), order != 0.0 ? fixed_text(order, 2) : ""});
    }
    if (samples)
      for (const SampledMetric& f : point->metrics) append(row, {cell(f.mean), cell(f.spread), cell(f.standard_error)});
    table.add(row);
    before = point;
  }
  return table;
}

std::string recommendation_section(const SweepSpec& spec, const Results& results) {
  std::ostringstream out;
  out << "\n## Recommended settings\n\nThe cheapest value of each curve from which on all errors are within 1 % and "
         "within 5 %, with its largest error and its processor time over\n"
         "the processor time of the scene's own value, or of the reference if the curve has no such value.";
  if (results.members > 1)
    out << " ± is the standard error of " << results.members
        << " samples;\nwhere it exceeds the limit, the value is not resolved.";
  out << " Where a value keeps all metrics but one within the limit,\nit is listed with the error of that metric.\n\n";
  Table table({"curve", "within 1 %", "largest error", "time", "within 5 %", "largest error", "time"});
  const std::vector<Recommendation> fine = recommendations_of(spec, results, 0.01),
                                    coarse = recommendations_of(spec, results, 0.05);
  for (std::size_t c = 0; c < fine.size(); ++c) {
    std::vector<std::string> row = {spec.curves[c].name};
    append(row, recommendation_cells(spec, fine[c]));
    append(row, recommendation_cells(spec, coarse[c]));
    table.add(row);
  }
  out << table.page() << errors_with_defaults(spec, results) << scatter_of_reference(spec, results);
  return out.str();
}

std::string error_page(const SweepSpec& spec, const Results& results, const std::string& command) {
  const bool samples = results.members > 1, grains = results.grains();
  std::vector<std::string> head = {"curve", "value", grains ? "windows" : "steps"};
  append(head, names_in(spec.metrics));
  if (grains) head.push_back("mechanism + exchange");
  head.push_back(samples ? "processor time" : grains ? "whole" : "run time");
  Table table(head);
  for (const CaseResult* point : points_of(results)) table.add(page_row(spec, results, *point));
  std::ostringstream out;
  out << "# " << spec.title << "\n\n";
  if (!samples) {
    out << "Errors in percent of the reference; run times in s.\n\n" << table.page();
    return out.str();
  }
  out << "Mean and standard deviation over " << results.members
      << " samples; then the error of the mean against the reference of the curve, and its standard error.\n"
         "Run times in s; processor time of all programs, without making the bed.\n\nMade by `"
      << command << "`.\n\n"
      << table.page() << recommendation_section(spec, results);
  return out.str();
}

namespace fs = std::filesystem;

namespace {

// Some point of the curve has this error, and a position over x; over run time all have one.
bool has_points(const Results& results, int curve, std::size_t metric, bool over_time) {
  return std::any_of(results.cases.begin(), results.cases.end(), [&](const CaseResult& c) {
    return c.is_of(curve) && c.code == 0 && (over_time || c.plan.x > 0.0) && c.metrics[metric].error > 0.0;
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

// Columns by their numbers, as gnuplot does not read names with a comma.
std::string error_lines(const SweepSpec& spec, const Results& results, const std::string& file, const Table& table,
                        std::size_t metric, bool over_time) {
  const bool samples = results.members > 1;
  const auto column = [&](const std::string& name) { return "column(" + std::to_string(table.column(name)) + ")"; };
  const std::string x = !over_time ? column("x")
                        : samples  ? column("cpu_s")
                                   : column("mbd_wall_s") + "+" + column("exchange_wall_s");
  const std::string name = spec.metrics[metric].name;
  std::vector<std::string> lines;
  for (std::size_t k = 0; k < spec.curves.size(); ++k) {
    const int curve = static_cast<int>(k);
    if (!has_points(results, curve, metric, over_time)) continue;
    std::string title = spec.curves[k].name;
    if (const double order = over_time ? 0.0 : order_of(results.cases, curve, metric); order != 0.0)
      title += "  order " + fixed_text(order, 1);
    // The title once: on the right only for curves that are not over x.
    if (over_time && !samples && has_points(results, curve, metric, false)) title.clear();
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

// The curve of a case, and behind it the band of an ensemble, which reads FILE of `folder`.
std::vector<std::string> plot_lines(const SampledCase& sampled, const std::string& column, const std::string& colour,
                                    const std::string& folder, const std::string& file) {
  const std::string title = " title " + gnuplot_text(sampled.name), line = " with lines lw 1.6 lc " + colour;
  if (sampled.runs.size() < 2) {
    const fs::path history = fs::absolute(sampled.runs.front()) / "history.csv";
    read_history(history.string()).column(column);  // throws for a missing column
    return {gnuplot_text(history.string()) + " using 1:" + gnuplot_text(column) + line + title};
  }
  write_history((fs::path(folder) / file).string(), bands_on_one_clock({sampled}, {column}));
  const auto edge = [&](const char* which) { return ":" + gnuplot_text(column + " (1" + which + ")"); };
  return {gnuplot_text(file) + " using 1" + edge(" low") + edge(" high") + " with filledcurves lc " + colour +
              " fs transparent solid 0.2 noborder notitle",
          gnuplot_text(file) + " using 1" + edge("") + line + title};
}

}  // namespace

std::vector<std::string> draw_plots(const SweepSpec& spec, const Results& results, const std::string& folder) {
  std::vector<std::string> scripts;
  for (const PlotSpec& plot : spec.plots) {
    std::vector<std::string> lines;
    for (std::size_t k = 0; k < results.cases.size(); ++k) {
      const CaseResult& c = results.cases[k];
      if (c.done.empty()) continue;
      SampledCase sampled{c.plan.name, {}};
      for (const std::size_t run : c.done) sampled.runs.push_back(results.runs[run].end.folder);
      const std::string number = std::to_string(k + 1);
      append(lines, plot_lines(sampled, plot.column, number, folder, plot.name + "_" + number + ".csv"));
    }
    if (lines.empty()) continue;
    const std::string label = plot.label.empty() ? plot.column : plot.label;
    scripts.push_back(write_drawing(folder, plot.name, {1000, 560}, csv_setup(),
                                    "set grid\nset title " + gnuplot_text(plot.title) +
                                        " noenhanced\nset xlabel 'time [s]'\nset ylabel " + gnuplot_text(label) +
                                        " noenhanced\nset key outside right top noenhanced\nplot " +
                                        joined(lines, ", ") + "\n"));
  }
  return run_gnuplot(folder, scripts);
}

std::vector<std::string> draw_errors(const SweepSpec& spec, const Results& results, const std::string& folder,
                                     const std::string& name, const Table& table) {
  const int rows = static_cast<int>(spec.metrics.size());
  const std::string time = results.members > 1 ? "processor time [s]"
                           : results.grains()  ? "run time of mechanism and exchange [s]"
                                               : "run time [s]";
  std::string drawing = "set multiplot layout " + std::to_string(rows) + ",2 title " + gnuplot_text(spec.title) +
                        " font 'DejaVu Sans,13' noenhanced\nset logscale xy\nset format '%.0e'\nset grid\n" +
                        "set key below center samplen 2 noenhanced\n";
  for (std::size_t metric = 0; metric < spec.metrics.size(); ++metric) {
    for (const bool over_time : {false, true}) {
      const std::string lines = error_lines(spec, results, name + ".csv", table, metric, over_time);
      drawing += "set ylabel " + gnuplot_text("error: " + spec.metrics[metric].name) + " noenhanced\nset xlabel " +
                 gnuplot_text(over_time ? time : spec.x_name) + " noenhanced offset 0,0.6\n" +
                 (lines.empty() ? "set multiplot next\n" : "plot " + lines + "\n");
    }
  }
  return run_gnuplot(
      folder, {write_drawing(folder, name, {1300, 490 * rows + 60}, csv_setup(), drawing + "unset multiplot\n")});
}

}  // namespace footfall
