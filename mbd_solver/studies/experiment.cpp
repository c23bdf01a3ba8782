// The keys of an experiment's file, described as those of a scene are (scene/field_visitor.h).
#include "mbd_solver/studies/experiment.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/named_file.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/studies/plan.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {
namespace {

const Rule kAny{};
const Rule kRequired{Unit::kNone, Range::kAny, Meaning::kPlain, true};
const Rule kWords{Unit::kNone, Range::kAny, Meaning::kWords};
const Rule kName{Unit::kNone, Range::kAny, Meaning::kWords, true};
const Rule kFileName{Unit::kNone, Range::kAny, Meaning::kName, true};
const Rule kPositive{Unit::kNone, Range::kPositive};
const Rule kNotNegative{Unit::kNone, Range::kNotNegative};

struct KeyedMember {
  const char* key;
  FieldRef member;
};

// Keys of one rule.
void fields(FieldVisitor& v, const Rule& rule, const std::vector<KeyedMember>& list) {
  for (const KeyedMember& one : list) v.field(one.key, one.member, rule);
}

}  // namespace

static void visit_fields(FieldVisitor& v, ChoiceSpec& c) {
  fields(v, kName, {{"name", &c.name}});
  fields(v, kWords, {{"settings", &c.settings}});
  fields(v, kAny, {{"scene", &c.scene}});
}

static void visit_fields(FieldVisitor& v, ParameterSpec& p) {
  fields(v, kAny, {{"", &p.source}, {"ensemble", &p.ensemble}});
  fields(v, kName, {{"name", &p.name}});
  fields(v, kWords, {{"settings", &p.settings}, {"values", &p.values}, {"short", &p.short_values}});
  v.list("choices", p.choices);
}

static void visit_fields(FieldVisitor& v, CurveSpec& c) {
  fields(v, kAny, {{"", &c.source}, {"scene", &c.scene}, {"scale", &c.scale}});
  fields(v, kName, {{"name", &c.name}});
  fields(v, kWords, {{"settings", &c.settings}, {"reference", &c.reference}, {"default", &c.default_value}});
  fields(v, kWords, {{"values", &c.values}, {"short", &c.short_values}, {"beside", &c.beside}});
  fields(v, kNotNegative, {{"until", &c.until}});
  EndSpec& e = c.end;
  fields(v, kWords, {{"ends", &e.ends}, {"columns", &e.columns}});
  fields(v, kAny, {{"group", &e.group}, {"message", &e.message}, {"at_end", &e.at_end}});
  fields(v, kNotNegative, {{"tolerance", &e.tolerance}, {"order_beyond", &e.order_beyond}});
}

static void visit_fields(FieldVisitor& v, ReferenceSpec& r) {
  fields(v, kAny, {{"scene", &r.scene}});
  fields(v, kWords, {{"settings", &r.settings}});
}

static void visit_fields(FieldVisitor& v, ShortSpec& s) {
  fields(v, kNotNegative, {{"until", &s.until}});
  fields(v, kWords, {{"settings", &s.settings}});
}

static void visit_fields(FieldVisitor& v, GrowthSpec& g) {
  fields(v, kPositive, {{"omega_h", &g.omega_h}, {"short", &g.short_omega_h}, {"substeps", &g.substeps}});
}

void visit_fields(FieldVisitor& v, FigureSpec& f) {
  fields(v, kAny, {{"", &f.source}, {"key", &f.key}, {"average", &f.average}, {"over", &f.over}});
  fields(v, kName, {{"name", &f.name}});
  fields(v, kWords, {{"columns", &f.columns}});
  fields(v, kAny, {{"slope", &f.slope}});
  fields(v, kNotNegative, {{"prominence", &f.prominence}, {"until", &f.until}});
  v.choice("reduce", f.reduction);
  v.choice("error", f.error);
}

static void visit_fields(FieldVisitor& v, LimitSpec& l) {
  fields(v, kAny, {{"", &l.source}});
  fields(v, kRequired, {{"figure", &l.figure}, {"most", &l.most}});
}

static void visit_fields(FieldVisitor& v, PrintedSpec& p) {
  fields(v, kAny, {{"", &p.source}});
  fields(v, kName, {{"name", &p.name}});
  fields(v, kWords, {{"values", &p.values}});
}

