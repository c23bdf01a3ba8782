// The keys of joints and prescribed motions.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, TimeFunctionSpec& f, Unit unit) {
  v.field("polynomial", &f.polynomial, {unit});
  v.field("amplitude", &f.amplitude, {unit});
  v.field("frequency", &f.frequency, {Unit::kFrequency, Range::kNotNegative});
  v.field("phase", &f.phase, {Unit::kAngle});
  v.field("table", &f.table, {unit});
}

void visit_fields(FieldVisitor& v, MotionSpec& m) {
  const auto length = [](FieldVisitor& w, TimeFunctionSpec& f) { visit_fields(w, f, Unit::kLength); };
  const auto angle = [](FieldVisitor& w, TimeFunctionSpec& f) { visit_fields(w, f, Unit::kAngle); };
  v.section("x", m.x, Presence::kOptional, length);
  v.section("y", m.y, Presence::kOptional, length);
  v.section("z", m.z, Presence::kOptional, length);
  v.section("rotation", m.rotation, Presence::kOptional, angle);
  v.field("hold_other_rotations", &m.hold_other_rotations, {});
}

void visit_fields(FieldVisitor& v, JointSpec& j) {
  v.field("", &j.source, {});
  v.field("name", &j.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.choice("type", j.type, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("bodies", &j.bodies, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("point", &j.point, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("point_a", &j.point_a, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("point_b", &j.point_b, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("axis", &j.axis, {Unit::kNone, Range::kAny, Meaning::kDirection});
  v.field("axis2", &j.axis2, {Unit::kNone, Range::kAny, Meaning::kDirection});
  v.field("length", &j.length, {Unit::kLength, Range::kPositive});
  v.section("motion", j.motion);
}

}  // namespace footfall
