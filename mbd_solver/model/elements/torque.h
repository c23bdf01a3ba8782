#pragma once
// A torque on the node of a marker, and the angular velocity that it works on. Everything adds to its last argument.

#include "mbd_solver/model/kinematic_vector.h"

namespace footfall {

// Angular velocity of the marker's node in W: w + A Psi da [rad/s].
inline Eigen::Vector3d angular_velocity(const BodyKinematics& body, const Marker& marker) {
  if (body.modes == 0) return body.w;
  const Eigen::Vector3d bending = marker.Psi * body.da;
  return body.w + body.A * bending;
}

// Q += [0; T; Psi^T A^T T] in the columns of the slot. T in W [N m].
inline void add_torque(const PairMotion& pair, int slot, const Marker& marker, const Eigen::Vector3d& T,
                       Eigen::Ref<Eigen::VectorXd> Q) {
  const BodyKinematics& body = *pair.body[slot];
  if (body.ground) return;
  const int offset = pair.offset(slot);
  Q.segment<3>(offset + 3) += T;
  if (body.modes > 0) {
    const Eigen::Vector3d local = body.A.transpose() * T;
    Q.segment(offset + 6, body.modes).noalias() += marker.Psi.transpose() * local;
  }
}

// K += d[0; T; Psi^T A^T T]/dx at fixed T: d(Psi^T A^T T)/dtheta = Psi^T A^T T~
inline void add_torque_derivative(const PairMotion& pair, int slot, const Marker& marker, const Eigen::Vector3d& T,
                                  Eigen::Ref<Eigen::MatrixXd> K) {
  const BodyKinematics& body = *pair.body[slot];
  for (int k = 0; k < body.modes; ++k) {
    const Eigen::Vector3d column = body.A * marker.Psi.col(k);
    K.block<1, 3>(pair.offset(slot) + 6 + k, pair.offset(slot) + 3) += column.cross(T).transpose();
  }
}

}  // namespace footfall
