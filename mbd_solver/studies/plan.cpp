// Combines values of parameters and curves into runs; runs that differ only in members of the ensemble are one case.
#include "mbd_solver/studies/plan.h"

#include <algorithm>
#include <cctype>
#include <set>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {
namespace {

constexpr std::size_t kLongest = 200;  // characters of a folder's name: the system allows 255, with ".done.json"

// As a part of a folder's name, without blanks, at which LIGGGHTS splits paths.
std::string file_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-' && c != '+') c = '_';
  if (!text.empty() && text.front() == '.') text.front() = '_';
  return text;
}

// One choice of every parameter.
struct Combination {
  std::string name;   // of a folder
  std::string group;  // the choices, without ensembles
  std::string scene;  // empty: not changed
  std::vector<std::string> values, settings;
};

std::vector<Combination> combinations_of(const std::vector<ParameterSpec>& parameters, bool short_form) {
  std::vector<Combination> all = {{}};
  for (const ParameterSpec& parameter : parameters) {
    if (parameter.is_drawn()) continue;
    std::vector<Combination> longer;
    for (const Combination& combination : all) {
      for (const ChoiceSpec& choice : short_form ? parameter.short_choices : parameter.choices) {
        Combination next = combination;
        next.name += (next.name.empty() ? "" : "__") + file_name(parameter.name) + "_" + file_name(choice.name);
        if (!parameter.ensemble) next.group += (next.group.empty() ? "" : ", ") + parameter.name + " " + choice.name;
        if (!choice.scene.empty()) next.scene = choice.scene;
        next.values.push_back(choice.name);
        append(next.settings, choice.settings);
        longer.push_back(next);
      }
    }
    all.swap(longer);
  }
  return all;
}

// The settings of one value of the curve.
std::vector<std::string> settings_of(const CurveSpec& curve, std::vector<std::string> settings,
                                     const std::string& value) {
  const auto at = std::find(curve.values.begin(), curve.values.end(), value) - curve.values.begin();
  settings = filled(std::move(settings), value);
  return curve.beside.empty() ? settings : filled(settings, curve.beside[at], "{beside}");
}

// Before the runs take memory.
const SweepSpec& with_limited_size(const SweepSpec& spec, bool short_form) {
  double combinations = 1.0, values = spec.curves.empty() ? 1.0 : 0.0;
  for (const ParameterSpec& parameter : spec.parameters)
    if (!parameter.is_drawn())
      combinations *= static_cast<double>((short_form ? parameter.short_choices : parameter.choices).size());
  for (const CurveSpec& curve : spec.curves)
    values += static_cast<double>((short_form ? curve.short_values : curve.values).size());
  if (combinations * values > kMostRuns)
    throw InputError(code::kTooManyRuns, spec.file + ": has " + number_text(combinations * values, 3) +
                                             " runs, expected at most " + number_text(kMostRuns) +
                                             "; give fewer values, or use several files");
  return spec;
}

class Planner {
 public:
  Planner(const SweepSpec& spec, bool short_form)
      : spec_(with_limited_size(spec, short_form)),
        short_(short_form),
        combinations_(combinations_of(spec.parameters, short_form)) {}

  Plan plan() {
    if (!spec_.curves.empty()) plan_.members = combinations_.size();
    int common = -1;
    if (spec_.reference && !spec_.is_map()) common = add_reference("reference", -1, {}, "", 0.0);
    if (spec_.curves.empty()) {
      PlannedCase shape;
      shape.reference = common;
      add("", shape, spec_.scene, {}, 0.0);
    }
    for (std::size_t k = 0; k < spec_.curves.size(); ++k) add_curve(k, common);
    std::set<std::string> names;
    for (const RunRequest& run : plan_.runs) {
      if (run.name.size() > kLongest)
        throw InputError(code::kRunName, spec_.file + ": the run \"" + run.name.substr(0, 60) + "...\" has a name of " +
                                             std::to_string(run.name.size()) + " characters, expected at most " +
                                             std::to_string(kLongest) +
                                             " for a folder; shorten names of parameters and choices");
      if (!names.insert(run.name).second)
        throw InputError(code::kRunName,
                         spec_.file + ": two runs are named \"" + run.name + "\"; give their choices different names");
    }
    return plan_;
  }

