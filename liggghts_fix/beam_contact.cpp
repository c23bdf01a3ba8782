#include "liggghts_fix/beam_contact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "coupler/base/errors.h"

namespace footfall {
namespace {

// Some unit vector at right angles to d.
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
  if (segments_.empty())
    throw InputError("body \"" + boundary.name() + "\" has no beam number " + std::to_string(chain));
  const auto count = static_cast<Eigen::Index>(boundary_node_.size());
  rho0_.resize(3, count);
  Phi_.resize(3 * count, boundary.mode_count());
  largest_Phi_.setZero(boundary.mode_count());
  for (Eigen::Index node = 0; node < count; ++node) {
    const int j = boundary_node_[static_cast<std::size_t>(node)];
    rho0_.col(node) = boundary.rho0().col(j);
    if (boundary.mode_count() == 0) continue;
    Phi_.middleRows<3>(3 * node) = boundary.Phi().middleRows<3>(3 * j);
    largest_Phi_ = largest_Phi_.cwiseMax(Phi_.middleRows<3>(3 * node).colwise().norm().transpose());
  }
  largest_rho0_ = rho0_.colwise().norm().maxCoeff();
  x_ = rho0_;
}

BoundaryPoint BeamChain::boundary_point(int node) const {
  const int j = boundary_node_[static_cast<std::size_t>(node)];
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
  const BeamSegment& s = segments_[static_cast<std::size_t>(segment)];
  return (x_.col(s.end) - x_.col(s.start)).norm();
}

BeamTouch BeamChain::touch(int segment, const Eigen::Vector3d& x, double r) const {
  const BeamSegment& s = segments_[static_cast<std::size_t>(segment)];
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
  // A centre on the axis itself has no direction of its own.
  touch.normal = distance > 0.0 ? Eigen::Vector3d(from_axis / distance) : any_normal(d);
  return touch;
}

}  // namespace footfall
