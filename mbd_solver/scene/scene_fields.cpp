// The keys of every part of a scene: name, member, unit, range and meaning, each once.

#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

static void visit_fields(FieldVisitor& v, TimeFunctionSpec& f, Unit unit);

// ---- the scene ----

static void visit_fields(FieldVisitor& v, ArraySpec& a) {
  v.field("", &a.source, {});
  v.field("count", &a.count, required(positive()));
  v.fields({Unit::kAngle}, {{"start", &a.start}, {"step", &a.step}});
  v.field("axis", &a.axis, direction);
}

void visit_fields(FieldVisitor& v, Scene& s) {
  v.field("", &s.source, {});
  v.field("title", &s.title, plain);
  v.field("end_time", &s.end_time, required(positive(Unit::kTime)));
  v.field("gravity", &s.gravity, {Unit::kAcceleration});
  v.field("total_mass", &s.total_mass, positive(Unit::kMass));
  v.field("flexible", &s.flexible, plain);
  v.list("arrays", s.arrays, true);
  v.list("materials", s.materials, true);
  v.list("bodies", s.bodies);
  v.list("joints", s.joints);
  v.list("struts", s.struts);
  v.list("cables", s.cables);
  v.list("springs", s.springs);
  v.list("forces", s.forces);
  v.list("drives", s.drives);
  v.list("gears", s.gears);
  v.list("boundaries", s.boundaries);
  v.list("contacts", s.contacts);
  v.section("ground", s.ground);
  v.section("particles", s.particles);
  v.list("controllers", s.controllers);
  v.list("signals", s.signals);
  v.list("states", s.states);
  v.list("events", s.events);
  v.section("initial", s.initial);
  v.section("solver", s.solver);
  v.section("coupling", s.coupling);
  v.section("output", s.output);
  v.section("landing", s.landing);
  v.list("requirements", s.requirements);
  v.field("accepted", &s.accepted, plain);
}

// The keys of materials and bodies.

static void visit_fields(FieldVisitor& v, MaterialSpec& m) {
  v.field("", &m.source, {});
  v.field("density", &m.density, required(positive(Unit::kDensity)));
  v.field("young", &m.young, positive(Unit::kPressure));
  v.field("poisson", &m.poisson, plain);
  v.field("yield_stress", &m.yield_stress, not_negative(Unit::kPressure));
}

static void visit_fields(FieldVisitor& v, ShapeSpec& s) {
  v.choice("kind", s.kind, required());
  v.field("centre", &s.centre, point);
  v.field("axis", &s.axis, direction);
  v.fields(point, {{"from", &s.from}, {"to", &s.to}});
  v.fields(positive(Unit::kLength), {{"size", &s.size},
                                     {"diameter", &s.diameter},
                                     {"wall", &s.wall},
                                     {"radius", &s.radius},
                                     {"length", &s.length},
                                     {"thickness", &s.thickness},
                                     {"depth", &s.depth}});
  v.field("points", &s.points, point);
  v.field("file", &s.file, path);
  v.field("scale", &s.scale, positive());
  v.field("position", &s.position, point);
  v.field("orientation", &s.orientation, plain);
}

static void visit_fields(FieldVisitor& v, SectionSpec& s) {
  v.fields(positive(Unit::kLength), {{"diameter", &s.diameter}, {"wall", &s.wall}});
  v.field("area", &s.area, positive(Unit::kArea));
  v.fields(positive(Unit::kArea2), {{"bending_y", &s.bending_y}, {"bending_z", &s.bending_z}, {"torsion", &s.torsion}});
}

static void visit_fields(FieldVisitor& v, MemberSpec& m) {
  v.fields(required(not_negative()), {{"first", &m.first}, {"second", &m.second}});
  v.field("section", &m.section, required(name));
  v.field("elements", &m.elements, positive());
}

static void visit_fields(FieldVisitor& v, InterfaceSpec& i) {
  v.field("node_set", &i.node_set, required());
  v.choice("kind", i.kind);
  v.field("point", &i.point, point);
}

