// Keys are described as those of a scene (scene/field_visitor.h); Checker completes the spec and reports contradictions.
#include "mbd_solver/studies/sweep_file.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/named_file.h"
#include "mbd_solver/scene/codes.h"
#include "mbd_solver/scene/field_reader.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/scene_schema.h"
#include "mbd_solver/studies/codes.h"
#include "mbd_solver/studies/plan.h"
#include "mbd_solver/studies/tables.h"

namespace footfall {

static void visit_fields(FieldVisitor& v, ChoiceSpec& c) {
  v.fields(rule::required(kWords), {{"name", &c.name}});
  v.fields(kWords, {{"settings", &c.settings}});
  v.fields(rule::plain, {{"scene", &c.scene}});
}

static void visit_fields(FieldVisitor& v, ParameterSpec& p) {
  v.fields(rule::plain, {{"", &p.source}, {"ensemble", &p.ensemble}});
  v.fields(rule::required(kWords), {{"name", &p.name}});
  v.fields(kWords, {{"settings", &p.settings}, {"values", &p.values}, {"short", &p.short_values}});
  v.list("choices", p.choices);
}

static void visit_fields(FieldVisitor& v, CurveSpec& c) {
  v.fields(rule::plain, {{"", &c.source}, {"scene", &c.scene}, {"scale", &c.scale}});
  v.fields(rule::required(kWords), {{"name", &c.name}});
  v.fields(kWords, {{"settings", &c.settings}, {"reference", &c.reference}, {"default", &c.default_value}});
  v.fields(kWords, {{"values", &c.values}, {"short", &c.short_values}, {"beside", &c.beside}});
  v.fields(rule::not_negative(), {{"until", &c.until}});
  EndSpec& e = c.end;
  v.fields(kWords, {{"ends", &e.ends}, {"columns", &e.columns}});
  v.fields(rule::plain, {{"group", &e.group}, {"message", &e.message}, {"at_end", &e.at_end}});
  v.fields(rule::not_negative(), {{"tolerance", &e.tolerance}, {"order_beyond", &e.order_beyond}});
}

static void visit_fields(FieldVisitor& v, ReferenceSpec& r) {
  v.fields(rule::plain, {{"scene", &r.scene}});
  v.fields(kWords, {{"settings", &r.settings}});
}

static void visit_fields(FieldVisitor& v, ShortSpec& s) {
  v.fields(rule::not_negative(), {{"until", &s.until}});
  v.fields(kWords, {{"settings", &s.settings}});
}

static void visit_fields(FieldVisitor& v, GrowthSpec& g) {
  v.fields(rule::positive(), {{"omega_h", &g.omega_h}, {"short", &g.short_omega_h}, {"substeps", &g.substeps}});
}

void visit_fields(FieldVisitor& v, MetricSpec& f) {
  v.fields(rule::plain, {{"", &f.source}, {"key", &f.key}, {"average", &f.average}, {"over", &f.over}});
  v.fields(rule::required(kWords), {{"name", &f.name}});
  v.fields(kWords, {{"columns", &f.columns}});
  v.fields(rule::plain, {{"slope", &f.slope}});
  v.fields(rule::not_negative(), {{"prominence", &f.prominence}, {"until", &f.until}});
  v.choice("reduce", f.reduction);
  v.choice("error", f.error);
}

static void visit_fields(FieldVisitor& v, LimitSpec& l) {
  v.fields(rule::plain, {{"", &l.source}});
  v.fields(rule::required(), {{"figure", &l.metric}, {"most", &l.most}});
}

static void visit_fields(FieldVisitor& v, PublishedSpec& p) {
  v.fields(rule::plain, {{"", &p.source}});
  v.fields(rule::required(kWords), {{"name", &p.name}});
  v.fields(kWords, {{"values", &p.values}});
}

static void visit_fields(FieldVisitor& v, CheckSpec& s) {
  v.fields(rule::plain,
           {{"", &s.source}, {"text", &s.text}, {"why", &s.why}, {"case", &s.of_case}, {"against", &s.against}});
  v.fields(rule::required(), {{"figure", &s.metric}});
  v.fields(rule::plain, {{"difference", &s.difference}, {"least", &s.least}, {"most", &s.most}});
  v.fields(rule::plain, {{"curve", &s.curve}, {"order", &s.order}, {"error", &s.error}});
}

static void visit_fields(FieldVisitor& v, PlotSpec& p) {
  v.fields(rule::required(rule::name), {{"name", &p.name}});
  v.fields(rule::required(), {{"column", &p.column}});
  v.fields(rule::plain, {{"title", &p.title}, {"label", &p.label}});
}

static void visit_fields(FieldVisitor& v, FitFactor& f) {
  v.fields(rule::plain, {{"", &f.source}, {"published", &f.published}});
  v.fields(rule::required(), {{"name", &f.name}});
  v.fields(kWords, {{"sum", &f.sum}});
}

static void visit_fields(FieldVisitor& v, FitSpec& f) {
  v.fields(rule::plain, {{"", &f.source}, {"label", &f.label}, {"marks", &f.marks}});
  v.fields(kWords, {{"where", &f.where}});
  v.fields(rule::required(rule::name), {{"name", &f.name}});
  v.fields(rule::required(), {{"figure", &f.metric}});
  v.list("factors", f.factors);
}

void visit_fields(FieldVisitor& v, SweepSpec& s) {
  v.fields(rule::plain, {{"", &s.source}, {"title", &s.title}, {"x_name", &s.x_name}, {"scene", &s.scene}});
  v.fields(rule::plain, {{"minimise", &s.minimise}});
  v.fields(kWords, {{"settings", &s.settings}});
  v.fields(rule::not_negative(), {{"until", &s.until}, {"time_limit", &s.time_limit}});
  v.fields(rule::positive(), {{"repeats", &s.repeats}});
  v.section("short", s.short_form);
  v.section("reference", s.reference);
  v.section("growth", s.growth);
  v.list("parameters", s.parameters);
  v.list("curves", s.curves);
  v.list("figures", s.metrics);
  v.list("limits", s.limits);
  v.list("printed", s.published_values);
  v.list("statements", s.checks);
  v.list("expect", s.expected);
  v.list("plots", s.plots);
  v.list("fits", s.fits);
}

std::string sweep_schema() {
  SweepSpec defaults;
  return schema_of("Sweep file of footfall", [&](FieldVisitor& v) { visit_fields(v, defaults); });
}

namespace fs = std::filesystem;

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// Fills what follows from other keys, and finds contradictions.
class Checker {
 public:
  Checker(SweepSpec& spec, Findings& findings) : spec_(spec), findings_(findings) {}

