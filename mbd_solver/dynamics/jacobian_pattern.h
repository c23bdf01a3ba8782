#pragma once
// The sparse matrices of the equations of motion and the places of all bodies, joints and force elements in them. Patterns are
// built once from a list of blocks; values are written without a search.

#include <vector>

#include "mbd_solver/dynamics/kinematics.h"
#include "mbd_solver/dynamics/sparse_blocks.h"
#include "mbd_solver/model/control/continuous_signals.h"

namespace footfall {

// Places of one joint between its two bodies; blocks of a ground body are empty.
struct PairPlaces {
  SparseBlock v_v[2][2];                 // force rows of body i by coordinates of body j
  SparseBlock extra_v[2], v_extra[2];    // own rows (lambda or z) by body, forces on body by own unknowns
  std::vector<SparseBlock> extra_extra;  // z by z, block by block
};

// The same of a force element, on two bodies or more.
struct ElementPlaces {
  std::vector<std::vector<SparseBlock>> v_v;
  std::vector<SparseBlock> extra_v, v_extra, extra_extra;
};

// Places of entries that depend on one body measured by continuous signals, or on the states of one signal: its
// columns in the rates of states and in the forces that read signals.
struct SignalPlaces {
  struct Driven {
    int force = 0;        // element of the model
    SparseBlock v[2], z;  // rows of its bodies, of its inner states
  };
  ContinuousSignals::Influence of;
  std::vector<SparseBlock> rates;  // as of.rates
  std::vector<Driven> driven;
};

struct JacobianPattern {
  JacobianPattern(const Model& model, const Layout& layout, const Kinematics& kinematics);

  // Derivatives of the lower rows F_v, F_z, F_lambda, in one pattern over [v; z; lambda], two value arrays:
  //   stiffness          by the increments dx of positions (columns of v)
  //   values of `lower`  by v, z, lambda, with c dF/dydot
  // All columns of one body have the same rows, so that the reduced Jacobian is a combination of columns.
  Eigen::SparseMatrix<double> lower;
  Eigen::VectorXd stiffness;
  std::vector<SparseBlock> bodies;  // force rows by the body's own coordinates
  std::vector<PairPlaces> joints;
  std::vector<ElementPlaces> forces;
  std::vector<int> v_v, z_z, lambda_lambda;  // diagonals
  std::vector<SignalPlaces> signals;
  Eigen::SparseMatrix<double> reduced;  // pattern of `lower`
};

// The saddle matrix [M, Phi_v^T; Phi_v, -eps].
struct SaddlePattern {
  SaddlePattern(const Model& model, const Layout& layout, const Kinematics& kinematics);

  Eigen::SparseMatrix<double> matrix;
  std::vector<SparseBlock> mass;   // per body
  std::vector<PairPlaces> joints;  // extra_v: Phi_v, v_extra: its transpose
  std::vector<int> diagonal;       // of the rows of joints
};

}  // namespace footfall
