#include "mbd_solver/cli/experiments/results.h"

#include <algorithm>
#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

std::size_t figure_index(const ExperimentSpec& spec, const std::string& name) {
  return static_cast<std::size_t>(index_of(spec.figures, name));
}

CaseResult case_of(const ExperimentSpec& spec, const PlannedCase& plan, const std::vector<RunResult>& runs) {
  CaseResult c;
  c.plan = plan;
  for (const std::size_t run : plan.runs) {
    if (runs[run].end.done()) {
      c.done.push_back(run);
      continue;
    }
    if (c.code == 0) c.message = runs[run].end.message;
    c.code = std::max(c.code, runs[run].end.code);
  }
  const double share = 1.0 / static_cast<double>(c.done.size());
  for (const std::size_t run : c.done) {
    const RunEnd& r = runs[run].end;
    for (const auto& [name, time] : kTimes) c.cost.*time += share * r.cost.*time;
    c.steps += share * r.summary.value("steps", 0.0);
    c.windows += share * r.summary.value("windows", 0.0);
  }
  for (std::size_t k = 0; k < spec.figures.size(); ++k) {
    std::vector<double> values;
    for (const std::size_t run : c.done) values.push_back(runs[run].figures[k]);
    c.figures.push_back(sampled_figure(values));
  }
  for (const LimitSpec& limit : spec.limits)
    c.within_limits = c.within_limits && c.figures[figure_index(spec, limit.figure)].mean <= limit.most;
  return c;
}

// Errors of a case whose runs are all done, against its reference.
void compare(const ExperimentSpec& spec, const std::vector<RunResult>& runs, const CaseResult* reference,
             CaseResult& c) {
  const double share = 1.0 / static_cast<double>(c.plan.runs.size());
  for (std::size_t m = 0; m < c.plan.runs.size() && reference; ++m) {
    const std::vector<double> errors =
        curve_errors(spec.figures, runs[c.plan.runs[m]].end.folder, runs[reference->plan.runs[m]].end.folder);
    for (std::size_t k = 0; k < errors.size(); ++k)
      if (spec.figures[k].compares_curves())
        c.figures[k].error = (m == 0 ? 0.0 : c.figures[k].error) + share * errors[k];
  }
  for (std::size_t k = 0; k < spec.figures.size(); ++k) {
    if (spec.figures[k].error == ErrorKind::kItself) {
      c.figures[k].error = 0.0;
      for (const std::size_t run : c.plan.runs) c.figures[k].error += share * std::abs(runs[run].figures[k]);
    }
    if (spec.figures[k].error != ErrorKind::kRelative || !reference) continue;
    std::vector<double> mine, theirs;
    for (const std::size_t run : c.plan.runs) mine.push_back(runs[run].figures[k]);
    for (const std::size_t run : reference->plan.runs) theirs.push_back(runs[run].figures[k]);
    c.figures[k] = sampled_figure(mine, theirs);
  }
}

}  // namespace

bool Results::all_done() const {
  return std::all_of(runs.begin(), runs.end(), [](const RunResult& run) { return run.end.done(); });
}

bool Results::grains() const {
  return std::any_of(cases.begin(), cases.end(),
                     [](const CaseResult& c) { return !c.plan.is_reference && c.cost.dem > 0.0; });
}

std::vector<CaseResult> cases_of(const ExperimentSpec& spec, const Plan& plan, const std::vector<RunResult>& runs) {
  std::vector<CaseResult> cases;
  for (const PlannedCase& c : plan.cases) cases.push_back(case_of(spec, c, runs));
  return cases;
}

Results results_of(const ExperimentSpec& spec, const Plan& plan, const RunStore& store) {
  Results results;
  results.members = plan.members;
  for (std::size_t run = 0; run < plan.runs.size(); ++run) {
    const RunEnd end = store.end_of(run);
    results.runs.push_back({end, end.done() ? figures_of_run(spec.figures, end.folder, spec.file)
                                            : std::vector<double>(spec.figures.size(), SampledFigure::kNone)});
  }
  results.cases = cases_of(spec, plan, results.runs);
  if (spec.figures.empty()) return results;  // nothing to compare
  for (CaseResult& c : results.cases) {
    const int k = c.plan.is_reference ? static_cast<int>(&c - results.cases.data()) : c.plan.reference;
    const CaseResult* reference = k < 0 ? nullptr : &results.cases[static_cast<std::size_t>(k)];
    if (reference && reference->code != 0)
      throw NumericalError("the run \"" + reference->plan.name +
                           "\", which others are compared with, ended with code " + std::to_string(reference->code) +
                           ": " + reference->message);
    if (c.code == 0) compare(spec, results.runs, reference, c);
  }
  return results;
}

std::vector<std::size_t> ranking(const ExperimentSpec& spec, const std::vector<CaseResult>& cases) {
  std::vector<std::size_t> order;
  if (spec.minimise.empty()) return order;
  const std::size_t k = figure_index(spec, spec.minimise);
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].within_limits && !cases[i].done.empty()) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return cases[a].figures[k].mean < cases[b].figures[k].mean; });
  return order;
}

double order_of(const std::vector<CaseResult>& cases, int curve, std::size_t figure) {
  std::vector<std::pair<double, double>> line;
  for (const CaseResult& c : cases)
    if (c.is_of(curve)) line.emplace_back(c.plan.x, c.figures[figure].error);
  return observed_order(line);
}

std::vector<Outcome> outcomes_of(const ExperimentSpec& spec, const std::vector<CaseResult>& cases) {
  std::vector<Outcome> outcomes;
  for (const StatementSpec& s : spec.statements) {
    const std::size_t k = figure_index(spec, s.figure);
    const int curve = index_of(spec.curves, s.curve);
    Outcome o;
    for (const CaseResult& c : cases) {  // some are left out of the short form
      if (c.plan.name == s.of_case) o.value = c.figures[k].mean;
      if (!s.against.empty() && c.plan.name == s.against) o.reference = c.figures[k].mean;
      // Of the last value, also where it is zero and no point of a logarithmic line.
      if (s.error && c.is_of(curve)) o.value = c.figures[k].error;
    }
    if (!s.order.empty()) o.value = order_of(cases, curve, k);
    o.judged = s.against.empty() ? o.value : o.value / o.reference;
    o.came_out = o.judged >= s.least && o.judged <= s.most;
    outcomes.push_back(o);
  }
  return outcomes;
}

}  // namespace footfall