static void visit_fields(FieldVisitor& v, StatementSpec& s) {
  fields(v, kAny, {{"", &s.source}, {"text", &s.text}, {"why", &s.why}, {"case", &s.of_case}, {"against", &s.against}});
  fields(v, kRequired, {{"figure", &s.figure}});
  fields(v, kAny, {{"least", &s.least}, {"most", &s.most}});
  fields(v, kAny, {{"curve", &s.curve}, {"order", &s.order}, {"error", &s.error}});
}

static void visit_fields(FieldVisitor& v, PlotSpec& p) {
  fields(v, kFileName, {{"name", &p.name}});
  fields(v, kRequired, {{"column", &p.column}});
  fields(v, kAny, {{"title", &p.title}, {"label", &p.label}});
}

static void visit_fields(FieldVisitor& v, FitFactor& f) {
  fields(v, kAny, {{"", &f.source}, {"published", &f.published}});
  fields(v, kRequired, {{"name", &f.name}});
  fields(v, kWords, {{"sum", &f.sum}});
}

static void visit_fields(FieldVisitor& v, FitSpec& f) {
  fields(v, kAny, {{"", &f.source}, {"label", &f.label}, {"marks", &f.marks}});
  fields(v, kWords, {{"where", &f.where}});
  fields(v, kFileName, {{"name", &f.name}});
  fields(v, kRequired, {{"figure", &f.figure}});
  v.list("factors", f.factors);
}

void visit_fields(FieldVisitor& v, ExperimentSpec& s) {
  fields(v, kAny, {{"", &s.source}, {"title", &s.title}, {"x_name", &s.x_name}, {"scene", &s.scene}});
  fields(v, kAny, {{"minimise", &s.minimise}});
  fields(v, kWords, {{"settings", &s.settings}});
  fields(v, kNotNegative, {{"until", &s.until}, {"time_limit", &s.time_limit}});
  fields(v, kPositive, {{"repeats", &s.repeats}});
  v.section("short", s.short_form);
  v.section("reference", s.reference);
  v.section("growth", s.growth);
  v.list("parameters", s.parameters);
  v.list("curves", s.curves);
  v.list("figures", s.figures);
  v.list("limits", s.limits);
  v.list("printed", s.printed);
  v.list("statements", s.statements);
  v.list("expect", s.expected);
  v.list("plots", s.plots);
  v.list("fits", s.fits);
}

std::string experiment_schema() {
  ExperimentSpec defaults;
  return schema_of("Experiment of footfall", [&](FieldVisitor& v) { visit_fields(v, defaults); });
}

namespace fs = std::filesystem;

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// What follows from the file's own words, and what cannot be.
class Checker {
 public:
  Checker(ExperimentSpec& spec, Findings& findings) : spec_(spec), findings_(findings) {}

  // What is wrong here leaves the checks without ground.
  void complete() {
    for (ParameterSpec& parameter : spec_.parameters) complete(parameter);
    for (CurveSpec& curve : spec_.curves) complete(curve);
    for (StatementSpec& statement : spec_.statements) complete(statement);
    for (FitSpec& fit : spec_.fits) complete(fit);
    find_scenes();
    findings_.throw_if_errors();
  }

  void check() {
    check_runs();
    check_figures();
    for (const FitSpec& fit : spec_.fits) check(fit);
    findings_.throw_if_errors();
    const std::vector<std::string> cases = names_in(plan_of(spec_, false).cases);
    for (const StatementSpec& statement : spec_.statements) check(statement, cases);
    findings_.throw_if_errors();
  }

 private:
  void wrong(const Source& at, const std::string& key, const std::string& what) { findings_.error(at, key, what); }

  void complete(ParameterSpec& p) {
    if (p.values.empty() == p.choices.empty())
      wrong(p.source, "values", "expected either values with settings that hold {value}, or choices");
    if (!p.values.empty() && p.settings.empty())
      wrong(p.source, "settings",
            "are missing; expected what {value} goes into, such as \"initial.velocity=[0,0,{value}]\"");
    for (const std::string& value : p.values) p.choices.push_back({value, "", filled(p.settings, value)});
    for (const std::string& name : p.short_values) {
      const int k = index_of(p.choices, name);
      if (k < 0)
        wrong(p.source, "short", "has \"" + name + "\", expected some of the values");
      else
        p.short_choices.push_back(p.choices[static_cast<std::size_t>(k)]);
    }
    if (p.short_choices.empty() && !p.choices.empty()) p.short_choices = {p.choices.front()};
  }

