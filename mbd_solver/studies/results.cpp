#include "mbd_solver/studies/results.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>

#include "coupler/base/errors.h"
#include "mbd_solver/studies/tables.h"

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

namespace {

bool is_judged(const CaseResult& point) {
  return point.code == 0 && std::all_of(point.figures.begin(), point.figures.end(),
                                        [](const SampledFigure& f) { return std::isfinite(f.error); });
}

// The figure with the largest error, but for one.
std::size_t worst_figure(const CaseResult& point, std::size_t apart = kNoFigure) {
  std::size_t worst = kNoFigure;
  for (std::size_t m = 0; m < point.figures.size(); ++m)
    if (m != apart && (worst == kNoFigure || point.figures[m].error > point.figures[worst].error)) worst = m;
  return worst;
}

double largest_error(const CaseResult& point, std::size_t apart = kNoFigure) {
  return point.figures[worst_figure(point, apart)].error;
}

// What the curve's run times are measured by.
const CaseResult* yardstick(const ExperimentSpec& spec, const Results& results, int curve) {
  const CaseResult *own = nullptr, *common = nullptr;
  for (const CaseResult& c : results.cases) {
    if (c.is_of(curve) && c.plan.value == spec.curves[static_cast<std::size_t>(curve)].default_value && c.code == 0)
      return &c;
    if (!c.plan.is_reference) continue;
    if (c.plan.curve == curve && !own) own = &c;
    if (c.plan.curve < 0) common = &c;
  }
  return own ? own : common;
}

Advice advice_for(const ExperimentSpec& spec, const Results& results, const CaseResult& point, double limit,
                  std::size_t apart = kNoFigure) {
  Advice advice;
  advice.point = &point;
  advice.apart = apart;
  advice.worst = worst_figure(point, apart);
  for (std::size_t k = 0; k < point.figures.size(); ++k)
    if (k != apart && point.figures[k].standard_error > limit) advice.resolved = false;
  const CaseResult* by = yardstick(spec, results, point.plan.curve);
  advice.time_ratio = by && by->cost.cpu > 0.0 ? point.cost.cpu / by->cost.cpu : 0.0;
  return advice;
}

Advice advice_of_curve(const ExperimentSpec& spec, const Results& results, int curve, double limit) {
  // The first case from which on all are within the limit; null without.
  const auto first_within = [&](std::size_t apart) {
    const CaseResult* first = nullptr;
    for (const CaseResult& c : results.cases) {
      if (!c.is_of(curve)) continue;
      const bool within = is_judged(c) && largest_error(c, apart) <= limit;
      first = !within ? nullptr : first ? first : &c;
    }
    return first;
  };
  const CaseResult* best = nullptr;
  for (const CaseResult& c : results.cases)
    if (c.is_of(curve) && is_judged(c) && (!best || largest_error(c) < largest_error(*best))) best = &c;
  if (!best) return {};
  std::size_t apart = kNoFigure;
  const CaseResult* chosen = first_within(apart);
  if (!chosen && best->figures.size() > 1) {
    apart = worst_figure(*best);
    chosen = first_within(apart);
  }
  Advice advice = chosen ? advice_for(spec, results, *chosen, limit, apart) : advice_for(spec, results, *best, limit);
  advice.within = chosen != nullptr;
  return advice;
}

}  // namespace

std::vector<Advice> advice_of(const ExperimentSpec& spec, const Results& results, double limit) {
  std::vector<Advice> advice;
  for (int curve = 0; curve < static_cast<int>(spec.curves.size()); ++curve)
    advice.push_back(advice_of_curve(spec, results, curve, limit));
  return advice;
}

std::vector<Advice> errors_of_defaults(const ExperimentSpec& spec, const Results& results) {
  std::vector<Advice> defaults;
  for (const CaseResult& c : results.cases)
    if (c.plan.curve >= 0 && !c.plan.is_reference && is_judged(c) &&
        c.plan.value == spec.curves[static_cast<std::size_t>(c.plan.curve)].default_value)
      defaults.push_back(advice_for(spec, results, c, 1.0));
  std::sort(defaults.begin(), defaults.end(),
            [](const Advice& a, const Advice& b) { return a.largest().error > b.largest().error; });
  return defaults;
}

namespace fs = std::filesystem;

namespace {

// More than this, of the reference energy, is a gain: the coupling warns of as much.
constexpr double kGain = 2e-2;

// Energy of the mechanism and of the interface: whatever is more than at the start plus the work done by motions. What
// the grains did to the bodies is taken as the grains' own account of it.
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
    if (name == "work.contact" || name == "work.motion" || name == "coupling.energy_residual") add(name, -1.0);
  return std::max(0.0, *std::max_element(sums.begin(), sums.end())) / reference;
}

// Longer messages are cut where a sentence or clause ends; files are named from the folder of the inputs on.
std::string shortened(const ExperimentSpec& spec, std::string text) {
  constexpr std::size_t most = 110;
  const std::string inputs = fs::path(spec.folder).parent_path().string() + "/";
  for (std::size_t at = text.find(inputs); at != std::string::npos; at = text.find(inputs))
    text.erase(at, inputs.size());
  std::replace(text.begin(), text.end(), '|', '/');
  if (text.size() <= most) return text;
  const std::size_t end = text.find_last_of(":;,", most);
  return text.substr(0, end == std::string::npos || end < 40 ? most : end) + " ...";
}

