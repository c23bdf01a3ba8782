#pragma once
// Flat triangular shell element: thin plate bending (discrete Kirchhoff triangle, Batoz, Bathe and Ho 1980)
// and a membrane with rotations about the normal (the optimal triangle of Felippa 2003), so that no
// fictitious drilling spring is needed. Three nodes, 18 degrees of freedom in the order [u1; theta1; u2;
// theta2; u3; theta3], each (x, y, z) in the drawing frame D.

#include <Eigen/Dense>

#include "mbd_solver/fe/material.h"

namespace footfall {

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
