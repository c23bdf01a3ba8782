// The keys of materials and bodies.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, MaterialSpec& m) {
  v.field("", &m.source, {});
  v.field("density", &m.density, {Unit::kDensity, Range::kPositive, Meaning::kPlain, true});
  v.field("young", &m.young, {Unit::kPressure, Range::kPositive});
  v.field("poisson", &m.poisson, {});
  v.field("yield_stress", &m.yield_stress, {Unit::kPressure, Range::kNotNegative});
}

void visit_fields(FieldVisitor& v, ShapeSpec& s) {
  v.choice("kind", s.kind, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("centre", &s.centre, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("axis", &s.axis, {Unit::kNone, Range::kAny, Meaning::kDirection});
  v.field("from", &s.from, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("to", &s.to, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("size", &s.size, {Unit::kLength, Range::kPositive});
  v.field("diameter", &s.diameter, {Unit::kLength, Range::kPositive});
  v.field("wall", &s.wall, {Unit::kLength, Range::kPositive});
  v.field("radius", &s.radius, {Unit::kLength, Range::kPositive});
  v.field("length", &s.length, {Unit::kLength, Range::kPositive});
  v.field("thickness", &s.thickness, {Unit::kLength, Range::kPositive});
  v.field("depth", &s.depth, {Unit::kLength, Range::kPositive});
  v.field("points", &s.points, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("file", &s.file, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("scale", &s.scale, {Unit::kNone, Range::kPositive});
  v.field("position", &s.position, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("orientation", &s.orientation, {});
}

void visit_fields(FieldVisitor& v, SectionSpec& s) {
  v.field("diameter", &s.diameter, {Unit::kLength, Range::kPositive});
  v.field("wall", &s.wall, {Unit::kLength, Range::kPositive});
  v.field("area", &s.area, {Unit::kArea, Range::kPositive});
  v.field("bending_y", &s.bending_y, {Unit::kArea2, Range::kPositive});
  v.field("bending_z", &s.bending_z, {Unit::kArea2, Range::kPositive});
  v.field("torsion", &s.torsion, {Unit::kArea2, Range::kPositive});
}

void visit_fields(FieldVisitor& v, MemberSpec& m) {
  v.field("first", &m.first, {Unit::kNone, Range::kNotNegative, Meaning::kPlain, true});
  v.field("second", &m.second, {Unit::kNone, Range::kNotNegative, Meaning::kPlain, true});
  v.field("section", &m.section, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("elements", &m.elements, {Unit::kNone, Range::kPositive});
}

void visit_fields(FieldVisitor& v, FlexibleSpec& f) {
  v.field("enabled", &f.enabled, {});
  v.choice("basis", f.basis);
  v.field("modes", &f.modes, {Unit::kNone, Range::kNotNegative});
  v.field("max_frequency", &f.max_frequency, {Unit::kFrequency, Range::kPositive});
  v.field("damping", &f.damping, {Unit::kNone, Range::kNotNegative});
  v.field("elements", &f.elements, {Unit::kNone, Range::kPositive});
  v.field("segments", &f.segments, {Unit::kNone, Range::kPositive});
  v.field("mesh_size", &f.mesh_size, {Unit::kLength, Range::kPositive});
  v.field("mesh", &f.mesh, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("mesh_scale", &f.mesh_scale, {Unit::kNone, Range::kPositive});
  v.field("thickness", &f.thickness, {Unit::kLength, Range::kPositive});
  v.field("file", &f.file, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("stiffness_matrix", &f.stiffness_matrix, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("mass_matrix", &f.mass_matrix, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("node_file", &f.node_file, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("nodes", &f.nodes, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.list("members", f.members);
  v.list("sections", f.sections, true);
}

void visit_fields(FieldVisitor& v, BodySpec& b) {
  v.field("", &b.source, {});
  v.field("name", &b.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.section("shape", b.shape);
  v.field("material", &b.material, {Unit::kNone, Range::kAny, Meaning::kName});
  NumberOrWord mass{&b.mass, "remainder", &b.mass_is_remainder};
  v.field("mass", &mass, {Unit::kMass, Range::kPositive});
  v.field("inertia", &b.inertia, {Unit::kInertia, Range::kPositive});
  v.field("position", &b.position, {Unit::kLength, Range::kAny, Meaning::kPoint});
  v.field("orientation", &b.orientation, {});
  v.section("flexible", b.flexible, Presence::kSwitch);
}

}  // namespace footfall
