// The keys of an experiment's file, described as those of a scene are (scene/field_visitor.h).
#include "mbd_solver/cli/experiments/experiment.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/scene_schema.h"

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

}  // namespace footfall
