// Jacobians of the equations of motion. Joints, force elements and bodies give derivatives by increments dx =
// [dr; dtheta; da] and by velocities; they are gathered once over [v; z; lambda] (Workspace::lower,
// Workspace::stiffness), and then
//   full:     columns of q = stiffness chained by dtheta = (2 R(L) / |L|^2) dL, rows of dq - N v on top;
//   reduced:  q eliminated by dq = N v at the rate c:
//             dx = T dv,  T = diag(1/c, (c I + w~/2) / (c^2 + |w|^2 / 4), 1/c).

#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/workspace.h"

namespace footfall {
namespace {

// Of what a body itself gives the diagonal: Newton needs one iteration in a hundred more.
constexpr double kNegligible = 3e-3;

void add_columns(const SparseBlock& block, double* values, const Eigen::Ref<const Eigen::MatrixXd>& X) {
  for (Eigen::Index k = 0; k < X.cols(); ++k) block.add_column(values, static_cast<int>(k), X.col(k));
}

// One column of a matrix as a vector of its stored values.
Eigen::Map<const Eigen::VectorXd> stored(const Eigen::SparseMatrix<double>& pattern, const double* values, int column) {
  const int begin = pattern.outerIndexPtr()[column], end = pattern.outerIndexPtr()[column + 1];
  return {values + begin, end - begin};
}

// The last `count` stored values of a column.
Eigen::Map<Eigen::VectorXd> tail(Eigen::SparseMatrix<double>& matrix, int column, Eigen::Index count) {
  return {matrix.valuePtr() + matrix.outerIndexPtr()[column + 1] - count, count};
}

}  // namespace

void Equations::add_body_derivatives(int index, double c, const Inputs& inputs) {
  Workspace& w = *work_;
  const std::size_t at = static_cast<std::size_t>(index);
  const BodyKinematics& body = w.kinematics.of(index);
  const int n = body.size();
  Eigen::Ref<Eigen::MatrixXd> K = w.K.topLeftCorner(n, n), D = w.D.topLeftCorner(n, n), M = w.M.topLeftCorner(n, n);
  body_derivatives(model_.body(index), body, w.inertia[at], K, D, M);
  Eigen::Ref<Eigen::VectorXd> own = w.own_diagonal.segment(layout_.body_v[at], n);
  own = c * M.diagonal();
  if (body.modes > 0) {
    own.tail(body.modes) += D.diagonal().tail(body.modes).cwiseMax(0.0);
    own.tail(body.modes) += (1.0 / c) * K.diagonal().tail(body.modes).cwiseMax(0.0);
  }
  if (!inputs.loads.empty()) {  // F_v takes -Q
    K = -K;
    D = -D;
    add_load_derivatives(inputs.loads[at], body, K, D);
    K = -K;
    D = -D;
  }
  D += c * M;
  add_columns(w.body_places[at].v_v, w.stiffness.data(), K);
  add_columns(w.body_places[at].v_v, w.lower.valuePtr(), D);
}

void Equations::add_joint_derivatives(int index, double t, double c, const Eigen::Ref<const Eigen::VectorXd>& lambda) {
  Workspace& w = *work_;
  const Joint& joint = model_.joint(index);
  const PairPlaces& places = w.joint_places[static_cast<std::size_t>(index)];
  const PairMotion pair = w.joint_pair(joint);
  MarkerVectors vectors(pair, joint.m1, joint.m2);
  const int n = pair.size();
  double* values = w.lower.valuePtr();
  double* stiffness = w.stiffness.data();
  const bool closes = joint.rows.front().inertia == 0.0;  // else a rotor
  const double alpha2 = closes ? 2.0 * baumgarte_.alpha : 0.0;

  Eigen::Ref<Eigen::MatrixXd> K = w.K.topLeftCorner(n, n);
  Eigen::Ref<Eigen::VectorXd> phi_v = w.row.head(n), rate_dx = w.row2.head(n), acc_dx = w.row3.head(n),
                              acc_dv = w.row4.head(n);
  K.setZero();
  for (std::size_t k = 0; k < joint.rows.size(); ++k) {
    const int local = static_cast<int>(k), row = layout_.joint_row[static_cast<std::size_t>(index)] + local;
    const double beta2 = closes && joint.rows[k].holds_positions() ? baumgarte_.beta * baumgarte_.beta : 0.0;
    evaluate_row(joint.rows[k], t, vectors, phi_v);  // phi alone depends on whole turns
    row_derivatives(joint.rows[k], t, vectors, lambda[row], rate_dx, acc_dx, acc_dv, K);
    // F_lambda = phi'' + 2 alpha phi' + beta^2 phi - eps lambda
    if (alpha2 != 0.0 || beta2 != 0.0) acc_dx += alpha2 * rate_dx + beta2 * phi_v;
    acc_dv += (c + alpha2) * phi_v;
    for (int i = 0; i < 2; ++i) {
      const int m = pair.body[i]->size(), offset = pair.offset(i);
      if (m == 0) continue;
      for (int j = 0; j < m; ++j) {
        places.extra_v[i].add(stiffness, local, j, acc_dx[offset + j]);
        places.extra_v[i].add(values, local, j, acc_dv[offset + j]);
      }
      places.v_extra[i].add_column(values, local, phi_v.segment(offset, m));
    }
  }
  for (int i = 0; i < 2; ++i) {
    for (int j = 0; j < 2; ++j) {
      const int ni = pair.body[i]->size(), nj = pair.body[j]->size();
      if (ni > 0 && nj > 0) add_columns(places.v_v[i][j], stiffness, K.block(pair.offset(i), pair.offset(j), ni, nj));
    }
  }
}

void Equations::add_force_derivatives(int index, double t, const Eigen::Ref<const Eigen::VectorXd>& z,
                                      const Eigen::VectorXd& values) {
  Workspace& w = *work_;
  const ForceElement& element = model_.force(index);
  const PairPlaces& places = w.force_places[static_cast<std::size_t>(index)];
  const PairMotion pair = w.force_pair(element);
  ElementDerivatives& d = w.elements[static_cast<std::size_t>(index)];
  double* values = w.lower.valuePtr();
  double* stiffness = w.stiffness.data();
  for (Eigen::MatrixXd* part : {&d.dQ_dx, &d.dQ_dv, &d.dQ_dz, &d.ddz_dx, &d.ddz_dv, &d.ddz_dz}) part->setZero();
  if (!element.add_derivatives({pair, z, values, t}, d)) return;

  // F_v takes -Q, F_z takes -g.
  for (Eigen::MatrixXd* part : {&d.dQ_dx, &d.dQ_dv, &d.dQ_dz, &d.ddz_dx, &d.ddz_dv, &d.ddz_dz}) *part = -*part;
  for (int j = 0; j < 2; ++j) {
    const int nj = pair.body[j]->size(), cj = pair.offset(j);
    if (nj == 0) continue;
    for (int i = 0; i < 2; ++i) {
      const int ni = pair.body[i]->size(), ci = pair.offset(i);
      if (ni == 0) continue;
      add_columns(places.v_v[i][j], stiffness, d.dQ_dx.block(ci, cj, ni, nj));
      add_columns(places.v_v[i][j], values, d.dQ_dv.block(ci, cj, ni, nj));
    }
    if (element.state_count() == 0) continue;
    add_columns(places.extra_v[j], stiffness, d.ddz_dx.middleCols(cj, nj));
    add_columns(places.extra_v[j], values, d.ddz_dv.middleCols(cj, nj));
    add_columns(places.v_extra[j], values, d.dQ_dz.middleRows(cj, nj));
  }
  const int block = element.state_block();
  for (std::size_t k = 0; k < places.extra_extra.size(); ++k)
    add_columns(places.extra_extra[k], values, d.ddz_dz.middleRows(static_cast<int>(k) * block, block));
}

void Equations::gather_derivatives(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                   const Eigen::Ref<const Eigen::VectorXd>& ydot, double c, const Inputs& inputs) {
  Workspace& w = *work_;
  w.kinematics.load(layout_, y.head(layout_.q_size), y.segment(layout_.v0(), layout_.v_size),
                    ydot.segment(layout_.v0(), layout_.v_size));
  w.stiffness.setZero();
  Eigen::Map<Eigen::VectorXd>(w.lower.valuePtr(), w.lower.nonZeros()).setZero();
  for (int i = 0; i < model_.body_count(); ++i) add_body_derivatives(i, c, inputs);
  for (int i = 0; i < model_.joint_count(); ++i) add_joint_derivatives(i, t, c, y.tail(layout_.row_count));
  for (int place : w.z_z) w.lower.valuePtr()[place] += c;
  for (std::size_t row = 0; row < w.lambda_lambda.size(); ++row)
    w.lower.valuePtr()[w.lambda_lambda[row]] -= w.regularisation[static_cast<Eigen::Index>(row)];
  const Eigen::VectorXd& values = input_values_at(t, y, inputs);
  for (int i = 0; i < model_.force_count(); ++i)
    add_force_derivatives(
        i, t, y.segment(layout_.z0() + layout_.force_z[static_cast<std::size_t>(i)], model_.force(i).state_count()),
        values);
  if (model_.signals()) add_signal_derivatives(t, y, inputs);
}

const Eigen::SparseMatrix<double>& Equations::jacobian_pattern() const { return work_->jacobian; }

const Eigen::SparseMatrix<double>& Equations::jacobian(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                       const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                                       const Inputs& inputs) {
  Workspace& w = *work_;
  gather_derivatives(t, y, ydot, c, inputs);
  double* values = w.jacobian.valuePtr();
  Eigen::Map<Eigen::VectorXd>(values, w.jacobian.nonZeros()).setZero();
  for (int j = 0; j < w.lower.cols(); ++j) {
    const Eigen::Map<const Eigen::VectorXd> column = stored(w.lower, w.lower.valuePtr(), j);
    tail(w.jacobian, layout_.q_size + j, column.size()) = column;
  }
  for (int i = 0; i < model_.body_count(); ++i) {
    const std::size_t at = static_cast<std::size_t>(i);
    const BodyKinematics& body = w.kinematics.of(i);
    const BodyPlaces& places = w.body_places[at];
    const int q = layout_.body_q[at], v = layout_.body_v[at];
    const Matrix34d R = rate_matrix(body.L);

    // Lower rows by q.
    const auto by = [&](int k) { return stored(w.lower, w.stiffness.data(), v + k); };
    const Eigen::Index count = by(0).size();
    for (int k = 0; k < 3; ++k) tail(w.jacobian, q + k, count) = by(k);
    const double scale = 2.0 / body.L.squaredNorm();
    for (int l = 0; l < 4; ++l)
      tail(w.jacobian, q + 3 + l, count) = scale * (R(0, l) * by(3) + R(1, l) * by(4) + R(2, l) * by(5));
    for (int k = 0; k < body.modes; ++k) tail(w.jacobian, q + 7 + k, count) = by(6 + k);

    // F_q = dq - N v;  -d(1/2 R(L)^T w)/dL = -1/2 [0, -w^T; w, w~]
    for (std::size_t k = 0; k < 3; ++k) {
      values[places.r_r[k]] = c;
      values[places.r_dr[k]] = -1.0;
    }
    for (std::size_t k = 0; k < places.a_a.size(); ++k) {
      values[places.a_a[k]] = c;
      values[places.a_da[k]] = -1.0;
    }
    Eigen::Matrix4d by_L;
    by_L(0, 0) = c;
    by_L.topRightCorner<1, 3>() = 0.5 * body.w.transpose();
    by_L.bottomLeftCorner<3, 1>() = -0.5 * body.w;
    by_L.bottomRightCorner<3, 3>() = -0.5 * skew(body.w);
    by_L.bottomRightCorner<3, 3>().diagonal().array() += c;
    for (int k = 0; k < 4; ++k) places.L_L.add_column(values, k, by_L.col(k));
    for (int k = 0; k < 3; ++k) places.L_w.add_column(values, k, -0.5 * R.row(k).transpose());
  }
  return w.jacobian;
}

const Eigen::SparseMatrix<double>& Equations::reduced_pattern() const { return work_->reduced; }

const Eigen::VectorXd& Equations::own_diagonal() const { return work_->own_diagonal; }

// Forces in pairs cancel in the sum of the rows of dr, so Newton keeps linear momentum to round-off at every iteration,
// converged or not: these rows stay whole. Where rows of joints follow from others all does: the mechanism may pass singular
// positions, in which the answer hangs on the order of pivots.
Eigen::VectorXd Equations::negligible_shares() const {
  if (!work_->redundancies.empty()) return Eigen::VectorXd::Zero(layout_.v_size);
  Eigen::VectorXd share = Eigen::VectorXd::Constant(layout_.v_size, kNegligible);
  for (const int v : layout_.body_v) share.segment<3>(v).setConstant(ThinLu::kRoundOff);
  return share;
}

const Eigen::SparseMatrix<double>& Equations::reduced_jacobian(double t, const Eigen::Ref<const Eigen::VectorXd>& y,
                                                               const Eigen::Ref<const Eigen::VectorXd>& ydot, double c,
                                                               const Inputs& inputs) {
  Workspace& w = *work_;
  gather_derivatives(t, y, ydot, c, inputs);
  Eigen::Map<Eigen::VectorXd> values(w.reduced.valuePtr(), w.reduced.nonZeros());
  values = Eigen::Map<const Eigen::VectorXd>(w.lower.valuePtr(), w.lower.nonZeros());
  for (int i = 0; i < model_.body_count(); ++i) {
    const BodyKinematics& body = w.kinematics.of(i);
    const int v = layout_.body_v[static_cast<std::size_t>(i)];
    const auto by = [&](int k) { return stored(w.lower, w.stiffness.data(), v + k); };
    const Eigen::Index count = by(0).size();
    Eigen::Matrix3d T = 0.5 * skew(body.w);
    T.diagonal().array() += c;
    T /= c * c + 0.25 * body.w.squaredNorm();
    for (int k = 0; k < 3; ++k) tail(w.reduced, v + k, count) += by(k) / c;
    for (int k = 0; k < 3; ++k)
      tail(w.reduced, v + 3 + k, count) += T(0, k) * by(3) + T(1, k) * by(4) + T(2, k) * by(5);
    for (int k = 6; k < body.size(); ++k) tail(w.reduced, v + k, count) += by(k) / c;
  }
  return w.reduced;
}

void Equations::subtract_stiffness(const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> out) const {
  const Workspace& w = *work_;
  const int* outer = w.lower.outerIndexPtr();
  const int* inner = w.lower.innerIndexPtr();
  for (int j = 0; j < layout_.v_size; ++j) {
    for (int k = outer[j]; k < outer[j + 1]; ++k) out[inner[k]] -= w.stiffness[k] * dx[j];
  }
}

}  // namespace footfall
