// theta is a function of u = [w; c], which is linear in dot products of axes; close to zero angle by series.

#include "mbd_solver/model/elements/bushing.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/text.h"
#include "mbd_solver/base/codes.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/codes.h"
#include "mbd_solver/model/elements/forces.h"

namespace footfall {
namespace {

constexpr double kSmall = 0.01;  // of (|w| / c)^2: series below it, because closed forms cancel
constexpr int kTerms = 9;        // of the series: kSmall^kTerms is below round-off

// dV/dG_ij of V = b . [w; c].
Eigen::Matrix3d by_products(const Eigen::Vector4d& b) {
  Eigen::Matrix3d B = 0.5 * b[3] * Eigen::Matrix3d::Identity();
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    B(j, i) += 0.5 * b[k];
    B(i, j) -= 0.5 * b[k];
  }
  return B;
}

}  // namespace

RotationVector::RotationVector(const PairMotion& pair, const Marker& m1, const Marker& m2) {
  Eigen::Matrix3d E1, E2;
  const NodeTurn turn_1(*pair.body[0], m1), turn_2(*pair.body[1], m2);
  for (int k = 0; k < 3; ++k) {
    e1_[k] = KinematicVector::axis(pair, 0, m1, k, turn_1);
    e2_[k] = KinematicVector::axis(pair, 1, m2, k, turn_2);
    E1.col(k) = e1_[k].value();
    E2.col(k) = e2_[k].value();
  }
  const Eigen::Matrix3d G = E1.transpose() * E2;
  for (int k = 0; k < 3; ++k) {
    const int i = (k + 1) % 3, j = (k + 2) % 3;
    w_[k] = 0.5 * (G(j, i) - G(i, j));
  }
  c_ = 0.5 * (G.trace() - 1.0);
  const double sigma = w_.squaredNorm(), s = std::sqrt(sigma);
  rho_ = sigma + c_ * c_;
  angle_ = std::atan2(s, c_);
  const double x = sigma / (c_ * c_);
  if (c_ > 0.0 && x < kSmall) {
    // f = 1/c sum (-x)^n / (2n + 1),  g = 2 df/dsigma,  h = dg/dsigma
    double power = 1.0;  // (-x)^n
    f_ = g_ = h_ = 0.0;
    for (int n = 0; n < kTerms; ++n) {
      f_ += power / (2 * n + 1);
      g_ -= power * (2 * n + 2) / (2 * n + 3);
      h_ += power * (n + 1) * (2 * n + 4) / (2 * n + 5);
      power *= -x;
    }
    f_ /= c_;
    g_ /= c_ * c_ * c_;
    h_ /= c_ * c_ * c_ * c_ * c_;
  } else {
    f_ = angle_ / s;
    g_ = (c_ / rho_ - f_) / sigma;
    h_ = (-c_ / (rho_ * rho_) - 1.5 * g_) / sigma;
  }
  theta_ = f_ * w_;
}

// df/dc = -1 / rho,  d2f/dc2 = 2 c / rho^2,  d2f/dc dw = 2 w / rho^2,  d2f/dw2 = g I + 2 h w w^T

Eigen::Vector4d RotationVector::gradient(const Eigen::Vector3d& p) const {
  const double pw = p.dot(w_);
  Eigen::Vector4d out;
  out.head<3>() = f_ * p + (pw * g_) * w_;
  out[3] = -pw / rho_;
  return out;
}

Eigen::Matrix4d RotationVector::curvature(const Eigen::Vector3d& p) const {
  const double pw = p.dot(w_), rho2 = rho_ * rho_;
  Eigen::Matrix4d out;
  out.topLeftCorner<3, 3>() = g_ * (w_ * p.transpose() + p * w_.transpose()) + (2.0 * pw * h_) * w_ * w_.transpose();
  out.topLeftCorner<3, 3>().diagonal().array() += pw * g_;
  out.topRightCorner<3, 1>() = -p / rho_ + (2.0 * pw / rho2) * w_;
  out.bottomLeftCorner<1, 3>() = out.topRightCorner<3, 1>().transpose();
  out(3, 3) = 2.0 * pw * c_ / rho2;
  return out;
}

