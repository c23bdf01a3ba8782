#include "mbd_solver/cli/experiments/stability_map.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <regex>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "coupler/base/text.h"
#include "coupler/base/whole_file.h"
#include "mbd_solver/cli/experiments/study_error.h"
#include "mbd_solver/cli/experiments/study_run.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// More than this, of the reference energy, is a gain: the coupling warns of as much.
constexpr double kGain = 2e-2;

std::string percent(double share) { return number_text(100.0 * share, 2) + " %"; }

std::string scene_path(const StudySpec& study, const std::string& scene) {
  return (fs::path(study.folder) / scene).lexically_normal().string();
}

// Longer messages are cut where a sentence or clause ends; files are named from the folder of the inputs on.
std::string shortened(const StudySpec& study, std::string text) {
  constexpr std::size_t most = 110;
  const std::string inputs = fs::path(study.folder).parent_path().string() + "/";
  for (std::size_t at = text.find(inputs); at != std::string::npos; at = text.find(inputs))
    text.erase(at, inputs.size());
  std::replace(text.begin(), text.end(), '|', '/');
  if (text.size() <= most) return text;
  const std::size_t end = text.find_last_of(":;,", most);
  return text.substr(0, end == std::string::npos || end < 40 ? most : end) + " ...";
}

bool mentions(const StudyRun& run, const std::string& pattern) {
  const std::regex expression(pattern);
  if (std::regex_search(run.message, expression)) return true;
  return std::any_of(run.warnings.begin(), run.warnings.end(),
                     [&](const std::string& warning) { return std::regex_search(warning, expression); });
}

Verdict judge(const StudySpec& study, const CaseSpec& spec, std::size_t index, const std::string& out) {
  const std::string value = spec.values.empty() ? "" : spec.values[index];
  Verdict verdict{spec.group, spec.name, value, spec.expect.size() == 1 ? spec.expect[0] : spec.expect[index], "", "",
                  0.0,        0.0,       false};
  StudyRunRequest request;
  request.scene = scene_path(study, spec.scene.empty() ? study.scene : spec.scene);
  request.settings = study.settings;
  const std::vector<std::string> own = filled(spec.settings, value);
  request.settings.insert(request.settings.end(), own.begin(), own.end());
  request.until = spec.until;
  request.time_limit = study.time_limit;
  request.out = (fs::path(out) / (spec.name + (value.empty() ? "" : "_" + value))).string();
  const StudyRun run = run_once(request);
  verdict.wall = run.wall;

  if (run.code == 1 || run.code == 2) {
    verdict.found = run.message.empty() ? "ended without a message" : run.code == 1 ? "stopped" : "refused";
    verdict.note = shortened(study, run.message);
  } else if (run.code != 0) {
    verdict.found = run.code == StudyRun::kHung ? "hangs" : "ended with code " + std::to_string(run.code);
    verdict.note = shortened(study, run.message);
  } else {
    double error = 0.0;
    if (!spec.columns.empty()) {
      StudyRunRequest exact = request;
      exact.out += "_reference";
      const std::vector<std::string> more = filled(spec.reference, value);
      exact.settings.insert(exact.settings.end(), more.begin(), more.end());
      const StudyRun reference = run_once(exact);
      if (reference.code != 0)
        throw NumericalError("case " + spec.name + " " + value + ": its reference fails: " + reference.message);
      error = history_error(run.history, reference.history, spec.columns, spec.at_end);
      verdict.error = error;
      verdict.note = "error " + percent(error) + ", ";
    }
    verdict.note += "gain " + percent(run.gain);
    // Without a reference, a warning is taken at its word.
    const bool good = run.gain <= kGain && (spec.columns.empty() ? run.warnings.empty() : error <= spec.tolerance);
    verdict.found = good ? "accurate" : run.warnings.empty() ? "WRONG WITHOUT A WARNING" : "warned";
    if (verdict.found == "warned") verdict.note += "; " + shortened(study, run.warnings.front());
  }
  verdict.as_expected = verdict.found == verdict.expected;
  if (verdict.as_expected && !spec.message.empty() && !mentions(run, spec.message)) {
    verdict.as_expected = false;
    verdict.note += "; no message matches " + spec.message;
  }
  return verdict;
}

void write_line(std::ostream& out, const Verdict& v) {
  out << "| " << v.name << " | " << v.value << " | " << v.found
      << (v.as_expected ? "" : " (expected: " + v.expected + ")") << " | " << v.note << " |\n";
}

// Of first order at most: beyond value order_beyond no error is larger than that of an earlier such value times the
// ratio of the values.
void judge_order(const CaseSpec& spec, const std::vector<Verdict>& earlier, Verdict& verdict) {
  const double x = std::atof(verdict.value.c_str());
  if (spec.order_beyond <= 0.0 || x < spec.order_beyond) return;
  for (const Verdict& v : earlier) {
    const double y = std::atof(v.value.c_str());
    if (v.name != verdict.name || y < spec.order_beyond || v.error <= 0.0 || verdict.error <= v.error * x / y) continue;
    verdict.as_expected = false;
    verdict.note += "; grew from " + percent(v.error) + " at " + v.value + ", faster than in proportion";
    return;
  }
}

}  // namespace

std::vector<Verdict> run_map(const StudySpec& study, const std::string& only, const std::string& out) {
  std::vector<Verdict> verdicts;
  std::vector<std::string> names;
  for (const CaseSpec& spec : study.cases) {
    names.push_back(spec.name);
    if (!only.empty() && spec.name != only) continue;
    for (std::size_t i = 0; i < std::max<std::size_t>(1, spec.values.size()); ++i) {
      Verdict judged = judge(study, spec, i, out);
      judge_order(spec, verdicts, judged);
      verdicts.push_back(judged);
      const Verdict& v = verdicts.back();
      std::printf("%-9s %-28s %-10s %-9s %s\n", v.as_expected ? "ok" : "NOT SO", v.name.c_str(), v.value.c_str(),
                  v.found.c_str(), v.note.c_str());
      std::fflush(stdout);
    }
  }
  if (verdicts.empty())
    throw InputError(study.file + ": no case \"" + only + "\"." + known_names("cases", only, names));
  return verdicts;
}

void write_map(const std::string& path, const StudySpec& study, const std::vector<Verdict>& verdicts) {
  std::ofstream out = open_to_write(path);
  out << "# " << study.title << "\n\nWritten by `footfall accuracy " << fs::path(study.file).filename().string()
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
}

}  // namespace footfall
