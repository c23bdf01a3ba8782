// Stiffness and stress in element axes: the beam in closed form, the shell as plate plus membrane.

#include "mbd_solver/fe/elements.h"

#include <algorithm>

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

// Bending in a plane with deflection v and slope t: EI/L^3 [12, 6L, -12, 6L; 6L, 4L^2, -6L, 2L^2; ...]. In the xy plane
// t = theta_z = dv/dx, in the xz plane dw/dx = -theta_y, hence the sign.
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

// Section forces are minus the nodal forces at the first end, and the nodal forces at the second.
BeamStressMatrix beam_stress(double length, const BeamSection& section, const Material& material) {
  const Matrix12d K = beam_stiffness(length, section, material);
  BeamStressMatrix S = BeamStressMatrix::Zero();
  for (int end = 0; end < 2; ++end) {
    const double sign = end == 0 ? -1.0 : 1.0;
    const Eigen::Matrix<double, 6, 12> force = sign * K.middleRows<6>(6 * end);  // N, Vy, Vz, T, My, Mz
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector2d& fibre = section.fibres[i];
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

namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

// Degrees of freedom of an element in its own axes: node i holds [u v w theta_x theta_y theta_z] at 6 i.
int bending_dof(int i) { return 6 * (i / 3) + 2 + i % 3; }                  // w, theta_x, theta_y
int membrane_dof(int i) { return 6 * (i / 3) + (i % 3 == 2 ? 5 : i % 3); }  // u, v, theta_z

}  // namespace

PlateElement::PlateElement(const Vector3d& p1, const Vector3d& p2, const Vector3d& p3, double thickness,
                           const Material& material)
    : thickness_(thickness), poisson_(material.poisson) {
  const Vector3d twice_area = (p2 - p1).cross(p3 - p1);
  area_ = 0.5 * twice_area.norm();
  FOOTFALL_DEMAND(area_ > 0.0 && thickness > 0.0);
  const Vector3d x = (p2 - p1).normalized();
  const Vector3d z = twice_area.normalized();
  R_DE_ << x, z.cross(x), z;
  const Vector3d centre = (p1 + p2 + p3) / 3.0;
  p_.col(0) = (R_DE_.transpose() * (p1 - centre)).head<2>();
  p_.col(1) = (R_DE_.transpose() * (p2 - centre)).head<2>();
  p_.col(2) = (R_DE_.transpose() * (p3 - centre)).head<2>();
  const double nu = material.poisson;
  plane_stress_ << 1.0, nu, 0.0, nu, 1.0, 0.0, 0.0, 0.0, 0.5 * (1.0 - nu);
  plane_stress_ *= material.young / (1.0 - nu * nu);
}

// The normal's rotations beta (u = z beta_x, v = z beta_y) are quadratic over the triangle. At the corners
// beta = -grad w, that is beta = (theta_y, -theta_x). Along a side i-j of length l and direction t, w is
// cubic, so that Kirchhoff's condition at its middle gives
//   t . beta = 3/(2 l) (w_i - w_j) - 1/4 t . (beta_i + beta_j),   and across the side  n . beta = 1/2 n .
//   (beta_i + beta_j).
PlateElement::Curvature PlateElement::curvature(double xi, double eta) const {
  const double L[3] = {1.0 - xi - eta, xi, eta};
  Vector2d dL[3];  // gradients of the area coordinates
  for (int i = 0; i < 3; ++i) {
    const Vector2d side = p_.col((i + 2) % 3) - p_.col((i + 1) % 3);
    dL[i] = Vector2d(-side.y(), side.x()) / (2.0 * area_);
  }
  using Beta = Eigen::Matrix<double, 2, 9>;
  const auto corner = [](int i) {
    Beta beta = Beta::Zero();
    beta(0, 3 * i + 2) = 1.0;
    beta(1, 3 * i + 1) = -1.0;
    return beta;
  };
  Curvature kappa = Curvature::Zero();
  const auto add = [&kappa](const Vector2d& dN, const Beta& beta) {
    kappa.row(0) += dN.x() * beta.row(0);
    kappa.row(1) += dN.y() * beta.row(1);
    kappa.row(2) += dN.y() * beta.row(0) + dN.x() * beta.row(1);
  };
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3;
    const Vector2d side = p_.col(j) - p_.col(i);
    const Vector2d t = side.normalized();
    const Beta both = corner(i) + corner(j);
    Beta middle = 0.5 * both - 0.75 * (t * t.transpose()) * both;
    middle.col(3 * i) += 1.5 / side.norm() * t;
    middle.col(3 * j) -= 1.5 / side.norm() * t;
    add((4.0 * L[i] - 1.0) * dL[i], corner(i));        // N_i = L_i (2 L_i - 1)
    add(4.0 * (L[i] * dL[j] + L[j] * dL[i]), middle);  // N_ij = 4 L_i L_j
  }
  return kappa;
}

// The curvature is linear, so the three middles of the sides integrate its energy exactly.
PlateElement::Matrix9d PlateElement::bending_stiffness() const {
  const double t = thickness_;
  const Matrix3d D = plane_stress_ * (t * t * t / 12.0);
  Matrix9d K = Matrix9d::Zero();
  for (const auto& [xi, eta] : {std::pair{0.5, 0.0}, std::pair{0.5, 0.5}, std::pair{0.0, 0.5}}) {
    const Curvature B = curvature(xi, eta);
    K += area_ / 3.0 * B.transpose() * D * B;
  }
  return K;
}

