#pragma once
// Hears of every contact of a stock LIGGGHTS mesh and projects its force on the coupled body.

#include <vector>

#include "liggghts_fix/dem_body.h"
#include "liggghts_fix/mesh_match.h"
#include "mesh_module.h"

namespace LAMMPS_NS {

// Constants of one grain type against the wall: of Hertz-Mindlin, or of a linear spring when the script has kn (model
// hooke/stiffness; for hertz/stiffness, kn is more than the stiffness at any overlap below 1 / radius). With s =
// sqrt(radius overlap): normal stiffness 2 young s, shear stiffness 8 shear s; damping sqrt(stiffness grain-mass) times
// `damping` (LIGGGHTS).
struct WallContact {
  double young = 0.0;                                       // E* [Pa]
  double shear = 0.0;                                       // G* [Pa]
  double damping = 0.0;                                     // -2 sqrt(5/6) beta, beta = ln e / sqrt(ln^2 e + pi^2) [-]
  double friction = 0.0;                                    // [-]
  double linear = 0.0, linear_shear = 0.0;                  // kn, kt [N/m]; 0: Hertz-Mindlin
  double linear_damping = 0.0, linear_shear_damping = 0.0;  // gamma_n, gamma_t, per mass of the grain [1/s]

  double stiffness(double s) const { return linear > 0.0 ? linear : 2.0 * young * s; }
};

// Attached to a `fix mesh/surface` or `mesh/surface/stress` behind the modules it has. Sign: the wall hands
// out the force on the GRAIN; the module `stress`, which hears first, has turned it round in place for grains
// of the mesh fix's group.
class MeshModuleMbd final : public MeshModule {
 public:
  // corners: boundary nodes by mesh element id.
  MeshModuleMbd(LAMMPS* lmp, FixMeshSurface* mesh_fix, std::vector<footfall::CornerNodes> corners);

  // The body that takes the forces, known once the coupling has started.
  void set_body(footfall::DemBody* body) { body_ = body; }
  // By grain type, from 1; empty: the script gives no elastic constants, and stiffnesses stay unknown.
  void set_contacts(std::vector<WallContact> contacts) { contacts_ = std::move(contacts); }
  const std::vector<footfall::CornerNodes>& corners() const { return corners_; }

  void add_particle_contribution(int ip, double* frc, double* delta, int iTri, double* v_wall) override;

 private:
  std::vector<footfall::CornerNodes> corners_;
  std::vector<WallContact> contacts_;
  footfall::DemBody* body_ = nullptr;
  bool behind_stress_;
};

}  // namespace LAMMPS_NS
