// fix ID all couple/mbd every N|auto [patience SECONDS] [gravity scene|script] [end scene|script] [lost SHARE]
//   [mesh MESH-ID BODY]...
// Moves stock meshes with the bodies of a multibody scene and sends the mean contact load of every N steps back. The
// bodies of fix wall/gran/beam take part without being named here. A partner that says nothing for SECONDS
// (coupling.timeout of the scene) counts as lost. gravity script: the fix gravity of the script need not be that of the
// scene; end script: the script may end, or unfix the coupling, before the scene ends; lost: share of the grains that
// LIGGGHTS may lose (0.05).
//
// Output: f_ID[1] windows done, [2] interface energy residual [J] (work of the grains on the boundaries minus the work
// received by the multibody side, over all windows but the last), [3] work of the grains on the boundaries [J], [4]
// largest overlap over grain radius, [5] contacts. f_ID[i][1..6]: mean force [N] and mean moment about Bo [N m], both
// in W, of the last window on the i-th body that the `mesh` pairs name, positive ON the body; then on the bodies that
// only beams touch, in the order of their fixes.

#ifdef FIX_CLASS
FixStyle(couple / mbd, FixCoupleMbd)
#else

#ifndef FOOTFALL_FIX_COUPLE_MBD_H
#define FOOTFALL_FIX_COUPLE_MBD_H

#include <memory>
#include <string>
#include <vector>

#include "coupler/couple_mbd_arguments.h"
#include "fix.h"
#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/fix_couple_mbd_mesh.h"
#include "liggghts_fix/fix_couple_mbd_walls.h"
#include "liggghts_fix/liggghts_access.h"

namespace LAMMPS_NS {

class TriMesh;

// Errors leave as exceptions of footfall (the launcher catches them): the same on every rank, as every rank sees the
// same messages.
class FixCoupleMbd : public Fix, private footfall::LateBoundaries {
 public:
  FixCoupleMbd(LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixed) override;
  void init() override;
  void initial_integrate(int) override;
  void final_integrate() override;
  void end_of_step() override;
  double compute_vector(int n) override;
  double compute_array(int i, int j) override;

  ~FixCoupleMbd() override;

 private:
  void move_boundaries() override;
  void go_ahead_or_wait(bool tell);
  void gather(const std::vector<double>& row);
  std::vector<double> sum_over_ranks(const std::vector<double>& row);
  void keep(const std::string& folder);
  void go_on_as_after_restart();
  void order_as_after_restart(TriMesh* mesh) const;

  footfall::DemLink& link_;
  bool grains_go_ahead_ = false;  // boundaries move behind the forces of grains on each other
  bool compare_gravity_ = false;  // it varies, and the first step has not begun
  const footfall::CoupleMbdArguments arguments_;
  std::vector<std::unique_ptr<CoupledMesh> > meshes_;
  const GrainTorque torque_before_ = std::make_shared<Eigen::Vector3d>(Eigen::Vector3d::Zero());
  WallWatch walls_;
  std::vector<int> rows_of_output_;  // body of each row of f_ID: those of meshes_, then the others
  std::vector<double> row_, rows_;   // of this rank, of all ranks
};

}  // namespace LAMMPS_NS

#endif
#endif
