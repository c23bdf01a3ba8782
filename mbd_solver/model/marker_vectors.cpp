#include "mbd_solver/model/marker_vectors.h"

#include "mbd_solver/model/mode_sums.h"

namespace footfall {

void MarkerVectors::find_axis(int slot, int k) {
  const Marker& at = marker(slot);
  if (!turn_[slot]) turn_[slot].emplace(*pair_.body[slot], at);
  vectors_[3 * slot + k].emplace(pair_, slot, at, k, *turn_[slot]);
}

// On the modes of a body the axes of one marker act together: Psi^T sum u_k x (A^T f_k).
void MarkerVectors::add_pushed(Eigen::Ref<Eigen::VectorXd> out) const {
  for (int slot = 0; slot < 2; ++slot) {
    const BodyKinematics& body = *pair_.body[slot];
    const bool* pushed = pushed_ + 3 * slot;
    if (body.ground || !(pushed[0] || pushed[1] || pushed[2])) continue;
    const Marker& at = marker(slot);
    const int first = pair_.offset(slot);
    Eigen::Vector3d of_modes = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
      if (!pushed[k]) continue;
      const Eigen::Vector3d& f = forces_[3 * slot + k];
      out.segment<3>(first + 3) += vectors_[3 * slot + k]->value().cross(f);
      if (body.modes == 0) continue;
      const Eigen::Vector3d local = body.A.transpose() * f;
      of_modes += Eigen::Vector3d(at.axes.col(k)).cross(local);
    }
    if (body.modes > 0) add_to_modes(at.Psi, of_modes, out.segment(first + 6, body.modes));
  }
  if (pushed_[kDifference]) vectors_[kDifference]->add_transposed(forces_[kDifference], out);
}

}  // namespace footfall