 private:
  void add_curve(std::size_t k, int common) {
    const CurveSpec& curve = spec_.curves[k];
    const bool varies = settings_of(curve, curve.reference, curve.values.front()) != curve.reference;
    int own = -1;
    for (const std::string& value : short_ ? curve.short_values : curve.values) {
      if (!curve.reference.empty() && (own < 0 || varies))
        own = add_reference(curve.name + (varies ? "_" + value : ""), static_cast<int>(k),
                            settings_of(curve, curve.reference, value), curve.scene, curve.until);
      PlannedCase shape;
      shape.name = curve.name + (value.empty() ? "" : " " + value);
      shape.curve = static_cast<int>(k);
      shape.value = value;
      shape.x = curve.scale * number_in(value).value_or(0.0);
      shape.reference = own >= 0 ? own : common;
      add(curve.name + (value.empty() ? "" : "_" + value), shape, curve.scene.empty() ? spec_.scene : curve.scene,
          settings_of(curve, curve.settings, value), curve.until);
    }
  }

  int add_reference(const std::string& name, int curve, const std::vector<std::string>& more, const std::string& scene,
                    double until) {
    const ReferenceSpec common = spec_.reference.value_or(ReferenceSpec{});
    std::vector<std::string> settings = common.settings;
    append(settings, more);
    PlannedCase shape;
    shape.name = curve < 0 ? name : name + " reference";
    shape.curve = curve;
    shape.value = "reference";
    shape.is_reference = true;
    const std::string own = !common.scene.empty() ? common.scene : !spec_.scene.empty() ? spec_.scene : scene;
    add(curve < 0 ? name : name + "_reference", shape, own, settings, until);
    return static_cast<int>(plan_.cases.size()) - 1;
  }

  // The runs of all combinations; those that differ by more than the ensemble are separate cases.
  void add(const std::string& name, const PlannedCase& shape, const std::string& scene,
           const std::vector<std::string>& settings, double until) {
    const std::size_t first = plan_.cases.size();
    for (const Combination& combination : combinations_) {
      PlannedCase mine = shape;
      mine.name += combination.group;
      auto found = std::find_if(plan_.cases.begin() + static_cast<std::ptrdiff_t>(first), plan_.cases.end(),
                                [&](const PlannedCase& c) { return c.name == mine.name; });
      if (found == plan_.cases.end()) found = plan_.cases.insert(found, mine);
      found->runs.push_back(plan_.runs.size());
      RunRequest r;
      r.name = file_name(name) + (name.empty() || combination.name.empty() ? "" : "__") + combination.name;
      r.scene = combination.scene.empty() ? scene : combination.scene;
      r.settings = spec_.settings;
      if (short_) append(r.settings, spec_.short_form.settings);
      append(r.settings, settings);
      append(r.settings, combination.settings);
      r.until = until > 0.0 ? until : short_ && spec_.short_form.until > 0.0 ? spec_.short_form.until : spec_.until;
      r.time_limit = spec_.time_limit;
      r.repeats = shape.is_reference || short_ ? 1 : spec_.repeats;
      r.may_be_refused = spec_.is_map();
      r.values = combination.values;
      plan_.runs.push_back(r);
    }
  }

  const SweepSpec& spec_;
  bool short_;
  std::vector<Combination> combinations_;
  Plan plan_;
};

}  // namespace

std::vector<std::string> filled(std::vector<std::string> texts, const std::string& value, const std::string& mark) {
  for (std::string& text : texts)
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size()))
      text.replace(at, mark.size(), value);
  return texts;
}

Plan plan_of(const SweepSpec& spec, bool short_form) {
  Plan plan = Planner(spec, short_form).plan();
  for (RunRequest& run : plan.runs) run.trusted = spec.trusted;
  return plan;
}

}  // namespace footfall
