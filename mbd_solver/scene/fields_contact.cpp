// The keys of boundaries, ground and particles.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, SurfaceSpec& s) {
  v.field("element_size", &s.element_size, {Unit::kLength, Range::kPositive});
  v.field("file", &s.file, {Unit::kNone, Range::kAny, Meaning::kPath});
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

void visit_fields(FieldVisitor& v, PlaneSpec& p) {
  v.field("point", &p.point, {Unit::kLength});
  v.field("normal", &p.normal, {Unit::kNone, Range::kAny, Meaning::kDirection});
  v.field("young", &p.young, {Unit::kPressure, Range::kPositive});
  v.field("poisson", &p.poisson, {});
  v.field("contact_radius", &p.contact_radius, {Unit::kLength, Range::kPositive});
  v.field("stiffness", &p.stiffness, {Unit::kNone, Range::kPositive});
  v.field("restitution", &p.restitution, {Unit::kNone, Range::kUnitInterval});
  v.field("impact_speed", &p.impact_speed, {Unit::kVelocity, Range::kPositive});
  v.field("damping", &p.damping, {Unit::kNone, Range::kNotNegative});
  v.field("friction", &p.friction, {Unit::kNone, Range::kNotNegative});
  v.field("friction_speed", &p.friction_speed, {Unit::kVelocity, Range::kPositive});
  v.field("bodies", &p.bodies, {Unit::kNone, Range::kAny, Meaning::kName});
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

void visit_fields(FieldVisitor& v, ParticlesSpec& p) {
  v.field("", &p.source, {});
  v.field("script", &p.script, {Unit::kNone, Range::kAny, Meaning::kPath, true});
  v.field("variables", &p.variables, {});
  v.field("ranks", &p.ranks, {Unit::kNone, Range::kPositive});
  v.section("bed", p.bed);
  v.field("grains", &p.grains, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("surface_height", &p.surface_height, {Unit::kLength});
  v.field("max_time_step", &p.max_time_step, {Unit::kTime, Range::kPositive});
}

}  // namespace footfall
