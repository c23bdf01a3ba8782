#pragma once
// How long a boundary falls before it can meet a grain.

#include "coupler/body_motion.h"
#include "mbd_solver/build/mechanism.h"

namespace footfall {

// Time [s] until the lowest point of the undeformed boundary, falling at its present speed, is as low as the highest
// grain that may lie under it; infinity when it does not fall; 0 when it may touch a grain now, or when nobody said how
// high the grains stand.
//   speed = |w| reach - up . dr,  reach = largest |rho0|
// up: unit vector. site: the grains below this boundary at the start, which count as long as it stays above them; null
// once it has touched: from then on the highest grain of all counts.
double flight_time(const BodyMotion& motion, const ModalBoundary& boundary, const Placement& placement,
                   const Eigen::Vector3d& up, const LandingSite* site);

}  // namespace footfall
