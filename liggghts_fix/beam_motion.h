#pragma once
// How a body carries its chain, and what contacts on the chain do to the body. The two are partners in virtual work:
// the contacts give the body the power
//   sum_c f_c . v_c = F_W . dr + T_W . w + Q_a . da.
// Both work through the nodes, so that a contact costs the same however many modes the body has; only nodes meet the
// modes.

#include <Eigen/Dense>

#include "coupler/modal_boundary.h"
#include "liggghts_fix/beam_contact.h"

namespace footfall {

// The axis between nodes is straight and its sections turn linearly from node to node:
//   v_c = (1 - mu) v_s + mu v_e + ((1 - mu) w_s + mu w_e) x arm,
// with node velocities v and angular velocities w of ModalBoundary.
class BeamMotion {
 public:
  // Both must outlive this.
  BeamMotion(const ModalBoundary& boundary, const BeamChain& chain);

  // A step begins: velocities at the nodes under this motion; no contact yet.
  void begin_step(const BodyMotion& motion);
  // Of the beam's material at the contact point of a touch, in W [m/s].
  Eigen::Vector3d velocity(const BeamTouch& touch) const;
  // The force f_W [N] on the beam and its moment m_p_W [N m] about the touch's point p on the axis. A force at the
  // contact point alone has m_p = arm x f; rolling friction adds its couple.
  void add_force(const BeamTouch& touch, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_p_W);
  // Adds what the forces since begin_step do to the body.
  void project(const BodyMotion& motion, GeneralizedForce& Q) const;

 private:
  const ModalBoundary& boundary_;
  const BeamChain& chain_;
  Eigen::Matrix3Xd v_;  // of nodes [m/s]
  Eigen::Matrix3Xd w_;  // [rad/s]
  Eigen::Matrix3Xd f_;  // on nodes [N]
  Eigen::Matrix3Xd m_;  // [N m]
};

}  // namespace footfall
