#pragma once
// What Equations writes while it works: sized once, reused for ever. Only the sources of Equations include
// this.

#include <array>
#include <vector>

#include "mbd_solver/dynamics/body_force.h"
#include "mbd_solver/dynamics/constraint_rows.h"
#include "mbd_solver/dynamics/equations.h"
#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/dynamics/sparse_blocks.h"
#include "mbd_solver/dynamics/sparse_lu.h"

namespace footfall {

// Places of one body in the Jacobian of the forces and in F_q. n = 6 + s.
struct BodyPlaces {
  SparseBlock v_v;                        // force rows by the body's own coordinates, in `lower`
  std::vector<int> r_r, r_dr, a_a, a_da;  // F_q in the full matrix, diagonals: by r, dr, a, da
  SparseBlock L_L, L_w;                   // F_q of the quaternion by L and w
};

// Places of one joint or force element between its two bodies; a ground body has empty blocks.
struct PairPlaces {
  SparseBlock v_v[2][2];                 // force rows of body i by coordinates of body j
  SparseBlock extra_v[2], v_extra[2];    // own rows (lambda or z) by body, forces on body by own unknowns
  std::vector<SparseBlock> extra_extra;  // z by z, block by block
};

// Places of what continuous signals do: forces that they drive and their own states, by the bodies that they measure and
// by their states. Made only for a model with signals.
struct SignalPlaces {
  struct Driven {
    int force = 0;                         // element of the model
    std::vector<SparseBlock> v_v[2], z_v;  // per measured body: rows of its bodies, of its inner states
    SparseBlock v_states[2], z_states;     // by the states of the signals
  };
  std::vector<int> measured;          // bodies
  std::vector<Driven> driven;         // elements that read inputs
  std::vector<SparseBlock> states_v;  // per measured body: rows of the states of the signals
  SparseBlock states_states;
};

struct Equations::Workspace {
  Workspace(const Model& model, const Layout& layout, const std::vector<RedundantGroup>& redundant);
  void build_full(const Model& model, const Layout& layout);

  PairMotion joint_pair(const Joint& joint) const { return kinematics.pair(joint.m1.body, joint.m2.body); }
  PairMotion force_pair(const ForceElement& force) const {
    return kinematics.pair(force.bodies()[0], force.bodies()[1]);
  }

  Kinematics kinematics;
  std::vector<InertiaScratch> inertia;       // per body
  std::vector<ElementDerivatives> elements;  // per force element
  Eigen::VectorXd row, row2, row3, row4;     // local rows of the largest pair
  Eigen::VectorXd local;                     // generalized force of a pair
  Eigen::MatrixXd K, D, M;                   // local matrices of the largest pair or body
  Eigen::VectorXd empty;
  Eigen::VectorXd values, signal_rates;  // with the continuous signals; rates of their states

  // Derivatives of the lower rows F_v, F_z, F_lambda, in one pattern over [v; z; lambda], two value arrays:
  //   stiffness          by the increments dx of positions (columns of v)
  //   values of `lower`  by v, z, lambda, with c dF/dydot
  // All columns of one body have the same rows, so both Jacobians are combinations of columns (jacobian.cpp).
  Eigen::SparseMatrix<double> lower;
  Eigen::VectorXd stiffness;
  Eigen::VectorXd own_diagonal;  // per velocity
  std::vector<BodyPlaces> body_places;
  std::vector<PairPlaces> joint_places, force_places;
  std::vector<int> z_z, lambda_lambda;
  SignalPlaces signal_places;
  Eigen::SparseMatrix<double> jacobian;  // of the full system: columns of q, then as in `lower` with F_q on top
  Eigen::SparseMatrix<double> reduced;   // pattern of `lower`

  // Saddle matrix [M, Phi_v^T; Phi_v, -eps] of accelerations and projections
  Eigen::SparseMatrix<double> saddle;
  std::vector<SparseBlock> saddle_mass;  // per body
  std::vector<PairPlaces> saddle_joint;  // extra_v: Phi_v, v_extra: its transpose
  std::vector<int> saddle_diagonal;
  Eigen::VectorXd saddle_own;  // diagonal of M in it
  std::unique_ptr<ThinLu> saddle_lu;
  bool saddle_factored = false;         // saddle_lu has factors,
  double saddle_time = 0.0;             // those of this time
  Eigen::VectorXd saddle_q;             // and position
  std::unique_ptr<ThinLu> smallest_lu;  // of the same pattern, for make_smallest()
  Eigen::VectorXd saddle_x, rest_x, phi_rate;
  Eigen::MatrixXd saddle_two;      // two right sides of a projection: of positions, of velocities
  Eigen::VectorXd reaction;        // Phi_v^T lambda
  Eigen::VectorXd y, rhs;          // full vectors of accelerations()
  Eigen::VectorXd last_q, last_v;  // copies during projection
  // Per row [1/kg or 1/(kg m2)]: (Phi_v M^-1 Phi_v^T)_ii at the start; s^2 of make_smallest(), the same or its mean over a
  // joint; eps of rows that do not rest; that of all
  Eigen::VectorXd row_size, smallest_size, eps, regularisation;

  std::vector<int> working_joints;  // with rows that move with time or turn a rotor: the others do no work

  std::vector<Redundancy> redundancies;
  bool redundancies_known = true;  // else found anew from the next state
  long rest_choices = 0;           // how often their resting rows were chosen
};

// Where a row stands: among all rows, its joint, among the rows of the joint.
struct RowPlace {
  int row, joint, local;
  bool adds;  // to the row of an earlier joint, the first member of its gear
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
    visit(RowPlace{layout.joint_row[static_cast<std::size_t>(j)] + local, j, local, joint.row_of >= 0}, pair, phi_v,
          value);
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
  return {body_1 == kGround ? -1 : layout.body_v[static_cast<std::size_t>(body_1)],
          body_2 == kGround ? -1 : layout.body_v[static_cast<std::size_t>(body_2)]};
}

}  // namespace footfall
