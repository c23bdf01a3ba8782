#include "mbd_solver/dynamics/kinematics.h"

namespace footfall {

Kinematics::Kinematics(const Model& model) : bodies_(static_cast<std::size_t>(model.body_count()) + 1) {
  for (int i = 0; i < model.body_count(); ++i) {
    BodyKinematics& body = bodies_[static_cast<std::size_t>(i) + 1];
    body.ground = false;
    body.modes = model.body(i).mode_count();
    body.a = body.da = body.dda = Eigen::VectorXd::Zero(body.modes);
  }
}

void Kinematics::load(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q, const Eigen::Ref<const Eigen::VectorXd>& v,
                      const Eigen::Ref<const Eigen::VectorXd>& dv) {
  for (std::size_t i = 0; i + 1 < bodies_.size(); ++i) {
    BodyKinematics& body = bodies_[i + 1];
    const int q0 = layout.body_q[i], v0 = layout.body_v[i];
    body.r = q.segment<3>(q0);
    body.L = q.segment<4>(q0 + 3);
    body.A = rotation_matrix(body.L);
    body.dr = v.segment<3>(v0);
    body.w = v.segment<3>(v0 + 3);
    if (dv.size() > 0) {
      body.ddr = dv.segment<3>(v0);
      body.dw = dv.segment<3>(v0 + 3);
    } else {
      body.ddr.setZero();
      body.dw.setZero();
    }
    if (body.modes == 0) continue;
    body.a = q.segment(q0 + 7, body.modes);
    body.da = v.segment(v0 + 6, body.modes);
    if (dv.size() > 0) {
      body.dda = dv.segment(v0 + 6, body.modes);
    } else {
      body.dda.setZero();
    }
  }
}

void add_increment(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> q) {
  const std::size_t count = layout.body_q.size();
  for (std::size_t i = 0; i < count; ++i) {
    const int q0 = layout.body_q[i], v0 = layout.body_v[i];
    const int end = i + 1 < count ? layout.body_v[i + 1] : layout.v_size;
    q.segment<3>(q0) += dx.segment<3>(v0);
    q.segment<4>(q0 + 3) = rotated(q.segment<4>(q0 + 3), dx.segment<3>(v0 + 3));
    q.segment(q0 + 7, end - v0 - 6) += dx.segment(v0 + 6, end - v0 - 6);
  }
}

}  // namespace footfall
