#include "mbd_solver/cli/experiments/sweep.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "coupler/base/errors.h"
#include "mbd_solver/cli/experiments/figure_reader.h"
#include "mbd_solver/cli/experiments/sweep_fit.h"
#include "mbd_solver/cli/experiments/table_reader.h"

namespace footfall {

namespace fs = std::filesystem;

namespace {

void replace_all(std::string& text, const std::string& what, const std::string& by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size()))
    text.replace(at, what.size(), by);
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
  if (values.empty() == p.choices.empty())
    t.fail("values", "expected either values with settings that hold {value}, or choices");
  for (const std::string& value : values) {
    SweepChoice choice{value, "", settings};
    for (std::string& setting : choice.settings) replace_all(setting, "{value}", value);
    p.choices.push_back(choice);
  }
  if (!values.empty() && settings.empty())
    t.fail("settings", "are missing; expected what {value} goes into, such as \"initial.velocity=[0,0,{value}]\"");
}

void read_figure(TableReader& t, SweepFigure& f) {
  t.take("name", f.name);
  t.require("name", !f.name.empty());
  take_figure(t, f);
}

void read_printed(TableReader& t, SweepPrinted& p) {
  std::vector<std::string> values;
  t.take("name", p.name);
  t.take("values", values);
  t.require("name", !p.name.empty());
  for (const std::string& value : values) {
    char* end = nullptr;
    p.values.push_back(value.empty() ? std::nan("") : std::strtod(value.c_str(), &end));
    if (end && *end != '\0')
      t.fail("values", "\"" + value + "\" is not a number; expected numbers, or \"\" for what is not printed");
  }
}

void read_statement(TableReader& t, SweepStatement& s) {
  t.take("text", s.text);
  t.take("figure", s.figure);
  t.take("case", s.of_case);
  t.take("against", s.against);
  t.take("why", s.why);
  t.take("least", s.least);
  t.take("most", s.most);
  t.require("text", !s.text.empty());
  t.require("case", !s.of_case.empty());
  if (std::isinf(s.least) && std::isinf(s.most)) t.fail("least", "expected least, most or both");
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
  t.take_list("printed", sweep.printed, read_printed);
  t.take_list("statements", sweep.statements, read_statement);
  t.take_list("fits", sweep.fits, read_fit);
  t.done();
  t.require("scene", !sweep.scene.empty());
  t.require("parameters", !sweep.parameters.empty());
  const auto beside_file = [&](const std::string& scene) {
    return (fs::path(file).parent_path() / scene).lexically_normal().string();
  };
  sweep.scene = beside_file(sweep.scene);
  for (SweepParameter& parameter : sweep.parameters)
    for (SweepChoice& choice : parameter.choices)
      if (!choice.scene.empty()) choice.scene = beside_file(choice.scene);
  const auto known_figure = [&](const std::string& name) {
    return std::any_of(sweep.figures.begin(), sweep.figures.end(),
                       [&](const SweepFigure& f) { return f.name == name; });
  };
  for (const SweepLimit& limit : sweep.limits)
    if (!known_figure(limit.figure)) t.fail("limits", "figure \"" + limit.figure + "\" is not one of [[figures]]");
  for (SweepPrinted& printed : sweep.printed) {
    if (printed.values.size() > sweep.figures.size())
      t.fail("printed", "\"" + printed.name + "\" has more values than there are [[figures]]");
    printed.values.resize(sweep.figures.size(), std::nan(""));
  }
  std::set<std::string> cases;
  for (const SweepRun& run : runs_of(sweep)) cases.insert(run.group);
  for (const SweepStatement& s : sweep.statements) {
    if (!known_figure(s.figure)) t.fail("statements", "figure \"" + s.figure + "\" is not one of [[figures]]");
    for (const std::string& name : {s.of_case, s.against})
      if (!name.empty() && !cases.count(name))
        t.fail("statements", "the sweep has no case \"" + name + "\"; it has \"" + *cases.begin() + "\" and the like");
  }
  if (!sweep.minimise.empty() && !known_figure(sweep.minimise))
    t.fail("minimise", "\"" + sweep.minimise + "\" is not one of [[figures]]");
  check_fits(sweep);
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
