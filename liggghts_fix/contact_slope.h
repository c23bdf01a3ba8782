#pragma once
// What a contact does to a small motion of its body, and the same projected on the body: the slopes that linearly
// implicit schemes ask for.

#include <Eigen/Dense>

#include "coupler/messages.h"

namespace footfall {

// Stiffness [N/m] and damping [N s/m] along the normal and across it (across: 0 while the contact slides).
struct ContactSlope {
  Eigen::Vector3d normal_W = Eigen::Vector3d::UnitZ();
  double stiffness = 0.0, shear_stiffness = 0.0;
  double damping = 0.0, shear_damping = 0.0;
};

// Adds the slope of a contact at rho_W [m] from Bo to the tangent of the body.
void add_slope(const ContactSlope& slope, const Eigen::Vector3d& rho_W, ContactTangent& sum);

}  // namespace footfall
