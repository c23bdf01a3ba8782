#pragma once
// Coordinates of joints, and angles over any number of turns.

#include <Eigen/Dense>
#include <cmath>
#include <string_view>

#include "mbd_solver/base/kinds.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/kinematic_vector.h"

namespace footfall {

// An angle q over any number of turns; a state z selects the turn. theory 3.6.
//   q = alpha + 2 pi round((z - alpha) / 2 pi),  z' = q' + kTurnFollow (q - z),  z = 0 at the start,  alpha in (-pi, pi]
constexpr double kTurnFollow = 10.0;  // the error of z as an integral decays within about 0.1 s [1/s]

inline double nearest_turn(double alpha, double z) { return alpha + 2.0 * kPi * std::round((z - alpha) / (2.0 * kPi)); }
inline double turn_counter_rate(double rate, double q, double z) { return rate + kTurnFollow * (q - z); }

enum class Coordinate {
  kAngle,          // about z1 [rad]
  kDisplacement,   // along z1 [m]
  kDisplacementX,  // along x1 [m]: of a planar joint, like the next
  kDisplacementY   // along y1 [m]
};
constexpr std::string_view name_of(Coordinate coordinate) {
  return name_in(coordinate, "angle", "displacement", "displacement_x", "displacement_y");
}
// The axis of marker 1 of the rotation or displacement: 0, 1, 2.
constexpr int axis_of(Coordinate coordinate) {
  switch (coordinate) {
    case Coordinate::kDisplacementX: return 0;
    case Coordinate::kDisplacementY: return 1;
    case Coordinate::kAngle:
    case Coordinate::kDisplacement: break;
  }
  return 2;
}

// Rows of a pair, sized once.
struct CoordinateScratch {
  explicit CoordinateScratch(Eigen::Index n) : s(n), c(n), row(n) {}
  Eigen::VectorXd s, c, row;
};

// A coordinate q of a joint: body 2 against body 1, with the derivatives that forces, rotors and histories require.
//   angle about z1:         q = atan2(s, c),  s = y1.x2,  c = x1.x2,  q' = (c s' - s c') / rho,  rho = s^2 + c^2
//                           q'' = (c s'' - s c'') / rho - q' rho' / rho
//   displacement along e:   q = e.(p2 - p1),  e = z1, x1 or y1, which turns with body 1
// An angle is in (-pi, pi]; turns are counted with nearest_turn. theory 2.1.
class JointCoordinate {
 public:
  JointCoordinate(Coordinate kind, const PairMotion& pair, const Marker& m1, const Marker& m2);

  double value() const { return q_; }  // [rad or m]
  double rate() const { return dq_; }  // [rad/s or m/s]
  double acc() const { return ddq_; }  // with the accelerations of the bodies

  // All add to their last argument.
  void add_gradient(double factor, Eigen::Ref<Eigen::VectorXd> out) const;  // factor dq/dx = factor dq'/dv
  void add_rate_by_position(double factor, CoordinateScratch& scratch, Eigen::Ref<Eigen::VectorXd> out) const;
  void add_acc_by_position(double factor, CoordinateScratch& scratch, Eigen::Ref<Eigen::VectorXd> out) const;
  void add_acc_by_velocity(double factor, CoordinateScratch& scratch, Eigen::Ref<Eigen::VectorXd> out) const;
  void add_second(double factor, CoordinateScratch& scratch, Eigen::Ref<Eigen::MatrixXd> K) const;  // factor d2q/dx2

 private:
  bool angle_;
  KinematicVector a_, b_;  // y1, x2; e, p2 - p1
  KinematicVector x1_;     // angle
  double s_ = 0.0, c_ = 0.0, ds_ = 0.0, dc_ = 0.0, rho_ = 1.0, drho_ = 0.0;
  double q_, dq_, ddq_;
};

}  // namespace footfall
