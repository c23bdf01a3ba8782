#include "mbd_solver/cli/experiments/experiment_reader.h"

#include <algorithm>
#include <filesystem>

#include "mbd_solver/cli/experiments/section_reader.h"
#include "mbd_solver/cli/experiments/table_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

// The choice of each value, with {value} replaced.
std::vector<ChoiceSpec> choices_of(const std::vector<std::string>& values, const std::vector<std::string>& settings) {
  std::vector<ChoiceSpec> choices;
  for (const std::string& value : values) choices.push_back({value, "", filled(settings, value)});
  return choices;
}

void read_parameter(TableReader& t, ParameterSpec& p) {
  std::vector<std::string> values, settings, short_values;
  t.take("name", p.name, "ensemble", p.ensemble, "settings", settings, "values", values, "short", short_values);
  t.take_list("choices", p.choices, [](TableReader& c, ChoiceSpec& choice) {
    c.take("name", choice.name, "settings", choice.settings, "scene", choice.scene);
    c.require("name", !choice.name.empty());
  });
  t.require("name", !p.name.empty());
  if (values.empty() == p.choices.empty())
    t.fail("values", "expected either values with settings that hold {value}, or choices");
  if (!values.empty() && settings.empty())
    t.fail("settings", "are missing; expected what {value} goes into, such as \"initial.velocity=[0,0,{value}]\"");
  if (!values.empty()) p.choices = choices_of(values, settings);
  for (const std::string& name : short_values) {
    const int k = index_of(p.choices, name);
    if (k < 0) t.fail(*t.next("short"), "short", "has \"" + name + "\", expected some of the values");
    p.short_choices.push_back(p.choices[static_cast<std::size_t>(k)]);
  }
  if (p.short_choices.empty()) p.short_choices = {p.choices.front()};
}

void read_end(TableReader& t, const std::vector<std::string>& values, EndSpec& e) {
  t.take("ends", e.ends, "group", e.group, "message", e.message, "columns", e.columns, "at_end", e.at_end, "tolerance",
         e.tolerance, "order_beyond", e.order_beyond);
  if (e.ends.size() > 1 && e.ends.size() != values.size())
    t.fail(*t.next("ends"), "ends", "expected one way to end for all, or one per value");
  for (const std::string& end : e.ends)
    if (end != "accurate" && end != "warned" && end != "stopped" && end != "refused")
      t.fail(*t.next("ends"), "ends", "is \"" + end + "\", expected accurate, warned, stopped or refused");
}

void read_curve(TableReader& t, CurveSpec& c) {
  t.take("name", c.name, "scene", c.scene, "settings", c.settings, "reference", c.reference, "values", c.values,
         "short", c.short_values, "beside", c.beside, "default", c.default_value, "scale", c.scale, "until", c.until);
  read_end(t, c.values, c.end);
  t.require("name", !c.name.empty());
  if (c.values.empty() && !c.end.ends.empty()) c.values = {""};  // one run
  t.require("values", !c.values.empty());
  if (c.short_values.empty()) c.short_values = {c.values.front()};
  const auto known = [&](const std::string& value) {
    return std::find(c.values.begin(), c.values.end(), value) != c.values.end();
  };
  if (!c.beside.empty() && c.beside.size() != c.values.size())
    t.fail(*t.next("beside"), "beside",
           "has " + std::to_string(c.beside.size()) + " entries, expected one for each of the " +
               std::to_string(c.values.size()) + " values");
  if (!std::all_of(c.short_values.begin(), c.short_values.end(), known))
    t.fail(*t.next("short"), "short", "expected some of the values");
  if (!c.default_value.empty() && !known(c.default_value))
    t.fail(*t.next("default"), "default", "is \"" + c.default_value + "\", expected one of the values");
}

// Scenes stand beside the file.
void find_scenes(ExperimentSpec& spec) {
  const auto find = [&](std::string& scene) {
    if (!scene.empty()) scene = (fs::path(spec.folder) / scene).lexically_normal().string();
  };
  find(spec.scene);
  if (spec.reference) find(spec.reference->scene);
  for (CurveSpec& curve : spec.curves) find(curve.scene);
  for (ParameterSpec& parameter : spec.parameters)
    for (auto* choices : {&parameter.choices, &parameter.short_choices})
      for (ChoiceSpec& choice : *choices) find(choice.scene);
}

