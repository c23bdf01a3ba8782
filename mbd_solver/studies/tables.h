#pragma once
// Tables, pages and pictures of a sweep: CSV for programs, Markdown for pages, pictures by gnuplot from the CSV files.

#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/app/report.h"
#include "mbd_solver/studies/results.h"

namespace footfall {

// Rows of cells. Rows shorter than the head stay short.
class Table {
 public:
  explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}

  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  int column(const std::string& name) const;  // its number, from 1; 0: none
  std::string csv() const;                    // RFC 4180, for CsvReader: cells with , " # or ends of lines are quoted
  std::string page() const;                   // Markdown
  const std::vector<std::vector<std::string>>& rows() const { return rows_; }

 private:
  std::vector<std::vector<std::string>> rows_;  // the head first
};

// A page of a study as Markdown and, with its pictures inside, as HTML.
class StudyPage {
 public:
  explicit StudyPage(const std::string& title) : markdown_("# " + title + "\n"), html_(title) {}

  void section(const std::string& heading);
  void paragraph(const std::string& text);
  void table(const Table& table);
  void picture(const std::string& file);  // PNG, in the folder of the page; throws InputError

  const std::string& markdown() const { return markdown_; }
  std::string html() const { return html_.text(); }

 private:
  std::string markdown_;
  HtmlPage html_;
};

void append(std::vector<std::string>& row, const std::vector<std::string>& more);

std::string cell(double value, int digits = 6);  // empty if not finite
std::string rounded(double value);               // three digits; round-off is zero
std::string percent(double share);
// The number that a text is; nothing if it is anything else.
std::optional<double> number_in(const std::string& text);

// Runs, cases and checks. The pages have the command that makes them, and explanations of checks that are not reproduced.
Table run_table(const SweepSpec& spec, const Plan& plan, const Results& results);
// The folders of the runs that are done, relative to the sweep's, by case: mbd_solver/app/difference/samples.h.
Table sample_table(const Results& results, const std::string& folder);
Table case_table(const SweepSpec& spec, const std::vector<CaseResult>& cases);
std::string case_page(const SweepSpec& spec, const std::vector<CaseResult>& cases);
Table check_table(const SweepSpec& spec, const std::vector<CheckResult>& results);
std::string check_page(const SweepSpec& spec, const std::vector<CheckResult>& results);

// The cases of the tables of errors: with an ensemble the references first. They point into the results.
std::vector<const CaseResult*> points_of(const Results& results);
// Errors of the curves; with an ensemble also mean, spread and standard error of every metric.
Table error_table(const SweepSpec& spec, const Results& results);
// The same as Markdown; with an ensemble also `command`, which makes it, and recommended values for 1 and 5 %.
std::string error_page(const SweepSpec& spec, const Results& results, const std::string& command);
std::string recommendation_section(const SweepSpec& spec, const Results& results);

// Both draw NAME.png and NAME.svg in `folder` and return the PNG files. Throw InputError when gnuplot is missing or fails.

// The histories of [[plots]] over time, a line per case; of an ensemble the mean and the band of its samples.
std::vector<std::string> draw_plots(const SweepSpec& spec, const Results& results, const std::string& folder);
// From NAME.csv, which holds `table`: a row per metric, error over x on the left (slopes: observed orders), over run time on
// the right, all axes logarithmic. With an ensemble over the processor time of all programs, as runs share the machine, and
// with bars of the standard error.
std::vector<std::string> draw_errors(const SweepSpec& spec, const Results& results, const std::string& folder,
                                     const std::string& name, const Table& table);

}  // namespace footfall
