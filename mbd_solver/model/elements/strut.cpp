// The laws act along the line between the markers; the chain rule takes their derivatives to both bodies.

#include "mbd_solver/model/elements/strut.h"

#include <cmath>

#include "coupler/base/errors.h"
#include "coupler/base/number.h"
#include "mbd_solver/model/codes.h"

namespace footfall {

struct Strut::Scratch : ElementScratch {
  Scratch(const ForceElement& element, const std::vector<std::unique_ptr<StrutLaw>>& laws, Eigen::Index n)
      : ElementScratch(element), row(n), row_rate(n) {
    for (const std::unique_ptr<StrutLaw>& law : laws) out.emplace_back(law->state_count());
  }
  std::vector<StrutOutput> out;  // one per law
  std::vector<StrutPower> power;
  Eigen::VectorXd row, row_rate;
};

Strut::Strut(std::string name, Marker m1, Marker m2, std::vector<std::unique_ptr<StrutLaw>> laws,
             double undeformed_length, int voltage_index)
    : ForceElement(std::move(name), m1.body, m2.body),
      m1_(std::move(m1)),
      m2_(std::move(m2)),
      laws_(std::move(laws)),
      length_(undeformed_length),
      voltage_index_(voltage_index) {
  if (!(std::isfinite(length_) && length_ > 0.0))
    throw InputError(code::kNoLength, "strut \"" + this->name() + "\": the undeformed length is " +
                                          plain_text(length_) +
                                          " m; it must be positive. Are both ends at the same point?");
  for (const std::unique_ptr<StrutLaw>& law : laws_) {
    first_state_.push_back(states_);
    states_ += law->state_count();
  }
}

std::unique_ptr<ElementScratch> Strut::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this, laws_, 12 + m1_.S.cols() + m2_.S.cols());
}

Eigen::VectorXd Strut::initial_state() const {
  Eigen::VectorXd z(states_);
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    if (laws_[i]->state_count() > 0) z.segment(first_state_[i], laws_[i]->state_count()) = laws_[i]->initial_state();
  }
  return z;
}

Strut::Line Strut::line(const PairMotion& pair) const {
  Line out{KinematicVector::difference(pair, m1_, m2_), 0.0, 0.0, 0.0, Eigen::Vector3d::Zero()};
  out.length = out.d.value().norm();
  if (!(out.length > 1e-9 * length_))
    throw NumericalError(code::kStrutEndsMeet,
                         "strut \"" + name() + "\": its two ends coincide, so that it has no direction.");
  out.e = out.d.value() / out.length;
  out.stroke = length_ - out.length;
  out.rate = -out.e.dot(out.d.rate());
  return out;
}

StrutInput Strut::law_input(const ElementInput& in, const Line& line, std::size_t law) const {
  const double voltage = voltage_index_ >= 0 ? in.inputs[voltage_index_] : 0.0;
  return {line.stroke, line.rate, voltage, in.z.segment(first_state_[law], laws_[law]->state_count())};
}

const StrutOutput& Strut::evaluate(const ElementInput& in, const Line& line, std::size_t law) const {
  StrutOutput& out = scratch_of<Scratch>(in).out[law];
  try {
    laws_[law]->evaluate(law_input(in, line, law), out);
  } catch (const NumericalError& error) {
    throw NumericalError("strut \"" + name() + "\": " + error.what());
  }
  return out;
}

void Strut::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd> Q, Eigen::Ref<Eigen::VectorXd> dz) const {
  const Line at = line(in.pair);
  double force = 0.0;
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const StrutOutput& law = evaluate(in, at, i);
    force += law.force;
    dz.segment(first_state_[i], laws_[i]->state_count()) = law.dz;
  }
  at.d.add_transposed(force * at.e, Q);
}

bool Strut::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  // Q = F X^T e;  dl/dx = X^T e,  d(l')/dx = X^T P d' / l + (d'_x)^T e,  d(l')/dv = X^T e,  P = I - e e^T
  const Line at = line(in.pair);
  const Eigen::Index n = in.pair.size();
  Scratch& scratch = scratch_of<Scratch>(in);
  Eigen::Ref<Eigen::VectorXd> length_x = scratch.row.head(n);
  Eigen::Ref<Eigen::VectorXd> rate_x = scratch.row_rate.head(n);
  length_x.setZero();
  rate_x.setZero();
  const Eigen::Matrix3d P_over_l = (Eigen::Matrix3d::Identity() - at.e * at.e.transpose()) / at.length;
  const Eigen::Vector3d turning = P_over_l * at.d.rate();
  at.d.add_transposed(at.e, length_x);
  at.d.add_transposed(turning, rate_x);
  at.d.add_rate_by_position(at.e, rate_x);

  double force = 0.0, by_stroke = 0.0, by_rate = 0.0;
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const StrutOutput& law = evaluate(in, at, i);
    force += law.force;
    by_stroke += law.dforce_dstroke;
    by_rate += law.dforce_drate;
    for (int j = 0; j < laws_[i]->state_count(); ++j) {  // stroke and rate fall when length grows
      const int row = first_state_[i] + j;
      out.dQ_dz.col(row) += law.dforce_dz[j] * length_x;
      out.ddz_dx.row(row) -= (law.ddz_dstroke[j] * length_x + law.ddz_drate[j] * rate_x).transpose();
      out.ddz_dv.row(row) -= law.ddz_drate[j] * length_x.transpose();
      for (int k = 0; k < laws_[i]->state_count(); ++k) out.ddz_dz(row, first_state_[i] + k) += law.ddz_dz(j, k);
    }
  }
  for (Eigen::Index k = 0; k < n; ++k) {
    out.dQ_dx.col(k) -= (by_stroke * length_x[k] + by_rate * rate_x[k]) * length_x;
    out.dQ_dv.col(k) -= (by_rate * length_x[k]) * length_x;
  }
  at.d.add_product(force * P_over_l, at.d, out.dQ_dx);
  at.d.add_second(force * at.e, out.dQ_dx);
  return true;
}

void Strut::add_energy(const ElementInput& in, StoredEnergy& stored, Dissipated& power) const {
  const Line at = line(in.pair);
  std::vector<StrutPower>& powers = scratch_of<Scratch>(in).power;
  powers.clear();
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    const StrutInput law = law_input(in, at, i);
    stored[laws_[i]->stored_kind()] += laws_[i]->stored_energy(law);
    laws_[i]->dissipated_power(law, powers);
  }
  for (const StrutPower& p : powers) power[p.kind] += p.power;
}

StrutMotion Strut::motion(const PairMotion& pair) const {
  const Line at = line(pair);
  return {at.stroke, at.rate};
}

StrutSample Strut::sample(const ElementInput& in) const {
  const Line at = line(in.pair);
  StrutSample out{at.stroke, at.rate, 0.0};
  for (std::size_t i = 0; i < laws_.size(); ++i) {
    out.force += evaluate(in, at, i).force;
  }
  return out;
}

}  // namespace footfall
