#pragma once
// What a sweep found: the figures of every run, mean and spread of every case, which case is best, and its plots.

#include <limits>
#include <string>
#include <vector>

#include "mbd_solver/cli/experiments/sweep.h"

namespace footfall {

struct SweepResult {
  bool done = false;
  std::string status;           // of summary.json; "missing" without one
  std::vector<double> figures;  // as SweepSpec::figures; NaN: not there
};

// Of one finished or unfinished run in `folder`.
SweepResult result_of(const SweepSpec& sweep, const std::string& folder);

struct SweepCase {
  std::string name;                  // values of all parameters but the ensembles
  std::vector<int> runs;             // those that are done
  std::vector<double> mean, spread;  // per figure; spread: standard deviation, 0 for one run
  bool within_limits = true;
};
std::vector<SweepCase> cases_of(const SweepSpec& sweep, const std::vector<SweepRun>& runs,
                                const std::vector<SweepResult>& results);

// runs.csv: one row per run. cases.csv: one row per case; cases.md the same as a table for a page, with the command
// that makes it.
void write_run_table(const std::string& path, const SweepSpec& sweep, const std::vector<SweepRun>& runs,
                     const std::vector<SweepResult>& results);
void write_case_table(const std::string& path, const SweepSpec& sweep, const std::vector<SweepCase>& cases);
void write_case_page(const std::string& path, const SweepSpec& sweep, const std::vector<SweepCase>& cases);
struct StatementVerdict {
  double value = 0.0, reference = std::numeric_limits<double>::quiet_NaN();
  double judged = 0.0;  // the value, or its ratio to the reference; NaN: not run
  bool came_out = false;
};
std::vector<StatementVerdict> verdicts_of(const SweepSpec& sweep, const std::vector<SweepCase>& cases);
// statements.csv and statements.md in `folder`.
void write_statements(const std::string& folder, const SweepSpec& sweep, const std::vector<StatementVerdict>& verdicts);
// The cases within the limits, best first; empty when nothing is minimised.
std::vector<int> ranking(const SweepSpec& sweep, const std::vector<SweepCase>& cases);
// NAME.png and NAME.svg in `folder` for every plot; returns the PNG files. `folders`: one per run.
std::vector<std::string> draw_sweep(const SweepSpec& sweep, const std::vector<SweepCase>& cases,
                                    const std::vector<std::string>& folders, const std::string& folder);

}  // namespace footfall
