#include "mbd_solver/cli/sweep.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <map>

#include "coupler/errors.h"
#include "mbd_solver/cli/table_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) text.replace(at, what.size(), by);
}

// As part of a folder's name.
std::string file_name(std::string text) {
  for (char& c : text)
    if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.' && c != '-' && c != '+') c = '_';
  return text;
}

void read_parameter(TableReader& t, SweepParameter& p) {
  std::vector<std::string> values, settings;
  t.take("name", p.name);
  t.take("ensemble", p.ensemble);
  t.take("settings", settings);
  t.take("values", values);
  t.take_list("choices", p.choices, [](TableReader& c, SweepChoice& choice) {
    c.take("name", choice.name);
    c.take("settings", choice.settings);
    c.take("scene", choice.scene);
    c.require("name", !choice.name.empty());
  });
  t.require("name", !p.name.empty());
  if (values.empty() == p.choices.empty()) t.fail("values", "expected either values with settings that hold {value}, or choices");
  for (const std::string& value : values) {
    SweepChoice choice{value, "", settings};
    for (std::string& setting : choice.settings) replace_all(setting, "{value}", value);
    p.choices.push_back(choice);
  }
  if (!values.empty() && settings.empty()) t.fail("settings", "are missing; expected what {value} goes into, such as \"initial.velocity=[0,0,{value}]\"");
}

void read_figure(TableReader& t, SweepFigure& f) {
  const std::map<std::string, Reduction> known = {
      {"max", Reduction::kMax}, {"min", Reduction::kMin}, {"final", Reduction::kFinal}, {"largest", Reduction::kLargest}};
  std::string reduce = "max";
  t.take("name", f.name);
  t.take("key", f.key);
  t.take("columns", f.columns);
  t.take("reduce", reduce);
  t.require("name", !f.name.empty());
  if (f.key.empty() == f.columns.empty()) t.fail("key", "expected either key (of summary.json) or columns (of history.csv)");
  const auto found = known.find(reduce);
  if (found == known.end()) t.fail("reduce", "is \"" + reduce + "\", expected max, min, final or largest");
  f.reduction = found->second;
}

}  // namespace

SweepSpec read_sweep(const std::string& file) {
  const ConfigNode root = parse_toml_file(file);
  SweepSpec sweep;
  sweep.file = file;
  TableReader t(file, "", root);
  t.take("title", sweep.title);
  t.take("scene", sweep.scene);
  t.take("settings", sweep.settings);
  t.take("until", sweep.until);
  t.take("minimise", sweep.minimise);
  t.take_list("parameters", sweep.parameters, read_parameter);
  t.take_list("figures", sweep.figures, read_figure);
  t.take_list("limits", sweep.limits, [](TableReader& l, SweepLimit& limit) {
    l.take("figure", limit.figure);
    l.take("most", limit.most);
    l.require("most", l.next("most") != nullptr);
  });
  t.take_list("plots", sweep.plots, [](TableReader& p, SweepPlot& plot) {
    p.take("name", plot.name);
    p.take("title", plot.title);
    p.take("column", plot.column);
    p.take("label", plot.label);
    p.require("name", !plot.name.empty());
    p.require("column", !plot.column.empty());
  });
  t.done();
  t.require("scene", !sweep.scene.empty());
  t.require("parameters", !sweep.parameters.empty());
  const auto beside_file = [&](const std::string& scene) { return (fs::path(file).parent_path() / scene).lexically_normal().string(); };
  sweep.scene = beside_file(sweep.scene);
  for (SweepParameter& parameter : sweep.parameters)
    for (SweepChoice& choice : parameter.choices)
      if (!choice.scene.empty()) choice.scene = beside_file(choice.scene);
  const auto known_figure = [&](const std::string& name) {
    return std::any_of(sweep.figures.begin(), sweep.figures.end(), [&](const SweepFigure& f) { return f.name == name; });
  };
  for (const SweepLimit& limit : sweep.limits)
    if (!known_figure(limit.figure)) t.fail("limits", "figure \"" + limit.figure + "\" is not one of [[figures]]");
  if (!sweep.minimise.empty() && !known_figure(sweep.minimise)) t.fail("minimise", "\"" + sweep.minimise + "\" is not one of [[figures]]");
  return sweep;
}

std::vector<SweepRun> runs_of(const SweepSpec& sweep) {
  std::vector<SweepRun> runs = {SweepRun{"", {}, sweep.scene, "", sweep.settings}};
  for (const SweepParameter& parameter : sweep.parameters) {
    std::vector<SweepRun> longer;
    for (const SweepRun& run : runs) {
      for (const SweepChoice& choice : parameter.choices) {
        SweepRun next = run;
        next.name += (next.name.empty() ? "" : "__") + file_name(parameter.name) + "_" + file_name(choice.name);
        next.values.push_back(choice.name);
        if (!choice.scene.empty()) next.scene = choice.scene;
        if (!parameter.ensemble) next.group += (next.group.empty() ? "" : ", ") + parameter.name + " " + choice.name;
        next.settings.insert(next.settings.end(), choice.settings.begin(), choice.settings.end());
        longer.push_back(next);
      }
    }
    runs.swap(longer);
  }
  return runs;
}

}  // namespace footfall
