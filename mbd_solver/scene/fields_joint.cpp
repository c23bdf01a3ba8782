// The keys of joints, prescribed motions, gears and drives.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

void visit_fields(FieldVisitor& v, TimeFunctionSpec& f, Unit unit) {
  v.fields({unit}, {{"polynomial", &f.polynomial}, {"amplitude", &f.amplitude}});
  v.field("frequency", &f.frequency, not_negative(Unit::kFrequency));
  v.field("phase", &f.phase, {Unit::kAngle});
  v.field("table", &f.table, {unit});
  v.field("signal", &f.signal, name);
}

static void visit_fields(FieldVisitor& v, MotionSpec& m) {
  const auto length = [](FieldVisitor& w, TimeFunctionSpec& f) { visit_fields(w, f, Unit::kLength); };
  const auto angle = [](FieldVisitor& w, TimeFunctionSpec& f) { visit_fields(w, f, Unit::kAngle); };
  v.section("x", m.x, Presence::kOptional, length);
  v.section("y", m.y, Presence::kOptional, length);
  v.section("z", m.z, Presence::kOptional, length);
  v.section("rotation", m.rotation, Presence::kOptional, angle);
  v.field("hold_other_rotations", &m.hold_other_rotations, plain);
}

static void visit_fields(FieldVisitor& v, CoordinateSpec& c, Unit unit) {
  v.section("stops", c.stops, Presence::kOptional, [unit](FieldVisitor& w, EndStopParameters& s) {
    w.fields({unit}, {{"min", &s.smallest_stroke}, {"max", &s.largest_stroke}});
    w.field("stiffness", &s.stiffness, required(positive()));
    w.field("dissipation", &s.dissipation, not_negative());
    w.field("toe", &s.toe, positive(unit));
  });
  v.section("friction", c.friction, Presence::kOptional, [unit](FieldVisitor& w, JointFrictionParameters& f) {
    w.field("coulomb", &f.coulomb, required(positive()));
    w.fields(positive(), {{"breakaway", &f.breakaway}, {"stribeck_speed", &f.stribeck_speed}});
    w.field("viscous", &f.viscous, not_negative());
    w.field("stick_displacement", &f.stick_displacement, positive(unit));
  });
  v.section("spring", c.spring, Presence::kOptional, [unit](FieldVisitor& w, LinearSpringDamperParameters& s) {
    w.fields(not_negative(), {{"stiffness", &s.stiffness}, {"damping", &s.damping}});
    w.field("rest", &s.free_stroke, {unit});
  });
}

void visit_fields(FieldVisitor& v, JointSpec& j) {
  v.entry(j.source, j.name);
  v.choice("type", j.type, required());
  v.field("bodies", &j.bodies, required(name));
  v.fields(point, {{"point", &j.point}, {"point_a", &j.point_a}, {"point_b", &j.point_b}});
  v.fields(direction, {{"axis", &j.axis}, {"axis2", &j.axis2}});
  v.fields(positive(Unit::kLength), {{"length", &j.length}, {"radius", &j.radius}});
  v.section("motion", j.motion);
  const auto along = [](FieldVisitor& w, CoordinateSpec& c) { visit_fields(w, c, Unit::kLength); };
  v.section("angle", j.angle, Presence::kOptional,
            [](FieldVisitor& w, CoordinateSpec& c) { visit_fields(w, c, Unit::kAngle); });
  v.section("displacement", j.displacement, Presence::kOptional, along);
  v.section("displacement_x", j.displacement_x, Presence::kOptional, along);
  v.section("displacement_y", j.displacement_y, Presence::kOptional, along);
}

void visit_fields(FieldVisitor& v, GearSpec& g) {
  v.entry(g.source, g.name);
  v.field("joints", &g.joints, required(name));
  v.field("factors", &g.factors, required());
  v.fields(plain, {{"coordinates", &g.coordinates}, {"curve", &g.curve}, {"closed", &g.closed}});
}

void visit_fields(FieldVisitor& v, DriveSpec& d) {
  MotorParameters& m = d.motor;
  v.entry(d.source, d.name);
  v.choice("kind", m.kind, required());
  v.field("joint", &d.joint, required(name));
  v.choice("coordinate", d.coordinate, "auto");
  v.section("command", d.command, Presence::kOptional,
            [](FieldVisitor& w, TimeFunctionSpec& function) { visit_fields(w, function, Unit::kNone); });
  v.fields(not_negative(), {{"kp", &m.kp}, {"ki", &m.ki}, {"kd", &m.kd}});
  v.field("max_torque", &m.largest_torque, positive(Unit::kTorque));
  v.field("max_speed", &m.no_load_speed, positive(Unit::kAngularVelocity));
  v.field("gear_ratio", &m.gear_ratio, positive());
  v.field("efficiency", &m.efficiency, share);
  v.field("lag", &d.lag, positive(Unit::kTime));
  v.field("rotor_inertia", &d.rotor_inertia, not_negative(Unit::kInertia));
}

}  // namespace footfall
