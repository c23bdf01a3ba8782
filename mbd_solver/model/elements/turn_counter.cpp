#include "mbd_solver/model/elements/turn_counter.h"

#include "mbd_solver/model/joints/whole_turns.h"

namespace footfall {

TurnCounter::TurnCounter(std::string name, Marker m1, Marker m2)
    : ForceElement(std::move(name), m1.body, m2.body),
      m1_(std::move(m1)),
      m2_(std::move(m2)),
      scratch_(12 + m1_.S.cols() + m2_.S.cols()),
      row_(scratch_.row.size()) {}

void TurnCounter::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd>, Eigen::Ref<Eigen::VectorXd> dz) const {
  const JointCoordinate at(Coordinate::kAngle, in.pair, m1_, m2_);
  dz[0] = turn_counter_rate(at.rate(), nearest_turn(at.value(), in.z[0]), in.z[0]);
}

bool TurnCounter::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const JointCoordinate at(Coordinate::kAngle, in.pair, m1_, m2_);
  Eigen::Ref<Eigen::VectorXd> row = row_.head(in.pair.size());
  row.setZero();
  at.add_gradient(1.0, row);
  out.ddz_dv.row(0) += row.transpose();
  out.ddz_dx.row(0) += kTurnFollow * row.transpose();
  row.setZero();
  at.add_rate_by_position(1.0, scratch_, row);
  out.ddz_dx.row(0) += row.transpose();
  out.ddz_dz(0, 0) -= kTurnFollow;
  return true;
}

}  // namespace footfall
