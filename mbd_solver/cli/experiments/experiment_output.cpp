#include "mbd_solver/cli/experiments/experiment_output.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/case_tables.h"
#include "mbd_solver/cli/experiments/error_page.h"
#include "mbd_solver/cli/experiments/figures.h"
#include "mbd_solver/cli/experiments/fits.h"
#include "mbd_solver/cli/experiments/pictures.h"
#include "mbd_solver/cli/experiments/verdicts.h"
#include "mbd_solver/cli/experiments/window_growth.h"
#include "mbd_solver/output/history.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

std::string path_of(const OutputPlace& place, const std::string& file) {
  return (fs::path(place.folder) / file).string();
}

void say(const std::string& text) { std::printf("%s\n", text.c_str()); }

// Into the folder, and where else it was asked for; and for people who look on.
void write_page(const OutputPlace& place, const std::string& text) {
  write_whole_file(path_of(place, place.name + ".md"), text);
  if (!place.table.empty()) write_whole_file(place.table, text);
  say(text + path_of(place, place.name + ".md"));
}

bool write_growth(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::vector<GrowthPoint> points = growth_of_schemes(*spec.growth, results.runs);
  write_page(place, growth_page(spec, points));
  bool all = true;
  for (const GrowthPoint& p : points) {
    if (p.as_theory(!results.runs.empty())) continue;
    all = false;
    std::printf("NOT SO    %s, omega H %g: growth in LIGGGHTS %.6g, code alone %.6g, theory %.6g\n", p.scheme.c_str(),
                p.omega_h, p.in_liggghts, p.measured, p.theory);
  }
  return all;
}

bool write_map(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::vector<Verdict> verdicts = verdicts_of(spec, results);
  write_page(place, verdict_page(spec, verdicts));
  const auto bad = std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return !v.as_expected; });
  std::printf("%zu cases, %td not as expected\n", verdicts.size(), bad);
  return bad == 0;
}

// True when all that must come out did.
bool write_statements(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::vector<Outcome> outcomes = outcomes_of(spec, results.cases);
  if (outcomes.empty()) return true;
  write_whole_file(path_of(place, "statements.csv"), statement_table(spec, outcomes).csv());
  write_whole_file(path_of(place, "statements.md"), statement_page(spec, outcomes));
  say("\n" + statement_page(spec, outcomes));
  for (std::size_t i = 0; i < outcomes.size(); ++i)
    if (spec.statements[i].must && !outcomes[i].came_out) return false;
  return true;
}

void write_errors(const ExperimentSpec& spec, const Results& results, const OutputPlace& place) {
  const std::string csv = path_of(place, place.name + ".csv");
  const Table table = error_table(spec, results);
  write_whole_file(csv, table.csv());
  if (!place.table.empty()) write_whole_file(place.table, error_page(spec, results, place.command));
  say(error_page(spec, results, place.command) + csv);
  try {
    say(joined(draw_errors(spec, results, place.folder, place.name, table), "\n"));
  } catch (const InputError& e) {
    std::fprintf(stderr, "footfall: warning: no picture: %s\n", e.what());
  }
}

}  // namespace

void demand_results(const ExperimentSpec& spec, const std::string& folder) {
  figures_of_run(spec.figures, folder, spec.file);
  if (spec.plots.empty()) return;
  const History history = read_history(folder + "/history.csv");
  for (const PlotSpec& plot : spec.plots)
    demand_columns({plot.column}, history, folder, spec.file, "plots." + plot.name + ".column");
}

bool write_output(const ExperimentSpec& spec, const Plan& plan, const Results& results, const OutputPlace& place) {
  if (spec.growth) return write_growth(spec, results, place);
  if (spec.is_map()) return write_map(spec, results, place);
  write_whole_file(path_of(place, "runs.csv"), run_table(spec, plan, results).csv());
  write_whole_file(path_of(place, "cases.csv"), case_table(spec, results.cases).csv());
  write_whole_file(path_of(place, "cases.md"), case_page(spec, results.cases));
  if (spec.curves.empty()) say(case_page(spec, results.cases));
  for (const CaseResult& c : results.cases)
    if (c.code != 0) std::printf("%s ended with code %d: %s\n", c.plan.name.c_str(), c.code, c.message.c_str());
  const bool expected = write_statements(spec, results, place);
  const std::vector<std::size_t> order = ranking(spec, results.cases);
  if (!order.empty())
    std::printf("best in %s within the limits: %s\n", spec.minimise.c_str(),
                results.cases[order.front()].plan.name.c_str());
  for (const std::string& file : {path_of(place, "runs.csv"), path_of(place, "cases.csv")}) say(file);
  for (const std::string& file : draw_plots(spec, results, place.folder)) say(file);
  if (!place.short_form)
    for (const std::string& file : write_fits(spec, plan, results.runs, place.folder)) say(file);
  if (!spec.curves.empty())
    write_errors(spec, results, place);
  else if (!place.table.empty())
    write_whole_file(place.table, case_page(spec, results.cases));
  // With curves, how a run ended is part of what is told.
  return expected && (!spec.curves.empty() || results.all_done());
}

}  // namespace footfall
