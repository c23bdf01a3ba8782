// Closest points of capsules; velocities and forces of contacts by linear interpolation between nodes.

#include "liggghts_fix/link/beam_chain.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "coupler/base/errors.h"
#include "liggghts_fix/link/codes.h"

namespace footfall {
namespace {

// Some unit vector perpendicular to d.
Eigen::Vector3d any_normal(const Eigen::Vector3d& d) {
  return d.isZero(0.0) ? Eigen::Vector3d::UnitZ() : Eigen::Vector3d(d.unitOrthogonal());
}

}  // namespace

BeamChain::BeamChain(const ModalBoundary& boundary, int chain) {
  std::map<int, int> number;  // node of the boundary -> node of the chain
  const auto numbered = [&](int boundary_node) {
    const auto [entry, is_new] = number.emplace(boundary_node, static_cast<int>(number.size()));
    if (is_new) boundary_node_.push_back(boundary_node);
    return entry->second;
  };
  for (BeamSegment segment : boundary.segments()) {
    if (segment.chain != chain) continue;
    segment.start = numbered(segment.start);
    segment.end = numbered(segment.end);
    segments_.push_back(segment);
    largest_radius_ = std::max(largest_radius_, segment.radius);
  }
  if (segments_.empty()) throw InputError(code::kBeamUnknown, "body \"", boundary.name(), "\" has no beam ", chain);
  const auto count = static_cast<Eigen::Index>(boundary_node_.size());
  rho0_.resize(3, count);
  Phi_.resize(3 * count, boundary.mode_count());
  largest_Phi_.setZero(boundary.mode_count());
  for (Eigen::Index node = 0; node < count; ++node) {
    const int j = boundary_node_[node];
    rho0_.col(node) = boundary.rho0().col(j);
    if (boundary.mode_count() == 0) continue;
    Phi_.middleRows<3>(3 * node) = boundary.Phi().middleRows<3>(3 * j);
    largest_Phi_ = largest_Phi_.cwiseMax(Phi_.middleRows<3>(3 * node).colwise().norm().transpose());
  }
  largest_rho0_ = rho0_.colwise().norm().maxCoeff();
  x_ = rho0_;
}

BoundaryPoint BeamChain::boundary_point(int node) const {
  const int j = boundary_node_[node];
  return {{j, j, j}, {1.0, 0.0, 0.0}};
}

void BeamChain::follow(const BodyMotion& motion) {
  const Eigen::Matrix3d A = motion.rotation();
  for (int node = 0; node < node_count(); ++node) {
    Eigen::Vector3d rho = rho0_.col(node);
    if (Phi_.cols() > 0) rho.noalias() += Phi_.middleRows<3>(3 * node) * motion.a;
    x_.col(node) = motion.r + A * rho;
  }
}

// x' - x = (r' - r) + (A' - A) (rho0 + Phi a) + A' Phi (a' - a).
double BeamChain::largest_travel(const BodyMotion& from, const BodyMotion& to) const {
  const double turn = (to.rotation() - from.rotation()).norm();
  double bent = 0.0, bends = 0.0;
  for (Eigen::Index m = 0; m < largest_Phi_.size(); ++m) {
    bent += largest_Phi_[m] * std::abs(from.a[m]);
    bends += largest_Phi_[m] * std::abs(to.a[m] - from.a[m]);
  }
  return (to.r - from.r).norm() + turn * (largest_rho0_ + bent) + bends;
}

double BeamChain::length(int segment) const {
  const BeamSegment& s = segments_[segment];
  return (x_.col(s.end) - x_.col(s.start)).norm();
}

BeamTouch BeamChain::touch(int segment, const Eigen::Vector3d& x, double r) const {
  const BeamSegment& s = segments_[segment];
  const Eigen::Vector3d p_s = x_.col(s.start);
  const Eigen::Vector3d d = x_.col(s.end) - p_s;
  const double d2 = d.squaredNorm();

  BeamTouch touch;
  touch.segment = segment;
  touch.radius = s.radius;
  touch.mu = d2 > 0.0 ? std::clamp((x - p_s).dot(d) / d2, 0.0, 1.0) : 0.0;
  touch.p = p_s + touch.mu * d;
  const Eigen::Vector3d from_axis = x - touch.p;
  const double distance = from_axis.norm();
  touch.gap = distance - s.radius - r;
  // For a centre on the axis any direction is valid.
  touch.normal = distance > 0.0 ? Eigen::Vector3d(from_axis / distance) : any_normal(d);
  return touch;
}

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
  const BeamSegment& s = chain_.segments()[touch.segment];
  const Eigen::Vector3d v = v_.col(s.start) + touch.mu * (v_.col(s.end) - v_.col(s.start));
  const Eigen::Vector3d w = w_.col(s.start) + touch.mu * (w_.col(s.end) - w_.col(s.start));
  return v + w.cross(touch.arm());
}

void BeamMotion::add_force(const BeamTouch& touch, const Eigen::Vector3d& f_W, const Eigen::Vector3d& m_p_W) {
  const BeamSegment& s = chain_.segments()[touch.segment];
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

double hertz_on_side(double r, double R) {
  const double ratio = 1.0 + r / R;  // of the principal radii
  const double F2 = 1.0 - std::pow(std::pow(ratio, 0.0684) - 1.0, 1.531);
  return std::pow(ratio, -0.25) * std::pow(F2, -1.5);
}

double hertz_on_end(double r, double R) { return std::sqrt(R / (r + R)); }

}  // namespace footfall
