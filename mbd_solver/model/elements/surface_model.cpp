// A tree of boxes per surface, built at its first use; lines become slivers, because boxes need an area.

#include "mbd_solver/model/elements/surface_model.h"

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/distance.h>
#include <Eigen/Geometry>
#include <algorithm>

#include "coupler/base/errors.h"
#include "mbd_solver/model/rotation.h"

namespace footfall {
namespace {

// Width of the sliver that replaces a line [of its length].
constexpr double kSliver = 1e-8;

bool is_line(const Eigen::Vector3i& t) { return t[0] == t[1] || t[1] == t[2] || t[2] == t[0]; }

fcl::Transform3d transform(const FramePose& pose) {
  fcl::Transform3d out = fcl::Transform3d::Identity();
  out.linear() = pose.R;
  out.translation() = pose.p;
  return out;
}

}  // namespace

struct SurfaceModel::Tree {
  fcl::BVHModel<fcl::OBBRSSd> model;
};

SurfaceModel::SurfaceModel(const Eigen::Matrix3Xd& vertices, std::vector<Eigen::Vector3i> triangles, double thickness)
    : triangles_(std::move(triangles)), thickness_(thickness) {
  FOOTFALL_DEMAND(!triangles_.empty() && thickness >= 0.0);
  corners_ = corners(vertices);
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : corners_) box.extend(point);
  centre_ = box.center();
  for (const Eigen::Vector3d& point : corners_) radius_ = std::max(radius_, (point - centre_).norm() + thickness_);
}

SurfaceModel::Tree& SurfaceModel::tree() {
  if (tree_) return *tree_;
  tree_ = std::make_unique<Tree>();
  std::vector<fcl::Triangle> three;
  for (std::size_t i = 0; i < triangles_.size(); ++i) three.emplace_back(3 * i, 3 * i + 1, 3 * i + 2);
  fcl::BVHModel<fcl::OBBRSSd>& model = tree_->model;
  model.beginModel(static_cast<int>(three.size()), static_cast<int>(corners_.size()));
  model.addSubModel(corners_, three);
  FOOTFALL_DEMAND(model.endModel() == fcl::BVH_OK);
  corners_ = {};
  return *tree_;
}

SurfaceModel::~SurfaceModel() = default;
SurfaceModel::SurfaceModel(SurfaceModel&&) noexcept = default;

std::vector<Eigen::Vector3d> SurfaceModel::corners(const Eigen::Matrix3Xd& vertices) const {
  std::vector<Eigen::Vector3d> points;
  points.reserve(3 * triangles_.size());
  for (const Eigen::Vector3i& t : triangles_) {
    for (const int i : t) points.push_back(vertices.col(i));
    if (!is_line(t)) continue;
    Eigen::Vector3d* const p = &points[points.size() - 3];
    const Eigen::Vector3d start = p[0], end = t[1] == t[0] ? p[2] : p[1];
    const double length = (end - start).norm();
    p[1] = end;
    p[2] = 0.5 * (start + end) + kSliver * std::max(length, 1e-9) * axes_with_z(end - start).col(0);
  }
  return points;
}

void SurfaceModel::move(const Eigen::Matrix3Xd& vertices) {
  fcl::BVHModel<fcl::OBBRSSd>& model = tree().model;
  model.beginReplaceModel();
  model.replaceSubModel(corners(vertices));
  FOOTFALL_DEMAND(model.endReplaceModel(true, true) == fcl::BVH_OK);
}

SurfaceGap gap_between(SurfaceModel& a, SurfaceModel& b, const FramePose& b_in_a) {
  const fcl::Transform3d at_a = fcl::Transform3d::Identity(), at_b = transform(b_in_a);
  fcl::DistanceRequestd request(true);
  fcl::DistanceResultd found;
  fcl::distance(&a.tree().model, at_a, &b.tree().model, at_b, request, found);
  SurfaceGap gap;
  gap.distance = std::max(0.0, found.min_distance) - a.thickness_ - b.thickness_;
  gap.place = 0.5 * (found.nearest_points[0] + found.nearest_points[1]);
  if (found.min_distance > 0.0) return gap;
  const fcl::CollisionRequestd where(1, true);
  fcl::CollisionResultd hit;
  if (fcl::collide(&a.tree().model, at_a, &b.tree().model, at_b, where, hit) > 0) gap.place = hit.getContact(0).pos;
  return gap;
}

}  // namespace footfall
