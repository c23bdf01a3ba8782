#pragma once
// Mass, centre and inertia of simple solids from dimensions and density, in axes of the reference configuration; principal
// axes.

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include "mbd_solver/model/modal_body.h"

namespace footfall {

struct MassProperties {
  double mass = 0.0;                                  // [kg]
  Eigen::Vector3d centre = Eigen::Vector3d::Zero();   // centre of mass [m]
  Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  // about the centre of mass [kg m2]
};

// All throw InputError if a dimension or the density is not positive, or a wall is thicker than the radius.
MassProperties box_properties(const Eigen::Vector3d& size, double density);  // centred at the origin
// Between two end points; outer diameter, wall thickness [m].
MassProperties tube_properties(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter, double wall,
                               double density);
MassProperties rod_properties(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter, double density);
// Flat round plate, centred at the origin, axis z.
MassProperties disc_properties(double radius, double thickness, double density);
MassProperties sphere_properties(double radius, double density);
// A cylinder with half a ball at each end; from, to: the centres of the balls.
MassProperties capsule_properties(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double diameter,
                                  double density);

// The same solid with another mass (density scaled).
MassProperties with_mass(const MassProperties& solid, double mass);
// Several solids as one rigid body.
MassProperties operator+(const MassProperties& a, const MassProperties& b);

// --- Nodes with a mass matrix.

// 6N x 6: unit translations, then unit rotations about the origin, of nodes at x (3 x N) [1, m, rad]. Rows 6 j + i as in
// ModalBody::mass; rows of rotations are zero if the nodes have none.
Eigen::MatrixXd rigid_motions(const Eigen::Matrix3Xd& x, bool rotations = true);
// R^T M R = [m 1, -m c~; m c~, J_o] of these motions R and a mass matrix M (6N x 6N), and c from its antisymmetric part.
MassProperties mass_properties(const Eigen::Matrix3Xd& x, const Eigen::SparseMatrix<double>& M);

// --- Principal axes, chosen uniquely where the shape of a body leaves a choice.

constexpr double kSameMoment = 1e-6;  // moments of inertia that differ by less, relative to the largest, are equal

// Unit vectors of the principal axes as columns, right-handed; column i is the one nearest to axis i of the frame, on the
// same side. For a solid of revolution: its axis, and the frame's other two axes turned with it by the shortest rotation. For
// a solid with three equal moments, or one along the frame's axes: exactly the identity.
// inertia: 3 x 3 symmetric [kg m2], about any one point.
Eigen::Matrix3d principal_axes(const Eigen::Matrix3d& inertia);
// About Bo, undeformed, in B.
Eigen::Matrix3d principal_axes(const ModalBody& body);

}  // namespace footfall
