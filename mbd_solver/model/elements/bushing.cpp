#include "mbd_solver/model/elements/bushing.h"

#include "coupler/base/errors.h"
#include "coupler/base/pi.h"
#include "coupler/base/text.h"
#include "mbd_solver/model/elements/rotation_vector.h"
#include "mbd_solver/model/elements/torque.h"

namespace footfall {
namespace {

// W += sign dw/dv, and by_x += sign dw/dx (only A Psi da depends on the attitude), 3 x n.
void add_angular_jacobian(const PairMotion& pair, int slot, const Marker& marker, double sign,
                          Eigen::Ref<Eigen::Matrix3Xd> W, Eigen::Ref<Eigen::Matrix3Xd> by_x) {
  const BodyKinematics& body = *pair.body[slot];
  if (body.ground) return;
  const int offset = pair.offset(slot);
  W.block<3, 3>(0, offset + 3).diagonal().array() += sign;
  if (body.modes == 0) return;
  const Eigen::Vector3d bending = marker.Psi * body.da;
  const Eigen::Vector3d bending_W = body.A * bending;
  by_x.block<3, 3>(0, offset + 3) -= sign * skew(bending_W);
  for (int k = 0; k < body.modes; ++k) {
    const Eigen::Vector3d column = body.A * marker.Psi.col(k);
    W.col(offset + 6 + k) += sign * column;
  }
}

// The rotation vector, with the complaint about half a turn.
RotationVector rotation(const std::string& name, const PairMotion& pair, const Marker& m1, const Marker& m2) {
  const RotationVector theta(pair, m1, m2);
  if (theta.angle() > Bushing::kLargestTurn * kPi / 180.0)
    throw NumericalError(
        "spring \"" + name + "\": its bodies are turned by " + number_text(theta.angle() * 180.0 / kPi, 4) +
        " degrees against each other, and at half a turn the way back is not known; expected at most " +
        number_text(Bushing::kLargestTurn) +
        " degrees. A torsion spring about a joint's axis takes any number of turns.");
  return theta;
}

}  // namespace

// Relative angular velocity w2 - w1 and its damping torque on body 2, T = -sum_i c_i (e1_i . w) e1_i.
class Bushing::Turn {
 public:
  Turn(const Bushing& bushing, const PairMotion& pair)
      : w(angular_velocity(*pair.body[1], bushing.m2_) - angular_velocity(*pair.body[0], bushing.m1_)) {
    const NodeTurn turn(*pair.body[0], bushing.m1_);
    for (int i = 0; i < 3; ++i) {
      e[i] = KinematicVector::axis(pair, 0, bushing.m1_, i, turn);
      rate[i] = e[i].value().dot(w);
      T -= bushing.parameters_.rotational_damping[i] * rate[i] * e[i].value();
    }
  }
  Eigen::Vector3d w;
  KinematicVector e[3];
  Eigen::Vector3d rate = Eigen::Vector3d::Zero(), T = Eigen::Vector3d::Zero();
};

Bushing::Bushing(std::string name, Marker m1, Marker m2, const Parameters& parameters)
    : ForceElement(std::move(name), m1.body, m2.body), m1_(std::move(m1)), m2_(std::move(m2)), parameters_(parameters) {
  const Parameters& p = parameters_;
  for (const Eigen::Vector3d* values : {&p.stiffness, &p.damping, &p.rotational_stiffness, &p.rotational_damping})
    if (!(values->minCoeff() >= 0.0))
      throw InputError("spring \"" + this->name() + "\": stiffness and damping must not be negative.");
  translates_ = !p.stiffness.isZero(0.0) || !p.damping.isZero(0.0);
  turns_ = !p.rotational_stiffness.isZero(0.0);
  damps_turning_ = !p.rotational_damping.isZero(0.0);
  const Eigen::Index n = 12 + m1_.S.cols() + m2_.S.cols();
  row_.resize(n);
  row_rate_.resize(n);
  columns_.resize(n, 4);
  W_.resize(3, n);
  T_.resize(3, n);
  X_.resize(3, n);
}

void Bushing::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd>) const {
  const Parameters& p = parameters_;
  if (translates_) {
    const KinematicVector d = KinematicVector::difference(in.pair, m1_, m2_);
    const NodeTurn turn(*in.pair.body[0], m1_);
    for (int i = 0; i < 3; ++i) {
      const KinematicVector e = KinematicVector::axis(in.pair, 0, m1_, i, turn);
      add_dot(e, d, -p.stiffness[i] * e.value().dot(d.value()) - p.damping[i] * dot_rate(e, d), Q);
    }
  }
  if (turns_) {  // Q = -dV/dx = -(k theta) . dtheta/dx
    const RotationVector theta = rotation(name(), in.pair, m1_, m2_);
    const Eigen::Vector3d torque = -p.rotational_stiffness.cwiseProduct(theta.value());
    theta.add_gradient(theta.gradient(torque), Q);
  }
  if (damps_turning_) {
    const Turn turn(*this, in.pair);
    add_torque(in.pair, 1, m2_, turn.T, Q);
    add_torque(in.pair, 0, m1_, -turn.T, Q);
  }
}

