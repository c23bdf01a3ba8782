#pragma once
// A marker is a point with three axes on a body or on the ground, to which joints, struts and contacts attach.
//   position  p = r + A s(a),  s = s0 + S a,  S = Phi_j - off~ Psi_j  (node j, offset `off` from it)
//   axis k    e_k = A (u_k + U_k a),  U_k = -u_k~ Psi_j
// The rotation of the node is taken to first order in a, as the modes themselves are.

#include <Eigen/Dense>

#include "mbd_solver/model/body.h"

namespace footfall {

struct Marker {
  int body = kGround;                                  // index in the model, or kGround
  Eigen::Vector3d s0 = Eigen::Vector3d::Zero();        // from Bo, in B [m]; on the ground: p_W
  Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();  // columns x, y, z in B (undeformed), orthonormal
  Eigen::Matrix3Xd S;                                  // 3 x s (no columns on rigid bodies) [m per unit of a]
  Eigen::Matrix3Xd U[3];                               // 3 x s each, of axis x, y, z
  Eigen::Matrix3Xd Psi;                                // 3 x s: rotation of the node [rad per unit of a]
};

Marker ground_marker(const Eigen::Vector3d& p_W, const Eigen::Matrix3d& axes_W = Eigen::Matrix3d::Identity());

// At a point of body `index`, in B. On a flexible body it is attached to the nearest node with a rigid offset.
Marker body_marker(int index, const Body& body, const Eigen::Vector3d& p_B,
                   const Eigen::Matrix3d& axes_B = Eigen::Matrix3d::Identity());

// At `offset` from node `node` of a flexible body, in B. Throws InputError if the body has no such node.
Marker node_marker(int index, const Body& body, int node, const Eigen::Vector3d& offset_B = Eigen::Vector3d::Zero(),
                   const Eigen::Matrix3d& axes_B = Eigen::Matrix3d::Identity());

}  // namespace footfall
