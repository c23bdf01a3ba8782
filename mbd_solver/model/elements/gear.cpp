// A gear adds one joint with a shared row per member, and a counter of turns for each angle.

#include "mbd_solver/model/elements/gear.h"

#include <cmath>

#include "coupler/base/errors.h"

namespace footfall {

int add_gear(Model& model, const std::string& name, const std::vector<GearMember>& members) {
  FOOTFALL_DEMAND(members.size() >= 2);
  int first = -1;
  for (std::size_t i = 0; i < members.size(); ++i) {
    const GearMember& member = members[i];
    FOOTFALL_DEMAND(std::isfinite(member.factor) && member.factor != 0.0);
    const Marker m1 = model.joint(member.joint).m1, m2 = model.joint(member.joint).m2;
    Joint joint;
    joint.name = i == 0 ? name : name + "/" + std::to_string(i + 1);
    joint.kind = "gear";
    joint.m1 = m1;
    joint.m2 = m2;
    joint.row_of = first;
    ConstraintRow row;
    row.unit = members[0].coordinate == Coordinate::kAngle ? ConstraintRow::Unit::kAngle : ConstraintRow::Unit::kLength;
    row.scale = member.factor / members[0].factor;
    row.coordinate = member.coordinate;
    row.curve = member.curve;
    const bool closed = member.curve && member.curve->closed();  // then turns do not matter
    if (member.curve && !closed && member.coordinate == Coordinate::kAngle)
      row.offset = nearest_turn(0.0, 0.5 * (member.curve->first() + member.curve->last()));
    joint.rows = {row};
    if (member.coordinate == Coordinate::kAngle && !closed)
      joint.turn_counter = model.add_force(std::make_unique<TurnCounter>("turns/" + joint.name, m1, m2)).index();
    const int index = model.add_joint(std::move(joint));
    if (first < 0) first = index;
  }
  return first;
}

struct TurnCounter::Scratch : ElementScratch {
  Scratch(const ForceElement& element, Eigen::Index n) : ElementScratch(element), row(n), coordinate(n) {}
  Eigen::VectorXd row;
  CoordinateScratch coordinate;
};

TurnCounter::TurnCounter(std::string name, Marker m1, Marker m2)
    : ForceElement(std::move(name), m1.body, m2.body), m1_(std::move(m1)), m2_(std::move(m2)) {}

std::unique_ptr<ElementScratch> TurnCounter::scratch(SharedCopies&) const {
  return std::make_unique<Scratch>(*this, 12 + m1_.S.cols() + m2_.S.cols());
}

void TurnCounter::add_force(const ElementInput& in, Eigen::Ref<Eigen::VectorXd>, Eigen::Ref<Eigen::VectorXd> dz) const {
  const JointCoordinate at(Coordinate::kAngle, in.pair, m1_, m2_);
  dz[0] = turn_counter_rate(at.rate(), nearest_turn(at.value(), in.z[0]), in.z[0]);
}

bool TurnCounter::add_derivatives(const ElementInput& in, ElementDerivatives& out) const {
  const JointCoordinate at(Coordinate::kAngle, in.pair, m1_, m2_);
  Scratch& scratch = scratch_of<Scratch>(in);
  Eigen::Ref<Eigen::VectorXd> row = scratch.row.head(in.pair.size());
  row.setZero();
  at.add_gradient(1.0, row);
  out.ddz_dv.row(0) += row.transpose();
  out.ddz_dx.row(0) += kTurnFollow * row.transpose();
  row.setZero();
  at.add_rate_by_position(1.0, scratch.coordinate, row);
  out.ddz_dx.row(0) += row.transpose();
  out.ddz_dz(0, 0) -= kTurnFollow;
  return true;
}

}  // namespace footfall
