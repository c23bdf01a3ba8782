// The top-level keys of a scene.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

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
}

}  // namespace footfall
