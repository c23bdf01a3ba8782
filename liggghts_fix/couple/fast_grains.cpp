// The speeds of grains and bodies bound their relative speeds. Where the bound allows no long way, which is the rule,
// nothing else is done; otherwise the paths of fast grains are compared with the boundaries.

#include "liggghts_fix/couple/fast_grains.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "atom.h"
#include "domain.h"
#include "liggghts_fix/link/grain_paths.h"
#include "neighbor.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

constexpr int kInterval = 50;  // steps after which speeds are measured even without a new list of neighbours

Eigen::Vector3d grain_vector(const double* x) { return {x[0], x[1], x[2]}; }

// The image of the grain nearest to a place.
Eigen::Vector3d image_nearest_to(const Eigen::Vector3d& place, const double* x, const Domain& domain) {
  Eigen::Vector3d image = grain_vector(x);
  for (int c = 0; c < 3; ++c) {
    if (domain.periodicity[c] == 0) continue;
    const double period = domain.boxhi[c] - domain.boxlo[c];
    image[c] += period * std::round((place[c] - image[c]) / period);
  }
  return image;
}

}  // namespace

void FastGrains::check() {
  const bool is_due = neighbor->lastcall != list_ || update->ntimestep >= measured_ + kInterval;
  if (!is_due && !link_.window().window_begins()) return;
  if (is_due) measure();
  if (smallest_ == 0.0) return;
  double speed = 0.0;
  for (int body = 0; body < link_.bodies().count(); ++body) {
    const footfall::BodyMotion& pose = link_.window().body(body).pose();
    const double reach = link_.window().body(body).boundary().rho0().colwise().norm().maxCoeff();
    speed = std::max(speed, pose.dr.norm() + pose.w.norm() * reach + elastic_[body]);
  }
  if ((rate_ + speed / smallest_) * update->dt > footfall::kLongestWay) find_faults();
}

void FastGrains::measure() {
  measured_ = update->ntimestep;
  list_ = neighbor->lastcall;
  double largest = 0.0, smallest = std::numeric_limits<double>::infinity();
  for (int i = 0; i < atom->nlocal; ++i) {
    const double r = atom->radius[i], v2 = grain_vector(atom->v[i]).squaredNorm();
    if (v2 > largest * r * r) largest = v2 / (r * r);
    smallest = std::min(smallest, r);
  }
  rate_ = std::sqrt(largest);
  smallest_ = atom->nlocal > 0 ? smallest : 0.0;
  elastic_.assign(link_.bodies().count(), 0.0);
  for (int body = 0; body < link_.bodies().count(); ++body) {
    const footfall::ModalBoundary& boundary = link_.window().body(body).boundary();
    if (boundary.mode_count() == 0) continue;
    footfall::BodyMotion alone = link_.window().body(body).pose();
    alone.dr.setZero();
    alone.w.setZero();
    nodes_.resize(3, boundary.node_count());
    boundary.node_velocities(alone, nodes_);
    elastic_[body] = nodes_.colwise().norm().maxCoeff();
  }
}

void FastGrains::find_faults() {
  for (int body = 0; body < link_.bodies().count(); ++body) {
    const footfall::BodyMotion& pose = link_.window().body(body).pose();
    const footfall::ModalBoundary& boundary = link_.window().body(body).boundary();
    nodes_.resize(3, boundary.node_count());
    boundary.node_positions(pose, nodes_);
    for (int i = 0; i < atom->nlocal; ++i) {
      const Eigen::Vector3d x = image_nearest_to(pose.r, atom->x[i], *domain);
      const Eigen::Vector3d v = grain_vector(atom->v[i]) - pose.dr - pose.w.cross(x - pose.r);
      const double r = atom->radius[i], speed = v.norm();
      if (speed * update->dt <= footfall::kLongestWay * r) continue;
      // To the end of the window, and one radius and step on either side.
      const Eigen::Vector3d margin = r / speed * v + update->dt * v;
      const Eigen::Vector3d way = link_.window().substeps_left() * update->dt * v + 2.0 * margin;
      if (!path_meets(boundary, nodes_, x - margin, way)) continue;
      link_.grains().fault(
          {footfall::GrainFault::kTooFast, link_.window().time(), static_cast<int>(atom->tag[i]), body, speed, r});
      return;
    }
  }
}

}  // namespace LAMMPS_NS
