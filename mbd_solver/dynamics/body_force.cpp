// Velocities are rotated into B, forces and matrices back into W, by blocks of three.

#include "mbd_solver/dynamics/body_force.h"

#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

// v_B = T^T v_W for v and dv.
void turn_into_body(const BodyKinematics& at, InertiaScratch& s) {
  s.v.head<3>().noalias() = at.A.transpose() * at.dr;
  s.v.segment<3>(3).noalias() = at.A.transpose() * at.w;
  s.v.tail(at.modes) = at.da;
  s.dv.head<3>().noalias() = at.A.transpose() * at.ddr;
  s.dv.segment<3>(3).noalias() = at.A.transpose() * at.dw;
  s.dv.tail(at.modes) = at.dda;
}

// out = T X T^T for a (6+s) x (6+s) matrix X.
void turn_matrix(const Eigen::Matrix3d& A, const Eigen::MatrixXd& X, Eigen::Ref<Eigen::MatrixXd> out) {
  const Eigen::Index s = X.rows() - 6;
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const Eigen::Matrix3d block = X.block<3, 3>(3 * i, 3 * j);
      const Eigen::Matrix3d left = A * block;
      out.block<3, 3>(3 * i, 3 * j).noalias() = left * A.transpose();
    }
    for (Eigen::Index k = 0; k < s; ++k) {
      const Eigen::Vector3d column = A * X.block<3, 1>(3 * i, 6 + k);
      const Eigen::Vector3d row = A * X.block<1, 3>(6 + k, 3 * i).transpose();
      out.block<3, 1>(3 * i, 6 + k) = column;
      out.block<1, 3>(6 + k, 3 * i) = row.transpose();
    }
  }
  out.bottomRightCorner(s, s) = X.bottomRightCorner(s, s);
}

Eigen::Matrix3d turned(const Eigen::Matrix3d& A, const Eigen::Matrix3d& J) {
  const Eigen::Matrix3d left = A * J;
  return left * A.transpose();
}

// Moment and its angle to the mean attitude, see TangentLoad.
Vector6d tangent_increment(const TangentLoad& t, const BodyKinematics& at, const Eigen::Matrix3d& A_mean) {
  Vector6d dx;
  dx.head<3>() = at.r - t.r_mean;
  dx.tail<3>().setZero();
  for (int k = 0; k < 3; ++k) dx.tail<3>() += 0.5 * Eigen::Vector3d(A_mean.col(k)).cross(Eigen::Vector3d(at.A.col(k)));
  return dx;
}

}  // namespace

InertiaScratch::InertiaScratch(int modes) : inertia(modes) {
  if (modes == 0) return;
  const int n = 6 + modes;
  v = dv = g = force = Eigen::VectorXd::Zero(n);
  M = dg_dv = Eigen::MatrixXd::Zero(n, n);
  dg_da = Eigen::MatrixXd::Zero(n, modes);
}

void add_body_force(const Body& body, const BodyKinematics& at, const Eigen::Vector3d& gravity, InertiaScratch& s,
                    Eigen::Ref<Eigen::VectorXd> F) {
  if (at.modes == 0) {
    // [m (ddr - gravity); J_W dw + w x J_W w], the product J_W x taken in B
    F.head<3>() += body.mass() * (at.ddr - gravity);
    const Eigen::Vector3d w_B = at.A.transpose() * at.w;
    const Eigen::Vector3d dw_B = at.A.transpose() * at.dw;
    const Eigen::Vector3d spin = body.rigid_inertia() * w_B;
    const Eigen::Vector3d moment = body.rigid_inertia() * dw_B + w_B.cross(spin);
    F.segment<3>(3) += at.A * moment;
    return;
  }
  turn_into_body(at, s);
  body.inertia().inertia_force(at.a, s.v, s.dv, s.inertia, s.g);
  F.head<3>() -= body.mass() * gravity;
  F.head<3>() += at.A * s.g.head<3>();
  F.segment<3>(3) += at.A * s.g.segment<3>(3);
  F.tail(at.modes) += s.g.tail(at.modes);
}

void body_mass_matrix(const Body& body, const BodyKinematics& at, InertiaScratch& s, Eigen::Ref<Eigen::MatrixXd> M) {
  if (at.modes == 0) {
    M.setZero();
    M.diagonal().head<3>().setConstant(body.mass());
    M.block<3, 3>(3, 3) = turned(at.A, body.rigid_inertia());
    return;
  }
  body.inertia().mass_matrix(at.a, s.M);
  turn_matrix(at.A, s.M, M);
}

void body_mass_product(const Body& body, const BodyKinematics& at, const Eigen::Ref<const Eigen::VectorXd>& x,
                       InertiaScratch& s, Eigen::Ref<Eigen::VectorXd> out) {
  const Eigen::Vector3d turned_B = at.A.transpose() * x.segment<3>(3);
  if (at.modes == 0) {
    const Eigen::Vector3d spin = body.rigid_inertia() * turned_B;
    out.head<3>() = body.mass() * x.head<3>();
    out.segment<3>(3) = at.A * spin;
    return;
  }
  s.dv.head<3>().noalias() = at.A.transpose() * x.head<3>();
  s.dv.segment<3>(3) = turned_B;
  s.dv.tail(at.modes) = x.tail(at.modes);
  body.inertia().mass_product(at.a, s.dv, s.inertia, s.g);
  out.head<3>() = at.A * s.g.head<3>();
  out.segment<3>(3) = at.A * s.g.segment<3>(3);
  out.tail(at.modes) = s.g.tail(at.modes);
}

