#include "mbd_solver/model/elements/applied_force.h"

#include "coupler/base/errors.h"
#include "mbd_solver/model/elements/torque.h"

namespace footfall {
namespace {

constexpr int kSlot = 1;  // of the body; slot 0 is the ground

}  // namespace

AppliedForce::AppliedForce(std::string name, Marker marker, std::optional<Eigen::Vector3d> fixed_direction,
                           Magnitude force, Magnitude torque)
    : ForceElement(std::move(name), kGround, marker.body),
      marker_(std::move(marker)),
      fixed_direction_(std::move(fixed_direction)),
      force_(std::move(force)),
      torque_(std::move(torque)),
      X_(3, 6 + marker_.S.cols()) {
  FOOTFALL_DEMAND(marker_.body != kGround && (force_.is_given() || torque_.is_given()));
}

KinematicVector AppliedForce::direction(const PairMotion& pair) const {
  return fixed_direction_ ? KinematicVector::constant(*fixed_direction_)
                          : KinematicVector::axis(pair, kSlot, marker_, 2);
}

void AppliedForce::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd>) const {
  const Eigen::Vector3d e = direction(in.pair).value();
  if (force_.is_given()) KinematicVector::point(in.pair, kSlot, marker_).add_transposed(force_.at(in) * e, Q);
  if (torque_.is_given()) add_torque(in.pair, kSlot, marker_, torque_.at(in) * e, Q);
}

bool AppliedForce::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const KinematicVector e = direction(in.pair);
  if (force_.is_given()) {
    const double f = force_.at(in);
    const KinematicVector p = KinematicVector::point(in.pair, kSlot, marker_);
    p.add_product(f * Eigen::Matrix3d::Identity(), e, out.dQ_dx);
    p.add_second(f * e.value(), out.dQ_dx);
  }
  if (torque_.is_given()) {
    const double m = torque_.at(in);
    const BodyKinematics& body = *in.pair.body[kSlot];
    add_torque_derivative(in.pair, kSlot, marker_, m * e.value(), out.dQ_dx);
    Eigen::Ref<Eigen::Matrix3Xd> X = X_.leftCols(in.pair.size());  // de/dx
    X.setZero();
    e.add_jacobian(X);
    out.dQ_dx.middleRows<3>(3) += m * X;
    for (int k = 0; k < body.modes; ++k) {
      const Eigen::Vector3d column = m * (body.A * marker_.Psi.col(k));
      out.dQ_dx.row(6 + k) += column.transpose().lazyProduct(X);
    }
  }
  return true;
}

void AppliedForce::add_supply(const ElementInput& in, Supplied& power) const {
  const Eigen::Vector3d e = direction(in.pair).value();
  power[Supply::kForce] += force_.at(in) * e.dot(KinematicVector::point(in.pair, kSlot, marker_).rate()) +
                           torque_.at(in) * e.dot(angular_velocity(*in.pair.body[kSlot], marker_));
}

}  // namespace footfall
