// The derivatives of one contact of mbd_solver/model/elements/surface_contact.h.
//   X = dp/dx of the place; E_r, E_A, E_B pick dr of B and the turns of A and B out of dx
//   D = X - E_r + (p - r_B)~ E_B               d(phi) = n.D dx, also p' - v_B(p) = D v
//   N = dn/dx = H D - n~ E_B
//   G = D + R n~ (E_A - E_B)                   g = G v, Q = G^T f
//   g_x = p'_x - w_B~ (X - E_r) - R (w_A - w_B)~ N
//   u_x = P (g_x - s~ E_B) - (n.y) N - n y^T N,  y = g + s,  s = xi / tau
//   f   = f_n (n - mu u / sqrt(u^2 + v_s^2))
#include "mbd_solver/model/elements/surface_contact_at.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {

void SurfaceContact::add_derivatives(const ElementInput& in, const Contact& at, int place, double share,
                                     ElementDerivatives& out) const {
  const BodyKinematics &A = *in.pair.body[at.slot], &B = *in.pair.body[1 - at.slot];
  const int n = in.pair.size(), a = in.pair.offset(at.slot), b = in.pair.offset(1 - at.slot);
  const double mu = law_.friction, tau = law_.stick_time;
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity(), P = unit - at.n * at.n.transpose();
  const Eigen::Vector3d turning = A.w - B.w;
  for (Eigen::Matrix3Xd* m : {&X_, &D_, &N_, &G_, &g_x_, &f_x_, &f_v_, &u_x_}) m->setZero(3, n);

  // The place against B.
  at.p.add_jacobian(X_);
  if (!B.ground) X_.middleCols<3>(b) -= unit;  // X - E_r
  D_ = X_;
  if (!B.ground) D_.middleCols<3>(b + 3) += skew(at.from_B);
  N_.noalias() = at.H.lazyProduct(D_);
  if (!B.ground) N_.middleCols<3>(b + 3) -= skew(at.n);
  G_ = D_;
  G_.middleCols<3>(a + 3) += at.radius * skew(at.n);
  if (!B.ground) G_.middleCols<3>(b + 3) -= at.radius * skew(at.n);
  at.p.add_rate_jacobian(g_x_);
  g_x_.noalias() -= skew(B.w).lazyProduct(X_);
  g_x_.noalias() -= (at.radius * skew(turning)).lazyProduct(N_);

  // The law.
  const Eigen::Vector3d y = at.g + at.spring, direction = at.n - mu * at.inverse_speed * at.u;
  u_x_.noalias() = P.lazyProduct(g_x_);
  u_x_.noalias() -= (at.n.dot(y) * unit + at.n * y.transpose()).lazyProduct(N_);
  if (!B.ground) u_x_.middleCols<3>(b + 3) -= P * skew(at.spring);
  const double cube = at.inverse_speed * at.inverse_speed * at.inverse_speed;
  const Eigen::Matrix3d by_u = (-mu * at.normal.force) * (at.inverse_speed * unit - cube * at.u * at.u.transpose());
  const Eigen::Vector3d by_overlap = at.normal.by_overlap * direction, by_closing = at.normal.by_closing * direction;
  f_x_.noalias() = by_u.lazyProduct(u_x_);
  f_x_.noalias() -= (by_overlap * at.n.transpose()).lazyProduct(D_);
  f_x_.noalias() -= (by_closing * at.n.transpose()).lazyProduct(g_x_);
  f_x_.noalias() += (at.normal.force * unit - by_closing * at.g.transpose()).lazyProduct(N_);
  const Eigen::Matrix3d by_g = by_u * P - by_closing * at.n.transpose();
  f_v_.noalias() = by_g.lazyProduct(G_);

  // Q = G^T f, and what turns with the bodies at fixed f.
  out.dQ_dx.noalias() += G_.transpose().lazyProduct(f_x_);
  out.dQ_dv.noalias() += G_.transpose().lazyProduct(f_v_);
  at.p.add_second(at.force, out.dQ_dx);
  const Eigen::Matrix3d f = skew(at.force), arm = at.radius * f;
  out.dQ_dx.middleRows<3>(a + 3).noalias() += arm.lazyProduct(N_);
  if (!B.ground) {
    out.dQ_dx.middleRows<3>(b + 3).noalias() += f.lazyProduct(X_);
    out.dQ_dx.middleRows<3>(b + 3).noalias() -= arm.lazyProduct(N_);
  }
  if (tau == 0.0) return;

  // xi_B' = R^T (clip(u) - P s), R the attitude of B: its share of this contact; -P s changes with n and B as u does.
  const ContactLaw::Clipped clipped = law_.clip(at.u);
  const Eigen::Matrix3d R = B.A, R_T = share * R.transpose();
  const Eigen::Matrix3d by_s = P * R / tau;
  out.dQ_dz.middleCols<3>(3 * place).noalias() += G_.transpose().lazyProduct(by_u * by_s);
  f_v_.noalias() = (clipped.slope * P).lazyProduct(G_);
  out.ddz_dv.middleRows<3>(3 * place).noalias() += R_T.lazyProduct(f_v_);
  out.ddz_dz.middleRows<3>(3 * place) += R_T * (clipped.slope - unit) * by_s;
  f_x_.noalias() = clipped.slope.lazyProduct(u_x_);
  f_x_.noalias() += (at.n.dot(at.spring) * unit + at.n * at.spring.transpose()).lazyProduct(N_);
  if (!B.ground) f_x_.middleCols<3>(b + 3) += P * skew(at.spring) + skew(clipped.value - at.held);
  out.ddz_dx.middleRows<3>(3 * place).noalias() += R_T.lazyProduct(f_x_);
}

}  // namespace footfall