  void complete(CurveSpec& c) {
    const std::vector<std::string>& ends = c.end.ends;
    if (c.values.empty() && !ends.empty()) c.values = {""};  // one run
    if (c.values.empty()) return wrong(c.source, "values", "are missing");
    if (c.short_values == CurveSpec().short_values) c.short_values = {c.values.front()};
    if (ends.size() > 1 && ends.size() != c.values.size())
      wrong(c.source, "ends", "expected one way to end for all, or one per value");
    for (const std::string& end : ends)
      if (!is_in({"accurate", "warned", "stopped", "refused"}, end))
        wrong(c.source, "ends", "is \"" + end + "\", expected accurate, warned, stopped or refused");
    if (!c.beside.empty() && c.beside.size() != c.values.size())
      wrong(c.source, "beside",
            "has " + std::to_string(c.beside.size()) + " entries, expected one for each of the " +
                std::to_string(c.values.size()) + " values");
    for (const std::string& value : c.short_values)
      if (!is_in(c.values, value)) wrong(c.source, "short", "has \"" + value + "\", expected some of the values");
    if (!c.default_value.empty() && !is_in(c.values, c.default_value))
      wrong(c.source, "default", "is \"" + c.default_value + "\", expected one of the values");
  }

  void complete(StatementSpec& s) {
    if (s.curve.empty()) {
      if (s.text.empty()) wrong(s.source, "text", "is missing");
      if (s.of_case.empty()) wrong(s.source, "case", "is missing");
      if (std::isinf(s.least) && std::isinf(s.most)) wrong(s.source, "least", "expected least, most or both");
      if (s.least > s.most) wrong(s.source, "most", "is less than least");
      return;
    }
    if (s.order.empty() != s.error.has_value())
      wrong(s.source, "curve", "expected order = [least, most] or error = most");
    if (!s.order.empty() && s.order.size() != 2) wrong(s.source, "order", "expected [least, most]");
    if (s.error) s.most = *s.error;
    if (s.order.size() == 2) s.least = s.order[0], s.most = s.order[1];
    if (s.least > s.most) wrong(s.source, "order", "is [most, least], expected the smaller number first");
    if (s.text.empty()) s.text = s.curve + ", " + s.figure;
  }

  void complete(FitSpec& f) {
    if (f.label.empty()) f.label = f.figure;
    if (f.factors.empty()) wrong(f.source, "factors", "are missing");
    for (FitFactor& factor : f.factors)
      if (factor.sum.empty()) factor.sum = {factor.name};
  }

  // Scenes stand beside the file.
  void find_scenes() {
    const auto find = [&](std::string& scene) {
      if (!scene.empty()) scene = (fs::path(spec_.folder) / scene).lexically_normal().string();
    };
    find(spec_.scene);
    if (spec_.reference) find(spec_.reference->scene);
    for (CurveSpec& curve : spec_.curves) find(curve.scene);
    for (ParameterSpec& parameter : spec_.parameters)
      for (auto* choices : {&parameter.choices, &parameter.short_choices})
        for (ChoiceSpec& choice : *choices) find(choice.scene);
  }

  void check_runs() {
    if (spec_.growth) {
      if (spec_.growth->omega_h.empty()) wrong(spec_.source, "growth.omega_h", "is missing");
      return;
    }
    if (spec_.curves.empty() && spec_.parameters.empty())
      wrong(spec_.source, "", "expected [[parameters]], [[curves]] or [growth]");
    bool scenes = !spec_.curves.empty();  // each curve has its own
    for (const CurveSpec& curve : spec_.curves) {
      scenes = scenes && !curve.scene.empty();
      if (curve.end.ends.empty() == spec_.is_map())
        wrong(curve.source, "ends", "expected ends for all curves, or for none");
      if (!curve.end.columns.empty() && curve.reference.empty() && !spec_.reference)
        wrong(curve.source, "columns", "without a reference to compare with");
    }
    if (spec_.scene.empty() && !scenes) wrong(spec_.source, "scene", "is missing");
    for (const ParameterSpec& parameter : spec_.parameters)
      if (!spec_.curves.empty() && !parameter.ensemble)
        wrong(parameter.source, "ensemble", "is not true, and only ensembles go with [[curves]]");
    if (!spec_.curves.empty() && !spec_.is_map() && spec_.figures.empty())
      wrong(spec_.source, "figures", "are missing");
  }

