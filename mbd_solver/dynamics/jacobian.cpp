// dF/dy + c dF/dydot of the equations of motion. Elements give derivatives by increments dx = [dr; dtheta; da] and velocities; here
// the columns of dtheta are chained once to those of the quaternion: dtheta = (2 R(L) / |L|^2) dL.

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {
namespace {

// values[rows of `block`, q columns of one body] += K, whose columns are the increments dx of that body (rows x n).
void add_by_position(const SparseBlock& block, double* values, const Eigen::Ref<const Eigen::MatrixXd>& K,
                     const Matrix34d& dtheta_dL) {
  for (int k = 0; k < 3; ++k) block.add_column(values, k, K.col(k));
  for (int l = 0; l < 4; ++l)
    block.add_column(values, 3 + l, dtheta_dL(0, l) * K.col(3) + dtheta_dL(1, l) * K.col(4) + dtheta_dL(2, l) * K.col(5));
  for (Eigen::Index k = 6; k < K.cols(); ++k) block.add_column(values, static_cast<int>(k) + 1, K.col(k));
}

void add_columns(const SparseBlock& block, double* values, const Eigen::Ref<const Eigen::MatrixXd>& D) {
  for (Eigen::Index k = 0; k < D.cols(); ++k) block.add_column(values, static_cast<int>(k), D.col(k));
}

// One row of a block (of conditions) by the increments of one body.
void add_row_by_position(const SparseBlock& block, double* values, int row, const Eigen::Ref<const Eigen::VectorXd>& x,
                         const Matrix34d& dtheta_dL) {
  const Eigen::Vector4d by_L = dtheta_dL.transpose() * x.segment<3>(3);
  for (int k = 0; k < 3; ++k) block.add(values, row, k, x[k]);
  for (int l = 0; l < 4; ++l) block.add(values, row, 3 + l, by_L[l]);
  for (int k = 6; k < static_cast<int>(x.size()); ++k) block.add(values, row, k + 1, x[k]);
}

}  // namespace

void Equations::add_body_jacobian(int index, double c, const Inputs& inputs) {
  Workspace& w = *work_;
  const std::size_t at = static_cast<std::size_t>(index);
  const BodyKinematics& body = w.kinematics.of(index);
  const BodyPlaces& places = w.body_places[at];
  double* values = w.jacobian.valuePtr();

  // F_q = dq - N v
  for (std::size_t k = 0; k < 3; ++k) {
    values[places.r_r[k]] += c;
    values[places.r_dr[k]] -= 1.0;
  }
  for (std::size_t k = 0; k < places.a_a.size(); ++k) {
    values[places.a_a[k]] += c;
    values[places.a_da[k]] -= 1.0;
  }
  // -d(1/2 R(L)^T w)/dL = -1/2 [0, -w^T; w, w~]
  Eigen::Matrix4d by_L;
  by_L(0, 0) = c;
  by_L.topRightCorner<1, 3>() = 0.5 * body.w.transpose();
  by_L.bottomLeftCorner<3, 1>() = -0.5 * body.w;
  by_L.bottomRightCorner<3, 3>() = -0.5 * skew(body.w);
  by_L.bottomRightCorner<3, 3>().diagonal().array() += c;
  for (int k = 0; k < 4; ++k) places.L_L.add_column(values, k, by_L.col(k));
  const Matrix34d R = rate_matrix(body.L);
  w.dtheta_dL[at] = (2.0 / body.L.squaredNorm()) * R;
  for (int k = 0; k < 3; ++k) places.L_w.add_column(values, k, -0.5 * R.row(k).transpose());

  // M dv + h - load
  const int n = body.size();
  Eigen::Ref<Eigen::MatrixXd> K = w.K.topLeftCorner(n, n), D = w.D.topLeftCorner(n, n), M = w.M.topLeftCorner(n, n);
  body_derivatives(model_.body(index), body, w.inertia[at], K, D, M);
  if (!inputs.loads.empty()) {
    K = -K;
    D = -D;
    add_load_derivatives(inputs.loads[at], body, K, D);
    K = -K;
    D = -D;
  }
  D += c * M;
  add_by_position(places.v_q, values, K, w.dtheta_dL[at]);
  add_columns(places.v_v, values, D);
}

void Equations::add_joint_jacobian(int index, double t, double c, const Eigen::Ref<const Eigen::VectorXd>& lambda) {
  Workspace& w = *work_;
  const Joint& joint = model_.joint(index);
  const PairPlaces& places = w.joint_places[static_cast<std::size_t>(index)];
  const PairMotion pair = w.joint_pair(joint);
  const int n = pair.size();
  const int bodies[2] = {joint.m1.body, joint.m2.body};
  double* values = w.jacobian.valuePtr();
  const double alpha2 = 2.0 * baumgarte_.alpha, beta2 = baumgarte_.beta * baumgarte_.beta;

  Eigen::Ref<Eigen::MatrixXd> K = w.K.topLeftCorner(n, n);
  Eigen::Ref<Eigen::VectorXd> phi_v = w.row.head(n), rate_dx = w.row2.head(n), acc_dx = w.row3.head(n), acc_dv = w.row4.head(n);
  K.setZero();
  int local = 0;
  for (std::size_t k = 0; k < joint.rows.size(); ++k) {
    const int kept = layout_.kept[static_cast<std::size_t>(layout_.joint_row[static_cast<std::size_t>(index)]) + k];
    if (kept < 0) continue;
    evaluate_row(joint.rows[k], t, pair, joint.m1, joint.m2, phi_v);
    row_derivatives(joint.rows[k], t, pair, joint.m1, joint.m2, lambda[kept], rate_dx, acc_dx, acc_dv, K);
    // F_lambda = phi'' + 2 alpha phi' + beta^2 phi - eps lambda
    if (alpha2 != 0.0 || beta2 != 0.0) acc_dx += alpha2 * rate_dx + beta2 * phi_v;
    acc_dv += (c + alpha2) * phi_v;
    for (int i = 0; i < 2; ++i) {
      const int m = pair.body[i]->size(), offset = pair.offset(i);
      if (m == 0) continue;
      add_row_by_position(places.extra_q[i], values, local, acc_dx.segment(offset, m),
                          w.dtheta_dL[static_cast<std::size_t>(bodies[i])]);
      for (int j = 0; j < m; ++j) places.extra_v[i].add(values, local, j, acc_dv[offset + j]);
      places.v_extra[i].add_column(values, local, phi_v.segment(offset, m));
    }
    values[w.lambda_lambda[static_cast<std::size_t>(kept)]] -= w.regularisation[kept];
    ++local;
  }
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const int ni = pair.body[i]->size(), nj = pair.body[j]->size();
      if (ni > 0 && nj > 0)
        add_by_position(places.v_q[i][j], values, K.block(pair.offset(i), pair.offset(j), ni, nj),
                        w.dtheta_dL[static_cast<std::size_t>(bodies[j])]);
    }
  }
}

