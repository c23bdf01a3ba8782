#include "mbd_solver/cli/experiments/experiment_output.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/experiments/error_page.h"
#include "mbd_solver/cli/experiments/error_table.h"
#include "mbd_solver/cli/experiments/fits.h"
#include "mbd_solver/cli/experiments/plots.h"
#include "mbd_solver/cli/experiments/results.h"
#include "mbd_solver/cli/experiments/tables.h"
#include "mbd_solver/cli/experiments/verdicts.h"
#include "mbd_solver/cli/experiments/window_growth.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kGrowthMiss = 1e-2;  // of the growth per window: a motion of a few windows does not tell it better

const char* mark(bool good) { return good ? "ok" : "NOT SO"; }

void say_files(const std::vector<std::string>& files) {
  for (const std::string& file : files) std::printf("%s\n", file.c_str());
}

// The files of a page's table.
std::vector<std::string> pages(const OutputPlace& place, const std::string& extension) {
  std::vector<std::string> files = {(fs::path(place.folder) / (place.name + extension)).string()};
  if (!place.table.empty()) files.push_back(place.table);
  return files;
}

bool write_growth_output(const ExperimentSpec& spec, const OutputPlace& place) {
  const std::string runs = spec.scene.empty() ? "" : (fs::path(place.folder) / "runs").string();
  const int n = spec.growth->substeps;
  const std::vector<GrowthPoint> points = growth_of_schemes(spec.growth->omega_h, n, runs);
  bool all = true;
  for (const GrowthPoint& p : points) {
    const auto near = [&](double found) { return std::abs(found - p.theory) <= kGrowthMiss * p.theory; };
    const bool good = near(p.measured) && (runs.empty() || near(p.in_liggghts));
    all = all && good;
    std::printf("%-9s %-14s omega H %-6g growth in LIGGGHTS %.6g, code alone %.6g, theory %.6g\n", mark(good),
                p.scheme.c_str(), p.omega_h, p.in_liggghts, p.measured, p.theory);
  }
  const std::vector<std::string> files = pages(place, ".md");
  for (const std::string& file : files) write_growth(file, spec.title, points, n);
  say_files(files);
  return all;
}

bool write_map_output(const ExperimentSpec& spec, const Plan& plan, const RunStore& store,
                      const std::vector<std::size_t>& numbers, const OutputPlace& place) {
  const std::vector<Verdict> verdicts = verdicts_of(spec, plan, store, numbers);
  for (const Verdict& v : verdicts)
    std::printf("%-9s %-28s %-10s %-9s %s\n", mark(v.as_expected), v.name.c_str(), v.value.c_str(), v.found.c_str(),
                v.note.c_str());
  const std::vector<std::string> files = pages(place, ".md");
  for (const std::string& file : files) write_verdicts(file, spec, verdicts);
  const auto bad = std::count_if(verdicts.begin(), verdicts.end(), [](const Verdict& v) { return !v.as_expected; });
  std::printf("%zu cases, %td not as expected: %s\n", verdicts.size(), bad, files.front().c_str());
  return bad == 0;
}

void say_case(const ExperimentSpec& spec, const CaseResult& c) {
  std::printf("%-24s wall %8.3f s, CPU %8.3f s (grains %.3f, mechanism %.3f, exchange %.3f)", c.plan.name.c_str(),
              c.cost.wall, c.cost.cpu, c.cost.dem, c.cost.mbd, c.cost.exchange);
  for (std::size_t k = 0; k < c.figures.size(); ++k) {
    const SampledFigure& f = c.figures[k];
    std::printf("  |  %s", spec.figures[k].name.c_str());
    if (std::isfinite(f.mean)) std::printf(" %.4g", f.mean);
    if (c.done.size() > 1 && std::isfinite(f.mean)) std::printf(" +- %.2g", f.spread);
    if (std::isfinite(f.error)) std::printf(" error %.3g", f.error);
  }
  std::printf("%s\n", c.within_limits ? "" : "  |  beyond the limits");
  if (c.code != 0) std::printf("%-24s ended with code %d: %s\n", "", c.code, c.message.c_str());
}

// True when all that must come out did.
bool say_statements(const ExperimentSpec& spec, const std::vector<Outcome>& outcomes) {
  bool all = true;
  for (std::size_t i = 0; i < outcomes.size(); ++i) {
    const StatementSpec& s = spec.statements[i];
    const Outcome& o = outcomes[i];
    std::printf("%-9s %s: %.4g, expected %.4g to %.4g\n", std::isnan(o.judged) ? "not run" : mark(o.came_out),
                s.text.c_str(), o.judged, s.least, s.most);
    all = all && (o.came_out || !s.must);
  }
  return all;
}

void write_errors(const ExperimentSpec& spec, const Plan& plan, const Results& results, const OutputPlace& place) {
  const ErrorTable table = error_table_of(spec, plan, results);
  const std::string csv = pages(place, ".csv").front();
  write_error_csv(csv, table);
  if (!place.table.empty()) write_error_page(place.table, table, place.command);
  say_files({csv});
  try {
    say_files({draw_errors(place.folder, place.name, table)});
  } catch (const InputError& e) {
    std::fprintf(stderr, "footfall: warning: no picture: %s\n", e.what());
  }
}

}  // namespace

bool write_output(const ExperimentSpec& spec, const Plan& plan, const RunStore& store,
                  const std::vector<std::size_t>& numbers, const OutputPlace& place) {
  if (spec.growth) return write_growth_output(spec, place);
  if (spec.is_map()) return write_map_output(spec, plan, store, numbers, place);
  const Results results = results_of(spec, plan, store, numbers);
  const auto file = [&](const char* name) { return (fs::path(place.folder) / name).string(); };
  write_run_table(file("runs.csv"), spec, plan, results);
  write_case_table(file("cases.csv"), spec, results.cases);
  write_case_page(file("cases.md"), spec, results.cases);
  for (const CaseResult& c : results.cases) say_case(spec, c);
  const std::vector<Outcome> outcomes = outcomes_of(spec, results.cases);
  write_statements(place.folder, spec, outcomes);
  const bool expected = say_statements(spec, outcomes);
  const std::vector<std::size_t> order = ranking(spec, results.cases);
  if (!order.empty())
    std::printf("best in %s within the limits: %s\n", spec.minimise.c_str(),
                results.cases[order.front()].plan.name.c_str());
  say_files({file("runs.csv"), file("cases.csv")});
  say_files(draw_plots(spec, results, place.folder));
  if (!place.short_form) say_files(write_fits(spec, plan, results.runs, place.folder));
  if (!spec.curves.empty())
    write_errors(spec, plan, results, place);
  else if (!place.table.empty())
    write_case_page(place.table, spec, results.cases);
  // With curves, how a run ended is part of what is told.
  return expected && (!spec.curves.empty() || results.all_done());
}

}  // namespace footfall
