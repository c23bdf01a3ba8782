// Reads the folders of finished runs, and judges cases by their metrics, errors and energies.
#include "mbd_solver/studies/results.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {
namespace {

CaseResult case_of(const SweepSpec& spec, const PlannedCase& plan, const std::vector<RunResult>& runs) {
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
  for (std::size_t k = 0; k < spec.metrics.size(); ++k) {
    std::vector<double> values;
    for (const std::size_t run : c.done) values.push_back(runs[run].metrics[k]);
    c.metrics.push_back(sampled_metric(values));
  }
  c.within_limits = !c.done.empty();
  for (const LimitSpec& limit : spec.limits)
    c.within_limits = c.within_limits && c.metrics[index_of(spec.metrics, limit.metric)].mean <= limit.most;
  return c;
}

// Errors of a case whose runs are all done, against its reference.
void compare(const SweepSpec& spec, const std::vector<RunResult>& runs, const CaseResult* reference, CaseResult& c) {
  const double share = 1.0 / static_cast<double>(c.plan.runs.size());
  for (std::size_t m = 0; m < c.plan.runs.size() && reference; ++m) {
    const std::vector<double> errors =
        curve_errors(spec.metrics, runs[c.plan.runs[m]].end.folder, runs[reference->plan.runs[m]].end.folder);
    for (std::size_t k = 0; k < errors.size(); ++k)
      if (spec.metrics[k].compares_curves())
        c.metrics[k].error = (m == 0 ? 0.0 : c.metrics[k].error) + share * errors[k];
  }
  for (std::size_t k = 0; k < spec.metrics.size(); ++k) {
    if (spec.metrics[k].error == ErrorKind::kItself) {
      c.metrics[k].error = 0.0;
      for (const std::size_t run : c.plan.runs) c.metrics[k].error += share * std::abs(runs[run].metrics[k]);
    }
    if (spec.metrics[k].error != ErrorKind::kRelative || !reference) continue;
    std::vector<double> mine, theirs;
    for (const std::size_t run : c.plan.runs) mine.push_back(runs[run].metrics[k]);
    for (const std::size_t run : reference->plan.runs) theirs.push_back(runs[run].metrics[k]);
    c.metrics[k] = sampled_metric(mine, theirs);
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

std::vector<CaseResult> cases_of(const SweepSpec& spec, const Plan& plan, const std::vector<RunResult>& runs) {
  std::vector<CaseResult> cases;
  for (const PlannedCase& c : plan.cases) cases.push_back(case_of(spec, c, runs));
  return cases;
}

Results results_of(const SweepSpec& spec, const Plan& plan, const RunStore& store) {
  Results results;
  results.members = plan.members;
  for (std::size_t run = 0; run < plan.runs.size(); ++run) {
    const RunEnd end = store.end_of(run);
    results.runs.push_back({end, end.done() ? metrics_of_run(spec.metrics, end.folder, spec.file)
                                            : std::vector<double>(spec.metrics.size(), SampledMetric::kNone)});
  }
  results.cases = cases_of(spec, plan, results.runs);
  if (spec.metrics.empty()) return results;  // nothing to compare
  for (CaseResult& c : results.cases) {
    const int k = c.plan.is_reference ? static_cast<int>(&c - results.cases.data()) : c.plan.reference;
    const CaseResult* reference = k < 0 ? nullptr : &results.cases[k];
    if (reference && reference->code != 0)
      throw NumericalError(code::kReferenceFailed, "the reference \"" + reference->plan.name +
                                                       "\" ended with exit code " + std::to_string(reference->code) +
                                                       ": " + reference->message);
    if (c.code == 0) compare(spec, results.runs, reference, c);
  }
  return results;
}

std::vector<std::size_t> ranking(const SweepSpec& spec, const std::vector<CaseResult>& cases) {
  std::vector<std::size_t> order;
  if (spec.minimise.empty()) return order;
  const int k = index_of(spec.metrics, spec.minimise);
  for (std::size_t i = 0; i < cases.size(); ++i)
    if (cases[i].within_limits && !cases[i].done.empty()) order.push_back(i);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return cases[a].metrics[k].mean < cases[b].metrics[k].mean; });
  return order;
}

double order_of(const std::vector<CaseResult>& cases, int curve, std::size_t metric) {
  std::vector<std::pair<double, double>> line;
  for (const CaseResult& c : cases)
    if (c.is_of(curve)) line.emplace_back(c.plan.x, c.metrics[metric].error);
  return observed_order(line);
}

std::vector<CheckResult> check_results_of(const SweepSpec& spec, const std::vector<CaseResult>& cases) {
  std::vector<CheckResult> check_results;
  for (const CheckSpec& s : spec.checks) {
    const int k = index_of(spec.metrics, s.metric);
    const int curve = index_of(spec.curves, s.curve);
    CheckResult o;
    for (const CaseResult& c : cases) {  // the short form leaves some out
      if (c.plan.name == s.of_case) o.value = c.metrics[k].mean;
      if (!s.against.empty() && c.plan.name == s.against) o.reference = c.metrics[k].mean;
      // At the last value, also if the error is zero and no point of a logarithmic line.
      if (s.error && c.is_of(curve)) o.value = c.metrics[k].error;
    }
    if (!s.order.empty()) o.value = order_of(cases, curve, k);
    o.judged = s.against.empty() ? o.value : s.difference ? o.value - o.reference : o.value / o.reference;
    o.reproduced = o.judged >= s.least && o.judged <= s.most;
    check_results.push_back(o);
  }
  return check_results;
}

namespace {

bool is_judged(const CaseResult& point) {
  return point.code == 0 && std::all_of(point.metrics.begin(), point.metrics.end(),
                                        [](const SampledMetric& f) { return std::isfinite(f.error); });
}

// The metric with the largest error, without one.
std::size_t worst_metric(const CaseResult& point, std::size_t excepted = kNoMetric) {
  std::size_t worst = kNoMetric;
  for (std::size_t m = 0; m < point.metrics.size(); ++m)
    if (m != excepted && (worst == kNoMetric || point.metrics[m].error > point.metrics[worst].error)) worst = m;
  return worst;
}

double largest_error(const CaseResult& point, std::size_t excepted = kNoMetric) {
  return point.metrics[worst_metric(point, excepted)].error;
}

// The case to whose run time the others of the curve are related.
const CaseResult* time_reference(const SweepSpec& spec, const Results& results, int curve) {
  const CaseResult *own = nullptr, *common = nullptr;
  for (const CaseResult& c : results.cases) {
    if (c.is_of(curve) && c.plan.value == spec.curves[curve].default_value && c.code == 0) return &c;
    if (!c.plan.is_reference) continue;
    if (c.plan.curve == curve && !own) own = &c;
    if (c.plan.curve < 0) common = &c;
  }
  return own ? own : common;
}

Recommendation recommendation_for(const SweepSpec& spec, const Results& results, const CaseResult& point, double limit,
                                  std::size_t excepted = kNoMetric) {
  Recommendation recommendation;
  recommendation.point = &point;
  recommendation.excepted = excepted;
  recommendation.worst = worst_metric(point, excepted);
  for (std::size_t k = 0; k < point.metrics.size(); ++k)
    if (k != excepted && point.metrics[k].standard_error > limit) recommendation.resolved = false;
  const CaseResult* by = time_reference(spec, results, point.plan.curve);
  recommendation.time_ratio = by && by->cost.cpu > 0.0 ? point.cost.cpu / by->cost.cpu : 0.0;
  return recommendation;
}

Recommendation recommendation_for_curve(const SweepSpec& spec, const Results& results, int curve, double limit) {
  // The first case from which on all are within the limit; null: none.
  const auto first_within = [&](std::size_t excepted) {
    const CaseResult* first = nullptr;
    for (const CaseResult& c : results.cases) {
      if (!c.is_of(curve)) continue;
      const bool within = is_judged(c) && largest_error(c, excepted) <= limit;
      first = !within ? nullptr : first ? first : &c;
    }
    return first;
  };
  const CaseResult* best = nullptr;
  for (const CaseResult& c : results.cases)
    if (c.is_of(curve) && is_judged(c) && (!best || largest_error(c) < largest_error(*best))) best = &c;
  if (!best) return {};
  std::size_t excepted = kNoMetric;
  const CaseResult* chosen = first_within(excepted);
  if (!chosen && best->metrics.size() > 1) {
    excepted = worst_metric(*best);
    chosen = first_within(excepted);
  }
  Recommendation recommendation = chosen ? recommendation_for(spec, results, *chosen, limit, excepted)
                                         : recommendation_for(spec, results, *best, limit);
  recommendation.within = chosen != nullptr;
  return recommendation;
}

}  // namespace

std::vector<Recommendation> recommendations_of(const SweepSpec& spec, const Results& results, double limit) {
  std::vector<Recommendation> recommendation;
  for (int curve = 0; curve < static_cast<int>(spec.curves.size()); ++curve)
    recommendation.push_back(recommendation_for_curve(spec, results, curve, limit));
  return recommendation;
}

std::vector<Recommendation> errors_of_defaults(const SweepSpec& spec, const Results& results) {
  std::vector<Recommendation> defaults;
  for (const CaseResult& c : results.cases)
    if (c.plan.curve >= 0 && !c.plan.is_reference && is_judged(c) &&
        c.plan.value == spec.curves[c.plan.curve].default_value)
      defaults.push_back(recommendation_for(spec, results, c, 1.0));
  std::sort(defaults.begin(), defaults.end(),
            [](const Recommendation& a, const Recommendation& b) { return a.largest().error > b.largest().error; });
  return defaults;
}

namespace fs = std::filesystem;

namespace {

constexpr double kGain = 2e-2;  // of the reference energy: created energy at which the coupling warns, too

// Energy created in the mechanism and the interface, over the reference energy: above the start plus the work of prescribed
// motions. The work of the grains counts as the grains report it.
double energy_gain(const History& h, double reference) {
  if (h.columns.empty() || h.columns.front().empty() || !(reference > 0.0)) return 0.0;
  std::vector<double> sums(h.columns.front().size(), 0.0);
  const auto add = [&](const std::string& name, double sign) {
    const std::vector<double>& column = h.column(name);
    for (std::size_t row = 0; row < sums.size(); ++row) sums[row] += sign * (column[row] - column.front());
  };
  for (const std::string& name : h.names)
    if (name == "energy.total" || name.rfind("dissipated.", 0) == 0) add(name, 1.0);
  for (const std::string& name : h.names)
    if (name == "work.contact" || name == "work.motion" || name == "coupling.energy_error") add(name, -1.0);
  return std::max(0.0, *std::max_element(sums.begin(), sums.end())) / reference;
}

// Cuts long messages after a clause, and names files relative to the folder of inputs.
std::string shortened(const SweepSpec& spec, std::string text) {
  constexpr std::size_t most = 110;
  const std::string inputs = fs::path(spec.folder).parent_path().string() + "/";
  for (std::size_t at = text.find(inputs); at != std::string::npos; at = text.find(inputs))
    text.erase(at, inputs.size());
  std::replace(text.begin(), text.end(), '|', '/');
  if (text.size() <= most) return text;
  const std::size_t end = text.find_last_of(":;,", most);
  return text.substr(0, end == std::string::npos || end < 40 ? most : end) + " ...";
}

// Judges a finished run: its error and created energy.
void judge_motion(const SweepSpec& spec, const MapSpec& map, const RunEnd& run, const RunEnd* reference, MapRow& row) {
  const History history = read_history(run.folder + "/history.csv");
  double error = 0.0;
  if (!map.columns.empty()) {
    if (reference->code != kExitDone)
      throw NumericalError(code::kReferenceFailed,
                           row.name + " " + row.value + ": its reference has failed: " + reference->message);
    error = history_error(history, read_history(reference->folder + "/history.csv"), map.columns, map.at_end);
    row.result = "error " + percent(error) + " %, ";
  }
  const double gain = energy_gain(history, run.summary.value("reference_energy_J", 0.0));
  row.result += "created energy " + percent(gain) + " %";
  // Without a reference a warning decides.
  const bool good = gain <= kGain && (map.columns.empty() ? run.warnings.empty() : error <= map.tolerance);
  row.fault = !good && run.warnings.empty();
  row.end = good ? "accurate" : row.fault ? "WRONG WITHOUT A WARNING" : "warned";
  if (row.end == "warned") row.result += "; " + shortened(spec, run.warnings.front());
}

MapRow map_row(const SweepSpec& spec, const PlannedCase& c, const RunEnd& run, const RunEnd* reference) {
  const CurveSpec& curve = spec.curves[c.curve];
  MapRow row{curve.map.group, curve.name, c.value, "", "", false};
  if (run.code == kExitDone) {
    judge_motion(spec, curve.map, run, reference, row);
    return row;
  }
  const bool own = run.code == kExitFailed || run.code == kExitBadInput;
  row.fault = !own || run.message.empty();
  row.end = run.code == RunEnd::kHung ? "no end"
            : !own                    ? "exit code " + std::to_string(run.code)
            : run.message.empty()     ? "ended without a message"
            : run.code == kExitFailed ? "stopped"
                                      : "refused";
  row.result = shortened(spec, run.message);
  return row;
}

}  // namespace

std::vector<MapRow> map_rows(const SweepSpec& spec, const Results& results) {
  std::vector<MapRow> rows;
  const auto end_of = [&](const PlannedCase& c) { return &results.runs[c.runs.front()].end; };
  for (const CaseResult& c : results.cases) {
    if (c.plan.is_reference) continue;
    const int k = c.plan.reference;
    const RunEnd* reference = k < 0 ? nullptr : end_of(results.cases[k].plan);
    rows.push_back(map_row(spec, c.plan, *end_of(c.plan), reference));
  }
  return rows;
}

std::string map_page(const SweepSpec& spec, const std::vector<MapRow>& rows) {
  std::string text =
      "# " + spec.title + "\n\nWritten by `footfall accuracy " + fs::path(spec.file).filename().string() +
      "`. accurate: within the tolerance of its reference, or without created energy. warned: done, energy "
      "bounded,\nerror larger, and a warning reported it. stopped: ended by itself with this message. refused: not "
      "started.\n";
  std::vector<std::string> groups;
  for (const MapRow& row : rows)
    if (std::find(groups.begin(), groups.end(), row.group) == groups.end()) groups.push_back(row.group);
  for (const std::string& group : groups) {
    Table table({"case", "value", "end", "result"});
    for (const MapRow& row : rows)
      if (row.group == group) table.add({row.name, row.value, row.end, row.result});
    text += "\n## " + group + "\n\n" + table.page();
  }
  return text;
}

}  // namespace footfall
