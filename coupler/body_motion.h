#pragma once
// Motion of one body's floating frame and modes, and the loads conjugate to it: generalized forces, and loads that react
// to the motion within a window. theory 1, 7.6.

#include <Eigen/Dense>

namespace footfall {

// Position, velocity and acceleration of one body. s = number of modes, 0 for a rigid body: a, da, dda are
// then empty. Frames: W inertial, B body. Bo is the origin of B (centre of mass of the undeformed body).
struct BodyMotion {
  explicit BodyMotion(int modes = 0) { resize(modes); }
  void resize(int modes);
  int mode_count() const { return static_cast<int>(a.size()); }

  // R_WB: turns components in B into components in W.
  Eigen::Matrix3d rotation() const;
  bool all_finite() const;

  Eigen::Vector3d r = Eigen::Vector3d::Zero();              // p_WBo_W [m]
  Eigen::Vector4d L = Eigen::Vector4d(1.0, 0.0, 0.0, 0.0);  // unit quaternion of R_WB, scalar first [-]
  Eigen::VectorXd a;                                        // s modal coordinates
  Eigen::Vector3d dr = Eigen::Vector3d::Zero();             // v_WBo_W [m/s]
  Eigen::Vector3d w = Eigen::Vector3d::Zero();              // w_WB_W [rad/s]
  Eigen::VectorXd da;                                       // s [1/s of a]
  Eigen::Vector3d ddr = Eigen::Vector3d::Zero();            // [m/s2]
  Eigen::Vector3d dw = Eigen::Vector3d::Zero();             // angular acceleration in W [rad/s2]
  Eigen::VectorXd dda;                                      // s [1/s2 of a]
};

// Force on one body, positive ON the body; power = F_W . dr + T_W . w + Q_a . da.
struct GeneralizedForce {
  explicit GeneralizedForce(int modes = 0) : Q_a(Eigen::VectorXd::Zero(modes)) {}
  void set_zero();

  Eigen::Vector3d F_W = Eigen::Vector3d::Zero();  // [N]
  Eigen::Vector3d T_W = Eigen::Vector3d::Zero();  // about Bo, in W [N m]
  Eigen::VectorXd Q_a;                            // s modal forces [J per unit of a]
};

// F_W . dr + T_W . w + Q_a . da [W].
double power(const GeneralizedForce& Q, const BodyMotion& motion);

// The unit quaternion of exp(theta_W) R(L): L turned by the rotation vector theta_W [rad] given in W.
Eigen::Vector4d turned(const Eigen::Vector4d& L, const Eigen::Vector3d& theta_W);

// The rotation vector theta_W [rad], |theta_W| <= pi, with to = turned(from, theta_W).
Eigen::Vector3d rotation_vector(const Eigen::Vector4d& from, const Eigen::Vector4d& to);

using Vector6d = Eigen::Matrix<double, 6, 1>;
using Matrix6d = Eigen::Matrix<double, 6, 6>;

// A load that reacts within the window, linearly in the motion of the body: [F; T] -= K dx + C dv, all in W, with
//   dx = [r - r_mean; rotation from L_mean to L]
//   dv = [dr; w] - v_mean
//   rotation = 1/2 sum_k A_mean e_k x A e_k, to third order the rotation vector
struct TangentLoad {
  Matrix6d K = Matrix6d::Zero();                     // [N/m, N, N m/m, N m]
  Matrix6d C = Matrix6d::Zero();                     // [N s/m, ...]
  Eigen::Vector3d r_mean = Eigen::Vector3d::Zero();  // [m]
  Eigen::Vector4d L_mean = Eigen::Vector4d::UnitX();
  Vector6d v_mean = Vector6d::Zero();  // [dr; w] [m/s, rad/s]
};

// Impulse [N s] on a body in a window of H [s] in addition to the grains' impulse, because the body moved otherwise than
// predicted: the reaction of grains taken at rest, which grains that yielded did not exert. From the states at both
// ends of the window.
Eigen::Vector3d surplus_impulse(const TangentLoad& load, const BodyMotion& start, const BodyMotion& end, double H);

}  // namespace footfall