// Felippa's force lumping matrix divided by the volume, alpha_b = 3/2; x_ij = x_i - x_j.
PlateElement::MeanStrain PlateElement::mean_strain() const {
  constexpr double kAlpha = 1.5;
  MeanStrain e;
  for (int i = 0; i < 3; ++i) {
    const Vector2d a = p_.col((i + 1) % 3);
    const Vector2d b = p_.col((i + 2) % 3);
    const Vector2d c = p_.col(i);
    const double y_ab = a.y() - b.y(), x_ba = b.x() - a.x();
    const double y_cb = c.y() - b.y(), y_ac = a.y() - c.y();
    const double x_bc = b.x() - c.x(), x_ca = c.x() - a.x();
    e.col(3 * i) = Vector3d(y_ab, 0.0, x_ba);
    e.col(3 * i + 1) = Vector3d(0.0, x_ba, y_ab);
    e.col(3 * i + 2) =
        kAlpha / 6.0 * Vector3d(y_ab * (y_cb - y_ac), x_ba * (x_bc - x_ca), 2.0 * (x_bc * y_cb - x_ca * y_ac));
  }
  return e / (2.0 * area_);
}

// Basic stiffness from the mean strain; higher-order stiffness from the corner rotations relative to the mean
// rotation, which bend the triangle. C. A. Felippa, "A study of optimal membrane triangles with drilling
// freedoms", 2003.
PlateElement::Matrix9d PlateElement::membrane_stiffness() const {
  const MeanStrain B = mean_strain();
  const double volume = area_ * thickness_;
  Matrix9d K = volume * B.transpose() * plane_stress_ * B;

  // Natural strains along the sides 21, 32, 13 from Cartesian ones.
  Matrix3d natural;
  Vector3d l2;  // squared lengths
  for (int i = 0; i < 3; ++i) {
    const Vector2d side = p_.col((i + 1) % 3) - p_.col(i);
    l2(i) = side.squaredNorm();
    natural.row(i) << side.x() * side.x() / l2(i), side.y() * side.y() / l2(i), side.x() * side.y() / l2(i);
  }
  const Matrix3d T = natural.inverse();
  const Matrix3d E = T.transpose() * plane_stress_ * T;

  // Corner rotations less the mean rotation (dv/dx - du/dy) / 2.
  Eigen::Matrix<double, 3, 9> deviator = Eigen::Matrix<double, 3, 9>::Zero();
  for (int i = 0; i < 3; ++i) {
    const Vector2d a = p_.col((i + 1) % 3);
    const Vector2d b = p_.col((i + 2) % 3);
    deviator.col(3 * i).setConstant((b.x() - a.x()) / (4.0 * area_));
    deviator.col(3 * i + 1).setConstant((b.y() - a.y()) / (4.0 * area_));
    deviator(i, 3 * i + 2) = 1.0;
  }

  // Natural strains at the corners from these rotations: beta_1..9 = 1, 2, 1, 0, 1, -1, -1, -1, -2.
  Matrix3d Q1, Q2, Q3;
  Q1 << 1.0, 2.0, 1.0, 0.0, 1.0, -1.0, -1.0, -1.0, -2.0;
  Q2 << -2.0, -1.0, -1.0, 1.0, 1.0, 2.0, -1.0, 0.0, 1.0;
  Q3 << 1.0, -1.0, 0.0, -1.0, -2.0, -1.0, 2.0, 1.0, 1.0;
  const Matrix3d scale = (2.0 * area_ / 3.0 * l2.cwiseInverse()).asDiagonal();
  Matrix3d K_theta = Matrix3d::Zero();
  for (const Matrix3d& Q : {Matrix3d(0.5 * (Q1 + Q2)), Matrix3d(0.5 * (Q2 + Q3)), Matrix3d(0.5 * (Q3 + Q1))}) {
    const Matrix3d strain = scale * Q;
    K_theta += volume * strain.transpose() * E * strain;
  }
  const double beta0 = std::max(0.5 * (1.0 - 4.0 * poisson_ * poisson_), 0.01);
  return K + 0.75 * beta0 * deviator.transpose() * K_theta * deviator;
}

Matrix18d PlateElement::stiffness() const {
  const Matrix9d bending = bending_stiffness();
  const Matrix9d membrane = membrane_stiffness();
  Matrix18d K = Matrix18d::Zero();
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 9; ++j) {
      K(bending_dof(i), bending_dof(j)) = bending(i, j);
      K(membrane_dof(i), membrane_dof(j)) = membrane(i, j);
    }
  return turned_stiffness(K, R_DE_);
}

PlateStressMatrix PlateElement::stress() const {
  const Eigen::Matrix<double, 3, 9> bending = 0.5 * thickness_ * plane_stress_ * curvature(1.0 / 3.0, 1.0 / 3.0);
  const Eigen::Matrix<double, 3, 9> membrane = plane_stress_ * mean_strain();
  constexpr int kRow[3] = {0, 1, 3};  // xx, yy, xy
  PlateStressMatrix S = PlateStressMatrix::Zero();
  for (int side = 0; side < 2; ++side)
    for (int i = 0; i < 9; ++i)
      for (int k = 0; k < 3; ++k) {
        S(6 * side + kRow[k], bending_dof(i)) = (side == 0 ? 1.0 : -1.0) * bending(k, i);
        S(6 * side + kRow[k], membrane_dof(i)) = membrane(k, i);
      }
  return turned_stress(S, R_DE_);
}

}  // namespace footfall
