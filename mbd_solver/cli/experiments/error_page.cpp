#include "mbd_solver/cli/experiments/error_page.h"

#include <cmath>
#include <sstream>
#include <string>

#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/advice.h"
#include "mbd_solver/cli/experiments/text.h"

namespace footfall {
namespace {

// Enough of a message for a cell.
std::string one_line(const std::string& message) {
  constexpr std::size_t kMost = 90;
  const std::string line = message.substr(0, message.find('\n'));
  return line.size() <= kMost ? line : line.substr(0, kMost) + "...";
}

// "12 ± 3 %"
std::string error_text(double error, double standard_error) {
  return percent(error) + (standard_error > 0.0 ? " ± " + percent(standard_error) : "") + " %";
}

std::string error_cell(const ErrorTable& table, const CaseResult& point, std::size_t m) {
  const SampledFigure& f = point.figures[m];
  if (!std::isfinite(f.error)) return "";
  if (table.members == 1) return percent(f.error);
  if (!std::isfinite(f.mean)) return percent(f.error) + " %";  // of whole curves: no figure
  const std::string figure = number_text(f.mean, 4) + " ± " + number_text(f.spread, 2);
  return point.plan.is_reference ? figure : figure + "; " + error_text(f.error, f.standard_error);
}

void write_row(std::ostream& out, const ErrorTable& table, const CaseResult& point) {
  out << "| " << table.curve_of(point) << " | " << point.plan.value << " | ";
  if (point.code != 0) {
    out << "ended with code " << point.code << ": " << one_line(point.message) << " |\n";
    return;
  }
  out << number_text(table.grains ? point.windows : point.steps) << " |";
  for (std::size_t m = 0; m < table.figures.size(); ++m) out << ' ' << error_cell(table, point, m) << " |";
  if (table.grains) out << ' ' << number_text(table.run_time(point), 3) << " |";
  out << ' ' << number_text(table.members > 1 ? point.cost.cpu : point.cost.wall, 3) << " |\n";
}

// Value, its largest error and its run time: three cells.
std::string advice_cells(const Advice& a) {
  if (a.best.empty()) return " none was done | | |";
  std::string text = a.value.empty() ? " none; best is " + a.best : " " + a.value;
  if (!a.apart.empty()) text += ", but for " + a.apart + " (" + percent(a.apart_error) + " %)";
  if (!a.resolved) text += " (not resolved)";
  text += " | " + error_text(a.error, a.standard_error) + ", " + a.figure + " | ";
  return text + (a.time_ratio > 0.0 ? fixed_text(a.time_ratio, 2) : "") + " |";
}

}  // namespace

void write_recommendations(std::ostream& out, const ErrorTable& table) {
  out << "\n## Recommended settings\n\nThe cheapest value of each curve from which on all errors are within 1 % and "
         "within 5 %, with its largest error and its processor time over\n"
         "that of the scene's own value, or of the reference where the curve has no such value.";
  if (table.members > 1)
    out << " ± is what " << table.members
        << " samples leave open: the deviation of the error from\nsample to sample over the root of their number; "
           "where it passes the limit, the value is not resolved.";
  out << " Where no value keeps all figures within\nthe limit but one does without the worst of them, it is told with "
         "that one's error.";
  out << "\n\n| curve | within 1 % | largest error | time | within 5 % | largest error | time "
         "|\n|---|---|---|---|---|---|---|\n";
  const std::vector<Advice> fine = advice_of(table, 0.01), coarse = advice_of(table, 0.05);
  for (std::size_t c = 0; c < fine.size(); ++c)
    out << "| " << fine[c].curve << " |" << advice_cells(fine[c]) << advice_cells(coarse[c]) << '\n';

  const std::vector<Advice> defaults = errors_of_defaults(table);
  if (!defaults.empty()) {
    out << "\nWith the scene's own values the largest error is that of \"" << defaults.front().curve << "\"";
    for (std::size_t k = 0; k < defaults.size(); ++k)
      out << (k == 0 ? ": " : "; \"" + defaults[k].curve + "\": ")
          << error_text(defaults[k].error, defaults[k].standard_error) << " of " << defaults[k].figure << " at "
          << defaults[k].value;
    out << ".\n";
  }
  if (table.members > 1 && !table.references.empty()) {
    out << "\nFrom sample to sample the figures of the reference scatter by";
    const CaseResult& reference = table.references.front();
    bool first = true;
    for (std::size_t m = 0; m < table.figures.size(); ++m) {
      const SampledFigure& f = reference.figures[m];
      if (!std::isfinite(f.mean) || f.mean == 0.0) continue;
      const double scatter = f.spread / std::abs(f.mean);
      out << (first ? " " : ", ") << percent(scatter) << " % (" << table.figures[m] << ")";
      first = false;
    }
    out << ";\nof a mean of " << table.members << " by "
        << fixed_text(1.0 / std::sqrt(static_cast<double>(table.members)), 2)
        << " times that. Errors are told closer because run and reference start from the same samples.\n";
  }
}

void write_error_page(const std::string& path, const ErrorTable& table, const std::string& command) {
  std::ostringstream out;
  const bool samples = table.members > 1;
  out << "# " << table.title << "\n\n";
  if (samples) {
    out << "Mean and spread (standard deviation) over " << table.members
        << " samples; then the error of the mean against the reference's of the same curve, and its standard "
           "error.\nRun times in s; processor time is that of all programs, without the bed.\n\n";
  } else {
    out << "Errors in percent of the reference; run times in s.\n\n";
  }
  if (samples) out << "Made by `" << command << "`.\n\n";
  out << "| curve | value |" << (table.grains ? " windows |" : " steps |");
  for (const std::string& figure : table.figures) out << ' ' << figure << " |";
  if (table.grains) out << " mechanism + exchange |";
  out << (samples ? " processor time |\n" : table.grains ? " whole |\n" : " run time |\n") << "|---|---|---|---|";
  for (std::size_t m = 0; m < table.figures.size() + (table.grains ? 1 : 0); ++m) out << "---|";
  out << '\n';
  if (samples)
    for (const CaseResult& reference : table.references) write_row(out, table, reference);
  for (const CaseResult& point : table.points) write_row(out, table, point);
  if (samples) write_recommendations(out, table);
  write_whole_file(path, out.str());
}

}  // namespace footfall
