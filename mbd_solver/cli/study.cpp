#include "mbd_solver/cli/study.h"

#include <algorithm>
#include <filesystem>

#include "coupler/errors.h"
#include "mbd_solver/scene/config_node.h"
#include "mbd_solver/scene/findings.h"

namespace footfall {
namespace {

// One table of the file: takes keys one by one; what nobody took is unknown.
class TableReader {
 public:
  TableReader(const std::string& file, const std::string& path, const ConfigNode& node) : file_(file), path_(path), node_(node) {
    if (node.kind != ConfigNode::Kind::kTable) fail(node, "", "is " + node.description() + ", expected a table");
  }

  void take(const std::string& key, std::string& out) {
    if (const ConfigNode* value = next(key)) out = text(key, *value);
  }
  void take(const std::string& key, double& out) {
    const ConfigNode* value = next(key);
    if (!value) return;
    if (!value->is_number()) fail(*value, key, "is " + value->description() + ", expected a number");
    out = value->number;
  }
  void take(const std::string& key, int& out) {
    double number = out;
    take(key, number);
    out = static_cast<int>(number);
  }
  void take(const std::string& key, bool& out) {
    const ConfigNode* value = next(key);
    if (!value) return;
    if (value->kind != ConfigNode::Kind::kFlag) fail(*value, key, "is " + value->description() + ", expected true or false");
    out = value->flag;
  }
  // A list of texts and numbers, or one of them.
  void take(const std::string& key, std::vector<std::string>& out) {
    const ConfigNode* value = next(key);
    if (!value) return;
    out.clear();
    if (value->kind != ConfigNode::Kind::kList) {
      out.push_back(text(key, *value));
      return;
    }
    for (const ConfigNode& entry : value->list) out.push_back(text(key, entry));
  }
  template <class Spec, class Read>
  void take_list(const std::string& key, std::vector<Spec>& out, const Read& read) {
    const ConfigNode* value = next(key);
    if (!value) return;
    if (value->kind != ConfigNode::Kind::kList) fail(*value, key, "expected [[" + key + "]]");
    for (const ConfigNode& entry : value->list) {
      TableReader table(file_, key, entry);
      out.emplace_back();
      read(table, out.back());
      table.done();
    }
  }
  // A table within this one, or null.
  const ConfigNode* next(const std::string& key) {
    known_.push_back(key);
    return node_.find(key);
  }
  void require(const std::string& key, bool given) const {
    if (!given) fail(node_, key, "is missing");
  }
  void done() const {
    for (const auto& [key, value] : node_.table) {
      if (std::find(known_.begin(), known_.end(), key) != known_.end()) continue;
      const std::string guess = closest_name(key, known_);
      fail(value, key, "is not known" + (guess.empty() ? "" : "; did you mean \"" + guess + "\"?"));
    }
  }
  [[noreturn]] void fail(const ConfigNode& at, const std::string& key, const std::string& what) const {
    throw InputError(file_ + ":" + std::to_string(at.line) + ": " + (path_.empty() || key.empty() ? path_ : path_ + ".") + key + ": " + what);
  }

 private:
  std::string text(const std::string& key, const ConfigNode& value) const {
    if (value.kind == ConfigNode::Kind::kText) return value.text;
    if (!value.is_number()) fail(value, key, "is " + value.description() + ", expected a text or a number");
    return short_number(value.number);
  }

  std::string file_, path_;
  const ConfigNode& node_;
  std::vector<std::string> known_;
};

void read_curve(TableReader& t, CurveSpec& c) {
  t.take("name", c.name);
  t.take("scene", c.scene);
  t.take("settings", c.settings);
  t.take("values", c.values);
  t.take("short", c.short_values);
  t.take("scale", c.scale);
  t.require("name", !c.name.empty());
  t.require("values", !c.values.empty());
  if (c.short_values.empty()) c.short_values = {c.values.front()};
}

void read_measure(TableReader& t, MeasureSpec& m) {
  std::string kind = "rms";
  t.take("name", m.name);
  t.take("kind", kind);
  t.take("columns", m.columns);
  t.take("key", m.key);
  t.require("name", !m.name.empty());
  if (kind == "rms") {
    m.kind = MeasureKind::kRms;
  } else if (kind == "final") {
    m.kind = MeasureKind::kFinal;
  } else if (kind == "figure") {
    m.kind = MeasureKind::kFigure;
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
  t.done();
  if (s.curves.empty() == s.cases.empty()) t.fail(root, "", "expected [[curves]] (a study) or [[cases]] (a stability map)");
  if (!s.curves.empty() && s.measures.empty()) t.fail(root, "measures", "is missing");
  for (const MeasureSpec& m : s.measures)
    if (m.kind != MeasureKind::kOwn && !s.has_reference) t.fail(root, "reference", "is missing; measure \"" + m.name + "\" compares with it");
  std::vector<std::string> curves, measures;
  for (const CurveSpec& c : s.curves) curves.push_back(c.name);
  for (const MeasureSpec& m : s.measures) measures.push_back(m.name);
  for (const ExpectSpec& e : s.expect) {
    if (std::find(curves.begin(), curves.end(), e.curve) == curves.end())
      t.fail(root, "expect.curve", "unknown curve \"" + e.curve + "\"" + known_names("curves", e.curve, curves));
    if (std::find(measures.begin(), measures.end(), e.measure) == measures.end())
      t.fail(root, "expect.measure", "unknown measure \"" + e.measure + "\"" + known_names("measures", e.measure, measures));
  }
  return s;
}

std::vector<std::string> filled(std::vector<std::string> texts, const std::string& value) {
  static const std::string mark = "{value}";
  for (std::string& text : texts)
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + value.size())) text.replace(at, mark.size(), value);
  return texts;
}

}  // namespace footfall
