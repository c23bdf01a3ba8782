#pragma once
// The order of unknowns, the kinematics of all bodies at one instant, and visits of the rows of all joints.

#include <array>
#include <vector>

#include "coupler/body_motion.h"
#include "mbd_solver/model/force_element.h"
#include "mbd_solver/model/kinematic_vector.h"
#include "mbd_solver/model/model.h"
#include "mbd_solver/model/state.h"

namespace footfall {

// Places of all parts in y = [q; v; z; lambda]; lambda are the multipliers of all rows of all joints.
struct Layout {
  explicit Layout(const Model& model);

  int q_size = 0, v_size = 0, z_size = 0, row_count = 0;  // row_count: constraint rows of all joints
  int v0() const { return q_size; }                       // first entry of v, z, lambda in y
  int z0() const { return q_size + v_size; }
  int lambda0() const { return q_size + v_size + z_size; }
  int size() const { return lambda0() + row_count; }

  std::vector<int> body_q, body_v;  // first entry of each body in q and in v
  std::vector<int> force_z;         // first inner state of each force element in z
  int signal_z = 0;                 // first state of the continuous signals, the last part of z
  std::vector<int> joint_row;       // first row of each joint among all rows; members of a gear share one
  std::vector<int> row_joint;       // for each of all rows: its joint, the first member of a gear
  std::vector<int> joint_turns;     // for each joint: the inner state that counts its turns for a gear in z, or -1
  std::vector<int> joint_angle;     // for each joint: its angle in State::angles, or -1
  int angle_count = 0;
  std::vector<char> shared;  // for each of all rows: several joints contribute to it

  // y of a state (multipliers given) and back.
  void pack(const State& state, const Eigen::Ref<const Eigen::VectorXd>& lambda, Eigen::Ref<Eigen::VectorXd> y) const {
    y << state.q, state.v, state.z, lambda;
  }
  void unpack(const Eigen::Ref<const Eigen::VectorXd>& y, State& state) const {
    state.q = y.head(q_size);
    state.v = y.segment(v0(), v_size);
    state.z = y.segment(z0(), z_size);
  }
};

// The kinematics of all bodies at one instant, unpacked from the vectors of a state.
class Kinematics {
 public:
  explicit Kinematics(const Model& model);

  // dv may be empty: accelerations are then zero.
  void load(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
            const Eigen::Ref<const Eigen::VectorXd>& v, const Eigen::Ref<const Eigen::VectorXd>& dv);
  // The inner states that count the turns of gears.
  void load_turns(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& z) {
    for (const int joint : turning_) turns_[joint] = z[layout.joint_turns[joint]];
  }
  double turns(int joint) const { return turning_.empty() ? 0.0 : turns_[joint]; }  // [rad]
  const BodyKinematics& of(int body) const { return bodies_[body + 1]; }            // kGround is -1
  PairMotion pair(int body_1, int body_2) const { return {{&of(body_1), &of(body_2)}}; }

 private:
  std::vector<BodyKinematics> bodies_;  // the ground first
  std::vector<int> turning_;            // joints that are members of gears and angles
  std::vector<double> turns_;           // per joint; empty without gears
};

// The quantities that a force element reads at this instant, with its scratch.
inline ElementInput element_input(const ForceElement& element, const Kinematics& kinematics,
                                  const Eigen::Ref<const Eigen::VectorXd>& z,
                                  const Eigen::Ref<const Eigen::VectorXd>& inputs, double time,
                                  ElementScratch* scratch) {
  ElementInput in{kinematics.pair(element.bodies()[0], element.bodies()[1]), z, inputs, time};
  in.scratch = scratch;
  for (std::size_t i = 0; i < element.further_bodies().size(); ++i)
    in.further[i] = &kinematics.of(element.further_bodies()[i]);
  return in;
}

// The quantities of a state that sensors of signals read (measured_by()).
struct Instant {
  const Kinematics& kinematics;
  const Layout& layout;
  const Model& model;
  Eigen::Ref<const Eigen::VectorXd> z;  // all inner states

  const BodyKinematics& of(int body) const { return kinematics.of(body); }
  PairMotion pair(int body_1, int body_2) const { return kinematics.pair(body_1, body_2); }
  // The states of a force element of the model; none for -1.
  Eigen::Ref<const Eigen::VectorXd> states(int force) const {
    return force < 0 ? z.head(0) : z.segment(layout.force_z[force], model.force(force).state_count());
  }
};

// Position, velocity and acceleration of a body as a message. `motion` is sized for the body's modes, or for none if its
// boundary is rigid. No allocation.
void fill_motion(const BodyKinematics& body, BodyMotion& motion);

// q moved by increments dx = [dr; dtheta; da] per body.
void add_increment(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> q);

// Positions of an implicit step: solves c (q - known) = N(q) v for q, exactly (the quaternion part is linear in L).
void solve_positions(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& known,
                     const Eigen::Ref<const Eigen::VectorXd>& v, double c, Eigen::Ref<Eigen::VectorXd> q);

// dq = (c I - d(N v)/dq)^-1 dq: the rows dq/dt - N v of Newton's matrix, whose positions follow from rates of velocities.
void solve_position_rows(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& v, double c,
                         Eigen::Ref<Eigen::VectorXd> dq);

// A small difference of positions dq as increments dx, and back.
void to_increments(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
                   const Eigen::Ref<const Eigen::VectorXd>& dq, Eigen::Ref<Eigen::VectorXd> dx);
void from_increments(const Layout& layout, const Eigen::Ref<const Eigen::VectorXd>& q,
                     const Eigen::Ref<const Eigen::VectorXd>& dx, Eigen::Ref<Eigen::VectorXd> dq);

// --- Rows of joints.

// A row: its index among all rows, its joint, its index in the joint.
struct RowPlace {
  int row, joint, local;
  bool adds;  // it contributes to the row of an earlier joint, the first member of its gear
};

// Calls visit(place, pair, phi_v, value) for every row of joint j. phi_v is a scratch row of the pair.
template <typename Visit>
void for_each_row_of(int j, const Model& model, const Layout& layout, const Kinematics& kinematics, double t,
                     Eigen::VectorXd& scratch, Visit visit) {
  const Joint& joint = model.joint(j);
  MarkerVectors vectors(kinematics.pair(joint.m1.body, joint.m2.body), joint.m1, joint.m2);
  const PairMotion& pair = vectors.pair();
  Eigen::Ref<Eigen::VectorXd> phi_v = scratch.head(pair.size());
  for (std::size_t k = 0; k < joint.rows.size(); ++k) {
    const RowValue value = evaluate_row(joint.rows[k], t, vectors, phi_v, kinematics.turns(j));
    const int local = static_cast<int>(k);
    visit(RowPlace{layout.joint_row[j] + local, j, local, joint.row_of >= 0}, pair, phi_v, value);
  }
}

// For every row of every joint.
template <typename Visit>
void for_each_row(const Model& model, const Layout& layout, const Kinematics& kinematics, double t,
                  Eigen::VectorXd& scratch, Visit visit) {
  for (int j = 0; j < model.joint_count(); ++j) for_each_row_of(j, model, layout, kinematics, t, scratch, visit);
}

// First velocity coordinate of each body of a pair in v; -1 for the ground.
inline std::array<int, 2> pair_v(const Layout& layout, int body_1, int body_2) {
  return {body_1 == kGround ? -1 : layout.body_v[body_1], body_2 == kGround ? -1 : layout.body_v[body_2]};
}

}  // namespace footfall
