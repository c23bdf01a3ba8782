#include "mbd_solver/cli/experiments/verdicts.h"

#include <algorithm>
#include <filesystem>
#include <regex>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/experiments/table.h"

namespace footfall {

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
