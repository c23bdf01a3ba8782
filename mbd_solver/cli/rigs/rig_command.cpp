#include "mbd_solver/cli/rigs/rig_command.h"

#include <algorithm>
#include <cstdio>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/cli/experiments/experiment.h"
#include "mbd_solver/cli/experiments/experiment_command.h"
#include "mbd_solver/cli/experiments/results.h"
#include "mbd_solver/cli/experiments/table.h"
#include "mbd_solver/cli/rigs/rig_curves.h"
#include "mbd_solver/cli/rigs/rig_output.h"
#include "mbd_solver/scene/findings.h"
#include "mbd_solver/scene/scene_reader.h"
#include "mbd_solver/scene/shipped_files.h"

namespace footfall {

namespace {

constexpr double kEarth = 9.81, kMoon = 1.62, kMars = 3.71;  // [m/s2]

std::string key_of(const std::string& setting) { return setting.substr(0, setting.find('=')); }

// What the rig varies itself would silently win over --set.
void demand_free(const ExperimentSpec& spec, const std::vector<std::string>& settings) {
  for (const ParameterSpec& parameter : spec.parameters)
    for (const ChoiceSpec& choice : parameter.choices)
      for (const std::string& varied : choice.settings)
        for (const std::string& setting : settings)
          if (key_of(setting) == key_of(varied))
            throw InputError("--set " + setting + ": the rig varies this key itself, as its \"" + parameter.name +
                             "\"; " +
                             (parameter.ensemble ? "--samples says how many there are"
                                                 : "copy " + spec.file + ", edit it, and give it by --file"));
}

// So many samples of the bed: the first ones of the file's one ensemble. Where those are 1, 2, 3 ... there are more.
void take_samples(ExperimentSpec& spec, int samples) {
  for (ParameterSpec& parameter : spec.parameters) {
    if (!parameter.ensemble || parameter.settings.empty()) continue;
    std::vector<ChoiceSpec>& choices = parameter.choices;
    const int given = static_cast<int>(choices.size());
    if (samples > given && choices.back().name != std::to_string(given))
      throw InputError("--samples " + std::to_string(samples) + ": " + spec.file + " names " + std::to_string(given) +
                       " values of its \"" + parameter.name + "\"; copy it, add values, and give it by --file");
    for (int k = given + 1; k <= samples; ++k)
      choices.push_back({std::to_string(k), "", filled(parameter.settings, std::to_string(k))});
    choices.resize(static_cast<std::size_t>(samples));
    parameter.short_choices = parameter.choices;
    return;
  }
  throw InputError(spec.file + ": --samples needs [[parameters]] with ensemble = true, settings and values");
}

// An evaluation that fails after hours of runs has lost them.
void demand_scenes(const Plan& plan, const Rig& rig) {
  for (const RunRequest& run : plan.runs) {
    const Scene scene = read_scene(run.scene, run.settings);
    box_of(scene);
    rig.demand(scene);
  }
}

// Every run again for each check, whose name is the last of its values; without checks they are empty.
void add_checks(Plan& plan, const Rig& rig, bool wanted) {
  const std::size_t own = plan.runs.size();
  for (std::size_t i = 0; i < own; ++i) {
    plan.runs[i].values.emplace_back();
    if (!wanted) continue;
    const RunRequest run = plan.runs[i];
    const Scene scene = read_scene(run.scene, run.settings);
    for (const RigCheck& check : rig.checks(scene, rig.slow)) {
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

// The finished runs, by check and sample. A sample of which a run is missing is left out, and said so.
std::vector<RigVariant> variants_of(const Rig& rig, const ExperimentSpec& spec, const Plan& plan,
                                    const Results& results) {
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
      std::printf("%s ended with code %d: %s; its sample of the bed is left out\n", request.name.c_str(),
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
  if (!(g > 0.0)) throw InputError("--gravity " + name + ": expected earth, moon, mars, or a number of m/s2 above 0");
  return "gravity=[0,0," + number_text(-g) + "]";
}

int rig_command(const RigArguments& a) {
  const Rig& rig = rig_named(a.name);
  std::vector<std::string> settings = a.settings;
  if (!a.gravity.empty()) settings.push_back(gravity_setting(a.gravity));
  ExperimentArguments e;
  e.command = "rig";
  e.file = a.file.empty() ? shipped_file(std::string("inputs/rigs/") + rig.name + ".toml") : a.file;
  e.out = a.out;
  e.runs = "runs/rigs";
  e.jobs = a.jobs;
  e.only = a.only;
  e.resume = true;
  e.short_form = a.short_form;
  e.list = a.list;
  e.again = {"rig", a.name};
  if (!a.file.empty()) append(e.again, {"--file", a.file});
  for (const std::string& setting : a.settings) append(e.again, {"--set", setting});
  if (!a.gravity.empty()) append(e.again, {"--gravity", a.gravity});
  if (a.samples > 0) append(e.again, {"--samples", std::to_string(a.samples)});
  if (a.checks) e.again.push_back("--checks");
  e.change = [&](ExperimentSpec& spec) {
    if (!spec.curves.empty() || spec.growth || spec.parameters.empty())
      throw InputError(spec.file + ": a rig is made of [[parameters]]");
    demand_free(spec, settings);
    append(spec.settings, settings);
    append(spec.short_form.settings, settings);
    if (a.samples > 0) take_samples(spec, a.samples);
  };
  e.extend = [&](Plan& plan) {
    demand_scenes(plan, rig);
    add_checks(plan, rig, a.checks);
  };
  e.write = [&](const ExperimentSpec& spec, const Plan& plan, const Results& results, const std::string& folder,
                const std::string& command) {
    const std::vector<RigVariant> variants = variants_of(rig, spec, plan, results);
    if (variants.empty() || variants.front().samples.empty())
      throw InputError(folder + ": no sample of the bed has all its runs; nothing to evaluate");
    write_rig(rig, variants, folder, spec.title, command + (a.short_form ? " --short" : ""), !a.short_form);
    return results.all_done();
  };
  return experiment_command(e);
}

}  // namespace footfall