void Equations::add_force_jacobian(int index, const Eigen::Ref<const Eigen::VectorXd>& z, const Inputs& inputs) {
  Workspace& w = *work_;
  const ForceElement& element = model_.force(index);
  const PairPlaces& places = w.force_places[static_cast<std::size_t>(index)];
  const PairMotion pair = w.force_pair(element);
  ElementDerivatives& d = w.elements[static_cast<std::size_t>(index)];
  double* values = w.jacobian.valuePtr();
  d.dQ_dx.setZero();
  d.dQ_dv.setZero();
  d.dQ_dz.setZero();
  d.ddz_dx.setZero();
  d.ddz_dv.setZero();
  d.ddz_dz.setZero();
  if (!element.add_derivatives({pair, z, inputs.voltages}, d)) return;

  // F_v takes -Q, F_z takes -g
  d.dQ_dx = -d.dQ_dx;
  d.dQ_dv = -d.dQ_dv;
  for (int j = 0; j < 2; ++j) {
    const int nj = pair.body[j]->size(), cj = pair.offset(j);
    if (nj == 0) continue;
    const Matrix34d& dtheta_dL = w.dtheta_dL[static_cast<std::size_t>(element.bodies()[static_cast<std::size_t>(j)])];
    for (int i = 0; i < 2; ++i) {
      const int ni = pair.body[i]->size(), ci = pair.offset(i);
      if (ni == 0) continue;
      add_by_position(places.v_q[i][j], values, d.dQ_dx.block(ci, cj, ni, nj), dtheta_dL);
      add_columns(places.v_v[i][j], values, d.dQ_dv.block(ci, cj, ni, nj));
    }
    for (int k = 0; k < element.state_count(); ++k) {
      w.row.head(nj) = -d.ddz_dx.row(k).segment(cj, nj).transpose();
      add_row_by_position(places.extra_q[j], values, k, w.row.head(nj), dtheta_dL);
      for (int l = 0; l < nj; ++l) places.extra_v[j].add(values, k, l, -d.ddz_dv(k, cj + l));
      places.v_extra[j].add_column(values, k, -d.dQ_dz.col(k).segment(cj, nj));
    }
  }
  for (int k = 0; k < element.state_count(); ++k) places.extra_extra.add_column(values, k, -d.ddz_dz.col(k));
}

const Eigen::SparseMatrix<double>& Equations::jacobian_pattern() const { return work_->jacobian; }

const Eigen::SparseMatrix<double>& Equations::jacobian(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                       const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                                       const Inputs& inputs) {
  Workspace& w = *work_;
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size),
                    ydot.segment(layout_.v0(), layout_.v_size));
  Eigen::Map<Eigen::VectorXd>(w.jacobian.valuePtr(), w.jacobian.nonZeros()).setZero();
  for (int i = 0; i < model_.body_count(); ++i) add_body_jacobian(i, c, inputs);
  for (int i = 0; i < model_.joint_count(); ++i) add_joint_jacobian(i, t, c, y.tail(layout_.row_count));
  for (int k = 0; k < layout_.z_size; ++k) w.jacobian.valuePtr()[w.z_z[static_cast<std::size_t>(k)]] += c;
  for (int i = 0; i < model_.force_count(); ++i)
    add_force_jacobian(i, y.segment(layout_.z0() + layout_.force_z[static_cast<std::size_t>(i)], model_.force(i).state_count()),
                       inputs);
  return w.jacobian;
}

}  // namespace footfall