static void visit_fields(FieldVisitor& v, FlexibleSpec& f) {
  v.field("enabled", &f.enabled, plain);
  v.choice("basis", f.basis);
  v.field("modes", &f.modes, not_negative());
  v.field("max_frequency", &f.max_frequency, positive(Unit::kFrequency));
  v.field("damping", &f.damping, not_negative());
  v.fields(positive(), {{"elements", &f.elements}, {"segments", &f.segments}});
  v.field("mesh_size", &f.mesh_size, positive(Unit::kLength));
  v.field("mesh", &f.mesh, path);
  v.field("mesh_scale", &f.mesh_scale, positive());
  v.field("thickness", &f.thickness, positive(Unit::kLength));
  v.fields(path, {{"file", &f.file},
                  {"stiffness_matrix", &f.stiffness_matrix},
                  {"mass_matrix", &f.mass_matrix},
                  {"node_file", &f.node_file},
                  {"dof_file", &f.dof_file},
                  {"stress_file", &f.stress_file}});
  v.choice("units", f.units);
  v.list("interfaces", f.interfaces);
  v.field("nodes", &f.nodes, point);
  v.list("members", f.members);
  v.list("sections", f.sections, true);
}

void visit_fields(FieldVisitor& v, BodySpec& b) {
  v.entry(b.source, b.name);
  v.section("shape", b.shape);
  v.field("material", &b.material, name);
  NumberOrWord mass{&b.mass, "remainder", &b.mass_is_remainder};
  v.field("mass", &mass, positive(Unit::kMass));
  v.field("inertia", &b.inertia, positive(Unit::kInertia));
  v.field("position", &b.position, point);
  v.field("orientation", &b.orientation, plain);
  v.section("flexible", b.flexible, Presence::kSwitch);
}

// The keys of joints, prescribed motions, gears and drives.

static void visit_fields(FieldVisitor& v, TimeFunctionSpec& f, Unit unit) {
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
  v.choice("kind", j.type, required());
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
  v.field("max_force", &m.largest_torque, positive(Unit::kForce));  // of a drive on a displacement
  v.field("max_speed", &m.no_load_speed, positive(Unit::kAngularVelocity));
  v.field("gear_ratio", &m.gear_ratio, positive());
  v.field("efficiency", &m.efficiency, share);
  v.field("lag", &d.lag, positive(Unit::kTime));
  v.field("rotor_inertia", &d.rotor_inertia, not_negative(Unit::kInertia));
}

// The keys of struts, springs and forces. The members of laws come from mbd_solver/model/laws.

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
  v.field("initial_voltage", &m.initial_voltage, share);
  v.field("voltage", &m.voltage, share);
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
  v.field("free_length", &s.free_length, not_negative(Unit::kLength));
}

static void visit_fields(FieldVisitor& v, TableSpec& t) { v.field("file", &t.file, required(path)); }

void visit_fields(FieldVisitor& v, StrutSpec& s) {
  v.entry(s.source, s.name);
  v.field("bodies", &s.bodies, required(name));
  v.field("points", &s.points, required(point));
  v.field("length", &s.length, positive(Unit::kLength));
  each_law(s, [&](const char* key, auto& law) { v.section(key, law); });
}

static void visit_fields(FieldVisitor& v, CableGuideSpec& g) {
  v.field("body", &g.body, required(name));
  v.field("point", &g.point, required(point));
  v.field("radius", &g.radius, positive(Unit::kLength));
  v.field("axis", &g.axis, direction);
  v.field("grip", &g.grip, plain);
  v.field("turns", &g.turns, not_negative());
}

