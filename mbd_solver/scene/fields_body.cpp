// The keys of materials and bodies.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

void visit_fields(FieldVisitor& v, MaterialSpec& m) {
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
                  {"node_file", &f.node_file}});
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

}  // namespace footfall
