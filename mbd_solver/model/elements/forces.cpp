// Both elements write their force as a gradient times a law, and differentiate it by the product rule.

#include "mbd_solver/model/elements/forces.h"

#include "coupler/base/errors.h"

namespace footfall {
namespace {

constexpr int kSlot = 1;  // of the body; slot 0 is the ground

}  // namespace

struct AppliedForce::Scratch : ElementScratch {
  Scratch(const ForceElement& element, Eigen::Index n) : ElementScratch(element), X(3, n) {}
  Eigen::Matrix3Xd X;
};

AppliedForce::AppliedForce(std::string name, Marker marker, std::optional<Eigen::Vector3d> fixed_direction,
                           Magnitude force, Magnitude torque)
    : ForceElement(std::move(name), kGround, marker.body),
      marker_(std::move(marker)),
      fixed_direction_(std::move(fixed_direction)),
      force_(std::move(force)),
      torque_(std::move(torque)) {
  FOOTFALL_DEMAND(marker_.body != kGround && (force_.is_given() || torque_.is_given()));
}

std::unique_ptr<ElementScratch> AppliedForce::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this, 6 + marker_.S.cols());
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
    Eigen::Ref<Eigen::Matrix3Xd> X = scratch_of<Scratch>(in).X.leftCols(in.pair.size());  // de/dx
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

struct JointForce::Scratch : ElementScratch {
  Scratch(const ForceElement& element, const std::vector<std::unique_ptr<StrutLaw>>& laws, Eigen::Index n)
      : ElementScratch(element), row(n), row_rate(n), coordinate(n) {
    for (const std::unique_ptr<StrutLaw>& law : laws) out.emplace_back(law->state_count());
  }
  std::vector<StrutOutput> out;  // one per law
  std::vector<StrutPower> power;
  Eigen::VectorXd row, row_rate;
  CoordinateScratch coordinate;
};

JointForce::JointForce(std::string name, Marker m1, Marker m2, Coordinate coordinate,
                       std::vector<std::unique_ptr<StrutLaw>> laws, int command_index)
    : ForceElement(std::move(name), m1.body, m2.body),
      m1_(std::move(m1)),
      m2_(std::move(m2)),
      coordinate_(coordinate),
      laws_(std::move(laws)),
      states_(coordinate == Coordinate::kAngle ? 1 : 0),
      command_index_(command_index) {
  FOOTFALL_DEMAND(!laws_.empty());
  for (const std::unique_ptr<StrutLaw>& law : laws_) {
    first_state_.push_back(states_);
    states_ += law->state_count();
    switches_ = switches_ || law->switches();
  }
}

std::unique_ptr<ElementScratch> JointForce::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this, laws_, 12 + m1_.S.cols() + m2_.S.cols());
}

Eigen::VectorXd JointForce::initial_state() const {
  Eigen::VectorXd z = Eigen::VectorXd::Zero(states_);
  for (std::size_t i = 0; i < laws_.size(); ++i)
    if (laws_[i]->state_count() > 0) z.segment(first_state_[i], laws_[i]->state_count()) = laws_[i]->initial_state();
  return z;
}

double JointForce::with_turns(const ElementInput& in, double alpha) const {
  if (coordinate_ != Coordinate::kAngle) return alpha;
  return nearest_turn(alpha, in.z[0]);
}

StrutInput JointForce::law_input(const ElementInput& in, const JointCoordinate& at, std::size_t law) const {
  return {with_turns(in, at.value()),
          at.rate(),
          0.0,
          in.z.segment(first_state_[law], laws_[law]->state_count()),
          in.time,
          command_index_ >= 0 ? in.inputs[command_index_] : 0.0};
}

const StrutOutput& JointForce::evaluate(const ElementInput& in, const JointCoordinate& at, std::size_t law) const {
  StrutOutput& out = scratch_of<Scratch>(in).out[law];
  laws_[law]->evaluate(law_input(in, at, law), out);
  return out;
}

void JointForce::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q,
                           Eigen::Ref<Eigen::VectorXd> dz) const {
  const JointCoordinate at(coordinate_, in.pair, m1_, m2_);
  if (coordinate_ == Coordinate::kAngle) dz[0] = turn_counter_rate(at.rate(), with_turns(in, at.value()), in.z[0]);
  double force = 0.0;
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const StrutOutput& law = evaluate(in, at, i);
    force += law.force;
    dz.segment(first_state_[i], laws_[i]->state_count()) = law.dz;
  }
  at.add_gradient(-force, Q);
}

