// The keys of signals, states and events.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, SignalSpec& s) {
  const Rule plain{}, not_negative{Unit::kNone, Range::kNotNegative};
  v.field("", &s.source, {});
  v.field("name", &s.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.choice("kind", s.kind, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("input", &s.input, plain);
  v.field("period", &s.period, {Unit::kTime, Range::kNotNegative});
  v.field("states", &s.states, {Unit::kNone, Range::kAny, Meaning::kName});
  v.field("initial", &s.initial, plain);
  v.field("kp", &s.kp, not_negative);
  v.field("ki", &s.ki, not_negative);
  v.field("kd", &s.kd, not_negative);
  v.field("bias", &s.bias, plain);
  v.field("rate", &s.rate, plain);
  v.field("derivative_frequency", &s.derivative_frequency, {Unit::kFrequency, Range::kNotNegative});
  v.field("min", &s.min, plain);
  v.field("max", &s.max, plain);
  v.field("frequency", &s.frequency, {Unit::kFrequency, Range::kNotNegative});
  v.field("damping", &s.damping, {Unit::kNone, Range::kPositive});
  v.field("max_rate", &s.max_rate, not_negative);
  v.field("points", &s.points, plain);
  v.field("input2", &s.input2, plain);
  v.field("x", &s.x, plain);
  v.field("x2", &s.x2, plain);
  v.field("values", &s.values, plain);
  v.field("file", &s.file, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("inputs", &s.inputs, plain);
  v.field("output", &s.output, plain);
}

void visit_fields(FieldVisitor& v, StateSpec& s) {
  v.field("", &s.source, {});
  v.field("name", &s.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
}

void visit_fields(FieldVisitor& v, EventSpec& e) {
  v.field("", &e.source, {});
  v.field("name", &e.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("from", &e.from, {Unit::kNone, Range::kAny, Meaning::kName});
  v.field("when", &e.when, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("to", &e.to, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("period", &e.period, {Unit::kTime, Range::kNotNegative});
}

}  // namespace footfall
