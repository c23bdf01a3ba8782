#pragma once
// Hears of every contact of a stock LIGGGHTS mesh and projects its force on the coupled body.

#include <utility>
#include <vector>

#include "liggghts_fix/dem_body.h"
#include "liggghts_fix/facet_width.h"
#include "liggghts_fix/fix_wall_torque.h"
#include "liggghts_fix/mesh_match.h"
#include "liggghts_fix/wall_contact.h"
#include "mesh_module.h"

namespace LAMMPS_NS {

// Attached to a `fix mesh/surface` or `mesh/surface/stress` behind the modules it has. Sign: the wall hands out the
// force on the GRAIN; the module `stress`, which hears first, has turned it round in place for grains of the mesh fix's
// group.
class MeshModuleMbd final : public MeshModule {
 public:
  // corners: boundary nodes by mesh element id; rho0: where they are in the body [m].
  MeshModuleMbd(LAMMPS* lmp, FixMeshSurface* mesh_fix, std::vector<footfall::CornerNodes> corners,
                const Eigen::Matrix3Xd& rho0);

  // The body that takes the forces, known once the coupling has started.
  void set_body(footfall::DemBody* body) { body_ = body; }
  // By grain type, from 1; empty: the script gives no elastic constants, and stiffnesses stay unknown.
  void set_contacts(std::vector<footfall::WallContact> contacts) { contacts_ = std::move(contacts); }
  // Of the grain that touches, from before the contact.
  void set_torque_before(GrainTorque torque) { torque_before_ = std::move(torque); }
  // Grains touch a smooth surface once: facets do not add up, and their widths do not matter.
  void set_touched_once() { widths_.clear(); }
  const std::vector<footfall::CornerNodes>& corners() const { return corners_; }

  void add_particle_contribution(int ip, double* frc, double* delta, int iTri, double* v_wall) override;

 private:
  std::vector<footfall::CornerNodes> corners_;
  std::vector<double> widths_;  // of facets on curved parts, by mesh element id [m]; empty: touched once
  std::vector<footfall::WallContact> contacts_;
  footfall::DemBody* body_ = nullptr;
  GrainTorque torque_before_;
  bool behind_stress_;
};

}  // namespace LAMMPS_NS
