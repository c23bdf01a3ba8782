#pragma once
// Everything that changes while a model runs, as plain numbers: saving and restoring a State resumes a run to
// the bit (the integrator itself is told to forget() at the checkpoint in both runs).

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
  // Next internal step to try [s]; 0: the integrator chooses.
  double step = 0.0;
};

// What comes from outside and is constant during one window: loads on bodies and controlled voltages.

struct ExternalLoad {
  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // force, constant in W [N]
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();  // moment about Bo, constant in the body frame B [N m]
  Eigen::VectorXd Q_a;                            // modal forces; empty means zero
  std::optional<TangentLoad> tangent;             // reacts within the window
};

struct Inputs {
  std::vector<ExternalLoad> loads;  // one per body, in the order of the model; empty means no loads at all
  Eigen::VectorXd voltages;  // one per controlled output [-]; then signals, those that are continuous without value
};

}  // namespace footfall
