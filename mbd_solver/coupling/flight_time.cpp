#include "mbd_solver/coupling/flight_time.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace footfall {

double flight_time(const BodyMotion& motion, const ModalBoundary& boundary, const Placement& placement,
                   const Eigen::Vector3d& up, const LandingSite* site) {
  if (!placement.ground_known) return 0.0;
  const Eigen::Matrix3Xd& rho0 = boundary.rho0();
  const double lowest = up.dot(motion.r) + (up.transpose() * motion.rotation() * rho0).minCoeff();
  const double reach = rho0.colwise().norm().maxCoeff();
  const double speed = motion.w.norm() * reach - up.dot(motion.dr);
  double radius = 0.0;  // of beams
  for (const BeamSegment& segment : boundary.segments()) radius = std::max(radius, segment.radius);
  double ground = placement.ground_height;
  if (site) {
    const Eigen::Vector3d way = motion.r - site->r;
    const double turned = Eigen::AngleAxisd(site->R_WB.transpose() * motion.rotation()).angle();
    if ((way - up * up.dot(way)).norm() + turned * reach < site->stray && std::isfinite(site->height))
      ground = site->height;
  }
  const double height = lowest - radius - ground;
  if (height <= 0.0) return 0.0;
  return speed > 0.0 ? height / speed : std::numeric_limits<double>::infinity();
}

}  // namespace footfall
