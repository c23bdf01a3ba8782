#pragma once
// Motors and brakes of a scene: each acts on one coordinate of a joint, by a limited torque or force. Torque and speed are
// those of the motor; at the joint they are gear_ratio times larger and smaller. On a displacement the joint has a force
// instead of a torque, and the gear ratio the unit rad/m.

#include <optional>
#include <string>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/model/laws/friction.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

struct DriveSpec {
  Source source;
  std::string name;
  MotorParameters motor;  // kind, gains, limits and gear; its command is made of `command`
  std::string joint;
  std::optional<Coordinate> coordinate;  // not given ("auto"): the only one of the joint
  // kTorque: of the motor [N m]; kSpeed: of the joint [rad/s or m/s]; kPosition: of the joint [rad or m]; kBrake: pressing,
  // limited to [0, 1] [-]
  std::optional<TimeFunctionSpec> command;
  double lag = BrakeParameters{}.lag;  // of the brake behind its command [s] > 0
  double rotor_inertia = 0.0;          // about the motor's axis [kg m2] >= 0
};

}  // namespace footfall
