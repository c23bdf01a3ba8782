#include "liggghts_fix/beam_motion.h"

namespace footfall {

BeamMotion::BeamMotion(const ModalBoundary& boundary, const BeamChain& chain)
    : boundary_(boundary), chain_(chain), v_(Eigen::Matrix3Xd::Zero(3, chain.node_count())), w_(v_), f_(v_), m_(v_) {}

void BeamMotion::begin_step(const BodyMotion& motion) {
  for (int node = 0; node < chain_.node_count(); ++node) {
    const BoundaryPoint point = chain_.boundary_point(node);
    v_.col(node) = boundary_.velocity(motion, point);
    w_.col(node) = boundary_.angular_velocity(motion, point);
  }
  f_.setZero();
  m_.setZero();
}

Eigen::Vector3d BeamMotion::velocity(const BeamTouch& touch) const {
  const BeamSegment& s = chain_.segments()[static_cast<std::size_t>(touch.segment)];
  const Eigen::Vector3d v = v_.col(s.start) + touch.mu * (v_.col(s.end) - v_.col(s.start));
  const Eigen::Vector3d w = w_.col(s.start) + touch.mu * (w_.col(s.end) - w_.col(s.start));
  return v + w.cross(touch.arm());
}

void BeamMotion::add_force(const BeamTouch& touch, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_p_W) {
  const BeamSegment& s = chain_.segments()[static_cast<std::size_t>(touch.segment)];
  f_.col(s.start) += (1.0 - touch.mu) * f_W;
  f_.col(s.end) += touch.mu * f_W;
  m_.col(s.start) += (1.0 - touch.mu) * m_p_W;
  m_.col(s.end) += touch.mu * m_p_W;
}

void BeamMotion::project(const BodyMotion& motion, GeneralizedForce& Q) const {
  for (int node = 0; node < chain_.node_count(); ++node) {
    if (f_.col(node).isZero(0.0) && m_.col(node).isZero(0.0)) continue;
    const BoundaryPoint point = chain_.boundary_point(node);
    boundary_.add_point_force(motion, point, f_.col(node), Q);
    boundary_.add_point_moment(motion, point, m_.col(node), Q);
  }
}

}  // namespace footfall
