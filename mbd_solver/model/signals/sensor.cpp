#include "mbd_solver/model/signals/sensor.h"

#include "mbd_solver/model/joints/whole_turns.h"

namespace footfall {

double CoordinateSensor::value(const PairMotion& pair, double z) const {
  const double q = JointCoordinate(coordinate_, pair, m1_, m2_).value();
  return coordinate_ == Coordinate::kAngle ? nearest_turn(q, z) : q;
}

double CoordinateSensor::rate_of_state(const PairMotion& pair, double z) const {
  const JointCoordinate at(coordinate_, pair, m1_, m2_);
  return turn_counter_rate(at.rate(), nearest_turn(at.value(), z), z);
}

}  // namespace footfall
