// Turns a rig into a sweep whose runs get an additional value, the check, and evaluates finished runs by check and sample.
#include "mbd_solver/studies/rig_command.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "coupler/base/errors.h"
#include "coupler/base/files.h"
#include "coupler/base/text.h"
#include "mbd_solver/app/codes.h"
#include "mbd_solver/app/plot_script.h"
#include "mbd_solver/app/results.h"
#include "mbd_solver/base/quote.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/shipped_files.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/fits.h"
#include "mbd_solver/studies/results.h"
#include "mbd_solver/studies/sweep_file.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

constexpr double kConfidence95 = 0.95, kMoved = 0.05;
constexpr int kSampleDigits = 8;

std::string answer_text(double value) { return std::isfinite(value) ? number_text(value, 4) : "not determined"; }

// "+12 %", relative to the rig without check.
std::string change_text(double mean, double own) {
  if (!std::isfinite(mean) || !std::isfinite(own) || own == 0.0) return "not determined";
  const double share = (mean - own) / std::abs(own);
  return (share < 0.0 ? "" : "+") + share_text(share) + (std::abs(share) > kMoved ? ", above the limit" : "");
}

Table answer_table(const std::vector<RigVariant>& variants) {
  std::vector<std::string> head = {"answer", "unit", "mean", "95 % interval: +-", "samples"};
  for (std::size_t v = 1; v < variants.size(); ++v) head.push_back(variants[v].name);
  Table table(head);
  const std::vector<RigAnswer>& answers = variants.front().samples.front().answers;
  for (std::size_t i = 0; i < answers.size(); ++i) {
    const RigStatistic own = statistic_of(variants.front().samples, i);
    std::vector<std::string> row = {answers[i].name, answers[i].unit, answer_text(own.mean),
                                    std::isfinite(own.interval) ? number_text(own.interval, 2) : "",
                                    std::to_string(own.samples)};
    for (std::size_t v = 1; v < variants.size(); ++v)
      row.push_back(change_text(statistic_of(variants[v].samples, i).mean, own.mean));
    table.add(row);
  }
  return table;
}

// A row per sample of the bed and check: the values of the means. Empty: not determined.
Table sample_table(const std::vector<RigVariant>& variants) {
  std::vector<std::string> head = {"check", "sample"};
  for (const RigAnswer& answer : variants.front().samples.front().answers) head.push_back(answer.name);
  Table table(head);
  for (const RigVariant& variant : variants)
    for (std::size_t k = 0; k < variant.samples.size(); ++k) {
      std::vector<std::string> row = {variant.name.empty() ? "none" : variant.name, std::to_string(k + 1)};
      for (const RigAnswer& answer : variant.samples[k].answers)
        row.push_back(std::isfinite(answer.value) ? number_text(answer.value, kSampleDigits) : "");
      table.add(row);
    }
  return table;
}

// A bound lies within the interval. 1 is no bound, as R^2 cannot exceed it.
bool is_open(const RigClaim& claim, const RigStatistic& s) {
  if (!std::isfinite(s.interval)) return false;
  const auto holds = [&](double bound) { return std::abs(bound - s.mean) < s.interval; };
  return holds(claim.least) || (claim.most != 1.0 && holds(claim.most));
}

std::string claim_lines(const Rig& rig, const RigVariant& own) {
  std::string text;
  const std::vector<RigAnswer>& answers = own.samples.front().answers;
  for (const RigClaim& claim : rig.claims) {
    const auto found =
        std::find_if(answers.begin(), answers.end(), [&](const RigAnswer& a) { return a.name == claim.answer; });
    FOOTFALL_DEMAND(found != answers.end());
    const RigStatistic s = statistic_of(own.samples, found - answers.begin());
    const bool met = s.mean >= claim.least && s.mean <= claim.most;
    text += "| " + claim.text + " (" + claim.source + ") | " + number_text(claim.least) + " to " +
            number_text(claim.most) + " | " + answer_text(s.mean) +
            (std::isfinite(s.interval) ? " +- " + number_text(s.interval, 2) : "") + " | " + (met ? "yes" : "no") +
            (is_open(claim, s) ? ", but within the interval of uncertainty" : "") + " |\n";
  }
  return text.empty() ? text : "\n| law | predicted | measured | agrees |\n|---|---|---|---|\n" + text;
}

