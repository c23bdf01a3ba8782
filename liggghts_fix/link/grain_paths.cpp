// A path is a segment of a line: it is intersected with triangles, and compared with beams by the distance of two segments.

#include "liggghts_fix/link/grain_paths.h"

#include <algorithm>

namespace footfall {
namespace {

// The line from x by `way` cuts the triangle within both [Moller, Trumbore 1997].
bool cuts(const Eigen::Vector3d& x, const Eigen::Vector3d& way, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
          const Eigen::Vector3d& c) {
  const Eigen::Vector3d u = b - a, v = c - a, p = way.cross(v);
  const double det = u.dot(p);
  if (det == 0.0) return false;  // parallel
  const Eigen::Vector3d from = x - a, q = from.cross(u);
  const double s = from.dot(p) / det, t = way.dot(q) / det, along = v.dot(q) / det;
  return s >= 0.0 && t >= 0.0 && s + t <= 1.0 && along >= 0.0 && along <= 1.0;
}

// Distance of the segments from x by `way` and from a by `axis` [m].
double distance(const Eigen::Vector3d& x, const Eigen::Vector3d& way, const Eigen::Vector3d& a,
                const Eigen::Vector3d& axis) {
  const auto share = [](double value, double of) { return of > 0.0 ? std::clamp(value / of, 0.0, 1.0) : 0.0; };
  const Eigen::Vector3d between = x - a;
  const double ww = way.squaredNorm(), aa = axis.squaredNorm(), wa = way.dot(axis);
  double s = share(wa * axis.dot(between) - aa * way.dot(between), ww * aa - wa * wa);
  const double t = share(axis.dot(between) + wa * s, aa);
  s = share(wa * t - way.dot(between), ww);
  return (between + s * way - t * axis).norm();
}

}  // namespace

bool path_meets(const ModalBoundary& boundary, const Eigen::Matrix3Xd& nodes_W, const Eigen::Vector3d& x_W,
                const Eigen::Vector3d& way_W) {
  const Eigen::Vector3d low = nodes_W.rowwise().minCoeff(), high = nodes_W.rowwise().maxCoeff(), end_W = x_W + way_W;
  double thickest = 0.0;
  for (const BeamSegment& segment : boundary.segments()) thickest = std::max(thickest, segment.radius);
  if ((x_W.cwiseMax(end_W).array() < low.array() - thickest).any() ||
      (x_W.cwiseMin(end_W).array() > high.array() + thickest).any())
    return false;
  for (const Eigen::Vector3i& corner : boundary.triangles())
    if (cuts(x_W, way_W, nodes_W.col(corner[0]), nodes_W.col(corner[1]), nodes_W.col(corner[2]))) return true;
  return std::any_of(boundary.segments().begin(), boundary.segments().end(), [&](const BeamSegment& segment) {
    const Eigen::Vector3d start = nodes_W.col(segment.start), axis = nodes_W.col(segment.end) - start;
    return distance(x_W, way_W, start, axis) < segment.radius;
  });
}

bool GrainPassages::passes(std::int64_t step, int tag, const Eigen::Vector3d& d_W, double way) {
  if (step != step_) {
    if (step == step_ + 1) {
      before_.swap(now_);
    } else {
      before_.clear();
    }
    now_.clear();
    step_ = step;
  }
  now_[tag].push_back(d_W);
  const auto before = before_.find(tag);
  if (before == before_.end()) return false;
  return std::any_of(before->second.begin(), before->second.end(), [&](const Eigen::Vector3d& d_before) {
    return d_W.dot(d_before) < 0.0 && (d_W - d_before).norm() <= 2.0 * way;
  });
}

}  // namespace footfall