Eigen::Matrix<double, 3, 4> RotationVector::jacobian() const {
  Eigen::Matrix<double, 3, 4> J;
  J.leftCols<3>() = g_ * w_ * w_.transpose();
  J.leftCols<3>().diagonal().array() += f_;
  J.col(3) = -w_ / rho_;
  return J;
}

void RotationVector::add_gradient(const Eigen::Vector4d& b, Eigen::Ref<Eigen::VectorXd> out) const {
  const Eigen::Matrix3d B = by_products(b);
  for (int i = 0; i < 3; ++i) {
    e1_[i].add_transposed(B(i, 0) * e2_[0].value() + B(i, 1) * e2_[1].value() + B(i, 2) * e2_[2].value(), out);
    e2_[i].add_transposed(B(0, i) * e1_[0].value() + B(1, i) * e1_[1].value() + B(2, i) * e1_[2].value(), out);
  }
}

void RotationVector::add_second(const Eigen::Vector4d& b, Eigen::Ref<Eigen::MatrixXd> K) const {
  const Eigen::Matrix3d B = by_products(b);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) add_dot_second(e1_[i], e2_[j], B(i, j), K);
}

void RotationVector::add_jacobian(Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 4>> columns) const {
  for (int a = 0; a < 4; ++a) add_gradient(Eigen::Vector4d::Unit(a), columns.col(a));
}

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

// The rotation vector; NumericalError near half a turn.
RotationVector rotation(const std::string& name, const PairMotion& pair, const Marker& m1, const Marker& m2) {
  const RotationVector theta(pair, m1, m2);
  if (theta.angle() > Bushing::kLargestTurn * kPi / 180.0)
    throw NumericalError(code::kHalfTurn, "spring \"" + name + "\": its bodies are rotated by " +
                                              number_text(theta.angle() * 180.0 / kPi, 4) +
                                              " degrees against each other (limit " +
                                              number_text(Bushing::kLargestTurn) +
                                              "), where the direction of the torque becomes ambiguous. Use a torsion "
                                              "spring about a joint's axis, which allows any number of turns.");
  return theta;
}

}  // namespace

struct Bushing::Scratch : ElementScratch {
  Scratch(const ForceElement& element, Eigen::Index n)
      : ElementScratch(element), row(n), row_rate(n), columns(n, 4), W(3, n), T(3, n), X(3, n) {}
  Eigen::VectorXd row, row_rate;
  Eigen::Matrix<double, Eigen::Dynamic, 4> columns;
  Eigen::Matrix3Xd W, T, X;
};

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
      throw InputError(code::kParameterOutOfRange,
                       "spring \"" + this->name() + "\": stiffness and damping must not be negative.");
  translates_ = !p.stiffness.isZero(0.0) || !p.damping.isZero(0.0);
  turns_ = !p.rotational_stiffness.isZero(0.0);
  damps_turning_ = !p.rotational_damping.isZero(0.0);
}

std::unique_ptr<ElementScratch> Bushing::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this, 12 + m1_.S.cols() + m2_.S.cols());
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
  Scratch& scratch = scratch_of<Scratch>(in);
  Eigen::Ref<Eigen::VectorXd> row = scratch.row.head(n), rate = scratch.row_rate.head(n);
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
  Eigen::Ref<Eigen::Matrix<double, Eigen::Dynamic, 4>> U = scratch_of<Scratch>(in).columns.topRows(in.pair.size());
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
  Scratch& scratch = scratch_of<Scratch>(in);
  Eigen::Ref<Eigen::Matrix3Xd> W = scratch.W.leftCols(n), T_x = scratch.T.leftCols(n), X = scratch.X.leftCols(n);
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