  // Before check(), which requires a complete spec.
  void complete() {
    for (ParameterSpec& parameter : spec_.parameters) complete(parameter);
    for (CurveSpec& curve : spec_.curves) complete(curve);
    for (CheckSpec& check_spec : spec_.checks) complete(check_spec);
    for (FitSpec& fit : spec_.fits) complete(fit);
    find_scenes();
    findings_.throw_if_errors();
  }

  void check() {
    check_runs();
    check_metrics();
    for (const FitSpec& fit : spec_.fits) check(fit);
    findings_.throw_if_errors();
    const std::vector<std::string> cases = names_in(plan_of(spec_, false).cases);
    for (const CheckSpec& check_spec : spec_.checks) check(check_spec, cases);
    findings_.throw_if_errors();
  }

 private:
  void wrong(const MessageCode& code, const Source& at, const std::string& key, const std::string& what) {
    findings_.error(code, at, key, what);
  }

  void complete(ParameterSpec& p) {
    if (p.values.empty() == p.choices.empty())
      wrong(code::kConflictingKeys, p.source, "values",
            "expected either values with settings that contain {value}, or choices");
    if (!p.values.empty() && p.settings.empty())
      wrong(code::kMissingKey, p.source, "settings",
            "are missing, expected settings that contain {value}, such as \"initial.velocity=[0,0,{value}]\"");
    for (const std::string& value : p.values) p.choices.push_back({value, "", filled(p.settings, value)});
    for (const std::string& name : p.short_values) {
      const int k = index_of(p.choices, name);
      if (k < 0)
        wrong(code::kNotAValue, p.source, "short", "has \"" + name + "\", expected some of the values");
      else
        p.short_choices.push_back(p.choices[static_cast<std::size_t>(k)]);
    }
    if (p.short_choices.empty() && !p.choices.empty()) p.short_choices = {p.choices.front()};
  }