// All curves of the rig without checks, one after the other.
std::string draw_curves(const Rig& rig, const RigVariant& own, const std::string& folder, const std::string& title) {
  Table table({"curve", "x", "y"});
  std::vector<std::string> lines;
  std::size_t row = 0;
  const std::string file = std::string(rig.name) + "_curves.csv";
  for (std::size_t k = 0; k < own.samples.size(); ++k) {
    for (std::size_t c = 0; c < own.samples[k].curves.size(); ++c) {
      const RigCurve& curve = own.samples[k].curves[c];
      if (curve.x.empty()) continue;
      const bool line = std::is_sorted(curve.x.begin(), curve.x.end());
      for (std::size_t i = 0; i < curve.x.size(); ++i)
        table.add({curve.name, number_text(curve.x[i], 8), number_text(curve.y[i], 8)});
      lines.push_back(gnuplot_text(file) + " every ::" + std::to_string(row) +
                      "::" + std::to_string(row + curve.x.size() - 1) + " using 2:3 with " + (line ? "lines" : "") +
                      "points ps 0.8 pt " + std::to_string(c + 1) + " lc " + std::to_string(c + 1) +
                      (k == 0 ? " title " + gnuplot_text(curve.name) : " notitle"));
      row += curve.x.size();
    }
  }
  write_whole_file((fs::path(folder) / file).string(), table.csv());
  if (lines.empty()) return "";
  const std::string drawing = "set grid\nset title " + gnuplot_text(title) + " noenhanced\nset xlabel " +
                              gnuplot_text(rig.x_label) + " noenhanced\nset ylabel " + gnuplot_text(rig.y_label) +
                              " noenhanced\nset key outside below noenhanced\nplot " + joined(lines, ", ") + "\n";
  try {
    return joined(run_gnuplot(folder, {write_drawing(folder, rig.name, {900, 620}, csv_setup(), drawing)}), "\n") +
           "\n";
  } catch (const InputError& e) {
    warn_missing_file("picture", e);
    return "";
  }
}

}  // namespace

RigStatistic statistic_of(const std::vector<RigSample>& samples, std::size_t answer) {
  RigStatistic s;
  s.mean = s.interval = std::numeric_limits<double>::quiet_NaN();
  std::vector<double> values;
  for (const RigSample& sample : samples)
    if (answer < sample.answers.size() && std::isfinite(sample.answers[answer].value))
      values.push_back(sample.answers[answer].value);
  s.samples = static_cast<int>(values.size());
  if (values.empty()) return s;
  const SampledMetric sampled = sampled_metric(values);
  s.mean = sampled.mean;
  if (s.samples > 1) s.interval = student_t(kConfidence95, s.samples - 1) * sampled.spread / std::sqrt(s.samples);
  return s;
}

void write_rig(const Rig& rig, const std::vector<RigVariant>& variants, const OutputFolder& output,
               const std::string& title) {
  const Table table = answer_table(variants);
  const auto path = [&](const std::string& end) { return output.path(rig.name + end); };
  std::string page = "## " + title + "\n\nMade by `" + output.command + (output.short_form ? " --short" : "") +
                     "`.\n\n" + table.page();
  if (!output.short_form) page += claim_lines(rig, variants.front());
  write_whole_file(path(".csv"), table.csv());
  write_whole_file(path("_samples.csv"), sample_table(variants).csv());
  write_whole_file(path(".md"), page);
  std::printf("%s\n", page.c_str());
  const std::string pictures = draw_curves(rig, variants.front(), output.folder, title);
  std::printf("%s\n%s%s\n", path(".md").c_str(), pictures.c_str(), path(".csv").c_str());
}