bool mentions(const RunEnd& run, const std::string& pattern) {
  const std::regex expression(pattern);
  if (std::regex_search(run.message, expression)) return true;
  return std::any_of(run.warnings.begin(), run.warnings.end(),
                     [&](const std::string& warning) { return std::regex_search(warning, expression); });
}

// Of a run that is done: its error and its gain of energy.
void judge_motion(const ExperimentSpec& spec, const EndSpec& end, const RunEnd& run, const RunEnd* reference,
                  Verdict& verdict) {
  const History history = read_history(run.folder + "/history.csv");
  if (!end.columns.empty()) {
    if (reference->code != kExitDone)
      throw NumericalError(verdict.name + " " + verdict.value + ": its reference fails: " + reference->message);
    verdict.error = history_error(history, read_history(reference->folder + "/history.csv"), end.columns, end.at_end);
    verdict.note = "error " + percent(verdict.error) + " %, ";
  }
  const double gain = energy_gain(history, run.summary.value("reference_energy_J", 0.0));
  verdict.note += "gain " + percent(gain) + " %";
  // Without a reference, a warning is taken at its word.
  const bool good = gain <= kGain && (end.columns.empty() ? run.warnings.empty() : verdict.error <= end.tolerance);
  verdict.found = good ? "accurate" : run.warnings.empty() ? "WRONG WITHOUT A WARNING" : "warned";
  if (verdict.found == "warned") verdict.note += "; " + shortened(spec, run.warnings.front());
}

Verdict judge(const ExperimentSpec& spec, const PlannedCase& c, const RunEnd& run, const RunEnd* reference) {
  const CurveSpec& curve = spec.curves[static_cast<std::size_t>(c.curve)];
  const EndSpec& end = curve.end;
  const auto at = std::find(curve.values.begin(), curve.values.end(), c.value) - curve.values.begin();
  Verdict verdict;
  verdict.group = end.group;
  verdict.name = curve.name;
  verdict.value = c.value;
  verdict.expected = end.ends[end.ends.size() == 1 ? 0 : static_cast<std::size_t>(at)];
  if (run.code == kExitDone) {
    judge_motion(spec, end, run, reference, verdict);
  } else {
    const bool own = run.code == kExitFailed || run.code == kExitBadInput;
    verdict.found = run.code == RunEnd::kHung ? "hangs"
                    : !own                    ? "ended with code " + std::to_string(run.code)
                    : run.message.empty()     ? "ended without a message"
                    : run.code == kExitFailed ? "stopped"
                                              : "refused";
    verdict.note = shortened(spec, run.message);
  }
  verdict.as_expected = verdict.found == verdict.expected;
  if (verdict.as_expected && !end.message.empty() && !mentions(run, end.message)) {
    verdict.as_expected = false;
    verdict.note += "; no message matches " + end.message;
  }
  return verdict;
}

// Of first order at most: beyond the value `beyond` no error is larger than that of an earlier such value times the
// ratio of the values.
void judge_order(double beyond, const std::vector<Verdict>& earlier, Verdict& verdict) {
  const double x = std::atof(verdict.value.c_str());
  if (beyond <= 0.0 || x < beyond) return;
  for (const Verdict& v : earlier) {
    const double y = std::atof(v.value.c_str());
    if (v.name != verdict.name || y < beyond || v.error <= 0.0 || verdict.error <= v.error * x / y) continue;
    verdict.as_expected = false;
    verdict.note += "; grew from " + percent(v.error) + " % at " + v.value + ", faster than in proportion";
    return;
  }
}

}  // namespace

std::vector<Verdict> verdicts_of(const ExperimentSpec& spec, const Results& results) {
  std::vector<Verdict> verdicts;
  const auto end_of = [&](const PlannedCase& c) { return &results.runs[c.runs.front()].end; };
  for (const CaseResult& c : results.cases) {
    if (c.plan.is_reference) continue;
    const int k = c.plan.reference;
    const RunEnd* reference = k < 0 ? nullptr : end_of(results.cases[static_cast<std::size_t>(k)].plan);
    Verdict verdict = judge(spec, c.plan, *end_of(c.plan), reference);
    judge_order(spec.curves[static_cast<std::size_t>(c.plan.curve)].end.order_beyond, verdicts, verdict);
    verdicts.push_back(verdict);
  }
  return verdicts;
}

std::string verdict_page(const ExperimentSpec& spec, const std::vector<Verdict>& verdicts) {
  std::string text = "# " + spec.title + "\n\nWritten by `footfall accuracy " +
                     fs::path(spec.file).filename().string() +
                     "`; every line is a test. accurate: against its reference, or by its energy where none is named. "
                     "warned: the run is done, its energy bounded,\n"
                     "its error larger, and it said so. stopped: it ended itself with this message. refused: it did "
                     "not start.\n";
  std::vector<std::string> groups;
  for (const Verdict& v : verdicts)
    if (std::find(groups.begin(), groups.end(), v.group) == groups.end()) groups.push_back(v.group);
  for (const std::string& group : groups) {
    Table table({"case", "value", "verdict", "what was seen"});
    for (const Verdict& v : verdicts)
      if (v.group == group)
        table.add({v.name, v.value, v.found + (v.as_expected ? "" : " (expected: " + v.expected + ")"), v.note});
    text += "\n## " + group + "\n\n" + table.page();
  }
  return text;
}

}  // namespace footfall