  void complete(CurveSpec& c) {
    const std::vector<std::string>& ends = c.end.ends;
    if (c.values.empty() && !ends.empty()) c.values = {""};  // one run
    if (c.values.empty()) return wrong(code::kMissingKey, c.source, "values", "are missing");
    if (c.short_values == CurveSpec().short_values) c.short_values = {c.values.front()};
    if (ends.size() > 1 && ends.size() != c.values.size())
      wrong(code::kWrongCount, c.source, "ends", "expected one for all values, or one per value");
    for (const std::string& end : ends)
      if (!is_in({"accurate", "warned", "stopped", "refused"}, end))
        wrong(code::kUnknownChoice, c.source, "ends",
              "is \"" + end + "\", expected accurate, warned, stopped or refused");
    if (!c.beside.empty() && c.beside.size() != c.values.size())
      wrong(code::kWrongCount, c.source, "beside",
            "has " + std::to_string(c.beside.size()) + " entries, expected one for each of the " +
                std::to_string(c.values.size()) + " values");
    for (const std::string& value : c.short_values)
      if (!is_in(c.values, value))
        wrong(code::kNotAValue, c.source, "short", "has \"" + value + "\", expected some of the values");
    if (!c.default_value.empty() && !is_in(c.values, c.default_value))
      wrong(code::kNotAValue, c.source, "default", "is \"" + c.default_value + "\", expected one of the values");
  }

  void complete(CheckSpec& s) {
    if (s.curve.empty()) {
      if (s.text.empty()) wrong(code::kMissingKey, s.source, "text", "is missing");
      if (s.of_case.empty()) wrong(code::kMissingKey, s.source, "case", "is missing");
      if (std::isinf(s.least) && std::isinf(s.most))
        wrong(code::kMissingKey, s.source, "least", "expected least, most or both");
      if (s.least > s.most) wrong(code::kRangeReversed, s.source, "most", "is less than least");
      return;
    }
    if (s.order.empty() != s.error.has_value())
      wrong(code::kConflictingKeys, s.source, "curve", "expected order = [least, most] or error = most");
    if (!s.order.empty() && s.order.size() != 2) wrong(code::kWrongCount, s.source, "order", "expected [least, most]");
    if (s.error) s.most = *s.error;
    if (s.order.size() == 2) s.least = s.order[0], s.most = s.order[1];
    if (s.least > s.most)
      wrong(code::kRangeReversed, s.source, "order", "is [most, least], expected the smaller number first");
    if (s.text.empty()) s.text = s.curve + ", " + s.metric;
  }

  void complete(FitSpec& f) {
    if (f.label.empty()) f.label = f.metric;
    if (f.factors.empty()) wrong(code::kMissingKey, f.source, "factors", "are missing");
    for (FitFactor& factor : f.factors)
      if (factor.sum.empty()) factor.sum = {factor.name};
  }