bool Bushing::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  if (translates_) add_translation_derivatives(in, out);
  if (turns_) add_rotation_derivatives(in, out);
  if (damps_turning_) add_turning_derivatives(in, out);
  return true;
}

void Bushing::add_translation_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  // Q = sum F_i dd_i/dx,  F_i = -k_i d_i - c_i d_i'
  const Eigen::Index n = in.pair.size();
  Eigen::Ref<Eigen::VectorXd> row = row_.head(n), rate = row_rate_.head(n);
  const KinematicVector d = KinematicVector::difference(in.pair, m1_, m2_);
  for (int i = 0; i < 3; ++i) {
    const double k = parameters_.stiffness[i], c = parameters_.damping[i];
    if (k == 0.0 && c == 0.0) continue;
    const KinematicVector e = KinematicVector::axis(in.pair, 0, m1_, i);
    row.setZero();
    rate.setZero();
    add_dot(e, d, 1.0, row);
    add_dot_rate(e, d, -c, rate);
    rate -= k * row;  // dF_i/dx
    out.dQ_dx.noalias() += row * rate.transpose();
    out.dQ_dv.noalias() -= (c * row) * row.transpose();
    add_dot_second(e, d, -k * e.value().dot(d.value()) - c * dot_rate(e, d), out.dQ_dx);
  }
}

void Bushing::add_rotation_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  // -d2V/dx2 = -(du/dx)^T (J^T K J + theta_uu . K theta) du/dx - V_u . d2u/dx2
  Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 4>> U = columns_.topRows(in.pair.size());
  const RotationVector theta = rotation(name(), in.pair, m1_, m2_);
  const Eigen::Vector3d& k = parameters_.rotational_stiffness;
  const Eigen::Vector3d torque = -k.cwiseProduct(theta.value());
  const Eigen::Matrix<double, 3, 4> J = theta.jacobian();
  const Eigen::Matrix4d H = theta.curvature(torque) - J.transpose() * k.asDiagonal() * J;
  U.setZero();
  theta.add_jacobian(U);
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < 4; ++b) out.dQ_dx.noalias() += (H(a, b) * U.col(a)) * U.col(b).transpose();
  theta.add_second(theta.gradient(torque), out.dQ_dx);
}

void Bushing::add_turning_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  // Q = W^T T, w = W v:  dT = -sum c_i [e_i (e_i.dw + w.de_i) + (e_i.w) de_i]
  const Eigen::Index n = in.pair.size();
  Eigen::Ref<Eigen::Matrix3Xd> W = W_.leftCols(n), T_x = T_.leftCols(n), X = X_.leftCols(n);
  const Turn turn(*this, in.pair);
  W.setZero();
  T_x.setZero();  // first dw/dx
  add_angular_jacobian(in.pair, 1, m2_, 1.0, W, T_x);
  add_angular_jacobian(in.pair, 0, m1_, -1.0, W, T_x);
  Eigen::Matrix3d C = Eigen::Matrix3d::Zero();
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3d e = turn.e[i].value();
    C += parameters_.rotational_damping[i] * e * e.transpose();
  }
  for (Eigen::Index j = 0; j < n; ++j) {
    const Eigen::Vector3d by_x = C * T_x.col(j), by_v = C * W.col(j);
    T_x.col(j) = -by_x;
    out.dQ_dv.col(j).noalias() -= W.transpose() * by_v;
  }
  for (int i = 0; i < 3; ++i) {
    const double c = parameters_.rotational_damping[i];
    X.setZero();
    turn.e[i].add_jacobian(X);
    for (Eigen::Index j = 0; j < n; ++j)
      T_x.col(j) -= c * (turn.w.dot(X.col(j)) * turn.e[i].value() + turn.rate[i] * X.col(j));
  }
  out.dQ_dx.noalias() += W.transpose().lazyProduct(T_x);
  // W^T at fixed T
  add_torque_derivative(in.pair, 1, m2_, turn.T, out.dQ_dx);
  add_torque_derivative(in.pair, 0, m1_, -turn.T, out.dQ_dx);
}

void Bushing::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const Parameters& p = parameters_;
  if (translates_) {
    const KinematicVector d = KinematicVector::difference(in.pair, m1_, m2_);
    for (int i = 0; i < 3; ++i) {
      const KinematicVector e = KinematicVector::axis(in.pair, 0, m1_, i);
      const double along = e.value().dot(d.value()), rate = dot_rate(e, d);
      stored[Stored::kStrain] += 0.5 * p.stiffness[i] * along * along;
      power[Dissipation::kDamper] += p.damping[i] * rate * rate;
    }
  }
  if (turns_) {
    const Eigen::Vector3d theta = rotation(name(), in.pair, m1_, m2_).value();
    stored[Stored::kStrain] += 0.5 * theta.dot(p.rotational_stiffness.cwiseProduct(theta));
  }
  if (damps_turning_) power[Dissipation::kDamper] += p.rotational_damping.dot(Turn(*this, in.pair).rate.cwiseAbs2());
}

}  // namespace footfall
