// The keys of boundaries, ground and particles.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, SurfaceSpec& s) {
  v.field("element_size", &s.element_size, {Unit::kLength, Range::kPositive});
  v.field("file", &s.file, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("from_script", &s.from_script, {Unit::kNone, Range::kAny, Meaning::kName});
  v.field("scale", &s.scale, {Unit::kNone, Range::kPositive});
  v.field("position", &s.position, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("orientation", &s.orientation, {});
  v.field("closed", &s.closed, {});
  v.choice("faces", s.faces);
}

void visit_fields(FieldVisitor& v, BeamsSpec& b) {
  v.field("radius", &b.radius, {Unit::kLength, Range::kPositive});
  v.field("segments", &b.segments, {Unit::kNone, Range::kPositive});
  v.field("points", &b.points, {Unit::kLength, Range::kAny, Meaning::kPoint});
}

void visit_fields(FieldVisitor& v, BoundarySpec& b) {
  v.field("", &b.source, {});
  v.field("body", &b.body, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.section("surface", b.surface);
  v.section("beams", b.beams);
}

namespace {

void visit_law(FieldVisitor& v, ContactLawSpec& p) {
  v.field("young", &p.young, {Unit::kPressure, Range::kPositive});
  v.field("poisson", &p.poisson, {});
  v.field("contact_radius", &p.contact_radius, {Unit::kLength, Range::kPositive});
  v.field("stiffness", &p.stiffness, {Unit::kNone, Range::kPositive});
  v.field("restitution", &p.restitution, {Unit::kNone, Range::kUnitInterval});
  v.field("impact_speed", &p.impact_speed, {Unit::kVelocity, Range::kPositive});
  v.field("damping", &p.damping, {Unit::kNone, Range::kNotNegative});
  v.field("friction", &p.friction, {Unit::kNone, Range::kNotNegative});
  v.field("friction_speed", &p.friction_speed, {Unit::kVelocity, Range::kPositive});
}

}  // namespace

void visit_fields(FieldVisitor& v, PlaneSpec& p) {
  v.field("point", &p.point, {Unit::kLength});
  v.field("normal", &p.normal, {Unit::kNone, Range::kAny, Meaning::kDirection});
  visit_law(v, p);
  v.field("bodies", &p.bodies, {Unit::kNone, Range::kAny, Meaning::kName});
}

void visit_fields(FieldVisitor& v, ContactSpec& c) {
  v.field("", &c.source, {});
  v.field("between", &c.between, {Unit::kNone, Range::kAny, Meaning::kName});
  v.field("walls", &c.walls, {});
  v.field("bodies", &c.bodies, {Unit::kNone, Range::kAny, Meaning::kName});
  v.field("ignore", &c.ignore, {});
  v.field("point", &c.point, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("normal", &c.normal, {Unit::kNone, Range::kAny, Meaning::kDirection});
  visit_law(v, c);
}

void visit_fields(FieldVisitor& v, GroundSpec& g) {
  v.field("", &g.source, {});
  v.choice("kind", g.kind);
  v.section("plane", g.plane);
}

void visit_fields(FieldVisitor& v, BedSpec& b) {
  v.field("script", &b.script, {Unit::kNone, Range::kAny, Meaning::kPath, true});
  v.field("variables", &b.variables, {});
}

void visit_fields(FieldVisitor& v, GrainMaterialSpec& m) {
  v.field("density", &m.density, {Unit::kDensity, Range::kPositive});
  v.field("young", &m.young, {Unit::kPressure, Range::kPositive});
  v.field("poisson", &m.poisson, {});
  v.field("restitution", &m.restitution, {Unit::kNone, Range::kUnitInterval});
  v.field("friction", &m.friction, {Unit::kNone, Range::kNotNegative});
  v.field("rolling_friction", &m.rolling_friction, {Unit::kNone, Range::kNotNegative});
  v.choice("rolling_model", m.rolling_model);
  v.field("cohesion", &m.cohesion, {Unit::kPressure, Range::kNotNegative});
  v.choice("cohesion_model", m.cohesion_model);
}

void visit_fields(FieldVisitor& v, BodyContactSpec& b) {
  v.field("young", &b.young, {Unit::kPressure, Range::kPositive});
  v.field("poisson", &b.poisson, {});
  v.field("restitution", &b.restitution, {Unit::kNone, Range::kUnitInterval});
  v.field("friction", &b.friction, {Unit::kNone, Range::kNotNegative});
  v.field("rolling_friction", &b.rolling_friction, {Unit::kNone, Range::kNotNegative});
  v.field("cohesion", &b.cohesion, {Unit::kPressure, Range::kNotNegative});
}

void visit_fields(FieldVisitor& v, BoxSpec& b) {
  v.field("size", &b.size, {Unit::kLength, Range::kPositive, Meaning::kPlain, true});
  v.field("depth", &b.depth, {Unit::kLength, Range::kPositive, Meaning::kPlain, true});
  v.field("radius", &b.radius, {Unit::kLength, Range::kPositive, Meaning::kPlain, true});
  v.field("shares", &b.shares, {Unit::kNone, Range::kPositive});
  v.field("clumps", &b.clumps, {});
  v.field("clump_shares", &b.clump_shares, {Unit::kNone, Range::kPositive});
  v.field("centre", &b.centre, {Unit::kLength});
  v.field("pit", &b.pit, {Unit::kLength});
  v.field("pit_depth", &b.pit_depth, {Unit::kLength, Range::kPositive});
  v.field("periodic", &b.periodic, {});
  v.field("walls", &b.walls, {});
  v.choice("packing", b.packing);
  v.field("seed", &b.seed, {Unit::kNone, Range::kPositive});
  v.field("headroom", &b.headroom, {Unit::kLength, Range::kPositive});
  v.field("margin", &b.margin, {Unit::kLength, Range::kPositive});
  v.field("time_step", &b.time_step, {Unit::kTime, Range::kPositive});
  v.field("rayleigh_fraction", &b.rayleigh_fraction, {Unit::kNone, Range::kUnitInterval});
  v.field("every", &b.every, {Unit::kNone, Range::kPositive});
  v.field("frames", &b.frames, {Unit::kTime, Range::kNotNegative});
  v.section("material", b.material);
  v.section("bodies", b.bodies);
}

void visit_fields(FieldVisitor& v, ParticlesSpec& p) {
  v.field("", &p.source, {});
  v.field("script", &p.script, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("variables", &p.variables, {});
  v.field("ranks", &p.ranks, {Unit::kNone, Range::kPositive});
  v.field("soil", &p.soil, {});
  v.section("bed", p.bed);
  v.section("box", p.box);
  v.field("grains", &p.grains, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("surface_height", &p.surface_height, {Unit::kLength});
  v.field("max_time_step", &p.max_time_step, {Unit::kTime, Range::kPositive});
}

}  // namespace footfall
