// The keys of boundaries, contacts, ground and particles.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

static void visit_fields(FieldVisitor& v, SurfaceSpec& s) {
  v.field("element_size", &s.element_size, positive(Unit::kLength));
  v.field("file", &s.file, path);
  v.field("from_script", &s.from_script, name);
  v.field("scale", &s.scale, positive());
  v.field("position", &s.position, point);
  v.fields(plain, {{"orientation", &s.orientation}, {"closed", &s.closed}});
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

void visit_fields(FieldVisitor& v, GroundSpec& g) {
  v.field("", &g.source, {});
  v.choice("kind", g.kind);
  v.section("plane", g.plane);
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

static void visit_fields(FieldVisitor& v, BoxSpec& b) {
  const Rule length = positive(Unit::kLength);
  v.fields(required(length), {{"size", &b.size}, {"depth", &b.depth}, {"radius", &b.radius}});
  v.field("shares", &b.shares, positive());
  v.field("clumps", &b.clumps, plain);
  v.field("clump_shares", &b.clump_shares, positive());
  v.fields({Unit::kLength}, {{"centre", &b.centre}, {"pit", &b.pit}});
  v.field("pit_depth", &b.pit_depth, length);
  v.fields(plain, {{"periodic", &b.periodic}, {"walls", &b.walls}});
  v.choice("packing", b.packing);
  v.field("seed", &b.seed, positive());
  v.fields(length, {{"headroom", &b.headroom}, {"margin", &b.margin}});
  v.field("time_step", &b.time_step, positive(Unit::kTime));
  v.field("rayleigh_fraction", &b.rayleigh_fraction, share);
  v.field("every", &b.every, positive());
  v.field("frames", &b.frames, not_negative(Unit::kTime));
  v.section("material", b.material);
  v.section("bodies", b.bodies);
}

void visit_fields(FieldVisitor& v, ParticlesSpec& p) {
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
}

}  // namespace footfall
