// Contacts with uneven rigid ground, and how far boundaries are above it.

#include <algorithm>
#include <cmath>
#include <limits>

#include "mbd_solver/assemble/mechanism.h"
#include "mbd_solver/base/pi.h"
#include "mbd_solver/model/elements/terrain_contact.h"
#include "mbd_solver/scene/box_bed.h"
#include "mbd_solver/scene/resolve.h"

namespace footfall {

std::shared_ptr<Terrain> build_terrain(const Scene& scene) {
  return scene.ground.is_uneven() ? terrain_of(*scene.ground.terrain) : nullptr;
}

std::shared_ptr<Terrain> build_bed_surface(const Scene& scene) {
  if (!terrain_bed(scene)) return nullptr;
  TerrainSpec field = *scene.ground.terrain;
  field.rocks.clear();
  field.rock_field.reset();
  return terrain_of(field);
}

namespace {

// The way that a point of the body can fall before a ball of this radius about it touches.
double fall_of(Terrain& terrain, const Eigen::Vector3d& p, double radius) {
  if (radius == 0.0) return p.z() - terrain.top(p.x(), p.y());
  // From a bound on, down by the distance, which is no more than the way left.
  constexpr int kRays = 16, kSteps = 60;
  double way = p.z() - radius - terrain.top(p.x(), p.y());
  for (int i = 0; i < kRays; ++i) {
    for (const double share : {0.35, 0.7, 0.95}) {
      const double angle = 2.0 * kPi * i / kRays, across = share * radius;
      const Eigen::Vector2d place = p.head<2>() + across * Eigen::Vector2d(std::cos(angle), std::sin(angle));
      way = std::min(way, p.z() - std::sqrt(radius * radius - across * across) - terrain.top(place.x(), place.y()));
    }
  }
  std::vector<Terrain::Foot> feet;
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector3d now = p - way * Eigen::Vector3d::UnitZ();
    terrain.feet(now, 1.5 * radius, feet);
    double left = std::numeric_limits<double>::infinity();
    for (const Terrain::Foot& foot : feet)
      if (foot.sign > 0.0) left = std::min(left, (foot.distance - radius) / std::max(0.1, foot.normal.z()));
    for (std::size_t k = 0; k < terrain.rocks().size(); ++k) {
      const Terrain::Foot foot = terrain.foot(now, static_cast<int>(k));
      if (foot.normal.z() > 0.0) left = std::min(left, (foot.distance - radius) / std::max(0.1, foot.normal.z()));
    }
    if (!std::isfinite(left)) break;  // no foot within reach: as good as the rays have it
    way += left;
    if (std::abs(left) < 1e-12) break;
  }
  return way;
}

// The least of fall(p, radius) over the points and edges of a body.
template <class Fall>
double least_fall(const BodyBoundary& entry, const Eigen::Vector3d& r, const Eigen::Matrix3d& R_WB, Fall fall) {
  double least = std::numeric_limits<double>::infinity();
  for (const ContactPoint& point : entry.points)
    least = std::min(least, fall(r + R_WB * point.marker.s0, point.radius));
  constexpr int kAround = 720;
  for (const ContactRim& rim : entry.rims) {
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2.0 * kPi * k / kAround;
      const Eigen::Vector3d e = std::cos(angle) * rim.marker.axes.col(0) + std::sin(angle) * rim.marker.axes.col(1);
      least = std::min(least, fall(r + R_WB * (rim.marker.s0 + rim.radius * e), 0.0));
    }
  }
  return least;
}

}  // namespace

double fall_to(Terrain& terrain, const BodyBoundary& entry, const Eigen::Vector3d& r, const Eigen::Matrix3d& R_WB) {
  return least_fall(entry, r, R_WB,
                    [&](const Eigen::Vector3d& p, double radius) { return fall_of(terrain, p, radius); });
}

double fall_to_rocks(const std::vector<Terrain::Sphere>& rocks, const BodyBoundary& entry, const Eigen::Vector3d& r,
                     const Eigen::Matrix3d& R_WB) {
  return least_fall(entry, r, R_WB, [&](const Eigen::Vector3d& p, double radius) {
    double way = std::numeric_limits<double>::infinity();
    for (const Terrain::Sphere& rock : rocks) {
      const double reach = rock.radius + radius, across = (p - rock.centre).head<2>().norm();
      if (across < reach) way = std::min(way, p.z() - rock.centre.z() - std::sqrt(reach * reach - across * across));
    }
    return way;
  });
}

}  // namespace footfall
