#pragma once
// Axes in which the inertia of a body is diagonal, chosen in one way where its shape leaves a choice.

#include <Eigen/Dense>

#include "mbd_solver/model/modal_body.h"

namespace footfall {

constexpr double kSameMoment = 1e-6;  // moments of inertia that differ by less, relative to the largest, are equal

// Unit vectors of the principal axes as columns, right-handed; column i is the one nearest to axis i of the frame, on the
// same side. Of a solid of revolution: its axis, and the frame's other two turned with it on the shortest way. Of a solid
// with three equal moments, and of one that lies along the frame's axes: the identity, to the bit.
// inertia: 3 x 3 symmetric [kg m2], about any one point.
Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& inertia);
// About Bo, undeformed, in B.
Eigen::Matrix3d principal_axes(const ModalBody& body);

}  // namespace footfall
