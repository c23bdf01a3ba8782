#include "mbd_solver/fe/beam_element.h"

#include "coupler/base/errors.h"

namespace footfall {

using Eigen::Vector3d;

Eigen::Matrix3d beam_axes(const Vector3d& from, const Vector3d& to, const Vector3d& up) {
  const Vector3d x = (to - from).normalized();
  Vector3d hint = up;
  if (hint.cross(x).norm() <= 1e-6 * hint.norm())  // none given, or along the element
    hint = std::abs(x.z()) < 0.999 ? Vector3d::UnitZ() : Vector3d::UnitX();
  const Vector3d y = hint.cross(x).normalized();
  Eigen::Matrix3d R_DE;
  R_DE << x, y, x.cross(y);
  return R_DE;
}

// Bending in a plane with deflection v and slope t: EI/L^3 [12, 6L, -12, 6L; 6L, 4L^2, -6L, 2L^2; ...]. In
// the xy plane t = theta_z = dv/dx, in the xz plane dw/dx = -theta_y, hence the sign.
Matrix12d beam_stiffness(double length, const BeamSection& section, const Material& material) {
  const double L = length;
  Matrix12d K = Matrix12d::Zero();
  const auto spring = [&K](int i, int j, double k) {
    K(i, i) = K(j, j) = k;
    K(i, j) = K(j, i) = -k;
  };
  const auto bending = [&K, L](int v1, int t1, int v2, int t2, double EI, double sign) {
    const int dof[4] = {v1, t1, v2, t2};
    const double s = sign * L;
    Eigen::Matrix4d k;
    k << 12.0, 6.0 * s, -12.0, 6.0 * s,               //
        6.0 * s, 4.0 * L * L, -6.0 * s, 2.0 * L * L,  //
        -12.0, -6.0 * s, 12.0, -6.0 * s,              //
        6.0 * s, 2.0 * L * L, -6.0 * s, 4.0 * L * L;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j) K(dof[i], dof[j]) = EI / (L * L * L) * k(i, j);
  };
  spring(0, 6, material.young * section.area / L);
  spring(3, 9, material.shear_modulus() * section.torsion / L);
  bending(1, 5, 7, 11, material.young * section.bending_z, 1.0);
  bending(2, 4, 8, 10, material.young * section.bending_y, -1.0);
  return K;
}

// Section forces at the first end are minus the nodal forces there, at the second end the nodal forces
// themselves.
BeamStressMatrix beam_stress(double length, const BeamSection& section, const Material& material) {
  const Matrix12d K = beam_stiffness(length, section, material);
  BeamStressMatrix S = BeamStressMatrix::Zero();
  for (int end = 0; end < 2; ++end) {
    const double sign = end == 0 ? -1.0 : 1.0;
    const Eigen::Matrix<double, 6, 12> force = sign * K.middleRows<6>(6 * end);  // N, Vy, Vz, T, My, Mz
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector2d& fibre = section.fibres[static_cast<std::size_t>(i)];
      const Eigen::Vector2d radial = fibre.normalized();
      const int row = 6 * (4 * end + i);
      S.row(row) = force.row(0) / section.area + fibre.y() / section.bending_y * force.row(4) -
                   fibre.x() / section.bending_z * force.row(5);
      S.row(row + 3) = -radial.y() / section.torsion_modulus * force.row(3);
      S.row(row + 5) = radial.x() / section.torsion_modulus * force.row(3);
    }
  }
  return S;
}

}  // namespace footfall
