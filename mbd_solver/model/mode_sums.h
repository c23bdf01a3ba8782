#pragma once
// Sums over the modes of a body at one marker, U: 3 x s: most of the work on a flexible body.

#include <Eigen/Dense>

#include "mbd_solver/model/body_kinematics.h"

namespace footfall {

// U a, U da and U dda in one pass. Nine sums that stay in registers; as three vectors they go through memory, at twice
// the time.
struct ModeSums {
  ModeSums(const Eigen::Matrix3Xd& U, const BodyKinematics& b) {
    double s0 = 0.0, s1 = 0.0, s2 = 0.0, d0 = 0.0, d1 = 0.0, d2 = 0.0, e0 = 0.0, e1 = 0.0, e2 = 0.0;
    const double* column = U.data();
    const double *at_a = b.a.data(), *at_da = b.da.data(), *at_dda = b.dda.data();
    for (int k = 0; k < b.modes; ++k, column += 3) {
      const double a_k = at_a[k], da_k = at_da[k], dda_k = at_dda[k];
      s0 += column[0] * a_k, s1 += column[1] * a_k, s2 += column[2] * a_k;
      d0 += column[0] * da_k, d1 += column[1] * da_k, d2 += column[2] * da_k;
      e0 += column[0] * dda_k, e1 += column[1] * dda_k, e2 += column[2] * dda_k;
    }
    a << s0, s1, s2;
    da << d0, d1, d2;
    dda << e0, e1, e2;
  }
  Eigen::Vector3d a, da, dda;
};

// out += U^T f, a row of three at a time: a product of Eigen's with so short an inner size takes twice the time.
inline void add_to_modes(const Eigen::Matrix3Xd& U, const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) {
  const double* column = U.data();
  for (Eigen::Index k = 0; k < out.size(); ++k, column += 3)
    out[k] += column[0] * f[0] + column[1] * f[1] + column[2] * f[2];
}

}  // namespace footfall
