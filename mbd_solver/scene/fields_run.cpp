// The keys of the start, controllers, solver, coupling and output.
#include "mbd_solver/scene/field_visitor.h"

namespace footfall {

void visit_fields(FieldVisitor& v, BodyVelocitySpec& b) {
  v.field("", &b.source, {});
  v.field("body", &b.body, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("velocity", &b.velocity, {Unit::kVelocity, Range::kAny, Meaning::kFree});
  v.field("angular_velocity", &b.angular_velocity, {Unit::kAngularVelocity, Range::kAny, Meaning::kFree});
}

void visit_fields(FieldVisitor& v, InitialJointSpec& j) {
  v.field("", &j.source, {});
  v.field("angle", &j.angle, {Unit::kAngle});
  v.field("displacement", &j.displacement, {Unit::kLength});
  v.field("displacement_x", &j.displacement_x, {Unit::kLength});
  v.field("displacement_y", &j.displacement_y, {Unit::kLength});
}

void visit_fields(FieldVisitor& v, InitialSpec& i) {
  v.field("", &i.source, {});
  v.field("position", &i.position, {Unit::kLength});
  v.field("roll", &i.roll, {Unit::kAngle});
  v.field("pitch", &i.pitch, {Unit::kAngle});
  v.field("yaw", &i.yaw, {Unit::kAngle});
  v.field("clearance", &i.clearance, {Unit::kLength});
  v.field("velocity", &i.velocity, {Unit::kVelocity});
  v.field("angular_velocity", &i.angular_velocity, {Unit::kAngularVelocity});
  v.list("bodies", i.bodies);
  v.list("joints", i.joints, true);
  v.field("settle", &i.settle, {});
  v.field("largest_gap", &i.largest_gap, {Unit::kLength, Range::kPositive});
}

void visit_fields(FieldVisitor& v, ControllerSpec& c) {
  v.field("", &c.source, {});
  v.field("name", &c.name, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.choice("kind", c.kind, {Unit::kNone, Range::kAny, Meaning::kPlain, true});
  v.field("body", &c.body, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("period", &c.period, {Unit::kTime, Range::kPositive});
  v.field("outputs", &c.outputs, {Unit::kNone, Range::kAny, Meaning::kName, true});
  v.field("touchdown_acceleration", &c.touchdown_acceleration, {Unit::kAcceleration, Range::kNotNegative});
  v.field("touchdown_delay", &c.touchdown_delay, {Unit::kTime, Range::kNotNegative});
  v.field("filter_frequency", &c.filter_frequency, {Unit::kFrequency, Range::kNotNegative});
  v.field("voltages", &c.voltages, {Unit::kNone, Range::kUnitInterval});
  v.field("file", &c.file, {Unit::kNone, Range::kAny, Meaning::kPath});
  v.field("tabulated", &c.tabulated, {});
  v.field("grid", &c.grid, {Unit::kNone, Range::kPositive});
  v.field("on", &c.on, {Unit::kNone, Range::kUnitInterval});
  v.field("off", &c.off, {Unit::kNone, Range::kUnitInterval});
  v.field("deadband", &c.deadband, {Unit::kVelocity, Range::kNotNegative});
  v.field("set_point", &c.set_point, {Unit::kAcceleration, Range::kPositive});
  v.field("kp", &c.kp, {Unit::kNone, Range::kNotNegative});
  v.field("ki", &c.ki, {Unit::kNone, Range::kNotNegative});
  v.field("kd", &c.kd, {Unit::kNone, Range::kNotNegative});
  v.field("bias", &c.bias, {Unit::kNone, Range::kUnitInterval});
}

void visit_fields(FieldVisitor& v, SolverSpec& s) {
  v.field("", &s.source, {});
  v.choice("integrator", s.integrator);
  v.choice("method", s.method);
  v.field("rtol", &s.rtol, {Unit::kNone, Range::kPositive});
  v.field("atol", &s.atol, {Unit::kNone, Range::kPositive});
  v.field("max_step", &s.max_step, {Unit::kTime, Range::kPositive});
  v.field("error_control", &s.error_control, {});
  v.choice("drift", s.drift);
  v.field("baumgarte_velocity", &s.baumgarte_velocity, {Unit::kNone, Range::kPositive});
  v.field("baumgarte_position", &s.baumgarte_position, {Unit::kNone, Range::kPositive});
}

void visit_fields(FieldVisitor& v, CouplingSpec& c) {
  v.field("", &c.source, {});
  v.choice("scheme", c.scheme, scheme_names());
  v.field("tolerance", &c.tolerance, {Unit::kNone, Range::kPositive});
  v.field("max_substeps", &c.max_substeps, {Unit::kNone, Range::kPositive});
  v.field("warn_omega_h", &c.warn_omega_h, {Unit::kNone, Range::kPositive});
  v.field("stop_on_energy_gain", &c.stop_on_energy_gain, {});
  v.field("max_energy_residual", &c.max_energy_residual, {Unit::kNone, Range::kPositive});
  v.field("stop_on_chatter", &c.stop_on_chatter, {});
  v.field("timeout", &c.timeout, {Unit::kTime, Range::kPositive});
}

void visit_fields(FieldVisitor& v, OutputSpec& o) {
  v.field("", &o.source, {});
  v.field("interval", &o.interval, {Unit::kTime, Range::kPositive});
  v.field("bodies", &o.bodies, {Unit::kNone, Range::kAny, Meaning::kName});
  v.field("joints", &o.joints, {});
  v.field("reactions", &o.reactions, {});
  v.field("attitudes", &o.attitudes, {});
  v.field("vtk", &o.vtk, {});
  v.field("vtk_interval", &o.vtk_interval, {Unit::kTime, Range::kNotNegative});
  v.field("plots", &o.plots, {});
  v.field("checkpoint_interval", &o.checkpoint_interval, {Unit::kTime, Range::kNotNegative});
}

}  // namespace footfall