  void check_figures() {
    for (const FigureSpec& f : spec_.figures) {
      if (const FigureFault fault = fault_of(f); !fault.key.empty()) wrong(f.source, fault.key, fault.text);
      if (f.compares_curves() && f.columns.empty()) wrong(f.source, "columns", "are missing");
      if (f.compares_curves() && !spec_.reference)
        wrong(f.source, "error", "compares with [reference], which is missing");
      if (f.average && f.columns.size() < 2)
        wrong(f.source, "average", "is true, expected at least two columns to take the mean of");
    }
    for (const LimitSpec& limit : spec_.limits) demand_figure(limit.source, "figure", limit.figure);
    if (!spec_.minimise.empty()) demand_figure(spec_.source, "minimise", spec_.minimise);
    for (const PrintedSpec& printed : spec_.printed) {
      if (printed.values.size() > spec_.figures.size())
        wrong(printed.source, "values", "has more values than there are [[figures]]");
      for (const std::string& value : printed.values)
        if (!value.empty() && !number_in(value))
          wrong(printed.source, "values", "\"" + value + "\" is not a number; expected numbers, or \"\" for none");
    }
  }

  void check(const StatementSpec& s, const std::vector<std::string>& cases) {
    demand_figure(s.source, "figure", s.figure);
    if (!s.curve.empty() && index_of(spec_.curves, s.curve) < 0)
      wrong(s.source, "curve",
            "unknown curve \"" + s.curve + "\"." + known_names("curves", s.curve, names_in(spec_.curves)));
    for (const std::string& name : {s.of_case, s.against})
      if (!name.empty() && !is_in(cases, name))
        wrong(s.source, "case", "there is no case \"" + name + "\"." + known_names("cases", name, cases));
  }

  void check(const FitSpec& fit) {
    demand_figure(fit.source, "figure", fit.figure);
    if (!fit.marks.empty()) parameter(fit.source, "marks", fit.marks);
    for (const auto& [name, value] : fit.where)
      if (const ParameterSpec* p = parameter(fit.source, "where", name); p && index_of(p->choices, value) < 0)
        wrong(fit.source, "where", "parameter \"" + name + "\" has no value \"" + value + "\"");
    for (const FitFactor& factor : fit.factors) {
      for (const auto& [who, exponent] : factor.published)
        if (!number_in(exponent))
          wrong(factor.source, "published." + who, "is \"" + exponent + "\", expected a number");
      for (const std::string& name : factor.sum) {
        if (index_of(spec_.figures, name) >= 0) continue;
        const ParameterSpec* p = parameter(factor.source, "sum", name);
        for (const std::string& value : p ? names_in(p->choices) : std::vector<std::string>())
          if (!number_in(value))
            wrong(factor.source, "sum",
                  "parameter \"" + name + "\" has the value \"" + value + "\", expected numbers in a power law");
      }
    }
  }

  void demand_figure(const Source& at, const std::string& key, const std::string& name) {
    if (index_of(spec_.figures, name) < 0)
      wrong(at, key,
            "\"" + name + "\" is not one of [[figures]]." + known_names("figures", name, names_in(spec_.figures)));
  }

  // Null after a finding.
  const ParameterSpec* parameter(const Source& at, const std::string& key, const std::string& name) {
    const int k = index_of(spec_.parameters, name);
    if (k >= 0) return &spec_.parameters[static_cast<std::size_t>(k)];
    wrong(at, key,
          "\"" + name + "\" is not one of [[parameters]]" + (key == "sum" ? ", nor of [[figures]]." : ".") +
              known_names("parameters", name, names_in(spec_.parameters)));
    return nullptr;
  }

  ExperimentSpec& spec_;
  Findings& findings_;
};

}  // namespace

ExperimentSpec read_experiment(const std::string& file) {
  require_file(file, "an experiment (TOML), as in inputs/sweeps and inputs/accuracy");
  const ConfigNode root = parse_toml_file(file);
  if (root.find("bodies") || root.find("base"))
    throw InputError(file +
                     ": this file is a scene, expected an experiment, which names a scene and says what to vary; " +
                     "run it with footfall run " + file + ", or see inputs/sweeps for experiments");
  Findings findings(file);
  ExperimentSpec s;
  s.file = file;
  s.folder = fs::absolute(file).parent_path().string();
  read_fields(
      root, s.folder, [&](FieldVisitor& reader) { visit_fields(reader, s); }, findings);
  findings.throw_if_errors();
  // Nobody looks at hundreds of runs one by one; the file may ask for drawings all the same.
  s.settings.insert(s.settings.begin(), "output.vtk=false");
  for (StatementSpec& statement : s.expected) {
    statement.must = true;
    s.statements.push_back(statement);
  }
  Checker checker(s, findings);
  checker.complete();
  checker.check();
  return s;
}

}  // namespace footfall
