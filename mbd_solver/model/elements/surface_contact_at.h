#pragma once
// One place in contact, as the two sources of surface_contact.h share it.

#include "mbd_solver/model/elements/surface_contact.h"

namespace footfall {

struct SurfaceContact::Contact {
  int slot = 0;                                      // of the body A with the place
  KinematicVector p;                                 // of the place
  double radius = 0.0;                               // R [m]
  double overlap = 0.0;                              // delta [m]
  double closing = 0.0;                              // delta' [m/s]
  Eigen::Vector3d n = Eigen::Vector3d::Zero();       // in W
  Eigen::Matrix3d H = Eigen::Matrix3d::Zero();       // dn/dp as seen from B, in W [1/m]
  Eigen::Vector3d from_B = Eigen::Vector3d::Zero();  // p - r_B [m]
  Eigen::Vector3d apart = Eigen::Vector3d::Zero();   // p' - v_B(p) [m/s]
  Eigen::Vector3d g = Eigen::Vector3d::Zero();       // [m/s]
  Eigen::Vector3d spring = Eigen::Vector3d::Zero();  // xi / tau in W [m/s]
  Eigen::Vector3d held = Eigen::Vector3d::Zero();    // P xi / tau [m/s]
  Eigen::Vector3d u = Eigen::Vector3d::Zero();       // [m/s]
  double inverse_speed = 0.0;                        // 1 / sqrt(u^2 + v_s^2)
  ContactLaw::Normal normal;
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // on A [N]
};

}  // namespace footfall
