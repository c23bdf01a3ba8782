#include "mbd_solver/cli/experiments/error_page.h"

#include <cmath>
#include <sstream>

#include "coupler/base/text.h"
#include "mbd_solver/cli/experiments/advice.h"

namespace footfall {
namespace {

std::string curve_of(const ExperimentSpec& spec, const CaseResult& point) {
  return point.plan.curve < 0 ? "reference" : spec.curves[static_cast<std::size_t>(point.plan.curve)].name;
}

// Enough of a message for a cell.
std::string one_line(const std::string& message) {
  constexpr std::size_t kMost = 90;
  const std::string line = message.substr(0, message.find('\n'));
  return line.size() <= kMost ? line : line.substr(0, kMost) + "...";
}

// "12 ± 3 %"
std::string error_text(const SampledFigure& f) {
  return percent(f.error) + (f.standard_error > 0.0 ? " ± " + percent(f.standard_error) : "") + " %";
}

std::string error_cell(const Results& results, const CaseResult& point, const SampledFigure& f) {
  if (!std::isfinite(f.error)) return "";
  if (results.members == 1) return percent(f.error);
  if (!std::isfinite(f.mean)) return percent(f.error) + " %";  // of whole curves: no figure
  const std::string figure = number_text(f.mean, 4) + " ± " + number_text(f.spread, 2);
  return point.plan.is_reference ? figure : figure + "; " + error_text(f);
}

std::vector<std::string> page_row(const ExperimentSpec& spec, const Results& results, const CaseResult& point) {
  std::vector<std::string> row = {curve_of(spec, point), point.plan.value};
  if (point.code != 0) {
    row.push_back("ended with code " + std::to_string(point.code) + ": " + one_line(point.message));
    return row;
  }
  const bool grains = results.grains();
  row.push_back(number_text(grains ? point.windows : point.steps));
  for (const SampledFigure& f : point.figures) row.push_back(error_cell(results, point, f));
  if (grains) row.push_back(number_text(point.own_time(), 3));
  row.push_back(number_text(results.members > 1 ? point.cost.cpu : point.cost.wall, 3));
  return row;
}

// Value, its largest error and its run time.
std::vector<std::string> advice_cells(const ExperimentSpec& spec, const Advice& a) {
  if (!a.point) return {"none was done", "", ""};
  std::string value = (a.within ? "" : "none; best is ") + a.point->plan.value;
  if (a.apart != kNoFigure)
    value += ", but for " + spec.figures[a.apart].name + " (" + percent(a.point->figures[a.apart].error) + " %)";
  if (!a.resolved) value += " (not resolved)";
  return {value, error_text(a.largest()) + ", " + spec.figures[a.worst].name,
          a.time_ratio > 0.0 ? fixed_text(a.time_ratio, 2) : ""};
}

std::string errors_with_defaults(const ExperimentSpec& spec, const Results& results) {
  const std::vector<Advice> defaults = errors_of_defaults(spec, results);
  if (defaults.empty()) return "";
  std::vector<std::string> errors;
  for (const Advice& a : defaults)
    errors.push_back((errors.empty() ? "" : "\"" + curve_of(spec, *a.point) + "\": ") + error_text(a.largest()) +
                     " of " + spec.figures[a.worst].name + " at " + a.point->plan.value);
  return "\nWith the scene's own values the largest error is that of \"" + curve_of(spec, *defaults.front().point) +
         "\": " + joined(errors, "; ") + ".\n";
}

std::string scatter_of_reference(const ExperimentSpec& spec, const Results& results) {
  const CaseResult& reference = *points_of(results).front();
  if (results.members == 1 || !reference.plan.is_reference) return "";
  std::vector<std::string> scatters;
  for (std::size_t m = 0; m < spec.figures.size(); ++m) {
    const SampledFigure& f = reference.figures[m];
    if (std::isfinite(f.mean) && f.mean != 0.0)
      scatters.push_back(percent(f.spread / std::abs(f.mean)) + " % (" + spec.figures[m].name + ")");
  }
  const double share = 1.0 / std::sqrt(static_cast<double>(results.members));
  return "\nFrom sample to sample the figures of the reference scatter by " + joined(scatters) + ";\nof a mean of " +
         std::to_string(results.members) + " by " + fixed_text(share, 2) +
         " times that. Errors are told closer because run and reference start from the same samples.\n";
}

}  // namespace

std::vector<const CaseResult*> points_of(const Results& results) {
  std::vector<const CaseResult*> references, points;
  for (const CaseResult& c : results.cases) (c.plan.is_reference ? references : points).push_back(&c);
  if (results.members > 1) points.insert(points.begin(), references.begin(), references.end());
  return points;
}

Table error_table(const ExperimentSpec& spec, const Results& results) {
  const bool samples = results.members > 1;
  std::vector<std::string> head = {"curve", "value", "x", "exit_code"};
  for (const auto& [name, time] : kTimes) head.push_back(name);
  append(head, {"steps", "windows"});
  for (const FigureSpec& figure : spec.figures) append(head, {"error." + figure.name, "order." + figure.name});
  if (samples)
    for (const FigureSpec& figure : spec.figures)
      append(head, {"mean." + figure.name, "spread." + figure.name, "standard_error." + figure.name});
  Table table(head);
  const CaseResult* before = nullptr;  // of the same curve
  for (const CaseResult* point : points_of(results)) {
    if (before && (before->plan.curve != point->plan.curve || before->plan.is_reference)) before = nullptr;
    std::vector<std::string> row = {curve_of(spec, *point), point->plan.value, number_text(point->plan.x),
                                    std::to_string(point->code)};
    for (const auto& [name, time] : kTimes) row.push_back(number_text(point->cost.*time, 4));
    append(row, {number_text(point->steps), number_text(point->windows)});
    for (std::size_t m = 0; m < spec.figures.size(); ++m) {
      const double error = point->figures[m].error;
      double order = 0.0;
      if (before && before->code == 0 && point->code == 0)
        order = observed_order({{before->plan.x, before->figures[m].error}, {point->plan.x, error}});
      append(row, {cell(error), order != 0.0 ? fixed_text(order, 2) : ""});
    }
    if (samples)
      for (const SampledFigure& f : point->figures) append(row, {cell(f.mean), cell(f.spread), cell(f.standard_error)});
    table.add(row);
    before = point;
  }
  return table;
}

std::string recommendations(const ExperimentSpec& spec, const Results& results) {
  std::ostringstream out;
  out << "\n## Recommended settings\n\nThe cheapest value of each curve from which on all errors are within 1 % and "
         "within 5 %, with its largest error and its processor time over\n"
         "that of the scene's own value, or of the reference where the curve has no such value.";
  if (results.members > 1)
    out << " ± is what " << results.members
        << " samples leave open: the deviation of the error from\nsample to sample over the root of their number; "
           "where it passes the limit, the value is not resolved.";
  out << " Where no value keeps all figures within\nthe limit but one does without the worst of them, it is told with "
         "that one's error.\n\n";
  Table table({"curve", "within 1 %", "largest error", "time", "within 5 %", "largest error", "time"});
  const std::vector<Advice> fine = advice_of(spec, results, 0.01), coarse = advice_of(spec, results, 0.05);
  for (std::size_t c = 0; c < fine.size(); ++c) {
    std::vector<std::string> row = {spec.curves[c].name};
    append(row, advice_cells(spec, fine[c]));
    append(row, advice_cells(spec, coarse[c]));
    table.add(row);
  }
  out << table.page() << errors_with_defaults(spec, results) << scatter_of_reference(spec, results);
  return out.str();
}

std::string error_page(const ExperimentSpec& spec, const Results& results, const std::string& command) {
  const bool samples = results.members > 1, grains = results.grains();
  std::vector<std::string> head = {"curve", "value", grains ? "windows" : "steps"};
  append(head, names_in(spec.figures));
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
  out << "Mean and spread (standard deviation) over " << results.members
      << " samples; then the error of the mean against the reference's of the same curve, and its standard "
         "error.\nRun times in s; processor time is that of all programs, without the bed.\n\nMade by `"
      << command << "`.\n\n"
      << table.page() << recommendations(spec, results);
  return out.str();
}

}  // namespace footfall