void visit_fields(FieldVisitor& v, CableSpec& c) {
  v.entry(c.source, c.name);
  v.list("path", c.path);
  v.field("stiffness", &c.stiffness, positive(Unit::kStiffness));
  v.field("EA", &c.EA, positive(Unit::kForce));
  v.field("damping", &c.damping, not_negative(Unit::kDamping));
  v.field("length", &c.length, positive(Unit::kLength));
  v.field("slack", &c.slack, not_negative(Unit::kLength));
  v.field("tension", &c.tension, not_negative(Unit::kForce));
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

// The keys of boundaries, contacts, ground and particles.

static void visit_fields(FieldVisitor& v, SurfaceSpec& s) {
  v.field("element_size", &s.element_size, positive(Unit::kLength));
  v.field("file", &s.file, path);
  v.field("from_script", &s.from_script, name);
  v.field("scale", &s.scale, positive());
  v.field("position", &s.position, point);
  v.fields(plain, {{"orientation", &s.orientation}, {"closed", &s.closed}});
  v.field("triangles", &s.triangles, positive());
  v.choice("faces", s.faces);
}

static void visit_fields(FieldVisitor& v, BeamsSpec& b) {
  v.field("radius", &b.radius, positive(Unit::kLength));
  v.field("segments", &b.segments, positive());
  v.field("points", &b.points, point);
}

void visit_fields(FieldVisitor& v, BoundarySpec& b) {
  v.field("", &b.source, {});
  v.field("body", &b.body, required(name));
  v.section("surface", b.surface);
  v.section("beams", b.beams);
}

namespace {

void visit_law(FieldVisitor& v, ContactLawSpec& p) {
  v.field("young", &p.young, positive(Unit::kPressure));
  v.field("poisson", &p.poisson, plain);
  v.field("contact_radius", &p.contact_radius, positive(Unit::kLength));
  v.field("stiffness", &p.stiffness, positive());
  v.field("restitution", &p.restitution, share);
  v.field("impact_speed", &p.impact_speed, positive(Unit::kVelocity));
  v.fields(not_negative(), {{"damping", &p.damping}, {"friction", &p.friction}});
  v.field("friction_speed", &p.friction_speed, positive(Unit::kVelocity));
}

}  // namespace

static void visit_fields(FieldVisitor& v, PlaneSpec& p) {
  v.field("point", &p.point, {Unit::kLength});
  v.field("normal", &p.normal, direction);
  visit_law(v, p);
  v.field("bodies", &p.bodies, name);
}

void visit_fields(FieldVisitor& v, ContactSpec& c) {
  v.field("", &c.source, {});
  v.field("between", &c.between, name);
  v.field("walls", &c.walls, plain);
  v.field("bodies", &c.bodies, name);
  v.field("ignore", &c.ignore, plain);
  v.field("point", &c.point, point);
  v.field("normal", &c.normal, direction);
  visit_law(v, c);
}

static void visit_fields(FieldVisitor& v, SoilSpec& s) {
  v.choice("kind", s.kind);
  v.field("point", &s.point, {Unit::kLength});
  v.field("normal", &s.normal, direction);
  v.field("bodies", &s.bodies, name);
  v.field("density", &s.density, positive(Unit::kDensity));
  v.field("inertia", &s.inertia, not_negative());
  v.field("speed_resistance", &s.speed_resistance, not_negative());
  v.fields(positive(Unit::kLength), {{"speed_depth", &s.speed_depth}, {"fitted_depth", &s.fitted_depth}});
  v.field("fitted_speed", &s.fitted_speed, positive(Unit::kVelocity));
  v.field("cohesion", &s.cohesion, not_negative(Unit::kPressure));
  v.field("friction", &s.friction, positive());
  v.field("surface_friction", &s.surface_friction, not_negative());
  v.field("rebound", &s.rebound, positive(Unit::kLength));
  v.field("damping", &s.damping, not_negative());
  v.field("resistance", &s.resistance, positive());
  v.field("gravity", &s.gravity, positive());
  v.fields(not_negative(), {{"cohesive_modulus", &s.cohesive_modulus}, {"frictional_modulus", &s.frictional_modulus}});
  v.field("exponent", &s.exponent, positive());
  v.fields(positive(Unit::kLength), {{"width", &s.width}, {"shear_length", &s.shear_length}});
}

static void visit_fields(FieldVisitor& v, TerrainMapSpec& m) {
  v.field("file", &m.file, required(path));
  v.field("origin", &m.origin, {Unit::kLength});
  v.field("height_scale", &m.height_scale, positive());
}

static void visit_fields(FieldVisitor& v, CraterSpec& c) {
  v.fields({Unit::kLength}, {{"x", &c.x}, {"y", &c.y}});
  v.field("diameter", &c.diameter, required(positive(Unit::kLength)));
  v.fields(not_negative(Unit::kLength), {{"depth", &c.depth}, {"rim_height", &c.rim_height}});
}

static void visit_fields(FieldVisitor& v, WaveSpec& w) {
  v.field("length", &w.length, required(positive(Unit::kLength)));
  v.field("height", &w.height, required(not_negative(Unit::kLength)));
  v.fields({Unit::kAngle}, {{"azimuth", &w.azimuth}, {"phase", &w.phase}});
}

static void visit_fields(FieldVisitor& v, RoughnessSpec& r) {
  v.field("height", &r.height, required(not_negative(Unit::kLength)));
  v.field("hurst", &r.hurst, share);
  v.fields(required(positive(Unit::kLength)), {{"shortest", &r.shortest}, {"longest", &r.longest}});
  v.field("seed", &r.seed, positive());
}

static void visit_fields(FieldVisitor& v, RockSpec& r) {
  v.fields({Unit::kLength}, {{"x", &r.x}, {"y", &r.y}});
  v.field("diameter", &r.diameter, required(positive(Unit::kLength)));
  v.field("buried", &r.buried, share);
}

static void visit_fields(FieldVisitor& v, RockFieldSpec& r) {
  v.field("abundance", &r.abundance, required(not_negative()));
  v.fields(required(positive(Unit::kLength)), {{"smallest", &r.smallest}, {"largest", &r.largest}, {"size", &r.size}});
  v.fields({Unit::kLength}, {{"x", &r.x}, {"y", &r.y}});
  v.field("buried", &r.buried, share);
  v.field("keep_out", &r.keep_out, not_negative(Unit::kLength));
  v.fields({Unit::kLength}, {{"keep_out_x", &r.keep_out_x}, {"keep_out_y", &r.keep_out_y}});
  v.field("seed", &r.seed, positive());
}

static void visit_fields(FieldVisitor& v, TerrainSpec& t) {
  v.field("position", &t.position, {Unit::kLength});
  v.fields({Unit::kAngle}, {{"slope", &t.slope}, {"azimuth", &t.azimuth}});
  v.section("map", t.map);
  v.list("craters", t.craters);
  v.list("waves", t.waves);
  v.section("roughness", t.roughness);
  v.list("rocks", t.rocks);
  v.section("rock_field", t.rock_field);
}

static void visit_fields(FieldVisitor& v, GroundSpec& g) {
  v.field("", &g.source, {});
  v.choice("kind", g.kind);
  v.section("plane", g.plane);
  v.field("soil", &g.soil, plain);
  v.section("law", g.law);
  v.section("terrain", g.terrain);
}

static void visit_fields(FieldVisitor& v, BedSpec& b) {
  v.field("script", &b.script, required(path));
  v.field("variables", &b.variables, plain);
}

static void visit_fields(FieldVisitor& v, GrainMaterialSpec& m) {
  v.field("density", &m.density, positive(Unit::kDensity));
  v.field("young", &m.young, positive(Unit::kPressure));
  v.field("poisson", &m.poisson, plain);
  v.field("restitution", &m.restitution, share);
  v.fields(not_negative(), {{"friction", &m.friction}, {"rolling_friction", &m.rolling_friction}});
  v.choice("rolling_model", m.rolling_model);
  v.field("cohesion", &m.cohesion, not_negative(Unit::kPressure));
  v.choice("cohesion_model", m.cohesion_model);
}

static void visit_fields(FieldVisitor& v, BodyContactSpec& b) {
  v.field("young", &b.young, positive(Unit::kPressure));
  v.field("poisson", &b.poisson, plain);
  v.field("restitution", &b.restitution, share);
  v.fields(not_negative(), {{"friction", &b.friction}, {"rolling_friction", &b.rolling_friction}});
  v.field("cohesion", &b.cohesion, not_negative(Unit::kPressure));
}

static void visit_fields(FieldVisitor& v, GrainRegionSpec& r) {
  v.field("region", &r.region, required({Unit::kLength}));
  v.field("from", &r.from, not_negative(Unit::kTime));
  v.field("until", &r.until, positive(Unit::kTime));
}

static void visit_fields(FieldVisitor& v, GrainSourceSpec& s) {
  visit_fields(v, static_cast<GrainRegionSpec&>(s));
  v.fields(positive(), {{"rate", &s.rate}, {"grains_per_second", &s.grains_per_second}});
  v.field("velocity", &s.velocity, {Unit::kVelocity});
}

static void visit_fields(FieldVisitor& v, SizeDistributionSpec& d) {
  v.choice("kind", d.kind, required());
  v.fields(positive(Unit::kLength),
           {{"diameters", &d.diameters}, {"median", &d.median}, {"finest", &d.finest}, {"coarsest", &d.coarsest}});
  v.fields(share, {{"fractions", &d.fractions}, {"passing", &d.passing}});
  v.fields(positive(), {{"deviation", &d.deviation}, {"classes", &d.classes}});
}

static void visit_fields(FieldVisitor& v, GrainSizesSpec& g) {
  v.field("radius", &g.radius, positive(Unit::kLength));
  v.field("shares", &g.shares, positive());
  v.section("size_distribution", g.size_distribution);
}

static void visit_fields(FieldVisitor& v, GrainZoneSpec& z) {
  v.field("under", &z.under, name);
  v.field("centre", &z.centre, {Unit::kLength});
  v.fields(required(positive(Unit::kLength)), {{"size", &z.size}, {"depth", &z.depth}});
  visit_fields(v, static_cast<GrainSizesSpec&>(z));
}

static void visit_fields(FieldVisitor& v, PourSpec& p) {
  v.fields(not_negative(), {{"friction", &p.friction}, {"rolling_friction", &p.rolling_friction}});
  v.field("rayleigh_fraction", &p.rayleigh_fraction, share);
  v.field("young", &p.young, positive(Unit::kPressure));
  v.field("settle_time", &p.settle_time, positive(Unit::kTime));
}

static void visit_fields(FieldVisitor& v, BoxSpec& b) {
  const Rule length = positive(Unit::kLength);
  v.fields(required(length), {{"size", &b.size}, {"depth", &b.depth}});
  visit_fields(v, static_cast<GrainSizesSpec&>(b));
  v.list("zones", b.zones);
  v.field("clumps", &b.clumps, plain);
  v.field("clump_shares", &b.clump_shares, positive());
  v.fields({Unit::kLength}, {{"centre", &b.centre}, {"pit", &b.pit}});
  v.field("pit_depth", &b.pit_depth, length);
  v.fields(plain, {{"periodic", &b.periodic}, {"walls", &b.walls}});
  v.field("follow", &b.follow, plain);
  v.choice("follow_directions", b.follow_directions);
  v.field("follow_distance", &b.follow_distance, length);
  v.choice("packing", b.packing);
  v.section("pour", b.pour);
  v.field("seed", &b.seed, positive());
  v.fields(length, {{"headroom", &b.headroom}, {"margin", &b.margin}});
  v.field("time_step", &b.time_step, positive(Unit::kTime));
  v.field("rayleigh_fraction", &b.rayleigh_fraction, share);
  v.field("exchange_steps", &b.every, positive());
  v.field("frame_interval", &b.frames, not_negative(Unit::kTime));
  v.list("sources", b.sources);
  v.list("sinks", b.sinks);
  v.section("material", b.material);
  v.section("bodies", b.bodies);
}

static void visit_fields(FieldVisitor& v, ParticlesSpec& p) {
  v.field("", &p.source, {});
  v.field("script", &p.script, path);
  v.field("variables", &p.variables, plain);
  v.field("ranks", &p.ranks, positive());
  v.field("soil", &p.soil, plain);
  v.section("bed", p.bed);
  v.section("box", p.box);
  v.field("grains", &p.grains, path);
  v.field("surface_height", &p.surface_height, {Unit::kLength});
  v.field("max_time_step", &p.max_time_step, positive(Unit::kTime));
  v.field("outflow", &p.outflow, plain);
}

// The keys of signals, states and events.

static void visit_fields(FieldVisitor& v, SignalSpec& s) {
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
  NamedTexts inputs{&s.inputs, &s.input_names}, outputs{&s.outputs, &s.output_names};
  v.fields(plain, {{"inputs", &inputs}, {"output", &s.output}, {"outputs", &outputs}, {"start", &s.start}});
  v.field("time_limit", &s.time_limit, positive(Unit::kTime));
  v.fields(plain, {{"function", &s.function}, {"stateless", &s.stateless}});
}

static void visit_fields(FieldVisitor& v, StateSpec& s) { v.entry(s.source, s.name); }

static void visit_fields(FieldVisitor& v, EventSpec& e) {
  v.entry(e.source, e.name);
  v.field("from", &e.from, name);
  v.field("when", &e.when, required());
  v.field("to", &e.to, required(name));
  v.field("period", &e.period, not_negative(Unit::kTime));
}

// The keys of the initial state, controllers, solver, coupling and output.

void visit_fields(FieldVisitor& v, BodyVelocitySpec& b) {
  v.field("", &b.source, {});
  v.field("body", &b.body, required(name));
  v.field("velocity", &b.velocity, {Unit::kVelocity, Range::kAny, Meaning::kFree});
  v.field("angular_velocity", &b.angular_velocity, {Unit::kAngularVelocity, Range::kAny, Meaning::kFree});
}

static void visit_fields(FieldVisitor& v, InitialJointSpec& j) {
  v.field("", &j.source, {});
  v.field("angle", &j.angle, {Unit::kAngle});
  v.fields({Unit::kLength}, {{"displacement", &j.displacement},
                             {"displacement_x", &j.displacement_x},
                             {"displacement_y", &j.displacement_y}});
}

static void visit_fields(FieldVisitor& v, InitialGroupsSpec& g) {
  v.fields(name, {{"moving", &g.moving}, {"still", &g.still}});
}

static void visit_fields(FieldVisitor& v, InitialSpec& i) {
  v.field("", &i.source, {});
  v.field("from", &i.from, path);
  v.field("position", &i.position, {Unit::kLength});
  v.fields({Unit::kAngle}, {{"roll", &i.roll}, {"pitch", &i.pitch}, {"yaw", &i.yaw}});
  v.field("clearance", &i.clearance, {Unit::kLength});
  v.field("velocity", &i.velocity, {Unit::kVelocity});
  v.field("angular_velocity", &i.angular_velocity, {Unit::kAngularVelocity});
  v.list("bodies", i.bodies);
  v.list("joints", i.joints, true);
  v.section("groups", i.groups);
  v.field("settle", &i.settle, plain);
  v.field("largest_gap", &i.largest_gap, positive(Unit::kLength));
}

static void visit_fields(FieldVisitor& v, ControllerSpec& c) {
  v.entry(c.source, c.name);
  v.choice("kind", c.kind, required());
  v.field("body", &c.body, required(name));
  v.field("period", &c.period, positive(Unit::kTime));
  v.field("outputs", &c.outputs, required(name));
  v.field("touchdown_acceleration", &c.touchdown_acceleration, not_negative(Unit::kAcceleration));
  v.field("touchdown_delay", &c.touchdown_delay, not_negative(Unit::kTime));
  v.field("filter_frequency", &c.filter_frequency, not_negative(Unit::kFrequency));
  v.field("voltages", &c.voltages, share);
  v.field("file", &c.file, path);
  v.field("tabulated", &c.tabulated, plain);
  v.field("grid", &c.grid, positive());
  v.fields(share, {{"on", &c.skyhook.on}, {"off", &c.skyhook.off}});
  v.field("deadband", &c.skyhook.deadband, not_negative(Unit::kVelocity));
  v.field("set_point", &c.pid.set_point, positive(Unit::kAcceleration));
  v.fields(not_negative(), {{"kp", &c.pid.kp}, {"ki", &c.pid.ki}, {"kd", &c.pid.kd}});
  v.field("bias", &c.pid.bias, share);
}

static void visit_fields(FieldVisitor& v, SolverSpec& s) {
  v.field("", &s.source, {});
  v.choice("integrator", s.integrator);
  v.choice("method", s.method);
  v.fields(positive(), {{"rtol", &s.rtol}, {"atol", &s.atol}});
  v.field("max_step", &s.max_step, positive(Unit::kTime));
  v.field("error_control", &s.error_control, plain);
  v.choice("drift", s.drift);
  v.fields(positive(), {{"baumgarte_velocity", &s.baumgarte_velocity}, {"baumgarte_position", &s.baumgarte_position}});
}

static void visit_fields(FieldVisitor& v, CouplingSpec& c) {
  v.field("", &c.source, {});
  v.choice("scheme", c.scheme, scheme_names());
  v.fields(positive(),
           {{"tolerance", &c.tolerance}, {"max_substeps", &c.max_substeps}, {"warn_omega_h", &c.warn_omega_h}});
  v.field("stop_on_energy_gain", &c.stop_on_energy_gain, plain);
  v.field("max_energy_residual", &c.max_energy_residual, positive());
  v.field("stop_on_chatter", &c.stop_on_chatter, plain);
  v.field("timeout", &c.timeout, positive(Unit::kTime));
}

static void visit_fields(FieldVisitor& v, LandingPointSpec& p) {
  v.entry(p.source, p.name);
  v.field("body", &p.body, required(name));
  v.field("point", &p.point, required(point));
}

static void visit_fields(FieldVisitor& v, LandingSpec& l) {
  v.field("", &l.source, {});
  v.fields(name, {{"base", &l.base}, {"pads", &l.pads}});
  v.field("axis", &l.axis, direction);
  v.list("points", l.points);
  v.fields(plain, {{"end_at_rest", &l.end_at_rest}, {"end_when_tipped", &l.end_when_tipped}});
  v.field("rest_speed", &l.rest_speed, positive(Unit::kVelocity));
  v.field("rest_time", &l.rest_time, positive(Unit::kTime));
}

static void visit_fields(FieldVisitor& v, RequirementSpec& r) {
  v.field("", &r.source, {});
  v.field("name", &r.name, required());
  v.field("value", &r.value, required());
  v.choice("reduce", r.reduce, "none");
  v.field("unit", &r.unit, plain);
  v.fields(plain, {{"least", &r.least}, {"most", &r.most}});
}

static void visit_fields(FieldVisitor& v, OutputSpec& o) {
  v.field("", &o.source, {});
  v.field("interval", &o.interval, positive(Unit::kTime));
  v.field("bodies", &o.bodies, name);
  v.fields(plain, {{"joints", &o.joints}, {"reactions", &o.reactions}, {"modal_forces", &o.modal_forces}});
  v.fields(plain, {{"attitudes", &o.attitudes}, {"vtk", &o.vtk}});
  v.field("vtk_interval", &o.vtk_interval, not_negative(Unit::kTime));
  v.field("plots", &o.plots, plain);
  v.field("checkpoint_interval", &o.checkpoint_interval, not_negative(Unit::kTime));
  v.field("keep_grains", &o.keep_grains, plain);
}

}  // namespace footfall
