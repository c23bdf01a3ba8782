#pragma once
// The kinematics of all bodies at one instant, unpacked from the vectors of a state.

#include <vector>

#include "coupler/body_motion.h"
#include "mbd_solver/dynamics/layout.h"
#include "mbd_solver/model/kinematic_vector.h"

namespace footfall {

class Kinematics {
 public:
  explicit Kinematics(const Model& model);

  // dv may be empty: then accelerations are zero.
  void load(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
            const Eigen::Ref<const Eigen::VectorXd>& v, const Eigen::Ref<const Eigen::VectorXd>& dv);
  // The inner states that count the turns of gears.
  void load_turns(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& z) {
    for (const int joint : turning_)
      turns_[static_cast<std::size_t>(joint)] = z[layout.joint_turns[static_cast<std::size_t>(joint)]];
  }
  double turns(int joint) const { return turning_.empty() ? 0.0 : turns_[static_cast<std::size_t>(joint)]; }  // [rad]
  const BodyKinematics& of(int body) const { return bodies_[static_cast<std::size_t>(body + 1)]; }  // kGround is -1
  PairMotion pair(int body_1, int body_2) const { return {{&of(body_1), &of(body_2)}}; }

 private:
  std::vector<BodyKinematics> bodies_;  // the ground first
  std::vector<int> turning_;            // joints that are members of gears and angles
  std::vector<double> turns_;           // per joint; empty without gears
};

// What a message tells of a body: position, velocity and acceleration. `motion` is sized: for the body's modes, or for
// none when its boundary is rigid. No allocation.
void fill_motion(const BodyKinematics& body, BodyMotion& motion);

// q moved by increments dx = [dr; dtheta; da] per body.
void add_increment(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> q);

// Positions of an implicit step: solves c (q - known) = N(q) v for q, exactly (the quaternion part is linear
// in L).
void solve_positions(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& known,
                     const Eigen::Ref<const Eigen::VectorXd>& v, double c, Eigen::Ref<Eigen::VectorXd> q);

// A difference of positions dq, small, in increments dx, and back.
void to_increments(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
                   const Eigen::Ref<const Eigen::VectorXd>& dq, Eigen::Ref<Eigen::VectorXd> dx);
void from_increments(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
                     const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> dq);

}  // namespace footfall
