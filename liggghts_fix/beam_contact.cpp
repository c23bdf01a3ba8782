#include "liggghts_fix/beam_contact.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include "coupler/errors.h"

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
  x_.resize(3, static_cast<Eigen::Index>(boundary_node_.size()));
  for (int node = 0; node < node_count(); ++node)
    x_.col(node) = boundary.rho0().col(boundary_point(node).nodes[0]);
}

BoundaryPoint BeamChain::boundary_point(int node) const {
  const int j = boundary_node_[static_cast<std::size_t>(node)];
  return {{j, j, j}, {1.0, 0.0, 0.0}};
}

void BeamChain::follow(const ModalBoundary& boundary, const BodyMotion& motion) {
  for (int node = 0; node < node_count(); ++node)
    x_.col(node) = boundary.position(motion, boundary_point(node));
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
