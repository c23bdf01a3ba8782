#include "liggghts_fix/mesh_module_mbd.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atom.h"
#include "fix_mesh_surface.h"
#include "liggghts_fix/liggghts_access.h"

namespace LAMMPS_NS {
namespace {

int no_arguments = 0;  // the base class takes its position in an argument list by reference

Eigen::Vector3d vector3(const double* x) { return {x[0], x[1], x[2]}; }

}  // namespace

MeshModuleMbd::MeshModuleMbd(LAMMPS* lmp_, FixMeshSurface* mesh_fix, std::vector<footfall::CornerNodes> corners)
    : MeshModule(lmp_, no_arguments, 0, nullptr, mesh_fix),
      corners_(std::move(corners)),
      behind_stress_(mesh_fix->get_module("stress") != nullptr) {}

// c = x_ip + delta lies on the element; delta points from the grain's centre to it. LIGGGHTS' torque on the grain has
// the arm radius - overlap / 2, the middle of the overlap: the force on the body acts there too, so that moments are
// action and reaction. (Rolling resistance turns the grain by a couple of which LIGGGHTS tells nobody: the body does
// not feel it.)
void MeshModuleMbd::add_particle_contribution(int ip, double* frc, double* delta, int iTri, double*) {
  if (body_ == nullptr) return;
  const bool on_body = behind_stress_ && (atom->mask[ip] & fix_mesh->get_groupbit());
  const Eigen::Vector3d f_W = on_body ? vector3(frc) : Eigen::Vector3d(-vector3(frc));

  if (f_W.isZero(0.0)) return;  // an output of LIGGGHTS looked at the contact once more

  const Eigen::Vector3d d = vector3(delta);
  const Eigen::Vector3d c = vector3(atom->x[ip]) + d;
  double** nodes = footfall::mesh_nodes(mesh)[iTri];
  const Eigen::Vector3d weights =
      footfall::barycentric_weights(vector3(nodes[0]), vector3(nodes[1]), vector3(nodes[2]), c);
  const footfall::CornerNodes& corner = corners_[static_cast<std::size_t>(mesh->id(iTri))];
  const footfall::BoundaryPoint point{{corner[0], corner[1], corner[2]}, {weights[0], weights[1], weights[2]}};

  const double radius = atom->radius[ip];
  const double distance = d.norm();
  const double overlap = std::max(0.0, radius - distance);
  const Eigen::Vector3d arm_W = (0.5 * overlap / distance) * d;  // from c
  if (contacts_.empty()) {
    body_->add_contact(point, f_W, arm_W.cross(f_W), overlap / radius, 0.0);
    return;
  }
  const footfall::WallContact& contact = contacts_[static_cast<std::size_t>(atom->type[ip])];
  const double s = std::sqrt(radius * overlap);
  body_->add_contact(point, f_W, arm_W.cross(f_W), overlap / radius, contact.stiffness(s));
  if (body_->samples_slopes()) body_->add_slope(c + arm_W, contact.slope(d / distance, f_W, s, atom->rmass[ip]));
}

}  // namespace LAMMPS_NS
