// Positions, attitudes and modal coordinates are visited body by body.

#include "mbd_solver/dynamics/kinematics.h"

#include "mbd_solver/model/control/continuous_signals.h"

namespace footfall {

Layout::Layout(const Model& model) {
  for (int i = 0; i < model.body_count(); ++i) {
    const int s = model.body(i).mode_count();
    body_q.push_back(q_size);
    body_v.push_back(v_size);
    q_size += 7 + s;
    v_size += 6 + s;
  }
  for (int i = 0; i < model.force_count(); ++i) {
    force_z.push_back(z_size);
    z_size += model.force(i).state_count();
  }
  signal_z = z_size;
  if (model.signals()) z_size += model.signals()->state_count();
  for (int i = 0; i < model.joint_count(); ++i) {
    const Joint& joint = model.joint(i);
    joint_turns.push_back(joint.turn_counter < 0 ? -1 : force_z[joint.turn_counter]);
    joint_angle.push_back(joint.counts_turns ? angle_count++ : -1);
    if (joint.row_of >= 0) {
      joint_row.push_back(joint_row[joint.row_of]);
      shared[joint_row.back()] = 1;
      continue;
    }
    joint_row.push_back(row_count);
    for (std::size_t k = 0; k < joint.rows.size(); ++k) row_joint.push_back(i);
    row_count = static_cast<int>(row_joint.size());
    shared.resize(row_joint.size(), 0);
  }
}

Kinematics::Kinematics(const Model& model) : bodies_(static_cast<std::size_t>(model.body_count()) + 1) {
  for (int i = 0; i < model.body_count(); ++i) {
    BodyKinematics& body = bodies_[static_cast<std::size_t>(i) + 1];
    body.ground = false;
    body.modes = model.body(i).mode_count();
    body.a = body.da = body.dda = Eigen::VectorXd::Zero(body.modes);
  }
  for (int j = 0; j < model.joint_count(); ++j)
    if (model.joint(j).turn_counter >= 0) turning_.push_back(j);
  if (!turning_.empty()) turns_.resize(static_cast<std::size_t>(model.joint_count()), 0.0);
}

void Kinematics::load(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
                      const Eigen::Ref<const Eigen::VectorXd>& v, const Eigen::Ref<const Eigen::VectorXd>& dv) {
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

void fill_motion(const BodyKinematics& body, BodyMotion& motion) {
  motion.r = body.r;
  motion.L = body.L;
  motion.dr = body.dr;
  motion.w = body.w;
  motion.ddr = body.ddr;
  motion.dw = body.dw;
  if (motion.mode_count() == 0) return;
  motion.a = body.a;
  motion.da = body.da;
  motion.dda = body.dda;
}

namespace {

// Calls visit(q0, v0, s) for every body: first entries in q and v, number of modes.
template <typename Visit>
void for_each_body(const Layout& layout, Visit visit) {
  for (std::size_t i = 0; i < layout.body_q.size(); ++i) {
    const int end = i + 1 < layout.body_v.size() ? layout.body_v[i + 1] : layout.v_size;
    visit(layout.body_q[i], layout.body_v[i], end - layout.body_v[i] - 6);
  }
}

}  // namespace

void add_increment(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> q) {
  for_each_body(layout, [&](int q0, int v0, int s) {
    q.segment<3>(q0) += dx.segment<3>(v0);
    q.segment<4>(q0 + 3) = rotated(q.segment<4>(q0 + 3), dx.segment<3>(v0 + 3));
    q.segment(q0 + 7, s) += dx.segment(v0 + 6, s);
  });
}

void solve_positions(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& known,
                     const Eigen::Ref<const Eigen::VectorXd>& v, double c, Eigen::Ref<Eigen::VectorXd> q) {
  // dL/dt = 1/2 W L with W = [0, -w^T; w, w~], W W = -|w|^2 I:  (c I - W/2)^-1 c = (I + W/(2c)) / (1 + |w|^2
  // / (4 c^2))
  for_each_body(layout, [&](int q0, int v0, int s) {
    const Eigen::Vector3d w = v.segment<3>(v0 + 3);
    const Eigen::Vector4d L = known.segment<4>(q0 + 3);
    q.segment<3>(q0) = known.segment<3>(q0) + v.segment<3>(v0) / c;
    q.segment<4>(q0 + 3) = (L + quaternion_rate(L, w) / c) / (1.0 + w.squaredNorm() / (4.0 * c * c));
    q.segment(q0 + 7, s) = known.segment(q0 + 7, s) + v.segment(v0 + 6, s) / c;
  });
}

void solve_position_rows(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& v, double c,
                         Eigen::Ref<Eigen::VectorXd> dq) {
  // (c I - W/2)^-1 = (c I + W/2) / (c^2 + |w|^2 / 4), as in solve_positions
  for_each_body(layout, [&](int q0, int v0, int s) {
    const Eigen::Vector3d w = v.segment<3>(v0 + 3);
    const Eigen::Vector4d L = dq.segment<4>(q0 + 3);
    dq.segment<3>(q0) /= c;
    dq.segment<4>(q0 + 3) = (c * L + quaternion_rate(L, w)) / (c * c + 0.25 * w.squaredNorm());
    dq.segment(q0 + 7, s) /= c;
  });
}

void to_increments(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
                   const Eigen::Ref<const Eigen::VectorXd>& dq, Eigen::Ref<Eigen::VectorXd> dx) {
  for_each_body(layout, [&](int q0, int v0, int s) {
    const Eigen::Vector4d L = q.segment<4>(q0 + 3);
    dx.segment<3>(v0) = dq.segment<3>(q0);
    dx.segment<3>(v0 + 3) = (2.0 / L.squaredNorm()) * (rate_matrix(L) * dq.segment<4>(q0 + 3));
    dx.segment(v0 + 6, s) = dq.segment(q0 + 7, s);
  });
}

void from_increments(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
                     const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> dq) {
  for_each_body(layout, [&](int q0, int v0, int s) {
    dq.segment<3>(q0) = dx.segment<3>(v0);
    dq.segment<4>(q0 + 3) = quaternion_rate(q.segment<4>(q0 + 3), dx.segment<3>(v0 + 3));
    dq.segment(q0 + 7, s) = dx.segment(v0 + 6, s);
  });
}

}  // namespace footfall
