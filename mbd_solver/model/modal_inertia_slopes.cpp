// Derivatives of the forces of inertia of one body.
#include "coupler/base/errors.h"
#include "mbd_solver/model/modal_inertia.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

using Vec = Eigen::Ref<const Eigen::VectorXd>;
using Eigen::Matrix3d;
using Eigen::Vector3d;

}  // namespace

// Row by row the derivatives of g = M(a) dv + h(a, v), with dv = [ddr; dw; dda]; see the function above.
void ModalInertia::derivatives(const Vec& a, const Vec& v, const Vec& dv, Eigen::Ref<Eigen::MatrixXd> dg_da,
                               Eigen::Ref<Eigen::MatrixXd> dg_dv) const {
  const Eigen::Index size = 6 + modes_;
  FOOTFALL_DEMAND(a.size() == modes_ && v.size() == size && dv.size() == size);
  FOOTFALL_DEMAND(dg_da.rows() == size && dg_da.cols() == modes_ && dg_dv.rows() == size && dg_dv.cols() == size);
  const Vector3d w = to_principal(v.segment<3>(3));
  const Vector3d ddr = to_principal(dv.head<3>());
  const Vector3d dw = to_principal(dv.segment<3>(3));
  const Matrix3d wx = skew(w);
  const Vector3d S = first_moment(a);
  const Symmetric half_squares = 0.5 * squares(w);
  Matrix3d J = J0_, J_rate = Matrix3d::Zero();
  Vector3d S1da = Vector3d::Zero(), Cda = Vector3d::Zero();
  for (int k = 0; k < modes_; ++k) {
    const double da = v(6 + k);
    const Matrix3d dJ = matrix(inertia_slope(k, a));
    const Vector3d S1 = S1_.col(k);
    Vector3d C = C0_.col(k);
    Vector3d to_dda = Vector3d::Zero();      // (dC/da_k) dda
    Vector3d to_da = Vector3d::Zero();       // (dC/da_k) da
    Vector3d C_rate = Vector3d::Zero();      // dC_k
    Symmetric dJ_rates = Symmetric::Zero();  // sum_l da_l d2J/da_l da_k
    for (int l = 0; l < modes_; ++l) {
      const Vector3d c_lk = coupling_slope(l, k), c_kl = coupling_slope(k, l);
      const Symmetric J2_lk = inertia_curvature(l, k);
      C += a(l) * c_lk;
      to_dda += dv(6 + l) * c_kl;
      to_da += v(6 + l) * c_kl;
      C_rate += v(6 + l) * c_lk;
      dJ_rates += v(6 + l) * J2_lk;
      dg_da(6 + k, l) = dw.dot(c_lk) - half_squares.dot(J2_lk);
      dg_dv(6 + k, 6 + l) = w.dot(c_lk - c_kl);
    }
    const Matrix3d dJ_rate = matrix(dJ_rates);
    J += 0.5 * a(k) * (matrix(J1_.col(k)) + dJ);
    J_rate += da * dJ;
    S1da += da * S1;
    Cda += da * C;
    dg_da(6 + k, k) += K_(k);
    dg_dv(6 + k, 6 + k) += C_(k);
    dg_da.block<3, 1>(0, k) = dw.cross(S1) + w.cross(w.cross(S1));
    dg_da.block<3, 1>(3, k) = S1.cross(ddr) + dJ * dw + to_dda + dJ_rate * w + w.cross(dJ * w + to_da);
    dg_dv.block<3, 1>(0, 6 + k) = 2.0 * w.cross(S1);
    dg_dv.block<3, 1>(3, 6 + k) = dJ * w + w.cross(C) + C_rate + to_da;
    dg_dv.block<1, 3>(6 + k, 3) = (C_rate - to_da - dJ * w).transpose();
  }
  dg_dv.leftCols<3>().setZero();
  dg_dv.block<3, 3>(0, 3) = -2.0 * skew(S1da) - skew(w.cross(S)) - wx * skew(S);
  dg_dv.block<3, 3>(3, 3) = J_rate + wx * J - skew(J * w + Cda);
  rows_to_body(dg_da);
  rows_to_body(dg_dv);
  columns_to_body(dg_dv);
}

}  // namespace footfall
