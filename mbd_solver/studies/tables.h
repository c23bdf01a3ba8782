#pragma once
// A table of an experiment: CSV for programs, Markdown for pages; and the texts of its cells.

#include <optional>
#include <string>
#include <vector>

#include "mbd_solver/studies/results.h"

namespace footfall {

// Rows of cells. Rows shorter than the head stay short.
class Table {
 public:
  explicit Table(std::vector<std::string> head) : rows_{std::move(head)} {}

  void add(std::vector<std::string> row) { rows_.push_back(std::move(row)); }
  int column(const std::string& name) const;  // its number, from 1; 0: there is none
  std::string csv() const;                    // RFC 4180: cells with a comma or a quote stand in quotes
  std::string page() const;                   // Markdown

 private:
  std::vector<std::vector<std::string>> rows_;  // the head first
};

void append(std::vector<std::string>& row, const std::vector<std::string>& more);

// A number in a table: empty where there is none.
std::string cell(double value, int digits = 6);
// As people read it: three digits, and round-off is zero.
std::string rounded(double value);
std::string percent(double share);

// The number that a text is; none when it is more or less than one.
std::optional<double> number_in(const std::string& text);

// The runs, cases and statements of an experiment as tables.

Table run_table(const ExperimentSpec& spec, const Plan& plan, const Results& results);
Table case_table(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);
// The same for people, with printed figures and the command that makes it.
std::string case_page(const ExperimentSpec& spec, const std::vector<CaseResult>& cases);

Table statement_table(const ExperimentSpec& spec, const std::vector<Outcome>& outcomes);
// The same for people, with why something did not come out.
std::string statement_page(const ExperimentSpec& spec, const std::vector<Outcome>& outcomes);

// Errors of the curves of an experiment: as CSV, and as a page; with an ensemble the page also says what it recommends.

// The rows of the tables: with an ensemble those of the references first. They point into the results.
std::vector<const CaseResult*> points_of(const Results& results);

// With an ensemble, every row has mean, spread and standard error (see SampledFigure) of every figure.
Table error_table(const ExperimentSpec& spec, const Results& results);

// `command`: the one that makes the page, told with an ensemble.
std::string error_page(const ExperimentSpec& spec, const Results& results, const std::string& command);

// The section "Recommended settings" for 1 and 5 %.
std::string recommendations(const ExperimentSpec& spec, const Results& results);

// Pictures of an experiment, drawn by gnuplot from the CSV files of its folder and of its runs.

// Each draws NAME.png and NAME.svg in `folder` and returns the PNG files. Throws InputError when gnuplot is missing or
// fails.

// The histories of [[plots]] over time, one line per case.
std::vector<std::string> draw_plots(const ExperimentSpec& spec, const Results& results, const std::string& folder);
// From NAME.csv, which holds `table` (error_page.h): one row per figure, error over x on the left (slopes: observed
// orders), over run time on the right, all axes logarithmic. Of an ensemble, whose runs often share the machine, errors
// are over the processor time of all programs, and bars go up by the standard error.
std::vector<std::string> draw_errors(const ExperimentSpec& spec, const Results& results, const std::string& folder,
                                     const std::string& name, const Table& table);

}  // namespace footfall
