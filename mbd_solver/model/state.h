#pragma once
// Everything that changes while a model runs, as plain numbers, and its inputs from outside. A State that is saved and
// restored resumes a run bit for bit, because integrators restart at a checkpoint in both runs.

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "coupler/body_motion.h"
#include "mbd_solver/model/laws/strut_law.h"

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
  // Next internal step to try [s]; 0: chosen by the integrator.
  double step = 0.0;
};

// A load on one body that is constant during one window.
struct ExternalLoad {
  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // force, constant in W [N]
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();  // moment about Bo, constant in the body frame B [N m]
  Eigen::VectorXd Q_a;                            // modal forces; empty means zero
  std::optional<TangentLoad> tangent;             // varies with the motion within the window
};

// What is constant during one window.
struct Inputs {
  std::vector<ExternalLoad> loads;  // one per body, in the order of the model; empty means no loads at all
  // Outputs of controllers [-], then signals. Entries of continuous signals are unused.
  Eigen::VectorXd values;
};

}  // namespace footfall
