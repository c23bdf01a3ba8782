#pragma once
// What comes from outside and is constant during one window: loads on bodies and controlled voltages.

#include <Eigen/Dense>
#include <optional>
#include <vector>

namespace footfall {

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// A load that reacts within the window, linearly: [F; T] -= K dx + C dv, all in W (scheme `tangent`).
//   dx = [r - r_mean; rotation from L_mean to L],  dv = [dr; w] - v_mean
//   rotation = 1/2 sum_k A_mean e_k x A e_k, to third order the rotation vector
struct TangentLoad {
  Matrix6d K = Matrix6d::Zero();  // [N/m, N, N m/m, N m]
  Matrix6d C = Matrix6d::Zero();
  Eigen::Vector3d r_mean = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L_mean = Eigen::Vector4d::UnitX();
  Vector6d v_mean = Vector6d::Zero();  // [dr; w]
};

struct ExternalLoad {
  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // force, constant in W [N]
  Eigen::Vector3d T_B = Eigen::Vector3d::Zero();  // moment about Bo, constant in the body frame B [N m]
  Eigen::VectorXd Q_a;                            // modal forces; empty means zero
  std::optional<TangentLoad> tangent;
};

struct Inputs {
  std::vector<ExternalLoad> loads;  // one per body, in the order of the model; empty means no loads at all
  Eigen::VectorXd voltages;         // one per controlled output [-]
};

}  // namespace footfall
