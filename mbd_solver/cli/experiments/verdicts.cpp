#include "mbd_solver/cli/experiments/verdicts.h"

#include <algorithm>
#include <filesystem>
#include <regex>
#include <sstream>

#include "coupler/base/errors.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/errors.h"
#include "mbd_solver/cli/experiments/text.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// More than this, of the reference energy, is a gain: the coupling warns of as much.
constexpr double kGain = 2e-2;

bool starts_with(const std::string& text, const std::string& start) { return text.rfind(start, 0) == 0; }

// Energy of the mechanism and of the interface: whatever is more than at the start plus the work done by motions. What
// the grains did to the bodies is taken as the grains' own account of it.
double energy_gain(const History& h, double reference) {
  if (h.columns.empty() || h.columns.front().empty() || !(reference > 0.0)) return 0.0;
  std::vector<const std::vector<double>*> plus, minus;
  for (std::size_t i = 0; i < h.names.size(); ++i) {
    const std::string& name = h.names[i];
    if (name == "energy.total" || starts_with(name, "dissipated.")) plus.push_back(&h.columns[i]);
    if (name == "work.contact" || name == "work.motion" || name == "coupling.energy_residual")
      minus.push_back(&h.columns[i]);
  }
  double gain = 0.0;
  for (std::size_t row = 0; row < h.columns.front().size(); ++row) {
    double sum = 0.0;
    for (const std::vector<double>* column : plus) sum += (*column)[row] - column->front();
    for (const std::vector<double>* column : minus) sum -= (*column)[row] - column->front();
    gain = std::max(gain, sum);
  }
  return gain / reference;
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

Verdict judge(const ExperimentSpec& spec, const PlannedCase& c, const RunEnd& run, const RunEnd& reference) {
  const CurveSpec& curve = spec.curves[static_cast<std::size_t>(c.curve)];
  const EndSpec& end = curve.end;
  const auto at = std::find(curve.values.begin(), curve.values.end(), c.value) - curve.values.begin();
  Verdict verdict;
  verdict.group = end.group;
  verdict.name = curve.name;
  verdict.value = c.value;
  verdict.expected = end.ends[end.ends.size() == 1 ? 0 : static_cast<std::size_t>(at)];
  if (run.code == kExitFailed || run.code == kExitBadInput) {
    verdict.found = run.message.empty() ? "ended without a message" : run.code == kExitFailed ? "stopped" : "refused";
    verdict.note = shortened(spec, run.message);
  } else if (run.code != kExitDone) {
    verdict.found = run.code == RunEnd::kHung ? "hangs" : "ended with code " + std::to_string(run.code);
    verdict.note = shortened(spec, run.message);
  } else {
    const History history = read_history(run.folder + "/history.csv");
    if (!end.columns.empty()) {
      if (reference.code != kExitDone) throw NumericalError(c.name + ": its reference fails: " + reference.message);
      verdict.error = history_error(history, read_history(reference.folder + "/history.csv"), end.columns, end.at_end);
      verdict.note = "error " + percent(verdict.error) + " %, ";
    }
    const double gain = energy_gain(history, run.summary.value("reference_energy_J", 0.0));
    verdict.note += "gain " + percent(gain) + " %";
    // Without a reference, a warning is taken at its word.
    const bool good = gain <= kGain && (end.columns.empty() ? run.warnings.empty() : verdict.error <= end.tolerance);
    verdict.found = good ? "accurate" : run.warnings.empty() ? "WRONG WITHOUT A WARNING" : "warned";
    if (verdict.found == "warned") verdict.note += "; " + shortened(spec, run.warnings.front());
  }
  verdict.as_expected = verdict.found == verdict.expected;
  if (verdict.as_expected && !end.message.empty() && !mentions(run, end.message)) {
    verdict.as_expected = false;
    verdict.note += "; no message matches " + end.message;
  }
  return verdict;
}

void write_line(std::ostream& out, const Verdict& v) {
  out << "| " << v.name << " | " << v.value << " | " << v.found
      << (v.as_expected ? "" : " (expected: " + v.expected + ")") << " | " << v.note << " |\n";
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

std::vector<Verdict> verdicts_of(const ExperimentSpec& spec, const Plan& plan, const RunStore& store,
                                 const std::vector<std::size_t>& numbers) {
  std::vector<Verdict> verdicts;
  for (const PlannedCase& c : plan.cases) {
    if (c.is_reference) continue;
    RunEnd reference;
    if (c.reference >= 0)
      reference = store.end_of(numbers[plan.cases[static_cast<std::size_t>(c.reference)].runs.front()]);
    Verdict verdict = judge(spec, c, store.end_of(numbers[c.runs.front()]), reference);
    judge_order(spec.curves[static_cast<std::size_t>(c.curve)].end.order_beyond, verdicts, verdict);
    verdicts.push_back(verdict);
  }
  return verdicts;
}

void write_verdicts(const std::string& path, const ExperimentSpec& spec, const std::vector<Verdict>& verdicts) {
  std::ostringstream out;
  out << "# " << spec.title << "\n\nWritten by `footfall accuracy " << fs::path(spec.file).filename().string()
      << "`; every line is a test. accurate: against its reference, or by its energy where none is named. warned: the "
         "run is done, its energy bounded,\n"
         "its error larger, and it said so. stopped: it ended itself with this message. refused: it did not start.\n";
  std::vector<std::string> groups;
  for (const Verdict& v : verdicts)
    if (std::find(groups.begin(), groups.end(), v.group) == groups.end()) groups.push_back(v.group);
  for (const std::string& group : groups) {
    out << "\n## " << group << "\n\n| case | value | verdict | what was seen |\n|---|---|---|---|\n";
    for (const Verdict& v : verdicts)
      if (v.group == group) write_line(out, v);
  }
  write_whole_file(path, out.str());
}

}  // namespace footfall
