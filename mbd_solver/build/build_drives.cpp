// What acts on the coordinates of joints: stops, friction, springs, and the drives with their rotors.

#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/build/time_functions.h"
#include "mbd_solver/model/elements/forces.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/model/laws/springs.h"

namespace footfall {
namespace {

using Laws = std::vector<std::unique_ptr<StrutLaw>>;

Laws laws_of(const CoordinateSpec& spec) {
  Laws laws;
  if (spec.stops) laws.push_back(std::make_unique<EndStop>(*spec.stops));
  if (spec.friction) laws.push_back(std::make_unique<JointFriction>(*spec.friction));
  if (spec.spring) laws.push_back(std::make_unique<LinearSpringDamper>(*spec.spring));
  return laws;
}

std::unique_ptr<StrutLaw> build(const DriveSpec& spec) {
  const TimeFunctionPtr command = time_function(spec.command, command_shape(spec.motor.kind));
  if (spec.motor.kind == MotorKind::kBrake) {
    BrakeParameters p;
    p.command = command;
    p.largest_force = spec.motor.gear_ratio * spec.motor.largest_torque.value_or(0.0);
    p.lag = spec.lag;
    return std::make_unique<Brake>(p);
  }
  MotorParameters p = spec.motor;
  p.command = command;
  return std::make_unique<Motor>(p);
}

int add_joint_force(const std::string& name, int joint, Coordinate coordinate, Laws laws, Model& model,
                    int command = -1) {
  const Marker m1 = model.joint(joint).m1, m2 = model.joint(joint).m2;
  return model.add_force(std::make_unique<JointForce>(name, m1, m2, coordinate, std::move(laws), command));
}

}  // namespace

void add_drives(const Scene& scene, Mechanism& mechanism) {
  Model& model = mechanism.model;
  for (std::size_t i = 0; i < scene.joints.size(); ++i) {
    const JointSpec& spec = scene.joints[i];
    const int joint = static_cast<int>(i);
    for (const Coordinate coordinate : coordinates_of(spec.type)) {
      mechanism.coordinates.push_back({spec.name, joint, coordinate});
      if (const std::optional<CoordinateSpec>& acting = spec.acting_on(coordinate))
        add_joint_force("joint/" + spec.name + "/" + std::string(name_of(coordinate)), joint, coordinate,
                        laws_of(*acting), model);
    }
  }
  for (const DriveSpec& spec : scene.drives) {
    const int joint = scene.joint_index(spec.joint);
    const Coordinate coordinate = scene.coordinate_of(spec);
    Laws laws;
    laws.push_back(build(spec));
    const int force = add_joint_force("drive/" + spec.name, joint, coordinate, std::move(laws), model,
                                      signal_place(mechanism, spec.command->signal));
    mechanism.drives.push_back({spec.name, force, coordinate});
    if (spec.rotor_inertia == 0.0) continue;
    const Marker m1 = model.joint(joint).m1, m2 = model.joint(joint).m2;
    model.add_joint(rotor("rotor/" + spec.name, m1, m2, coordinate,
                          spec.rotor_inertia * spec.motor.gear_ratio * spec.motor.gear_ratio));
  }
}

}  // namespace footfall
