#include "mbd_solver/cli/experiments/experiment.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "coupler/base/nearest_name.h"
#include "mbd_solver/cli/experiments/runs.h"
#include "mbd_solver/cli/experiments/table.h"
#include "mbd_solver/scene/field_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

bool is_in(const std::vector<std::string>& list, const std::string& word) {
  return std::find(list.begin(), list.end(), word) != list.end();
}

// What follows from the file's own words. What is wrong leaves the rest without ground: it is told before the checks.
class Completer {
 public:
  explicit Completer(Findings& findings) : findings_(findings) {}

  void complete(ParameterSpec& p) {
    if (p.values.empty() == p.choices.empty())
      findings_.error(p.source, "values", "expected either values with settings that hold {value}, or choices");
    if (!p.values.empty() && p.settings.empty())
      findings_.error(p.source, "settings",
                      "are missing; expected what {value} goes into, such as \"initial.velocity=[0,0,{value}]\"");
    for (const std::string& value : p.values) p.choices.push_back({value, "", filled(p.settings, value)});
    for (const std::string& name : p.short_values) {
      const int k = index_of(p.choices, name);
      if (k < 0)
        findings_.error(p.source, "short", "has \"" + name + "\", expected some of the values");
      else
        p.short_choices.push_back(p.choices[static_cast<std::size_t>(k)]);
    }
    if (p.short_choices.empty() && !p.choices.empty()) p.short_choices = {p.choices.front()};
  }

  void complete(CurveSpec& c) {
    if (c.values.empty() && !c.end.ends.empty()) c.values = {""};  // one run
    if (c.values.empty()) return findings_.error(c.source, "values", "are missing");
    if (c.short_values.empty()) c.short_values = {c.values.front()};
    const std::vector<std::string>& ends = c.end.ends;
    if (ends.size() > 1 && ends.size() != c.values.size())
      findings_.error(c.source, "ends", "expected one way to end for all, or one per value");
    for (const std::string& end : ends)
      if (!is_in({"accurate", "warned", "stopped", "refused"}, end))
        findings_.error(c.source, "ends", "is \"" + end + "\", expected accurate, warned, stopped or refused");
    if (!c.beside.empty() && c.beside.size() != c.values.size())
      findings_.error(c.source, "beside",
                      "has " + std::to_string(c.beside.size()) + " entries, expected one for each of the " +
                          std::to_string(c.values.size()) + " values");
    for (const std::string& value : c.short_values)
      if (!is_in(c.values, value)) findings_.error(c.source, "short", "expected some of the values");
    if (!c.default_value.empty() && !is_in(c.values, c.default_value))
      findings_.error(c.source, "default", "is \"" + c.default_value + "\", expected one of the values");
  }

  void complete(StatementSpec& s) {
    if (s.curve.empty()) {
      if (s.text.empty()) findings_.error(s.source, "text", "is missing");
      if (s.of_case.empty()) findings_.error(s.source, "case", "is missing");
      if (std::isinf(s.least) && std::isinf(s.most)) findings_.error(s.source, "least", "expected least, most or both");
      return;
    }
    if (s.order.empty() != s.error.has_value())
      findings_.error(s.source, "curve", "expected order = [least, most] or error = most");
    if (!s.order.empty() && s.order.size() != 2) findings_.error(s.source, "order", "expected [least, most]");
    if (s.error) s.most = *s.error;
    if (s.order.size() == 2) s.least = s.order[0], s.most = s.order[1];
    if (s.text.empty()) s.text = s.curve + ", " + s.figure;
  }

  void complete(FitSpec& f) {
    if (f.label.empty()) f.label = f.figure;
    if (f.factors.empty()) findings_.error(f.source, "factors", "are missing");
    for (FitFactor& factor : f.factors)
      if (factor.sum.empty()) factor.sum = {factor.name};
  }

 private:
  Findings& findings_;
};

// Scenes stand beside the file.
void find_scenes(ExperimentSpec& spec) {
  const auto find = [&](std::string& scene) {
    if (!scene.empty()) scene = (fs::path(spec.folder) / scene).lexically_normal().string();
  };
  find(spec.scene);
  if (spec.reference) find(spec.reference->scene);
  for (CurveSpec& curve : spec.curves) find(curve.scene);
  for (ParameterSpec& parameter : spec.parameters)
    for (ChoiceSpec& choice : parameter.choices) find(choice.scene);
}

// That what the sections name is there, and that what they need is given.
class Checker {
 public:
  Checker(const ExperimentSpec& spec, Findings& findings) : spec_(spec), findings_(findings) {}

  void check_runs() {
    const ExperimentSpec& s = spec_;
    if (s.growth) return;
    if (s.curves.empty() && s.parameters.empty())
      findings_.error(s.source, "", "expected [[parameters]], [[curves]] or [growth]");
    bool scenes = !s.curves.empty();  // each curve has its own
    for (const CurveSpec& curve : s.curves) {
      scenes = scenes && !curve.scene.empty();
      if (curve.end.ends.empty() == s.is_map())
        findings_.error(curve.source, "ends", "expected ends for all curves, or for none");
      if (!curve.end.columns.empty() && curve.reference.empty() && !s.reference)
        findings_.error(curve.source, "columns", "without a reference to compare with");
    }
    if (s.scene.empty() && !scenes) findings_.error(s.source, "scene", "is missing");
    for (const ParameterSpec& parameter : s.parameters)
      if (!s.curves.empty() && !parameter.ensemble)
        findings_.error(parameter.source, "ensemble", "is not true, and only ensembles go with [[curves]]");
    if (!s.curves.empty() && !s.is_map() && s.figures.empty()) findings_.error(s.source, "figures", "are missing");
  }

