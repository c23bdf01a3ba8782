// The law of contact_law.h on a surface whose normal turns with the place.
#include "mbd_solver/model/elements/curved_contact.h"

#include <cmath>

namespace footfall {

void CurvedContact::apply(const ContactLaw& law) {
  held = spring - n.dot(spring) * n;
  u = g + closing * n + held;
  inverse_speed = 1.0 / std::sqrt(u.squaredNorm() + law.slip_speed * law.slip_speed);
  normal = law.normal_force(overlap, closing);
  force = normal.force * (n - law.friction * inverse_speed * u);
}

void CurvedContact::add_energy(const ContactLaw& law, const Eigen::Vector3d& rate, StoredEnergy& stored,
                               Dissipated& power) const {
  const double mu = law.friction, tau = law.stick_time, v_s = law.slip_speed, elastic = normal.elastic;
  stored[Stored::kContact] += 0.4 * elastic * overlap;
  power[Dissipation::kContact] += (normal.force - elastic) * closing;
  power[Dissipation::kFriction] += mu * normal.force * inverse_speed * u.dot(g + closing * n);
  if (tau == 0.0) return;
  // Stored mu f psi(P xi), f = k delta^1.5: its rate is not dissipated.
  const double root = std::sqrt(held.squaredNorm() + v_s * v_s), psi = tau * (root - v_s);
  stored[Stored::kContact] += mu * elastic * psi;
  power[Dissipation::kFriction] -= mu * (elastic * held.dot(rate) / root + 1.5 * elastic / overlap * closing * psi);
}

CurvedContact::Slopes CurvedContact::differentiate(const ContactLaw& law, const Eigen::Matrix3Xd& D,
                                                   const Eigen::Matrix3Xd& N, const Eigen::Matrix3Xd& g_x,
                                                   const Eigen::Matrix3Xd& u_x, Eigen::Matrix3Xd& f_x) const {
  const Eigen::Matrix3d unit = Eigen::Matrix3d::Identity(), P = unit - n * n.transpose();
  const double mu = law.friction, cube = inverse_speed * inverse_speed * inverse_speed;
  const Eigen::Vector3d direction = n - mu * inverse_speed * u;
  const Eigen::Matrix3d by_u = (-mu * normal.force) * (inverse_speed * unit - cube * u * u.transpose());
  const Eigen::Vector3d by_overlap = normal.by_overlap * direction, by_closing = normal.by_closing * direction;
  f_x.noalias() = by_u.lazyProduct(u_x);
  f_x.noalias() -= (by_overlap * n.transpose()).lazyProduct(D);
  f_x.noalias() -= (by_closing * n.transpose()).lazyProduct(g_x);
  f_x.noalias() += (normal.force * unit - by_closing * g.transpose()).lazyProduct(N);
  return {by_u, by_u * P - by_closing * n.transpose()};
}

}  // namespace footfall
