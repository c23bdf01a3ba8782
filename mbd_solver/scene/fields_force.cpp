// The keys of struts, springs and forces.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, GasSpec& g) {
  v.field("piston_diameter", &g.piston_diameter, {Unit::kLength, Range::kPositive, Meaning::kPlain, true});
  v.field("pressure", &g.pressure, {Unit::kPressure, Range::kPositive, Meaning::kPlain, true});
  v.field("volume", &g.volume, {Unit::kVolume, Range::kPositive, Meaning::kPlain, true});
  v.field("exponent", &g.exponent, {Unit::kNone, Range::kPositive});
}

void visit_fields(FieldVisitor& v, MrGeometrySpec& g) {
  const Rule length{Unit::kLength, Range::kPositive, Meaning::kPlain, true};
  v.field("D1", &g.D1, length);
  v.field("d1", &g.d1, length);
  v.field("D2", &g.D2, length);
  v.field("D3", &g.D3, length);
  v.field("D4", &g.D4, {Unit::kLength, Range::kPositive});
  v.field("d", &g.d, {Unit::kLength, Range::kPositive});
  v.field("L1", &g.L1, length);
  v.field("L2", &g.L2, {Unit::kLength, Range::kNotNegative});
  v.field("L3", &g.L3, length);
  v.field("L4", &g.L4, {Unit::kLength, Range::kNotNegative});
  v.field("viscosity", &g.viscosity, {Unit::kNone, Range::kPositive, Meaning::kPlain, true});
  v.field("yield_stress", &g.yield_stress, {Unit::kPressure, Range::kAny, Meaning::kPlain, true});
}

void visit_fields(FieldVisitor& v, MrSpec& m) {
  v.field("yield_force", &m.yield_force, {Unit::kForce, Range::kNotNegative});
  v.field("viscous", &m.viscous, {Unit::kDamping, Range::kNotNegative});
  v.field("yield_table", &m.yield_table, {Unit::kForce});
  v.field("regularisation_speed", &m.regularisation_speed, {Unit::kVelocity, Range::kPositive});
  v.field("coil_lag", &m.coil_lag, {Unit::kTime, Range::kNotNegative});
  v.field("initial_voltage", &m.initial_voltage, {Unit::kNone, Range::kUnitInterval});
  v.field("voltage", &m.voltage, {Unit::kNone, Range::kUnitInterval});
  v.field("controller", &m.controller, {Unit::kNone, Range::kAny, Meaning::kName});
  v.field("signal", &m.signal, {Unit::kNone, Range::kAny, Meaning::kName});
  v.section("geometry", m.geometry);
}

void visit_fields(FieldVisitor& v, CrushStageSpec& s) {
  v.field("force", &s.force, {Unit::kForce, Range::kPositive, Meaning::kPlain, true});
  v.field("length", &s.length, {Unit::kLength, Range::kPositive, Meaning::kPlain, true});
}

void visit_fields(FieldVisitor& v, HoneycombSpec& h) {
  v.list("stages", h.stages);
  v.field("compression", &h.compression, {});
  v.field("tension", &h.tension, {});
  v.field("elastic_stiffness", &h.elastic_stiffness, {Unit::kStiffness, Range::kPositive});
  v.field("bottom_out_stiffness", &h.bottom_out_stiffness, {Unit::kStiffness, Range::kPositive});
  v.field("transition_length", &h.transition_length, {Unit::kLength, Range::kPositive});
  v.field("toe", &h.toe, {Unit::kLength, Range::kPositive});
}

void visit_fields(FieldVisitor& v, StopsSpec& s) {
  v.field("min", &s.min, {Unit::kLength});
  v.field("max", &s.max, {Unit::kLength});
  v.field("stiffness", &s.stiffness, {Unit::kStiffness, Range::kPositive});
  v.field("dissipation", &s.dissipation, {Unit::kNone, Range::kNotNegative});
  v.field("toe", &s.toe, {Unit::kLength, Range::kPositive});
}

void visit_fields(FieldVisitor& v, LinearSpringSpec& s) {
  v.field("stiffness", &s.stiffness, {Unit::kStiffness, Range::kNotNegative});
  v.field("damping", &s.damping, {Unit::kDamping, Range::kNotNegative});
  v.field("preload", &s.preload, {Unit::kForce});
  v.field("free_length", &s.free_length, {Unit::kLength, Range::kPositive});
}

void visit_fields(FieldVisitor& v, TableSpec& t) {
  v.field("file", &t.file, {Unit::kNone, Range::kAny, Meaning::kPath, true});
}

void visit_fields(FieldVisitor& v, StrutSpec& s) {
  v.field("", &s.source, {});
  v.field("name", &s.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("bodies", &s.bodies, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("points", &s.points, {Unit::kLength, Range::kAny, Meaning::kPoint, true});
  v.field("length", &s.length, {Unit::kLength, Range::kPositive});
  each_law(s, [&](const char* key, auto& law) { v.section(key, law); });
}

void visit_fields(FieldVisitor& v, SpringSpec& s) {
  v.field("", &s.source, {});
  v.field("name", &s.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.choice("kind", s.kind, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("bodies", &s.bodies, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("point", &s.point, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("axis", &s.axis, {Unit::kNone, Range::kAny, Meaning::kDirection});
  v.field("axis2", &s.axis2, {Unit::kNone, Range::kAny, Meaning::kDirection});
  const auto per_axis = [&](const std::string& key, Eigen::Vector3d& values, Unit unit) {
    PerAxis each{&values};
    v.field(key, &each, {unit, Range::kNotNegative});
  };
  per_axis("stiffness", s.stiffness, Unit::kNone);
  per_axis("damping", s.damping, Unit::kNone);
  v.field("rest_angle", &s.rest_angle, {Unit::kAngle});
  per_axis("turning_stiffness", s.turning_stiffness, Unit::kTurningStiffness);
  per_axis("turning_damping", s.turning_damping, Unit::kTurningDamping);
}

void visit_fields(FieldVisitor& v, ForceSpec& f) {
  v.field("", &f.source, {});
  v.field("name", &f.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("body", &f.body, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("point", &f.point, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.choice("frame", f.frame);
  v.field("direction", &f.direction, {Unit::kNone, Range::kAny, Meaning::kDirection, true});
  v.section("force", f.force, Presence::kOptional,
            [](FieldVisitor& w, TimeFunctionSpec& function) { visit_fields(w, function, Unit::kForce); });
  v.section("torque", f.torque, Presence::kOptional,
            [](FieldVisitor& w, TimeFunctionSpec& function) { visit_fields(w, function, Unit::kTorque); });
}

}  // namespace footfall
