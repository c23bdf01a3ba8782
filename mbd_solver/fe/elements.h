#pragma once
// Finite elements: a beam and a flat shell, and the transformation of their matrices to the frame D of the reference
// configuration.

#include <Eigen/Dense>

#include "mbd_solver/fe/material.h"

namespace footfall {

// --- Transformation by vectors of three: every degree of freedom belongs to one.

// T K T^T, T = diag(R_DE, R_DE, ...): columns of R_DE are the axes of the element in D.
template <class Matrix>
Matrix turned_stiffness(Matrix K, const Eigen::Matrix3d& R_DE) {
  for (Eigen::Index j = 0; j < K.cols(); j += 3)
    for (Eigen::Index i = 0; i < K.rows(); i += 3) {
      const Eigen::Matrix3d block = R_DE * K.template block<3, 3>(i, j);
      K.template block<3, 3>(i, j).noalias() = block * R_DE.transpose();
    }
  return K;
}

// S T^T.
template <class Matrix>
Matrix turned_stress(Matrix S, const Eigen::Matrix3d& R_DE) {
  for (Eigen::Index j = 0; j < S.cols(); j += 3)
    for (Eigen::Index i = 0; i < S.rows(); i += 3) {
      const Eigen::Matrix3d block = S.template block<3, 3>(i, j);
      S.template block<3, 3>(i, j).noalias() = block * R_DE.transpose();
    }
  return S;
}

// --- Straight 3D Euler-Bernoulli beam: axial force, torsion and bending in two planes. Two nodes, 12 degrees of freedom in
// the order [u1; theta1; u2; theta2], each (x, y, z).

using Matrix12d = Eigen::Matrix<double, 12, 12>;
constexpr int kBeamStressPoints = 8;  // four fibres at the first end, then four at the second
using BeamStressMatrix = Eigen::Matrix<double, 6 * kBeamStressPoints, 12>;

// R_DE: columns are the element's axes in D. x from first to second end; z as near to `up` as possible. Without `up` (zero):
// D's z axis, or D's x axis for an element along z. It matters only for sections that are not round.
Eigen::Matrix3d beam_axes(const Eigen::Vector3d& from, const Eigen::Vector3d& to,
                          const Eigen::Vector3d& up = Eigen::Vector3d::Zero());

// Stiffness in element axes [N/m, N, N m]; exact for loads at the ends.
Matrix12d beam_stiffness(double length, const BeamSection& section, const Material& material);

// Stress (xx yy zz xy yz zx, element axes) at the fibres from the end displacements in element axes [Pa/m, Pa/rad].
// sigma_xx = N/A + My z/Iy - Mz y/Iz, torsion shear T/W along the circumference; shear of transverse forces is neglected.
BeamStressMatrix beam_stress(double length, const BeamSection& section, const Material& material);

// --- Flat triangular shell: thin plate bending (discrete Kirchhoff triangle, Batoz, Bathe and Ho 1980) and a membrane with
// rotations about the normal (the optimal triangle of Felippa 2003), without a fictitious drilling spring. Three nodes, 18
// degrees of freedom in the order [u1; theta1; u2; theta2; u3; theta3], each (x, y, z) in D.

using Matrix18d = Eigen::Matrix<double, 18, 18>;
using PlateStressMatrix = Eigen::Matrix<double, 12, 18>;

class PlateElement {
 public:
  // Corners in D [m], counter-clockwise seen from the side the normal points to; thickness [m]. The triangle
  // must not be degenerate.
  PlateElement(const Eigen::Vector3d& p1, const Eigen::Vector3d& p2, const Eigen::Vector3d& p3, double thickness,
               const Material& material);

  double area() const { return area_; }                    // [m2]
  Eigen::Vector3d normal() const { return R_DE_.col(2); }  // unit, in D
  // R_DE: x along the edge 1-2, z normal.
  const Eigen::Matrix3d& axes() const { return R_DE_; }

  // Stiffness in D [N/m, N, N m].
  Matrix18d stiffness() const;
  // Stress (xx yy zz xy yz zx, element axes) at the centroid: top side (along the normal), then bottom, from
  // displacements in D.
  PlateStressMatrix stress() const;

 private:
  using Matrix9d = Eigen::Matrix<double, 9, 9>;
  using Curvature = Eigen::Matrix<double, 3, 9>;
  using MeanStrain = Eigen::Matrix<double, 3, 9>;

  // Curvatures (xx, yy, 2 xy) at area coordinates (xi of corner 2, eta of corner 3) from (w, theta_x,
  // theta_y) of the corners.
  Curvature curvature(double xi, double eta) const;
  // Mean membrane strain (xx, yy, 2 xy) from (u, v, theta_z) of the corners.
  MeanStrain mean_strain() const;
  Matrix9d bending_stiffness() const;
  Matrix9d membrane_stiffness() const;

  Eigen::Matrix3d R_DE_;
  Eigen::Matrix<double, 2, 3> p_;  // corners in the element's plane [m]
  double area_;
  double thickness_;
  double poisson_;
  Eigen::Matrix3d plane_stress_;  // (sxx, syy, sxy) = plane_stress (exx, eyy, 2 exy) [Pa]
};

}  // namespace footfall
