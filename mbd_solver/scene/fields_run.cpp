// The keys of the initial state, controllers, solver, coupling and output.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

using namespace rule;

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

void visit_fields(FieldVisitor& v, InitialSpec& i) {
  v.field("", &i.source, {});
  v.field("position", &i.position, {Unit::kLength});
  v.fields({Unit::kAngle}, {{"roll", &i.roll}, {"pitch", &i.pitch}, {"yaw", &i.yaw}});
  v.field("clearance", &i.clearance, {Unit::kLength});
  v.field("velocity", &i.velocity, {Unit::kVelocity});
  v.field("angular_velocity", &i.angular_velocity, {Unit::kAngularVelocity});
  v.list("bodies", i.bodies);
  v.list("joints", i.joints, true);
  v.field("settle", &i.settle, plain);
  v.field("largest_gap", &i.largest_gap, positive(Unit::kLength));
}

void visit_fields(FieldVisitor& v, ControllerSpec& c) {
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

void visit_fields(FieldVisitor& v, SolverSpec& s) {
  v.field("", &s.source, {});
  v.choice("integrator", s.integrator);
  v.choice("method", s.method);
  v.fields(positive(), {{"rtol", &s.rtol}, {"atol", &s.atol}});
  v.field("max_step", &s.max_step, positive(Unit::kTime));
  v.field("error_control", &s.error_control, plain);
  v.choice("drift", s.drift);
  v.fields(positive(), {{"baumgarte_velocity", &s.baumgarte_velocity}, {"baumgarte_position", &s.baumgarte_position}});
}

void visit_fields(FieldVisitor& v, CouplingSpec& c) {
  v.field("", &c.source, {});
  v.choice("scheme", c.scheme, scheme_names());
  v.fields(positive(),
           {{"tolerance", &c.tolerance}, {"max_substeps", &c.max_substeps}, {"warn_omega_h", &c.warn_omega_h}});
  v.field("stop_on_energy_gain", &c.stop_on_energy_gain, plain);
  v.field("max_energy_residual", &c.max_energy_residual, positive());
  v.field("stop_on_chatter", &c.stop_on_chatter, plain);
  v.field("timeout", &c.timeout, positive(Unit::kTime));
}

void visit_fields(FieldVisitor& v, OutputSpec& o) {
  v.field("", &o.source, {});
  v.field("interval", &o.interval, positive(Unit::kTime));
  v.field("bodies", &o.bodies, name);
  v.fields(plain, {{"joints", &o.joints}, {"reactions", &o.reactions}, {"attitudes", &o.attitudes}, {"vtk", &o.vtk}});
  v.field("vtk_interval", &o.vtk_interval, not_negative(Unit::kTime));
  v.field("plots", &o.plots, plain);
  v.field("checkpoint_interval", &o.checkpoint_interval, not_negative(Unit::kTime));
}

}  // namespace footfall