  void check_figures() {
    for (const FigureSpec& f : spec_.figures) {
      if (f.key.empty() == f.columns.empty())
        findings_.error(f.source, "key", "expected either key (of summary.json) or columns (of history.csv)");
      if (f.compares_curves() && f.columns.empty()) findings_.error(f.source, "columns", "are missing");
      if (f.compares_curves() && !spec_.reference)
        findings_.error(f.source, "error", "compares with [reference], which is missing");
      if (f.average && f.columns.size() < 2)
        findings_.error(f.source, "average", "is true, expected at least two columns to take the mean of");
    }
    for (const LimitSpec& limit : spec_.limits) demand_figure(limit.source, "figure", limit.figure);
    if (!spec_.minimise.empty()) demand_figure(spec_.source, "minimise", spec_.minimise);
    for (const PrintedSpec& printed : spec_.printed) {
      if (printed.values.size() > spec_.figures.size())
        findings_.error(printed.source, "values", "has more values than there are [[figures]]");
      for (const std::string& value : printed.values)
        if (!value.empty() && !number_in(value))
          findings_.error(printed.source, "values",
                          "\"" + value + "\" is not a number; expected numbers, or \"\" for none");
    }
  }

  void check_statements() {
    const std::vector<std::string> cases = names_in(plan_of(spec_, false).cases);
    for (const StatementSpec& s : spec_.statements) {
      demand_figure(s.source, "figure", s.figure);
      if (!s.curve.empty() && index_of(spec_.curves, s.curve) < 0)
        findings_.error(s.source, "curve",
                        "unknown curve \"" + s.curve + "\"" + known_names("curves", s.curve, names_in(spec_.curves)));
      for (const std::string& name : {s.of_case, s.against})
        if (!name.empty() && !is_in(cases, name))
          findings_.error(s.source, "case", "there is no case \"" + name + "\"" + known_names("cases", name, cases));
    }
  }

  void check_fit(const FitSpec& fit) {
    demand_figure(fit.source, "figure", fit.figure);
    if (!fit.marks.empty()) parameter(fit.source, "marks", fit.marks);
    for (const auto& [name, value] : fit.where)
      if (const ParameterSpec* p = parameter(fit.source, "where", name); p && index_of(p->choices, value) < 0)
        findings_.error(fit.source, "where", "parameter \"" + name + "\" has no value \"" + value + "\"");
    for (const FitFactor& factor : fit.factors) {
      for (const auto& [who, exponent] : factor.published)
        if (!number_in(exponent))
          findings_.error(factor.source, "published." + who, "is \"" + exponent + "\", expected a number");
      for (const std::string& name : factor.sum) {
        if (index_of(spec_.figures, name) >= 0) continue;
        const ParameterSpec* p = parameter(factor.source, "sum", name);
        for (const ChoiceSpec& choice : p ? p->choices : std::vector<ChoiceSpec>())
          if (!number_in(choice.name))
            findings_.error(
                factor.source, "sum",
                "parameter \"" + name + "\" has the value \"" + choice.name + "\", expected numbers in a power law");
      }
    }
  }

 private:
  void demand_figure(const Source& at, const std::string& key, const std::string& name) {
    if (index_of(spec_.figures, name) < 0)
      findings_.error(
          at, key,
          "\"" + name + "\" is not one of [[figures]]." + known_names("figures", name, names_in(spec_.figures)));
  }
  // Null after a finding.
  const ParameterSpec* parameter(const Source& at, const std::string& key, const std::string& name) {
    const int k = index_of(spec_.parameters, name);
    if (k >= 0) return &spec_.parameters[static_cast<std::size_t>(k)];
    findings_.error(at, key,
                    "\"" + name + "\" is not one of [[parameters]]" + (key == "sum" ? ", nor of [[figures]]." : ".") +
                        known_names("parameters", name, names_in(spec_.parameters)));
    return nullptr;
  }

  const ExperimentSpec& spec_;
  Findings& findings_;
};

}  // namespace

ExperimentSpec read_experiment(const std::string& file) {
  const ConfigNode root = parse_toml_file(file);
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
  find_scenes(s);
  Completer completer(findings);
  for (ParameterSpec& parameter : s.parameters) completer.complete(parameter);
  for (CurveSpec& curve : s.curves) completer.complete(curve);
  for (StatementSpec& statement : s.statements) completer.complete(statement);
  for (FitSpec& fit : s.fits) completer.complete(fit);
  findings.throw_if_errors();

  Checker checker(s, findings);
  checker.check_runs();
  checker.check_figures();
  for (const FitSpec& fit : s.fits) checker.check_fit(fit);
  findings.throw_if_errors();
  checker.check_statements();
  findings.throw_if_errors();
  return s;
}

}  // namespace footfall
