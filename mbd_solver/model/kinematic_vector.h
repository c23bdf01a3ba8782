#pragma once
// The piece of kinematics from which all joints, struts and contacts are made: a vector alpha that is a signed sum of body
// vectors, sigma (r + A u) for points, sigma A u for axes, u = u0 + U a, with all derivatives of an implicit solver.
//   x = A u,  y = A U da,   x' = w x x + y,   x'' = dw x x + A U dda + w x (w x x) + 2 w x y
// Local coordinates of a pair of bodies: increments dx = [dr; dtheta; da] and velocities v = [dr; w; da],
// body 1 then body 2.
//   d alpha = X dx,  alpha' = X v,  X = sigma [I or 0, -x~, A U] in the columns of its body.
// All functions add to their last argument and allocate nothing. A ground body has no columns.

#include <Eigen/Dense>
#include <optional>

#include "mbd_solver/model/marker.h"

namespace footfall {

// The motion of one body at one instant, unpacked once per evaluation and read by all joints and forces. (BodyMotion is
// the message of coupler/.)
struct BodyKinematics {
  bool ground = true;                           // the inertial frame: no coordinates
  int modes = 0;                                // s
  Eigen::Vector3d r = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L = Eigen::Vector4d::UnitX();
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();  // A(L / |L|)
  Eigen::Vector3d dr = Eigen::Vector3d::Zero();     // [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();      // [rad/s]
  Eigen::Vector3d ddr = Eigen::Vector3d::Zero();    // [m/s2]; zero unless accelerations are loaded
  Eigen::Vector3d dw = Eigen::Vector3d::Zero();     // [rad/s2]
  Eigen::VectorXd a, da, dda;                       // s each; sized once

  int size() const { return ground ? 0 : 6 + modes; }  // number of velocity coordinates
};

// The two bodies an element acts on. Columns of body 1 start at 0, columns of body 2 at body[0]->size().
struct PairMotion {
  const BodyKinematics* body[2];
  int offset(int slot) const { return slot == 0 ? 0 : body[0]->size(); }
  int size() const { return body[0]->size() + body[1]->size(); }
};

// Rotation of a node by the modes of its body, in B: sums over the modes that all axes of a marker share,
//   U_k a = -u_k~ Psi a = (Psi a) x u_k
struct NodeTurn {
  NodeTurn() = default;
  NodeTurn(const BodyKinematics& body, const Marker& marker);
  Eigen::Vector3d a = Eigen::Vector3d::Zero(), da = a, dda = a;  // Psi a, Psi da, Psi dda
};

class KinematicVector {
 public:
  // A constant vector of W, for dot products with a fixed direction.
  static KinematicVector constant(const Eigen::Vector3d& value_W);
  // Axis k (0, 1, 2) of the marker on the body in `slot` (0 or 1).
  static KinematicVector axis(const PairMotion& pair, int slot, const Marker& marker, int k);
  static KinematicVector axis(const PairMotion& pair, int slot, const Marker& marker, int k, const NodeTurn& turn) {
    return {pair, slot, marker, k, turn};
  }
  // Position of the marker's point.
  static KinematicVector point(const PairMotion& pair, int slot, const Marker& marker);
  // d = p2 - p1.
  static KinematicVector difference(const PairMotion& pair, const Marker& m1, const Marker& m2) {
    return {pair, m1, m2};
  }

  const Eigen::Vector3d& value() const { return value_; }  // alpha
  const Eigen::Vector3d& rate() const { return rate_; }    // alpha'
  const Eigen::Vector3d& acc() const { return acc_; }      // alpha'' with the accelerations of the BodyKinematics

