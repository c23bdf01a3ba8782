// Where the mechanism starts: attitude about its mass centre, then moved, then set to its clearance above the ground.

#include <cmath>
#include <limits>

#include "mbd_solver/build/codes.h"
#include "mbd_solver/build/grain_dump.h"
#include "mbd_solver/build/mechanism.h"
#include "mbd_solver/model/rotation.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {
namespace {

// Height of the highest grain (its top) whose footprint overlaps the circle around one boundary, along `up`.
double highest_under(const std::vector<GrainPlace>& grains, const Eigen::Vector3d& up, const Eigen::Vector3d& centre,
                     double reach) {
  double highest = -std::numeric_limits<double>::infinity();
  for (const GrainPlace& grain : grains) {
    const Eigen::Vector3d d = grain.centre - centre;
    const double across = (d - up * up.dot(d)).norm();
    if (across < reach + grain.radius) highest = std::max(highest, up.dot(grain.centre) + grain.radius);
  }
  return highest;
}

constexpr double kStray = 0.1;  // of the radius of a boundary's footprint

}  // namespace

Placement place(const Scene& scene, const std::vector<BodyBoundary>& boundaries,
                const std::vector<FlexibleBody>& flexible) {
  Placement placement;
  const InitialSpec& initial = scene.initial;
  placement.R_WD = rotation_from_rpy(initial.roll, initial.pitch, initial.yaw);
  const Eigen::Vector3d centre = mass_centre(scene);
  placement.p_WD = centre - placement.R_WD * centre + initial.position;

  const Eigen::Vector3d up = up_direction(scene.gravity);
  const bool plane = scene.ground.kind == GroundKind::kPlane;
  std::vector<GrainPlace> grains;
  const bool particles = scene.touches_particles();
  if (particles && !scene.particles->grains.empty()) grains = read_grains(scene.particles->grains);
  if (plane) placement.ground_height = up.dot(scene.ground.plane->point);
  if (particles && scene.particles->surface_height) placement.ground_height = *scene.particles->surface_height;

  placement.ground_known = plane || !grains.empty() || (particles && scene.particles->surface_height);

  // Per boundary: how far its lowest point is above the ground under it.
  double smallest = std::numeric_limits<double>::infinity();
  double highest_ground = -std::numeric_limits<double>::infinity();
  for (const BodyBoundary& entry : boundaries) {
    const auto i = static_cast<std::size_t>(entry.body);
    const Eigen::Matrix3d R_WB = placement.R_WD * axes_D(scene.bodies[i], flexible[i]);
    const Eigen::Vector3d r = placement.point(origin_D(scene.bodies[i], flexible[i]));
    const auto lowest_along = [&](const Eigen::Vector3d& n) {
      return n.dot(r) + lowest_place(entry, R_WB.transpose() * n, Eigen::VectorXd());
    };
    if (plane) {  // a sloping plane: the point of the boundary nearest to it counts
      const PlaneSpec& spec = *scene.ground.plane;
      const double gap = lowest_along(spec.normal) - spec.normal.dot(spec.point);
      smallest = std::min(smallest, gap / std::max(1e-6, spec.normal.dot(up)));
      continue;
    }
    double ground = placement.ground_height;
    if (!grains.empty()) {
      double reach = 0.0;
      for (const ContactPoint& point : entry.points) {
        const Eigen::Vector3d offset = R_WB * point.marker.s0;
        reach = std::max(reach, (offset - up * up.dot(offset)).norm() + point.radius);
      }
      ground = highest_under(grains, up, r, reach);
      placement.sites.push_back({highest_under(grains, up, r, (1.0 + kStray) * reach), kStray * reach, r, R_WB});
    }
    if (!std::isfinite(ground)) continue;  // no grain under this boundary
    highest_ground = std::max(highest_ground, ground);
    smallest = std::min(smallest, lowest_along(up) - ground);
  }
  if (particles && std::isfinite(highest_ground)) placement.ground_height = highest_ground;

  if (initial.clearance) {
    if (particles && grains.empty() && !scene.particles->surface_height)
      throw InputError(code::kNoGroundHeight,
                       "initial.clearance: the height of the grains is unknown; give particles.grains (a dump of x y z "
                       "radius) or particles.surface_height, or use initial.position instead");
    if (!std::isfinite(smallest))
      throw InputError(code::kNoGroundHeight,
                       std::string("initial.clearance: ") +
                           (boundaries.empty() ? "the scene has no boundary; add [[boundaries]]"
                                               : "no grain is under any boundary; check initial.position and the bed"));
    const Eigen::Vector3d lift = (*initial.clearance - smallest) * up;
    placement.p_WD += lift;
    for (LandingSite& site : placement.sites) site.r += lift;
  }
  return placement;
}

}  // namespace footfall