void body_derivatives(const Body& body, const BodyKinematics& at, InertiaScratch& s, Eigen::Ref<Eigen::MatrixXd> dF_dx,
                      Eigen::Ref<Eigen::MatrixXd> dF_dv, Eigen::Ref<Eigen::MatrixXd> M) {
  if (at.modes == 0) {
    // g = J dw + w x J w:  dg/dw = w~ J - (J w)~,  dg/dtheta = -g~ + (dg/dw) w~ + J dw~
    body_mass_matrix(body, at, s, M);
    const Eigen::Matrix3d J = M.block<3, 3>(3, 3);
    const Eigen::Vector3d Jw = J * at.w;
    const Eigen::Vector3d g = J * at.dw + at.w.cross(Jw);
    const Eigen::Matrix3d by_w = skew(at.w) * J - skew(Jw);
    dF_dx.setZero();
    dF_dv.setZero();
    dF_dv.block<3, 3>(3, 3) = by_w;
    dF_dx.block<3, 3>(3, 3) = by_w * skew(at.w) + J * skew(at.dw) - skew(g);
    return;
  }
  turn_into_body(at, s);
  body.inertia().inertia_force(at.a, s.v, s.dv, s.inertia, s.g);
  body.inertia().mass_matrix(at.a, s.M);
  body.inertia().derivatives(at.a, s.v, s.dv, s.dg_da, s.dg_dv);
  turn_matrix(at.A, s.M, M);
  turn_matrix(at.A, s.dg_dv, dF_dv);
  // by a: T dg_da
  for (int k = 0; k < at.modes; ++k) {
    const Eigen::Vector3d force = at.A * s.dg_da.block<3, 1>(0, k);
    const Eigen::Vector3d moment = at.A * s.dg_da.block<3, 1>(3, k);
    dF_dx.block<3, 1>(0, 6 + k) = force;
    dF_dx.block<3, 1>(3, 6 + k) = moment;
    dF_dx.col(6 + k).tail(at.modes) = s.dg_da.col(k).tail(at.modes);
  }
  // by theta: -g~ + (dg/dv) v~ + M dv~, over the translational and the rotational block of v and dv
  dF_dx.leftCols<3>().setZero();
  const Eigen::Matrix3d dr = skew(at.dr), w = skew(at.w), ddr = skew(at.ddr), dw = skew(at.dw);
  for (Eigen::Index i = 0; i < dF_dx.rows(); ++i) {
    const Eigen::RowVector3d row = dF_dv.block<1, 3>(i, 0) * dr + dF_dv.block<1, 3>(i, 3) * w +
                                   M.block<1, 3>(i, 0) * ddr + M.block<1, 3>(i, 3) * dw;
    dF_dx.block<1, 3>(i, 3) = row;
  }
  const Eigen::Vector3d g_r = at.A * s.g.head<3>(), g_w = at.A * s.g.segment<3>(3);
  dF_dx.block<3, 3>(0, 3) -= skew(g_r);
  dF_dx.block<3, 3>(3, 3) -= skew(g_w);
}

void add_load_force(const ExternalLoad& load, const BodyKinematics& at, Eigen::Ref<Eigen::VectorXd> Q) {
  Q.head<3>() += load.F_W;
  Q.segment<3>(3) += at.A * load.T_B;
  if (load.Q_a.size() > 0) Q.tail(at.modes) += load.Q_a;
  if (!load.tangent) return;
  const TangentLoad& t = *load.tangent;
  const Vector6d dx = tangent_increment(t, at, rotation_matrix(t.L_mean));
  Vector6d dv;
  dv << at.dr, at.w;
  dv -= t.v_mean;
  const Vector6d reaction = t.K * dx + t.C * dv;
  Q.head<6>() -= reaction;
}

void add_load_derivatives(const ExternalLoad& load, const BodyKinematics& at, Eigen::Ref<Eigen::MatrixXd> K,
                          Eigen::Ref<Eigen::MatrixXd> D) {
  const Eigen::Vector3d T_W = at.A * load.T_B;
  K.block<3, 3>(3, 3) -= skew(T_W);
  if (!load.tangent) return;
  // rotation by theta: -1/2 sum_k (A_mean e_k)~ (A e_k)~
  const TangentLoad& t = *load.tangent;
  const Eigen::Matrix3d A_mean = rotation_matrix(t.L_mean);
  Matrix6d by_x = Matrix6d::Identity();
  by_x.block<3, 3>(3, 3).setZero();
  for (int k = 0; k < 3; ++k) by_x.block<3, 3>(3, 3) -= 0.5 * skew(A_mean.col(k)) * skew(at.A.col(k));
  const Matrix6d K_x = t.K * by_x;
  K.topLeftCorner<6, 6>() -= K_x;
  D.topLeftCorner<6, 6>() -= t.C;
}

}  // namespace footfall
