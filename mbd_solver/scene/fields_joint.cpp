// The keys of joints, prescribed motions, and drives.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, TimeFunctionSpec& f, Unit unit) {
  v.field("polynomial", &f.polynomial, {unit});
  v.field("amplitude", &f.amplitude, {unit});
  v.field("frequency", &f.frequency, {Unit::kFrequency, Range::kNotNegative});
  v.field("phase", &f.phase, {Unit::kAngle});
  v.field("table", &f.table, {unit});
  v.field("signal", &f.signal, {Unit::kNone, Range::kAny, Meaning::kName});
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

void visit_fields(FieldVisitor& v, CoordinateSpec& c, Unit unit) {
  v.section("stops", c.stops, Presence::kOptional, [unit](FieldVisitor& w, JointStopsSpec& s) {
    w.field("min", &s.min, {unit});
    w.field("max", &s.max, {unit});
    w.field("stiffness", &s.stiffness, {Unit::kNone, Range::kPositive, Meaning::kPlain, true});
    w.field("dissipation", &s.dissipation, {Unit::kNone, Range::kNotNegative});
    w.field("toe", &s.toe, {unit, Range::kPositive});
  });
  v.section("friction", c.friction, Presence::kOptional, [unit](FieldVisitor& w, JointFrictionSpec& f) {
    w.field("coulomb", &f.coulomb, {Unit::kNone, Range::kPositive, Meaning::kPlain, true});
    w.field("breakaway", &f.breakaway, {Unit::kNone, Range::kPositive});
    w.field("stribeck_speed", &f.stribeck_speed, {Unit::kNone, Range::kPositive});
    w.field("viscous", &f.viscous, {Unit::kNone, Range::kNotNegative});
    w.field("stick_displacement", &f.stick_displacement, {unit, Range::kPositive});
  });
  v.section("spring", c.spring, Presence::kOptional, [unit](FieldVisitor& w, JointSpringSpec& s) {
    w.field("stiffness", &s.stiffness, {Unit::kNone, Range::kNotNegative});
    w.field("damping", &s.damping, {Unit::kNone, Range::kNotNegative});
    w.field("rest", &s.rest, {unit});
  });
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
  v.field("radius", &j.radius, {Unit::kLength, Range::kPositive});
  v.section("motion", j.motion);
  const auto along = [](FieldVisitor& w, CoordinateSpec& c) { visit_fields(w, c, Unit::kLength); };
  v.section("angle", j.angle, Presence::kOptional,
            [](FieldVisitor& w, CoordinateSpec& c) { visit_fields(w, c, Unit::kAngle); });
  v.section("displacement", j.displacement, Presence::kOptional, along);
  v.section("displacement_x", j.displacement_x, Presence::kOptional, along);
  v.section("displacement_y", j.displacement_y, Presence::kOptional, along);
}

void visit_fields(FieldVisitor& v, GearSpec& g) {
  v.field("", &g.source, {});
  v.field("name", &g.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("joints", &g.joints, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("factors", &g.factors, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("coordinates", &g.coordinates, {});
  v.field("curve", &g.curve, {});
  v.field("closed", &g.closed, {});
}

void visit_fields(FieldVisitor& v, DriveSpec& d) {
  v.field("", &d.source, {});
  v.field("name", &d.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.choice("kind", d.kind, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("joint", &d.joint, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.choice("coordinate", d.coordinate);
  v.section("command", d.command, Presence::kOptional,
            [](FieldVisitor& w, TimeFunctionSpec& function) { visit_fields(w, function, Unit::kNone); });
  v.field("kp", &d.kp, {Unit::kNone, Range::kNotNegative});
  v.field("ki", &d.ki, {Unit::kNone, Range::kNotNegative});
  v.field("kd", &d.kd, {Unit::kNone, Range::kNotNegative});
  v.field("max_torque", &d.max_torque, {Unit::kTorque, Range::kPositive});
  v.field("max_speed", &d.max_speed, {Unit::kAngularVelocity, Range::kPositive});
  v.field("gear_ratio", &d.gear_ratio, {Unit::kNone, Range::kPositive});
  v.field("efficiency", &d.efficiency, {Unit::kNone, Range::kUnitInterval});
  v.field("lag", &d.lag, {Unit::kTime, Range::kPositive});
  v.field("rotor_inertia", &d.rotor_inertia, {Unit::kInertia, Range::kNotNegative});
}

}  // namespace footfall