bool JointForce::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  // Q = -F q_x:  by x -(F_q q_x + F_v q'_x) q_x^T - F q_xx,  by v -F_v q_x q_x^T
  const JointCoordinate at(coordinate_, in.pair, m1_, m2_);
  const Eigen::Index n = in.pair.size();
  Scratch& scratch = scratch_of<Scratch>(in);
  Eigen::Ref<Eigen::VectorXd> q_x = scratch.row.head(n), rate_x = scratch.row_rate.head(n);
  q_x.setZero();
  rate_x.setZero();
  at.add_gradient(1.0, q_x);
  at.add_rate_by_position(1.0, scratch.coordinate, rate_x);
  if (coordinate_ == Coordinate::kAngle) {
    out.ddz_dx.row(0) += (rate_x + kTurnFollow * q_x).transpose();
    out.ddz_dv.row(0) += q_x.transpose();
    out.ddz_dz(0, 0) -= kTurnFollow;
  }
  double force = 0.0, by_q = 0.0, by_rate = 0.0;
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const StrutOutput& law = evaluate(in, at, i);
    force += law.force;
    by_q += law.dforce_dstroke;
    by_rate += law.dforce_drate;
    for (int j = 0; j < laws_[i]->state_count(); ++j) {
      const int row = first_state_[i] + j;
      out.dQ_dz.col(row) -= law.dforce_dz[j] * q_x;
      out.ddz_dx.row(row) += (law.ddz_dstroke[j] * q_x + law.ddz_drate[j] * rate_x).transpose();
      out.ddz_dv.row(row) += law.ddz_drate[j] * q_x.transpose();
      for (int k = 0; k < laws_[i]->state_count(); ++k) out.ddz_dz(row, first_state_[i] + k) += law.ddz_dz(j, k);
    }
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    out.dQ_dx.col(k) -= (by_q * q_x[k] + by_rate * rate_x[k]) * q_x;
    out.dQ_dv.col(k) -= (by_rate * q_x[k]) * q_x;
  }
  at.add_second(-force, scratch.coordinate, out.dQ_dx);
  return true;
}

void JointForce::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const JointCoordinate at(coordinate_, in.pair, m1_, m2_);
  std::vector<StrutPower>& powers = scratch_of<Scratch>(in).power;
  powers.clear();
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const StrutInput law = law_input(in, at, i);
    stored[laws_[i]->stored_kind()] += laws_[i]->stored_energy(law);
    laws_[i]->dissipated_power(law, powers);
  }
  for (const StrutPower& p : powers) power[p.kind] += p.power;
}

double JointForce::switch_value(const ElementInput& in) const {
  const JointCoordinate at(coordinate_, in.pair, m1_, m2_);
  double smallest = 1.0;
  for (std::size_t i = 0; i < laws_.size(); ++i)
    if (laws_[i]->switches()) smallest = std::min(smallest, laws_[i]->switch_value(law_input(in, at, i)));
  return smallest;
}

bool JointForce::switch_states(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> z) const {
  const JointCoordinate at(coordinate_, in.pair, m1_, m2_);
  bool any = false;
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    if (!laws_[i]->switches() || laws_[i]->switch_value(law_input(in, at, i)) >= 0.0) continue;
    laws_[i]->switch_state(law_input(in, at, i), z.segment(first_state_[i], laws_[i]->state_count()));
    any = true;
  }
  return any;
}

void JointForce::add_supply(const ElementInput& in, Supplied& power) const {
  const JointCoordinate at(coordinate_, in.pair, m1_, m2_);
  for (std::size_t i = 0; i < laws_.size(); ++i)
    power[Supply::kDrive] += laws_[i]->supplied_power(law_input(in, at, i));
}

JointForceSample JointForce::sample(const ElementInput& in) const {
  const JointCoordinate at(coordinate_, in.pair, m1_, m2_);
  JointForceSample out{with_turns(in, at.value()), at.rate()};
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    out.force -= evaluate(in, at, i).force;
    out.supply += laws_[i]->supplied_power(law_input(in, at, i));
  }
  return out;
}

std::unique_ptr<JointForce> torsional_spring(std::string name, Marker m1, Marker m2,
                                             const LinearSpringDamperParameters& parameters) {
  std::vector<std::unique_ptr<StrutLaw>> laws;
  laws.push_back(std::make_unique<LinearSpringDamper>(parameters));
  return std::make_unique<JointForce>(std::move(name), std::move(m1), std::move(m2), Coordinate::kAngle,
                                      std::move(laws));
}

}  // namespace footfall
