#include "mbd_solver/model/elements/bushing.h"

#include "coupler/base/errors.h"

namespace footfall {
namespace {

// Angular velocity of the marker's node: w + A Psi da.
Eigen::Vector3d angular_velocity(const BodyKinematics& body, const Marker& marker) {
  if (body.modes == 0) return body.w;
  const Eigen::Vector3d bending = marker.Psi * body.da;
  return body.w + body.A * bending;
}

// Q += [0; T; Psi^T A^T T] in the columns of the slot.
void add_torque(const PairMotion& pair, int slot, const Marker& marker, const Eigen::Vector3d& T,
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

}  // namespace

Bushing::Bushing(std::string name, Marker m1, Marker m2, const Parameters& parameters)
    : ForceElement(std::move(name), m1.body, m2.body), m1_(std::move(m1)), m2_(std::move(m2)), parameters_(parameters) {
  const Eigen::Vector3d& k = parameters_.rotational_stiffness;
  if (!(parameters_.stiffness >= 0.0 && parameters_.damping >= 0.0 && parameters_.rotational_damping >= 0.0 &&
        k.minCoeff() >= 0.0))
    throw InputError("spring \"" + this->name() + "\": stiffness and damping must not be negative.");
  axis_weight_ = {k[1] + k[2] - k[0], k[2] + k[0] - k[1], k[0] + k[1] - k[2]};
  const Eigen::Index n = 12 + m1_.S.cols() + m2_.S.cols();
  X_.resize(3, n);
  X_rate_.resize(3, n);
}

void Bushing::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd>) const {
  if (parameters_.stiffness > 0.0 || parameters_.damping > 0.0) {
    const KinematicVector d = KinematicVector::difference(in.pair, m1_, m2_);
    d.add_transposed(-parameters_.stiffness * d.value() - parameters_.damping * d.rate(), Q);
  }
  for (int i = 0; i < 3; ++i) {
    if (axis_weight_[i] == 0.0) continue;
    const KinematicVector e1 = KinematicVector::axis(in.pair, 0, m1_, i);
    const KinematicVector e2 = KinematicVector::axis(in.pair, 1, m2_, i);
    e1.add_transposed(0.5 * axis_weight_[i] * e2.value(), Q);
    e2.add_transposed(0.5 * axis_weight_[i] * e1.value(), Q);
  }
  if (parameters_.rotational_damping > 0.0) {
    const Eigen::Vector3d T = -parameters_.rotational_damping *
                              (angular_velocity(*in.pair.body[1], m2_) - angular_velocity(*in.pair.body[0], m1_));
    add_torque(in.pair, 1, m2_, T, Q);
    add_torque(in.pair, 0, m1_, -T, Q);
  }
}

bool Bushing::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const Eigen::Index n = in.pair.size();
  Eigen::Ref<Eigen::Matrix3Xd> X = X_.leftCols(n), rate = X_rate_.leftCols(n);
  if (parameters_.stiffness > 0.0 || parameters_.damping > 0.0) {
    const double k = parameters_.stiffness, c = parameters_.damping;
    const KinematicVector d = KinematicVector::difference(in.pair, m1_, m2_);
    X.setZero();
    rate.setZero();
    d.add_jacobian(X);
    d.add_rate_jacobian(rate);
    rate = -k * X - c * rate;  // dF/dx
    out.dQ_dx.noalias() += X.transpose().lazyProduct(rate);
    out.dQ_dv.noalias() -= c * X.transpose().lazyProduct(X);
    d.add_second(-k * d.value() - c * d.rate(), out.dQ_dx);
  }
  for (int i = 0; i < 3; ++i) {
    if (axis_weight_[i] == 0.0) continue;
    const double half = 0.5 * axis_weight_[i];
    const KinematicVector e1 = KinematicVector::axis(in.pair, 0, m1_, i);
    const KinematicVector e2 = KinematicVector::axis(in.pair, 1, m2_, i);
    e1.add_second(half * e2.value(), out.dQ_dx);
    e2.add_second(half * e1.value(), out.dQ_dx);
    const Eigen::Matrix3d scaled = half * Eigen::Matrix3d::Identity();
    e1.add_product(scaled, e2, out.dQ_dx);
    e2.add_product(scaled, e1, out.dQ_dx);
  }
  if (parameters_.rotational_damping > 0.0) {
    // Q = -c W^T w_rel, with w_rel = W v
    const double c = parameters_.rotational_damping;
    X.setZero();
    rate.setZero();
    add_angular_jacobian(in.pair, 1, m2_, 1.0, X, rate);
    add_angular_jacobian(in.pair, 0, m1_, -1.0, X, rate);
    out.dQ_dx.noalias() -= c * X.transpose().lazyProduct(rate);
    out.dQ_dv.noalias() -= c * X.transpose().lazyProduct(X);
    // W^T at fixed T: d(Psi^T A^T T)/dtheta = Psi^T A^T T~
    const Eigen::Vector3d T = -c * (angular_velocity(*in.pair.body[1], m2_) - angular_velocity(*in.pair.body[0], m1_));
    for (int slot = 0; slot < 2; ++slot) {
      const BodyKinematics& body = *in.pair.body[slot];
      const Eigen::Vector3d torque = slot == 1 ? T : Eigen::Vector3d(-T);
      for (int k = 0; k < body.modes; ++k) {
        const Eigen::Vector3d column = body.A * (slot == 1 ? m2_ : m1_).Psi.col(k);
        out.dQ_dx.block<1, 3>(in.pair.offset(slot) + 6 + k, in.pair.offset(slot) + 3) +=
            column.cross(torque).transpose();
      }
    }
  }
  return true;
}

void Bushing::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const KinematicVector d = KinematicVector::difference(in.pair, m1_, m2_);
  stored[Stored::kStrain] += 0.5 * parameters_.stiffness * d.value().squaredNorm();
  power[Dissipation::kDamper] += parameters_.damping * d.rate().squaredNorm();
  for (int i = 0; i < 3; ++i) {
    const KinematicVector e1 = KinematicVector::axis(in.pair, 0, m1_, i);
    const KinematicVector e2 = KinematicVector::axis(in.pair, 1, m2_, i);
    stored[Stored::kStrain] += 0.5 * axis_weight_[i] * (1.0 - e1.value().dot(e2.value()));
  }
  const Eigen::Vector3d relative = angular_velocity(*in.pair.body[1], m2_) - angular_velocity(*in.pair.body[0], m1_);
  power[Dissipation::kDamper] += parameters_.rotational_damping * relative.squaredNorm();
}

}  // namespace footfall
