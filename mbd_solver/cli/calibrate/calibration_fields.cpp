// The keys of a calibration's file, described as those of a scene are (scene/field_visitor.h).
#include "mbd_solver/cli/calibrate/calibration.h"
#include "mbd_solver/scene/field_visitor.h"
#include "mbd_solver/scene/scene_schema.h"

namespace footfall {

namespace {

const Rule kAnything{};
const Rule kNeeded{Unit::kNone, Range::kAny, Meaning::kPlain, true};
const Rule kTexts{Unit::kNone, Range::kAny, Meaning::kWords};
const Rule kAboveZero{Unit::kNone, Range::kPositive};
const Rule kNeededAboveZero{Unit::kNone, Range::kPositive, Meaning::kPlain, true};
const Rule kZeroOrMore{Unit::kNone, Range::kNotNegative};
const Rule kShare{Unit::kNone, Range::kUnitInterval};

}  // namespace

static void visit_fields(FieldVisitor& v, SoughtParameter& p) {
  v.field("", &p.source, kAnything);
  v.field("name", &p.name, kNeeded);
  v.field("settings", &p.settings, kTexts);
  v.field("least", &p.least, kNeeded);
  v.field("most", &p.most, kNeeded);
  v.field("start", &p.start, kAnything);
  v.field("source", &p.origin, kAnything);
  v.choice("scale", p.scale);
}

static void visit_fields(FieldVisitor& v, CalibrationScene& s) {
  v.field("", &s.source, kAnything);
  v.field("name", &s.name, kNeeded);
  v.field("scene", &s.scene, kAnything);
  v.field("settings", &s.settings, kTexts);
  v.field("until", &s.until, kZeroOrMore);
}

static void visit_fields(FieldVisitor& v, SeedsSpec& s) {
  v.field("", &s.source, kAnything);
  v.field("settings", &s.settings, kTexts);
  v.field("values", &s.values, kTexts);
  v.field("search", &s.search, kAboveZero);
}

static void visit_fields(FieldVisitor& v, StageSpec& s) {
  v.field("", &s.source, kAnything);
  v.choice("method", s.method, kNeeded);
  v.field("evaluations", &s.evaluations, kNeededAboveZero);
  v.field("seed", &s.seed, kZeroOrMore);
  v.field("precision", &s.precision, kAboveZero);
  v.field("settings", &s.settings, kTexts);
  v.field("until", &s.until, kZeroOrMore);
}

static void visit_fields(FieldVisitor& v, CalibrationLimits& l) {
  v.field("runs", &l.runs, kZeroOrMore);
  v.field("hours", &l.hours, kZeroOrMore);
}

static void visit_fields(FieldVisitor& v, TargetSpec& t) {
  v.field("", &t.source, kAnything);
  v.field("name", &t.name, kAnything);
  v.field("figure", &t.figure, kAnything);
  v.field("scene", &t.scene, kAnything);
  v.field("against", &t.against, kAnything);
  v.field("value", &t.value, kAnything);
  v.field("least", &t.least, kAnything);
  v.field("most", &t.most, kAnything);
  v.field("column", &t.column, kAnything);
  v.field("over", &t.over, kAnything);
  v.field("file", &t.file, kAnything);
  v.field("tolerance", &t.tolerance, kNeededAboveZero);
  v.field("weight", &t.weight, kZeroOrMore);
  v.field("source", &t.origin, kAnything);
}

static void visit_fields(FieldVisitor& v, ConstraintSpec& c) {
  v.field("", &c.source, kAnything);
  v.field("name", &c.name, kNeeded);
  v.field("formula", &c.formula, kNeeded);
  v.field("least", &c.least, kAnything);
  v.field("most", &c.most, kAnything);
}

void visit_fields(FieldVisitor& v, CalibrationSpec& s) {
  v.field("", &s.source, kAnything);
  v.field("title", &s.title, kAnything);
  v.field("scene", &s.scene, kAnything);
  v.field("settings", &s.settings, kTexts);
  v.field("until", &s.until, kZeroOrMore);
  v.field("time_limit", &s.time_limit, kZeroOrMore);
  v.field("step", &s.step, kAboveZero);
  v.field("confidence", &s.confidence, kShare);
  v.field("failed", &s.failed, kAboveZero);
  v.field("cap", &s.cap, kZeroOrMore);
  v.field("confirm", &s.confirm, kAboveZero);
  v.field("alone", &s.alone, kZeroOrMore);
  v.section("seeds", s.seeds);
  v.section("limits", s.limits);
  v.list("parameters", s.parameters);
  v.list("scenes", s.scenes);
  v.list("stages", s.stages);
  v.list("figures", s.figures);
  v.list("targets", s.targets);
  v.list("constraints", s.constraints);
}

std::string calibration_schema() {
  CalibrationSpec defaults;
  return schema_of("Calibration of footfall", [&](FieldVisitor& v) { visit_fields(v, defaults); });
}

}  // namespace footfall
