#pragma once
// The motion of one body at one instant, unpacked once per evaluation and read by all joints and forces. (BodyMotion is
// the message of coupler/.)

#include <Eigen/Dense>

#include "mbd_solver/model/rotation.h"

namespace footfall {

struct BodyKinematics {
  bool ground = true;                           // the inertial frame: no coordinates
  int modes = 0;                                // s
  Eigen::Vector3d r = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L = Eigen::Vector4d::UnitX();
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();  // A(L / |L|)
  Eigen::Vector3d dr = Eigen::Vector3d::Zero();     // [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();      // [rad/s]
  Eigen::Vector3d ddr = Eigen::Vector3d::Zero();    // [m/s2]; zero unless accelerations are loaded
  Eigen::Vector3d dw = Eigen::Vector3d::Zero();     // [rad/s2]
  Eigen::VectorXd a, da, dda;                       // s each; sized once

  int size() const { return ground ? 0 : 6 + modes; }  // number of velocity coordinates
};

}  // namespace footfall
