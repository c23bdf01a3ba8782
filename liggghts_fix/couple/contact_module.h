#pragma once
// Receives every contact of a stock LIGGGHTS mesh and projects its force on the coupled body.

#include <utility>
#include <vector>

#include "liggghts_fix/contact/wall_observers.h"
#include "liggghts_fix/link/contact_slope.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/link/grain_paths.h"
#include "liggghts_fix/link/mesh_match.h"
#include "liggghts_fix/link/surface_pieces.h"
#include "mesh_module.h"

namespace LAMMPS_NS {

// Added to a `fix mesh/surface` or `mesh/surface/stress` after the modules that it has. Sign: the wall passes the force on
// the GRAIN; the module `stress`, which is called first, reverses it in place for grains of the mesh fix's group.
class ContactModule final : public MeshModule {
 public:
  // corners: boundary nodes by mesh element id; rho0: positions of the nodes in the body [m].
  ContactModule(LAMMPS* lmp, FixMeshSurface* mesh_fix, std::vector<footfall::CornerNodes> corners,
                const Eigen::Matrix3Xd& rho0);

  // The body on which the forces act; known once the coupling has started.
  void set_body(footfall::DemLink& link, int body) {
    link_ = &link;
    index_ = body;
    body_ = &link.window().body(body);
  }
  // By grain type, from 1; empty: the script gives no elastic constants, and stiffnesses are unknown.
  void set_contacts(std::vector<footfall::WallContact> contacts) { contacts_ = std::move(contacts); }
  // The torque of the touching grain before the contact.
  void set_torque_before(GrainTorque torque) { torque_before_ = std::move(torque); }
  // Grains touch a smooth surface once: the widths of facets do not matter.
  void set_touched_once() { widths_.clear(); }
  const std::vector<footfall::CornerNodes>& corners() const { return corners_; }

  void add_particle_contribution(int ip, double* frc, double* delta, int iTri, double* v_wall) override;

 private:
  void watch_passage(int grain, const Eigen::Vector3d& d, const footfall::BoundaryPoint& point);

  std::vector<footfall::CornerNodes> corners_;
  std::vector<double> widths_;  // of facets on curved parts, by mesh element id [m]; empty: touched once
  std::vector<footfall::WallContact> contacts_;
  footfall::DemLink* link_ = nullptr;
  int index_ = 0;  // of the body in the link
  footfall::DemBody* body_ = nullptr;
  footfall::GrainPassages passages_;
  GrainTorque torque_before_;
  bool after_stress_;  // the module `stress` has been called
};

}  // namespace LAMMPS_NS
