#include "mbd_solver/model/moving_point.h"

#include "mbd_solver/model/mode_sums.h"

namespace footfall {

MovingPoint::MovingPoint(const BodyKinematics& body, const Marker& marker) : body_(&body), marker_(&marker) {
  Eigen::Vector3d s = marker.s0;
  rate_ = body.dr;
  if (body.modes > 0) {
    Eigen::Vector3d ds = Eigen::Vector3d::Zero();
    for (int k = 0; k < body.modes; ++k) {
      s += body.a[k] * marker.S.col(k);
      ds += body.da[k] * marker.S.col(k);
    }
    rate_ += body.A.lazyProduct(ds);
  }
  x_ = body.A.lazyProduct(s);
  value_ = body.r + x_;
  rate_ += body.w.cross(x_);
}

void MovingPoint::add_transposed(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const {
  out.head<3>() += f;
  out.segment<3>(3) += x_.cross(f);
  if (body_->modes == 0) return;
  const Eigen::Vector3d local = body_->A.transpose() * f;
  add_to_modes(marker_->S, local, out.segment(6, body_->modes));
}

}  // namespace footfall