  // Scenes are relative to the file.
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
      for (const double n : spec_.growth->substeps)
        if (n != std::floor(n)) wrong(code::kOutOfRange, spec_.source, "growth.substeps", "expected whole numbers");
      if (spec_.growth->omega_h.empty()) wrong(code::kMissingKey, spec_.source, "growth.omega_h", "is missing");
      return;
    }
    if (spec_.curves.empty() && spec_.parameters.empty())
      wrong(code::kMissingKey, spec_.source, "", "expected [[parameters]], [[curves]] or [growth]");
    bool scenes = !spec_.curves.empty();  // each curve names one
    for (const CurveSpec& curve : spec_.curves) {
      scenes = scenes && !curve.scene.empty();
      if (curve.end.ends.empty() == spec_.is_map())
        wrong(code::kConflictingKeys, curve.source, "ends", "expected ends for all curves, or for none");
      if (!curve.end.columns.empty() && curve.reference.empty() && !spec_.reference)
        wrong(code::kNeedsOtherKey, curve.source, "columns", "have no reference to be compared with");
    }
    if (spec_.scene.empty() && !scenes) wrong(code::kMissingKey, spec_.source, "scene", "is missing");
    for (const ParameterSpec& parameter : spec_.parameters)
      if (!spec_.curves.empty() && !parameter.ensemble)
        wrong(code::kConflictingKeys, parameter.source, "ensemble",
              "is false, expected true: only ensembles are allowed with [[curves]]");
    if (!spec_.curves.empty() && !spec_.is_map() && spec_.metrics.empty())
      wrong(code::kMissingKey, spec_.source, "figures", "are missing");
  }

  void check_metrics() {
    for (const MetricSpec& f : spec_.metrics) {
      if (const MetricFault fault = fault_of(f); !fault.key.empty())
        wrong(code::kConflictingKeys, f.source, fault.key, fault.text);
      if (f.compares_curves() && f.columns.empty()) wrong(code::kMissingKey, f.source, "columns", "are missing");
      if (f.compares_curves() && !spec_.reference)
        wrong(code::kNeedsOtherKey, f.source, "error", "compares with [reference], which is missing");
      if (f.average && f.columns.size() < 2)
        wrong(code::kWrongCount, f.source, "average", "is true, expected at least two columns");
    }
    for (const LimitSpec& limit : spec_.limits) require_metric(limit.source, "figure", limit.metric);
    if (!spec_.minimise.empty()) require_metric(spec_.source, "minimise", spec_.minimise);
    for (const PublishedSpec& published : spec_.published_values) {
      if (published.values.size() > spec_.metrics.size())
        wrong(code::kWrongCount, published.source, "values", "has more values than there are [[figures]]");
      for (const std::string& value : published.values)
        if (!value.empty() && !number_in(value))
          wrong(code::kWrongType, published.source, "values",
                "has \"" + value + "\", expected numbers, or \"\" for none");
    }
  }

  void check(const CheckSpec& s, const std::vector<std::string>& cases) {
    require_metric(s.source, "figure", s.metric);
    if (!s.curve.empty() && index_of(spec_.curves, s.curve) < 0)
      wrong(code::kUnknownCurve, s.source, "curve",
            "unknown curve \"" + s.curve + "\"." + known_names("curves", s.curve, names_in(spec_.curves)));
    for (const std::string& name : {s.of_case, s.against})
      if (!name.empty() && !is_in(cases, name))
        wrong(code::kUnknownCurve, s.source, "case",
              "unknown case \"" + name + "\"." + known_names("cases", name, cases));
  }

  void check(const FitSpec& fit) {
    require_metric(fit.source, "figure", fit.metric);
    if (!fit.marks.empty()) parameter(fit.source, "marks", fit.marks);
    for (const auto& [name, value] : fit.where)
      if (const ParameterSpec* p = parameter(fit.source, "where", name); p && index_of(p->choices, value) < 0)
        wrong(code::kNotAValue, fit.source, "where", "parameter \"" + name + "\" has no value \"" + value + "\"");
    for (const FitFactor& factor : fit.factors) {
      for (const auto& [who, exponent] : factor.published)
        if (!number_in(exponent))
          wrong(code::kWrongType, factor.source, "published." + who, "is \"" + exponent + "\", expected a number");
      for (const std::string& name : factor.sum) {
        if (index_of(spec_.metrics, name) >= 0) continue;
        const ParameterSpec* p = parameter(factor.source, "sum", name);
        for (const std::string& value : p ? names_in(p->choices) : std::vector<std::string>())
          if (!number_in(value))
            wrong(code::kWrongType, factor.source, "sum",
                  "parameter \"" + name + "\" has the value \"" + value + "\", expected numbers in a power law");
      }
    }
  }

  void require_metric(const Source& at, const std::string& key, const std::string& name) {
    if (index_of(spec_.metrics, name) < 0)
      wrong(code::kUnknownMetric, at, key,
            "\"" + name + "\" is not one of [[figures]]." + known_names("metrics", name, names_in(spec_.metrics)));
  }

  // Null after a finding.
  const ParameterSpec* parameter(const Source& at, const std::string& key, const std::string& name) {
    const int k = index_of(spec_.parameters, name);
    if (k >= 0) return &spec_.parameters[static_cast<std::size_t>(k)];
    wrong(code::kUnknownParameter, at, key,
          "\"" + name + "\" is not one of [[parameters]]" + (key == "sum" ? ", nor of [[figures]]." : ".") +
              known_names("parameters", name, names_in(spec_.parameters)));
    return nullptr;
  }

  SweepSpec& spec_;
  Findings& findings_;
};

}  // namespace

SweepSpec read_sweep_file(const std::string& file) {
  require_file(file, "a sweep file (TOML), as in inputs/sweeps and inputs/accuracy");
  const ConfigNode root = parse_toml_file(file);
  if (root.find("bodies") || root.find("base"))
    throw InputError(code::kSceneGiven,
                     file +
                         ": is a scene, expected a sweep file, which names a scene and what to vary; "
                         "see inputs/sweeps, or run the scene: footfall run " +
                         file);
  Findings findings(file);
  SweepSpec s;
  s.file = file;
  s.folder = fs::absolute(file).parent_path().string();
  read_fields(
      root, s.folder, [&](FieldVisitor& reader) { visit_fields(reader, s); }, findings);
  findings.throw_if_errors();
  // A default that the file may override.
  s.settings.insert(s.settings.begin(), "output.vtk=false");
  for (CheckSpec& check_spec : s.expected) {
    check_spec.must = true;
    s.checks.push_back(check_spec);
  }
  Checker checker(s, findings);
  checker.complete();
  checker.check();
  return s;
}

}  // namespace footfall