  // out += X^T f
  void add_transposed(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const;
  // out += (d alpha' / dx)^T f   (at fixed v)
  void add_rate_by_position(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const;
  // out += (d alpha'' / dx)^T f  (at fixed v, dv)
  void add_acc_by_position(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const;
  // out += (d alpha'' / dv)^T f  (at fixed x, dv)
  void add_acc_by_velocity(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const;
  // K += X^T C X_other
  void add_product(const Eigen::Matrix3d& C, const KinematicVector& other, Eigen::Ref<Eigen::MatrixXd> K) const;
  // out += X;  out += d alpha' / dx  (3 x n each), for laws written with matrices
  void add_jacobian(Eigen::Ref<Eigen::Matrix3Xd> out) const;
  void add_rate_jacobian(Eigen::Ref<Eigen::Matrix3Xd> out) const;
  // K += d(X^T f) / dx at fixed f
  void add_second(const Eigen::Vector3d& f, Eigen::Ref<Eigen::MatrixXd> K) const;

  KinematicVector() = default;  // the zero vector of W
  // axis() and difference() in place, without a copy
  KinematicVector(const PairMotion& pair, int slot, const Marker& marker, int k, const NodeTurn& turn);
  KinematicVector(const PairMotion& pair, const Marker& m1, const Marker& m2);

 private:
  struct Term {
    const BodyKinematics* body;
    const Eigen::Matrix3Xd* U;  // 3 x s
    int offset;                 // first local column of the body
    double sign;
    bool point;               // r is included
    Eigen::Vector3d x, y, z;  // A u, A U da, A U dda
  };
  struct Local {  // in B
    Eigen::Vector3d u, U_da, U_dda;
  };
  void add_term(const PairMotion& pair, int slot, double sign, bool point, const Eigen::Vector3d& u0,
                const Eigen::Matrix3Xd& U);
  void add_term(const PairMotion& pair, int slot, double sign, bool point, const Local& local,
                const Eigen::Matrix3Xd& U);

  int count_ = 0;
  Term terms_[2];
  Eigen::Vector3d value_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d rate_ = Eigen::Vector3d::Zero();
  Eigen::Vector3d acc_ = Eigen::Vector3d::Zero();
};

// --- Derivatives of a dot product a.b of kinematic vectors, the coordinate of most springs between two markers.

// (a.b)'
inline double dot_rate(const KinematicVector& a, const KinematicVector& b) {
  return a.rate().dot(b.value()) + a.value().dot(b.rate());
}

// out += factor d(a.b)/dx = factor d(a.b)'/dv
inline void add_dot(const KinematicVector& a, const KinematicVector& b, double factor,
                    Eigen::Ref<Eigen::VectorXd> out) {
  a.add_transposed(factor * b.value(), out);
  b.add_transposed(factor * a.value(), out);
}

// out += factor d(a.b)'/dx
inline void add_dot_rate(const KinematicVector& a, const KinematicVector& b, double factor,
                         Eigen::Ref<Eigen::VectorXd> out) {
  a.add_rate_by_position(factor * b.value(), out);
  b.add_rate_by_position(factor * a.value(), out);
  a.add_transposed(factor * b.rate(), out);
  b.add_transposed(factor * a.rate(), out);
}

// (a.b)''
inline double dot_acc(const KinematicVector& a, const KinematicVector& b) {
  return a.acc().dot(b.value()) + 2.0 * a.rate().dot(b.rate()) + a.value().dot(b.acc());
}

// out += factor d(a.b)''/dx at fixed v and dv
inline void add_dot_acc(const KinematicVector& a, const KinematicVector& b, double factor,
                        Eigen::Ref<Eigen::VectorXd> out) {
  a.add_acc_by_position(factor * b.value(), out);
  b.add_acc_by_position(factor * a.value(), out);
  a.add_rate_by_position(2.0 * factor * b.rate(), out);
  b.add_rate_by_position(2.0 * factor * a.rate(), out);
  a.add_transposed(factor * b.acc(), out);
  b.add_transposed(factor * a.acc(), out);
}

// out += factor d(a.b)''/dv at fixed x and dv
inline void add_dot_acc_by_velocity(const KinematicVector& a, const KinematicVector& b, double factor,
                                    Eigen::Ref<Eigen::VectorXd> out) {
  a.add_acc_by_velocity(factor * b.value(), out);
  b.add_acc_by_velocity(factor * a.value(), out);
  a.add_transposed(2.0 * factor * b.rate(), out);
  b.add_transposed(2.0 * factor * a.rate(), out);
}

// K += factor d2(a.b)/dx2
inline void add_dot_second(const KinematicVector& a, const KinematicVector& b, double factor,
                           Eigen::Ref<Eigen::MatrixXd> K) {
  a.add_second(factor * b.value(), K);
  b.add_second(factor * a.value(), K);
  const Eigen::Matrix3d scaled = factor * Eigen::Matrix3d::Identity();
  a.add_product(scaled, b, K);
  b.add_product(scaled, a, K);
}

// The vectors between two markers, each computed at most once. Forces on them are collected, so that all rows of a joint
// pass through the modes of its bodies once.
class MarkerVectors {
 public:
  MarkerVectors(const PairMotion& pair, const Marker& m1, const Marker& m2) : pair_(pair), m1_(m1), m2_(m2) {}
  const PairMotion& pair() const { return pair_; }
  const Marker& marker(int slot) const { return slot == 0 ? m1_ : m2_; }
  const KinematicVector& axis(int slot, int k) {  // axis k of marker 1 (slot 0) or 2 (slot 1)
    std::optional<KinematicVector>& axis = vectors_[3 * slot + k];
    if (!axis) find_axis(slot, k);
    return *axis;
  }
  const KinematicVector& difference() {  // p2 - p1
    std::optional<KinematicVector>& d = vectors_[kDifference];
    if (!d) d.emplace(pair_, m1_, m2_);
    return *d;
  }

  void push_axis(int slot, int k, const Eigen::Vector3d& f) { push(3 * slot + k, f); }
  void push_difference(const Eigen::Vector3d& f) { push(kDifference, f); }
  // out += sum X^T f over all pushed forces
  void add_pushed(Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  static constexpr int kDifference = 6, kVectors = 7;
  void find_axis(int slot, int k);
  void push(int i, const Eigen::Vector3d& f) {
    if (!pushed_[i]) forces_[i].setZero();
    pushed_[i] = true;
    forces_[i] += f;
  }

  PairMotion pair_;
  const Marker& m1_;
  const Marker& m2_;
  bool pushed_[kVectors] = {};
  std::optional<NodeTurn> turn_[2];
  std::optional<KinematicVector> vectors_[kVectors];
  Eigen::Vector3d forces_[kVectors];  // of the pushed vectors
};

// Position and velocity of a marker's point, r + x and dr + w x x + A S da, where no further derivatives are required.
class MovingPoint {
 public:
  MovingPoint() = default;
  MovingPoint(const BodyKinematics& body, const Marker& marker);  // not on the ground
  const Eigen::Vector3d& value() const { return value_; }
  const Eigen::Vector3d& rate() const { return rate_; }
  // out += X^T f, in the columns of the body
  void add_transposed(const Eigen::Vector3d& f, Eigen::Ref<Eigen::VectorXd> out) const;

 private:
  const BodyKinematics* body_ = nullptr;
  const Marker* marker_ = nullptr;
  Eigen::Vector3d value_ = Eigen::Vector3d::Zero(), rate_ = value_, x_ = value_;
};

}  // namespace footfall