namespace {

constexpr double kEarth = 9.81, kMoon = 1.62, kMars = 3.71;  // [m/s2]

std::string key_of(const std::string& setting) { return setting.substr(0, setting.find('=')); }

// --set would have no effect on keys that the rig varies.
void require_not_varied(const SweepSpec& spec, const std::vector<std::string>& settings) {
  for (const ParameterSpec& parameter : spec.parameters)
    for (const ChoiceSpec& choice : parameter.choices)
      for (const std::string& varied : choice.settings)
        for (const std::string& setting : settings)
          if (key_of(setting) == key_of(varied))
            throw InputError(code::kConflictingKeys,
                             "--set " + setting + ": the rig varies this key itself, as \"" + parameter.name + "\"; " +
                                 (parameter.ensemble ? "set their number with --samples"
                                                     : "edit a copy of " + spec.file + " and use --file"));
}

// Sets the number of samples: the first ones of the file's ensemble; if those are 1, 2, 3 ... there are more.
void set_samples(SweepSpec& spec, int samples) {
  for (ParameterSpec& parameter : spec.parameters) {
    if (!parameter.ensemble || parameter.settings.empty()) continue;
    std::vector<ChoiceSpec>& choices = parameter.choices;
    const int given = static_cast<int>(choices.size());
    if (samples > given && choices.back().name != std::to_string(given))
      throw InputError(code::kWrongOption, "--samples " + std::to_string(samples) + ": " + spec.file + " has " +
                                               std::to_string(given) + " values of \"" + parameter.name +
                                               "\"; add values to a copy and use --file");
    for (int k = given + 1; k <= samples; ++k)
      choices.push_back({std::to_string(k), "", filled(parameter.settings, std::to_string(k))});
    choices.resize(samples);
    parameter.short_choices = parameter.choices;
    return;
  }
  throw InputError(code::kNeedsOtherKey,
                   spec.file + ": --samples requires [[parameters]] with ensemble = true, settings and values");
}

// Before the runs, which take hours.
void require_scenes(const Plan& plan, const Rig& rig) {
  for (const RunRequest& run : plan.runs) {
    const Scene scene = read_scene(run.scene, run.settings);
    box_of(scene);
    rig.require(scene);
  }
}

// Repeats every run for each check, whose name is the last of its values; empty without checks.
void add_variations(Plan& plan, const Rig& rig, bool with_checks) {
  const std::size_t own = plan.runs.size();
  for (std::size_t i = 0; i < own; ++i) {
    plan.runs[i].values.emplace_back();
    if (!with_checks) continue;
    const RunRequest run = plan.runs[i];
    const Scene scene = read_scene(run.scene, run.settings);
    for (const RigVariation& check : rig.variations(scene, rig.slow)) {
      RunRequest again = run;
      again.name = check.name;
      std::replace(again.name.begin(), again.name.end(), ' ', '_');
      again.name += "__" + run.name;
      append(again.settings, check.settings);
      again.values.back() = check.name;
      plan.runs.push_back(again);
    }
  }
}

// The finished runs, by check and sample. Leaves out, and reports, samples with a missing run.
std::vector<RigVariant> variants_of(const Rig& rig, const SweepSpec& spec, const Plan& plan, const Results& results) {
  struct VariantRuns {
    std::string check;
    std::vector<RigRun> runs;
    bool whole = true;
  };
  std::vector<std::pair<std::string, VariantRuns>> groups;  // by the values of check and ensemble, in their order
  for (std::size_t i = 0; i < plan.runs.size(); ++i) {
    const RunRequest& request = plan.runs[i];
    const std::string check = request.values.back();
    std::string key = check + "\n", name;
    for (std::size_t p = 0; p < spec.parameters.size(); ++p) {
      const ParameterSpec& parameter = spec.parameters[p];
      if (parameter.ensemble)
        key += request.values[p] + "\n";
      else
        name += (name.empty() ? "" : ", ") + parameter.name + " " + request.values[p];
    }
    auto group = std::find_if(groups.begin(), groups.end(), [&](const auto& g) { return g.first == key; });
    if (group == groups.end()) group = groups.insert(group, {key, VariantRuns{check, {}, true}});
    if (!results.runs[i].end.done()) {
      std::printf("%s ended with exit code %d: %s; its sample of the bed is left out\n", request.name.c_str(),
                  results.runs[i].end.code, results.runs[i].end.message.c_str());
      group->second.whole = false;
      continue;
    }
    group->second.runs.push_back(
        {name.empty() ? rig.name : name, results.runs[i].end.folder, read_scene(request.scene, request.settings)});
  }
  std::vector<RigVariant> variants;
  for (const auto& [key, group] : groups) {
    auto variant = std::find_if(variants.begin(), variants.end(),
                                [&, check = group.check](const RigVariant& v) { return v.name == check; });
    if (variant == variants.end()) variant = variants.insert(variant, {group.check, {}});
    if (group.whole) variant->samples.push_back(rig.evaluate(group.runs));
  }
  return variants;
}

}  // namespace

std::string gravity_setting(const std::string& name) {
  double g = 0.0;
  if (name == "earth") g = kEarth;
  if (name == "moon") g = kMoon;
  if (name == "mars") g = kMars;
  if (g == 0.0) g = number_in(name).value_or(0.0);
  if (!(g > 0.0))
    throw InputError(code::kRigGravity,
                     "--gravity " + name + ": expected earth, moon, mars, or a number above zero [m/s2]");
  return "gravity=[0,0," + number_text(-g) + "]";
}

int rig_command(const RigArguments& a) {
  const Rig& rig = rig_named(a.name);
  std::vector<std::string> settings = a.settings;
  if (!a.gravity.empty()) settings.push_back(gravity_setting(a.gravity));
  SweepArguments e = a;
  if (a.file.empty()) e.file = shipped_file(std::string("inputs/rigs/") + rig.name + ".toml");
  e.again = {"rig", a.name};
  if (!a.file.empty()) append(e.again, {"--file", a.file});
  for (const std::string& setting : a.settings) append(e.again, {"--set", setting});
  if (!a.gravity.empty()) append(e.again, {"--gravity", a.gravity});
  if (a.samples > 0) append(e.again, {"--samples", std::to_string(a.samples)});
  if (a.checks) e.again.push_back("--checks");
  e.change = [&](SweepSpec& spec) {
    if (!spec.curves.empty() || spec.parameters.empty())
      throw InputError(code::kRigRuns, spec.file + ": a rig requires [[parameters]], without [[curves]]");
    require_not_varied(spec, settings);
    append(spec.settings, settings);
    append(spec.short_form.settings, settings);
    if (a.samples > 0) set_samples(spec, a.samples);
  };
  e.extend = [&](Plan& plan) {
    require_scenes(plan, rig);
    add_variations(plan, rig, a.checks);
  };
  e.write = [&](const SweepSpec& spec, const Plan& plan, const Results& results, const OutputFolder& output) {
    const std::vector<RigVariant> variants = variants_of(rig, spec, plan, results);
    if (variants.empty() || variants.front().samples.empty())
      throw InputError(code::kRigRuns, output.folder + ": no sample of the bed has all its runs, nothing to evaluate");
    write_rig(rig, variants, output, spec.title);
    return results.all_done();
  };
  return sweep_command(e);
}

}  // namespace footfall
