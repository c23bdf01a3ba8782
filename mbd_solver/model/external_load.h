#pragma once
// What comes from outside and is constant during one window: loads on bodies and controlled voltages.

#include <Eigen/Dense>
#include <optional>
#include <vector>

#include "coupler/tangent_load.h"

namespace footfall {

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
