// The keys of struts, springs and forces. The members of laws are those of mbd_solver/model/laws.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

static void visit_fields(FieldVisitor& v, GasSpringParameters& g) {
  v.field("piston_diameter", &g.piston_diameter, required(positive(Unit::kLength)));
  v.field("pressure", &g.initial_pressure, required(positive(Unit::kPressure)));
  v.field("volume", &g.initial_volume, required(positive(Unit::kVolume)));
  v.field("exponent", &g.exponent, positive());
}

static void visit_fields(FieldVisitor& v, MrGeometry& g) {
  const Rule length = positive(Unit::kLength), not_negative_length = not_negative(Unit::kLength);
  v.fields(required(length), {{"D1", &g.D1}, {"d1", &g.d1}, {"D2", &g.D2}, {"D3", &g.D3}});
  v.fields(length, {{"D4", &g.D4}, {"d", &g.d}});
  v.field("L1", &g.L1, required(length));
  v.field("L2", &g.L2, not_negative_length);
  v.field("L3", &g.L3, required(length));
  v.field("L4", &g.L4, not_negative_length);
  v.field("viscosity", &g.eta, required(positive()));
  v.field("yield_stress", &g.tau_y, required({Unit::kPressure}));
}

static void visit_fields(FieldVisitor& v, MrSpec& m) {
  v.field("yield_force", &m.yield_force, not_negative(Unit::kForce));
  v.field("viscous", &m.viscous_coefficient, not_negative(Unit::kDamping));
  v.field("yield_table", &m.yield_table, {Unit::kForce});
  v.field("regularisation_speed", &m.regularisation_speed, positive(Unit::kVelocity));
  v.field("coil_lag", &m.coil_lag, not_negative(Unit::kTime));
  v.fields(share, {{"initial_voltage", &m.initial_voltage}, {"voltage", &m.voltage}});
  v.fields(name, {{"controller", &m.controller}, {"signal", &m.signal}});
  v.section("geometry", m.geometry);
}

static void visit_fields(FieldVisitor& v, HoneycombStage& s) {
  v.field("force", &s.crush_force, required(positive(Unit::kForce)));
  v.field("length", &s.crush_length, required(positive(Unit::kLength)));
}

static void visit_fields(FieldVisitor& v, HoneycombSpec& h) {
  v.list("stages", h.stages);
  v.fields(plain, {{"compression", &h.compression}, {"tension", &h.tension}});
  v.fields(positive(Unit::kStiffness),
           {{"elastic_stiffness", &h.elastic_stiffness}, {"bottom_out_stiffness", &h.bottom_out_stiffness}});
  v.fields(positive(Unit::kLength), {{"transition_length", &h.transition_length}, {"toe", &h.toe}});
}

static void visit_fields(FieldVisitor& v, EndStopParameters& s) {
  v.fields({Unit::kLength}, {{"min", &s.smallest_stroke}, {"max", &s.largest_stroke}});
  v.field("stiffness", &s.stiffness, positive(Unit::kStiffness));
  v.field("dissipation", &s.dissipation, not_negative());
  v.field("toe", &s.toe, positive(Unit::kLength));
}

static void visit_fields(FieldVisitor& v, LinearSpringSpec& s) {
  v.field("stiffness", &s.stiffness, not_negative(Unit::kStiffness));
  v.field("damping", &s.damping, not_negative(Unit::kDamping));
  v.field("preload", &s.preload, {Unit::kForce});
  v.field("free_length", &s.free_length, positive(Unit::kLength));
}

static void visit_fields(FieldVisitor& v, TableSpec& t) { v.field("file", &t.file, required(path)); }

void visit_fields(FieldVisitor& v, StrutSpec& s) {
  v.entry(s.source, s.name);
  v.field("bodies", &s.bodies, required(name));
  v.field("points", &s.points, required(point));
  v.field("length", &s.length, positive(Unit::kLength));
  each_law(s, [&](const char* key, auto& law) { v.section(key, law); });
}

void visit_fields(FieldVisitor& v, SpringSpec& s) {
  v.entry(s.source, s.name);
  v.choice("kind", s.kind, required());
  v.field("bodies", &s.bodies, required(name));
  v.field("point", &s.point, point);
  v.fields(direction, {{"axis", &s.axis}, {"axis2", &s.axis2}});
  const auto per_axis = [&](const std::string& key, Eigen::Vector3d& values, Unit unit) {
    PerAxis each{&values};
    v.field(key, &each, not_negative(unit));
  };
  per_axis("stiffness", s.stiffness, Unit::kNone);
  per_axis("damping", s.damping, Unit::kNone);
  v.field("rest_angle", &s.rest_angle, {Unit::kAngle});
  per_axis("turning_stiffness", s.rotational_stiffness, Unit::kTurningStiffness);
  per_axis("turning_damping", s.rotational_damping, Unit::kTurningDamping);
}

void visit_fields(FieldVisitor& v, ForceSpec& f) {
  v.entry(f.source, f.name);
  v.field("body", &f.body, required(name));
  v.field("point", &f.point, point);
  v.choice("frame", f.frame);
  v.field("direction", &f.direction, required(direction));
  v.section("force", f.force, Presence::kOptional,
            [](FieldVisitor& w, TimeFunctionSpec& function) { visit_fields(w, function, Unit::kForce); });
  v.section("torque", f.torque, Presence::kOptional,
            [](FieldVisitor& w, TimeFunctionSpec& function) { visit_fields(w, function, Unit::kTorque); });
}

}  // namespace footfall
