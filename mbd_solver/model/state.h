#pragma once
// Everything that changes while a model runs, as plain numbers: saving and restoring a State resumes a run to
// the bit (the integrator itself is told to forget() at the checkpoint in both runs).

#include <Eigen/Dense>

#include "mbd_solver/model/laws/energy.h"

namespace footfall {

struct State {
  double time = 0.0;  // [s]
  Eigen::VectorXd q;  // [r; L; a] per body
  Eigen::VectorXd v;  // [dr; w; da] per body
  Eigen::VectorXd z;  // inner states of the force elements
  // Time integrals since the start, accumulated by the integrator:
  Dissipated dissipated;      // [J]
  Eigen::VectorXd load_work;  // work of the external loads on each body [J]
  Supplied supplied;          // work of prescribed motions, forces and drives [J]
  // Next internal step to try [s]; 0: the integrator chooses.
  double step = 0.0;
};

}  // namespace footfall