void check_runs(const TableReader& t, const ExperimentSpec& s) {
  if (s.growth) return;
  if (s.curves.empty() && s.parameters.empty()) t.fail("", "expected [[parameters]], [[curves]] or [growth]");
  for (const CurveSpec& curve : s.curves) {
    if (curve.scene.empty()) t.require("scene", !s.scene.empty());
    if (curve.end.ends.empty() == s.is_map())
      t.fail("curves", "\"" + curve.name + "\": expected ends for all curves, or for none");
    if (!curve.end.columns.empty() && curve.reference.empty() && !s.reference)
      t.fail("curves", "\"" + curve.name + "\": columns without a reference to compare with");
  }
  if (s.curves.empty()) t.require("scene", !s.scene.empty());
  for (const ParameterSpec& parameter : s.parameters)
    if (!s.curves.empty() && !parameter.ensemble)
      t.fail("parameters", "\"" + parameter.name + "\" is no ensemble, and only ensembles go with [[curves]]");
  if (!s.curves.empty() && !s.is_map()) t.require("figures", !s.figures.empty());
}

void read_keys(TableReader& t, ExperimentSpec& s) {
  t.take("title", s.title, "x_name", s.x_name, "scene", s.scene, "settings", s.settings, "until", s.until, "time_limit",
         s.time_limit, "repeats", s.repeats, "minimise", s.minimise);
  // Nobody looks at hundreds of runs one by one; the file may ask for drawings all the same.
  s.settings.insert(s.settings.begin(), "output.vtk=false");
  t.take_table("short", [&](TableReader& form) { form.take("until", s.short_until, "settings", s.short_settings); });
  t.take_table("reference", [&](TableReader& reference) {
    s.reference.emplace();
    reference.take("scene", s.reference->scene, "settings", s.reference->settings);
  });
  t.take_table("growth", [&](TableReader& growth) {
    s.growth.emplace();
    growth.take("omega_h", s.growth->omega_h, "substeps", s.growth->substeps);
    growth.require("omega_h", !s.growth->omega_h.empty());
    for (const double w : s.growth->omega_h)
      if (!(w > 0.0)) growth.fail("omega_h", "expected numbers above 0");
    if (s.growth->substeps < 1) growth.fail("substeps", "expected 1 or more");
  });
  t.take_list("parameters", s.parameters, read_parameter);
  t.take_list("curves", s.curves, read_curve);
  t.take_list("figures", s.figures, read_figure);
  t.take_list("limits", s.limits, [](TableReader& l, LimitSpec& limit) {
    l.take("figure", limit.figure, "most", limit.most);
    l.require("most", l.next("most") != nullptr);
  });
  t.take_list("printed", s.printed, read_printed);
  t.take_list("statements", s.statements, read_statement);
  t.take_list("expect", s.statements, [](TableReader& e, StatementSpec& statement) {
    read_statement(e, statement);
    statement.must = true;
  });
  t.take_list("plots", s.plots, read_plot);
  t.take_list("fits", s.fits, read_fit);
}

}  // namespace

ExperimentSpec read_experiment(const std::string& file) {
  const ConfigNode root = parse_toml_file(file);
  ExperimentSpec s;
  s.file = file;
  s.folder = fs::absolute(file).parent_path().string();
  TableReader t(file, "", root);
  read_keys(t, s);
  t.done();
  find_scenes(s);
  check_runs(t, s);
  check_sections(t, s);
  return s;
}

std::string experiment_schema() {
  nlohmann::ordered_json keys;
  TableReader t(keys);
  ExperimentSpec s;
  read_keys(t, s);
  nlohmann::ordered_json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                                   {"title", "Experiment of footfall"}};
  schema.update(keys);
  return schema.dump(2);
}

std::vector<std::string> filled(std::vector<std::string> texts, const std::string& value, const std::string& mark) {
  for (std::string& text : texts)
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size()))
      text.replace(at, mark.size(), value);
  return texts;
}

}  // namespace footfall
