// What acts on the coordinates of joints: stops, friction, springs, and the drives with their rotors.

#include "coupler/base/errors.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/springs.h"

namespace footfall {
namespace {

using Laws = std::vector<std::unique_ptr<StrutLaw>>;

std::unique_ptr<StrutLaw> build(const JointStopsSpec& spec) {
  EndStopParameters p;
  p.smallest_stroke = spec.min;
  p.largest_stroke = spec.max;
  p.stiffness = spec.stiffness;
  p.dissipation = spec.dissipation;
  p.toe = spec.toe;
  return std::make_unique<EndStop>(p);
}

std::unique_ptr<StrutLaw> build(const JointFrictionSpec& spec) {
  JointFrictionParameters p;
  p.coulomb = spec.coulomb;
  p.breakaway = spec.breakaway.value_or(spec.coulomb);
  p.stribeck_speed = spec.stribeck_speed;
  p.viscous = spec.viscous;
  p.stick_displacement = spec.stick_displacement;
  return std::make_unique<JointFriction>(p);
}

std::unique_ptr<StrutLaw> build(const JointSpringSpec& spec) {
  LinearSpringDamperParameters p;
  p.stiffness = spec.stiffness;
  p.damping = spec.damping;
  p.free_stroke = spec.rest;
  return std::make_unique<LinearSpringDamper>(p);
}

Laws laws_of(const CoordinateSpec& spec) {
  Laws laws;
  if (spec.stops) laws.push_back(build(*spec.stops));
  if (spec.friction) laws.push_back(build(*spec.friction));
  if (spec.spring) laws.push_back(build(*spec.spring));
  return laws;
}

std::unique_ptr<StrutLaw> build_brake(const DriveSpec& spec) {
  BrakeParameters p;
  p.command = time_function(spec.command, command_shape(spec.kind));
  p.largest_force = spec.gear_ratio * spec.max_torque.value_or(0.0);
  p.lag = spec.lag;
  return std::make_unique<Brake>(p);
}

std::unique_ptr<StrutLaw> build(const DriveSpec& spec) {
  if (spec.kind == MotorKind::kBrake) return build_brake(spec);
  MotorParameters p;
  p.kind = spec.kind;
  p.command = time_function(spec.command, command_shape(spec.kind));
  p.kp = spec.kp;
  p.ki = spec.ki;
  p.kd = spec.kd;
  p.largest_torque = spec.max_torque;
  p.no_load_speed = spec.max_speed;
  p.gear_ratio = spec.gear_ratio;
  p.efficiency = spec.efficiency;
  return std::make_unique<Motor>(p);
}

int add_joint_force(const std::string& name, int joint, Coordinate coordinate, Laws laws, Model& model,
                    int command = -1) {
  const Marker m1 = model.joint(joint).m1, m2 = model.joint(joint).m2;
  return model.add_force(std::make_unique<JointForce>(name, m1, m2, coordinate, std::move(laws), command));
}

}  // namespace

Coordinate coordinate_of(CoordinateChoice choice) {
  switch (choice) {
    case CoordinateChoice::kAngle: return Coordinate::kAngle;
    case CoordinateChoice::kDisplacement: return Coordinate::kDisplacement;
    case CoordinateChoice::kDisplacementX: return Coordinate::kDisplacementX;
    case CoordinateChoice::kDisplacementY: return Coordinate::kDisplacementY;
    case CoordinateChoice::kAuto: break;
  }
  FOOTFALL_DEMAND(false);
}

void add_drives(const Scene& scene, Mechanism& mechanism) {
  Model& model = mechanism.model;
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const JointSpec& spec = scene.joints[i];
    const int joint = static_cast<int>(i);
    for (const CoordinateChoice choice : coordinates_of(spec.type)) {
      const Coordinate coordinate = coordinate_of(choice);
      mechanism.coordinates.push_back({spec.name, joint, coordinate});
      if (const std::optional<CoordinateSpec>& acting = spec.acting_on(choice))
        add_joint_force("joint/" + spec.name + "/" + std::string(name_of(coordinate)), joint, coordinate,
                        laws_of(*acting), model);
    }
  }
  for (const DriveSpec& spec : scene.drives) {
    const int joint = scene.joint_index(spec.joint);
    const Coordinate coordinate = coordinate_of(scene.coordinate_of(spec));
    Laws laws;
    laws.push_back(build(spec));
    const int force = add_joint_force("drive/" + spec.name, joint, coordinate, std::move(laws), model,
                                      signal_place(mechanism, spec.command->signal));
    mechanism.drives.push_back({spec.name, force, coordinate});
    if (spec.rotor_inertia == 0.0) continue;
    const Marker m1 = model.joint(joint).m1, m2 = model.joint(joint).m2;
    model.add_joint(
        rotor("rotor/" + spec.name, m1, m2, coordinate, spec.rotor_inertia * spec.gear_ratio * spec.gear_ratio));
  }
}

}  // namespace footfall
