#include "mbd_solver/cli/experiments/study.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>

#include "coupler/base/errors.h"
#include "coupler/base/nearest_name.h"
#include "mbd_solver/cli/experiments/figure_reader.h"
#include "mbd_solver/cli/experiments/table_reader.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {
namespace {

void read_curve(TableReader& t, CurveSpec& c) {
  t.take("name", c.name);
  t.take("scene", c.scene);
  t.take("settings", c.settings);
  t.take("reference", c.reference);
  t.take("values", c.values);
  t.take("short", c.short_values);
  t.take("beside", c.beside);
  t.take("default", c.default_value);
  t.take("scale", c.scale);
  t.require("name", !c.name.empty());
  t.require("values", !c.values.empty());
  if (c.short_values.empty()) c.short_values = {c.values.front()};
  const auto known = [&](const std::string& value) {
    return std::find(c.values.begin(), c.values.end(), value) != c.values.end();
  };
  if (!c.beside.empty() && c.beside.size() != c.values.size())
    t.fail(*t.next("beside"), "beside",
           "has " + std::to_string(c.beside.size()) + " entries, expected one for each of the " +
               std::to_string(c.values.size()) + " values");
  if (!c.beside.empty() && !std::all_of(c.short_values.begin(), c.short_values.end(), known))
    t.fail(*t.next("short"), "short", "expected some of the values");
  if (!c.default_value.empty() && !known(c.default_value))
    t.fail(*t.next("default"), "default", "is \"" + c.default_value + "\", expected one of the values");
}

void read_measure(TableReader& t, MeasureSpec& m) {
  std::string kind = "rms";
  t.take("name", m.name);
  t.take("kind", kind);
  t.require("name", !m.name.empty());
  if (kind == "figure") {
    m.kind = MeasureKind::kFigure;
    m.figure.name = m.name;
    take_figure(t, m.figure);
    return;
  }
  t.take("columns", m.columns);
  t.take("key", m.key);
  t.take("until", m.until);
  if (kind == "rms") {
    m.kind = MeasureKind::kRms;
  } else if (kind == "final") {
    m.kind = MeasureKind::kFinal;
  } else if (kind == "own") {
    m.kind = MeasureKind::kOwn;
  } else {
    t.fail(*t.next("kind"), "kind", "is \"" + kind + "\", expected rms, final, figure or own");
  }
  const bool of_history = m.kind == MeasureKind::kRms || m.kind == MeasureKind::kFinal;
  t.require(of_history ? "columns" : "key", of_history ? !m.columns.empty() : !m.key.empty());
}

void read_expect(TableReader& t, ExpectSpec& e) {
  std::vector<std::string> order;
  t.take("curve", e.curve);
  t.take("measure", e.measure);
  t.take("order", order);
  t.take("error", e.most_error);
  if (order.empty()) return;
  if (order.size() != 2) t.fail(*t.next("order"), "order", "expected [least, most]");
  e.least_order = std::stod(order[0]);
  e.most_order = std::stod(order[1]);
}

void read_case(TableReader& t, CaseSpec& c) {
  t.take("name", c.name);
  t.take("group", c.group);
  t.take("scene", c.scene);
  t.take("settings", c.settings);
  t.take("values", c.values);
  t.take("expect", c.expect);
  t.take("message", c.message);
  t.take("reference", c.reference);
  t.take("columns", c.columns);
  t.take("at_end", c.at_end);
  t.take("tolerance", c.tolerance);
  t.take("order_beyond", c.order_beyond);
  t.take("until", c.until);
  t.require("name", !c.name.empty());
  t.require("expect", !c.expect.empty());
  if (c.expect.size() != 1 && c.expect.size() != c.values.size())
    t.fail(*t.next("expect"), "expect", "expected one verdict for all, or one per value");
  for (const std::string& verdict : c.expect)
    if (verdict != "accurate" && verdict != "warned" && verdict != "stopped" && verdict != "refused")
      t.fail(*t.next("expect"), "expect", "is \"" + verdict + "\", expected accurate, warned, stopped or refused");
}

}  // namespace

