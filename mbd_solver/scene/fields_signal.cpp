// The keys of signals, states and events.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

void visit_fields(FieldVisitor& v, SignalSpec& s) {
  v.entry(s.source, s.name);
  v.choice("kind", s.kind, required());
  v.field("input", &s.input, plain);
  v.field("period", &s.period, not_negative(Unit::kTime));
  v.field("states", &s.states, name);
  v.field("initial", &s.initial, plain);
  v.fields(not_negative(), {{"kp", &s.kp}, {"ki", &s.ki}, {"kd", &s.kd}});
  v.fields(plain, {{"bias", &s.bias}, {"rate", &s.rate}});
  v.field("derivative_frequency", &s.derivative_frequency, not_negative(Unit::kFrequency));
  v.fields(plain, {{"min", &s.min}, {"max", &s.max}});
  v.field("frequency", &s.frequency, not_negative(Unit::kFrequency));
  v.field("damping", &s.damping, positive());
  v.field("max_rate", &s.max_rate, not_negative());
  v.fields(plain, {{"points", &s.points}, {"input2", &s.input2}, {"x", &s.x}, {"x2", &s.x2}, {"values", &s.values}});
  v.field("file", &s.file, path);
  v.fields(plain, {{"inputs", &s.inputs}, {"output", &s.output}});
}

void visit_fields(FieldVisitor& v, StateSpec& s) { v.entry(s.source, s.name); }

void visit_fields(FieldVisitor& v, EventSpec& e) {
  v.entry(e.source, e.name);
  v.field("from", &e.from, name);
  v.field("when", &e.when, required());
  v.field("to", &e.to, required(name));
  v.field("period", &e.period, not_negative(Unit::kTime));
}

}  // namespace footfall
