#pragma once
// Motors of a scene: each drives one coordinate of a joint, by a torque or force that it can bring up.
// Torque and speed are those of the motor; at the joint they are gear_ratio times larger and smaller. On a
// displacement, read force for the torque of the joint, and rad/m for the unit of the gear ratio.

#include <optional>
#include <string>

#include "coupler/base/kinds.h"
#include "mbd_solver/model/laws/brake.h"
#include "mbd_solver/model/laws/motor.h"
#include "mbd_solver/scene/joint_spec.h"

namespace footfall {

struct DriveSpec {
  Source source;
  std::string name;
  MotorKind kind = MotorKind::kTorque;
  std::string joint;
  CoordinateChoice coordinate = CoordinateChoice::kAuto;
  // kTorque: of the motor [N m]; kSpeed: of the joint [rad/s or m/s]; kPosition: of the joint [rad or m]; kBrake: how hard
  // it is pressed, cut to [0, 1] [-]
  std::optional<TimeFunctionSpec> command;
  // Torque of the motor per error of the joint's coordinate and of its rate:
  //   kSpeed: kp [N m s/rad], ki [N m/rad]; kPosition: kp [N m/rad], ki [N m/(rad s)], kd [N m s/rad]
  double kp = MotorParameters{}.kp, ki = MotorParameters{}.ki, kd = MotorParameters{}.kd;  // >= 0
  std::optional<double> max_torque;  // of the motor at rest [N m] > 0; not given: no limit. Of the brake
  std::optional<double> max_speed;   // of the motor without load [rad/s] > 0; not given: no limit
  double gear_ratio = MotorParameters{}.gear_ratio;  // turns of the motor per turn of the joint > 0 [-]
  double efficiency = MotorParameters{}.efficiency;  // of the gear, in (0, 1] [-]
  double lag = BrakeParameters{}.lag;                // of the brake behind its command [s] > 0
  double rotor_inertia = 0.0;                        // about the motor's axis [kg m2] >= 0
};

}  // namespace footfall
