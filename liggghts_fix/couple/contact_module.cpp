// Force and couple on the grain become force and moment at a point of the boundary.

#include "liggghts_fix/couple/contact_module.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atom.h"
#include "fix_mesh_surface.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "update.h"

namespace LAMMPS_NS {
namespace {

int no_arguments = 0;  // the base class takes its position in an argument list by reference

Eigen::Vector3d vector3(const double* x) { return {x[0], x[1], x[2]}; }

}  // namespace

ContactModule::ContactModule(LAMMPS* lmp_, FixMeshSurface* mesh_fix, std::vector<footfall::CornerNodes> corners,
                             const Eigen::Matrix3Xd& rho0)
    : MeshModule(lmp_, no_arguments, 0, nullptr, mesh_fix),
      corners_(std::move(corners)),
      widths_(footfall::curved_facet_widths(rho0, corners_)),
      after_stress_(mesh_fix->get_module("stress") != nullptr) {}

// c = x_ip + delta is on the element; delta points from the grain's centre to it. The grain gets force and torque of the
// contact about its centre x, and the body their reaction, shifted from x to c:
//   f_W = -f,   m_c = (x - c) x f_W - (torque after - torque before)
// That is the force in the middle of the overlap, where LIGGGHTS applies it to the grain, and the couple of rolling
// friction.
void ContactModule::add_particle_contribution(int ip, double* frc, double* delta, int iTri, double*) {
  if (body_ == nullptr) return;
  const bool on_body = after_stress_ && (atom->mask[ip] & fix_mesh->get_groupbit());
  const Eigen::Vector3d f_W = on_body ? vector3(frc) : Eigen::Vector3d(-vector3(frc));

  if (f_W.isZero(0.0)) return;  // an output of LIGGGHTS evaluates the contact once more

  const Eigen::Vector3d d = vector3(delta);
  const Eigen::Vector3d c = vector3(atom->x[ip]) + d;
  double** nodes = footfall::mesh_nodes(mesh)[iTri];
  const Eigen::Vector3d weights =
      footfall::barycentric_weights(vector3(nodes[0]), vector3(nodes[1]), vector3(nodes[2]), c);
  const auto element = static_cast<std::size_t>(mesh->id(iTri));
  const footfall::CornerNodes& corner = corners_[element];
  const footfall::BoundaryPoint point{{corner[0], corner[1], corner[2]}, {weights[0], weights[1], weights[2]}};

  const double radius = atom->radius[ip];
  const double distance = d.norm();
  const double overlap = std::max(0.0, radius - distance);
  // Moments are taken about the boundary point. That is c, except on the round surface, which is above the element.
  Eigen::Vector3d to_point = d;
  if (widths_.empty())
    to_point = weights[0] * vector3(nodes[0]) + weights[1] * vector3(nodes[1]) + weights[2] * vector3(nodes[2]) -
               vector3(atom->x[ip]);
  const Eigen::Vector3d m_W = *torque_before_ - vector3(atom->torque[ip]) - to_point.cross(f_W);
  if (overlap > footfall::GrainPassages::kDeep * radius) watch_passage(ip, d, point);
  if (!widths_.empty()) body_->count_patch(std::sqrt(2.0 * radius * overlap) / widths_[element]);
  const footfall::TouchingGrain grain{atom->rmass[ip], radius, vector3(atom->v[ip])};
  if (contacts_.empty()) {
    body_->add_contact(point, f_W, m_W, overlap / radius, 0.0, grain);
    return;
  }
  const footfall::WallContact& contact = contacts_[atom->type[ip]];
  const double s = std::sqrt(radius * overlap);
  body_->add_contact(point, f_W, m_W, overlap / radius, contact.stiffness(s), grain);
  if (body_->samples_slopes())
    body_->add_slope(point, (0.5 * overlap / distance) * d, contact.slope(d / distance, f_W, s, atom->rmass[ip]));
}

void ContactModule::watch_passage(int ip, const Eigen::Vector3d& d, const footfall::BoundaryPoint& point) {
  const double speed = (vector3(atom->v[ip]) - body_->boundary().velocity(body_->pose(), point)).norm();
  const int tag = static_cast<int>(atom->tag[ip]);
  if (!passages_.passes(update->ntimestep, tag, d, speed * update->dt)) return;
  link_->grains().fault({footfall::GrainFault::kPassed, link_->window().time(), tag, index_, speed, atom->radius[ip]});
}

}  // namespace LAMMPS_NS