StudySpec read_study(const std::string& file) {
  namespace fs = std::filesystem;
  const ConfigNode root = parse_toml_file(file);
  StudySpec s;
  s.file = file;
  s.folder = fs::absolute(file).parent_path().string();
  TableReader t(file, "", root);
  t.take("title", s.title);
  t.take("scene", s.scene);
  t.take("x_name", s.x_name);
  t.take("settings", s.settings);
  t.take("until", s.until);
  t.take("short_settings", s.short_settings);
  t.take("short_until", s.short_until);
  t.take("repeats", s.repeats);
  t.take("time_limit", s.time_limit);
  if (const ConfigNode* node = t.next("reference")) {
    TableReader reference(file, "reference", *node);
    reference.take("settings", s.reference);
    reference.take("scene", s.reference_scene);
    reference.done();
    s.has_reference = true;
  }
  if (const ConfigNode* node = t.next("ensemble")) {
    TableReader ensemble(file, "ensemble", *node);
    ensemble.take("settings", s.ensemble_settings);
    ensemble.take("values", s.ensemble_values);
    ensemble.take("short", s.ensemble_short);
    ensemble.done();
    ensemble.require("values", !s.ensemble_values.empty());
  }
  t.take_list("curves", s.curves, read_curve);
  t.take_list("measures", s.measures, read_measure);
  t.take_list("expect", s.expect, read_expect);
  t.take_list("cases", s.cases, read_case);
  std::vector<std::string> omega_h;
  t.take("omega_h", omega_h);
  t.take("substeps", s.substeps);
  t.done();
  if (s.substeps < 1) t.fail(root, "substeps", "is " + std::to_string(s.substeps) + ", expected 1 or more");
  for (const std::string& text : omega_h) {
    char* end = nullptr;
    s.omega_h.push_back(std::strtod(text.c_str(), &end));
    if (*end != '\0' || !(s.omega_h.back() > 0.0))
      t.fail(root, "omega_h", "has \"" + text + "\", expected numbers above 0");
  }
  if (!s.omega_h.empty() && s.curves.empty() && s.cases.empty()) return s;
  if (s.curves.empty() == s.cases.empty())
    t.fail(root, "", "expected [[curves]] (a study) or [[cases]] (a stability map)");
  if (!s.curves.empty() && s.measures.empty()) t.fail(root, "measures", "is missing");
  for (const MeasureSpec& m : s.measures)
    if (m.kind != MeasureKind::kOwn && !s.has_reference)
      t.fail(root, "reference", "is missing; measure \"" + m.name + "\" compares with it");
  std::vector<std::string> curves, measures;
  for (const CurveSpec& c : s.curves) curves.push_back(c.name);
  for (const MeasureSpec& m : s.measures) measures.push_back(m.name);
  for (const ExpectSpec& e : s.expect) {
    if (std::find(curves.begin(), curves.end(), e.curve) == curves.end())
      t.fail(root, "expect.curve", "unknown curve \"" + e.curve + "\"" + known_names("curves", e.curve, curves));
    if (std::find(measures.begin(), measures.end(), e.measure) == measures.end())
      t.fail(root, "expect.measure",
             "unknown measure \"" + e.measure + "\"" + known_names("measures", e.measure, measures));
  }
  return s;
}

std::vector<std::string> settings_of(const CurveSpec& curve, const std::string& value) {
  const auto at = std::find(curve.values.begin(), curve.values.end(), value);
  const std::vector<std::string> settings = filled(curve.settings, value);
  return curve.beside.empty() || at == curve.values.end()
             ? settings
             : filled(settings, curve.beside[static_cast<std::size_t>(at - curve.values.begin())], "{beside}");
}

std::vector<std::string> filled(std::vector<std::string> texts, const std::string& value, const std::string& mark) {
  for (std::string& text : texts)
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size()))
      text.replace(at, mark.size(), value);
  return texts;
}

}  // namespace footfall
