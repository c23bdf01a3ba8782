#pragma once
// Straight 3D Euler-Bernoulli frame element: axial force, torsion and bending in two planes, cross sections
// stay plane and normal. Two nodes, 12 degrees of freedom in the order [u1; theta1; u2; theta2], each (x, y,
// z).

#include <Eigen/Dense>

#include "mbd_solver/fe/beam_section.h"
#include "mbd_solver/fe/material.h"

namespace footfall {

using Matrix12d = Eigen::Matrix<double, 12, 12>;
constexpr int kBeamStressPoints = 8;  // four fibres at the first end, then four at the second
using BeamStressMatrix = Eigen::Matrix<double, 6 * kBeamStressPoints, 12>;

// R_DE: columns are the element's axes in the drawing frame D. x from first to second end; z is as near to
// `up` as x allows. Without `up` (zero): D's z axis, or D's x axis for an element that runs along z. It
// matters only for sections that are not round.
Eigen::Matrix3d beam_axes(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                          const Eigen::Vector3d& up = Eigen::Vector3d::Zero());

// Stiffness in element axes [N/m, N, N m]; exact for loads at the ends.
Matrix12d beam_stiffness(double length, const BeamSection& section, const Material& material);

// Stress (xx yy zz xy yz zx, element axes) at the fibres from the end displacements in element axes [Pa/m,
// Pa/rad]. sigma_xx = N/A + My z/Iy - Mz y/Iz, torsion shear T/W along the circumference; shear of transverse
// forces is left out.
BeamStressMatrix beam_stress(double length, const BeamSection& section, const Material& material);

}  // namespace footfall
