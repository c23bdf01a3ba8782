#pragma once
// fix ID all couple/mbd every N|auto [patience SECONDS] [gravity scene|script] [end scene|script] [lost SHARE]
//   [outflow yes|no] [surface smooth|facets|round] [edge DEGREES] [damping_mass grain|pair] [mesh MESH-ID BODY]...
// Moves stock meshes with the bodies of a multibody scene, and sends the mean contact load of every N steps to
// mbd_solver. Bodies of fix wall/gran/beam take part without being named here. couple_mbd_arguments.h describes the
// keywords.
//
// Output: f_ID[1] windows done, [2] interface energy residual [J] (work of the grains on the boundaries minus the work
// received by the multibody side, over all windows but the last), [3] work of the grains on the boundaries [J], [4]
// largest overlap over grain radius, [5] contacts, [6] [7] [8] energy of inserted and of lost grains (negative), and from
// commands up to this step [J]. f_ID[i][1..6]: mean force [N] and mean moment about Bo [N m], both in
// W, of the last window ON the i-th body that the `mesh` pairs name; then on the bodies that only have beams, in the
// order of their fixes. f_ID[i][7..]: mean modal forces Q_a [J per unit of a] of a flexible body.

#include <memory>
#include <string>
#include <vector>

#include "coupler/couple_mbd_arguments.h"
#include "fix.h"
#include "liggghts_fix/couple/coupled_mesh.h"
#include "liggghts_fix/couple/fast_grains.h"
#include "liggghts_fix/couple/grain_changes.h"
#include "liggghts_fix/couple/script_walls.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/force_listeners.h"

namespace LAMMPS_NS {

class TriMesh;

// Errors leave as exceptions of footfall, which the launcher catches. They are the same on every rank, because every rank
// receives the same messages.
class FixCoupleMbd : public Fix, private footfall::DeferredBoundaryMotion, private footfall::SetUpListener {
 public:
  FixCoupleMbd(LAMMPS* lmp, int narg, char** arg);
  ~FixCoupleMbd() override;

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixed) override;
  void init() override;
  void initial_integrate(int) override;
  void final_integrate() override;
  void end_of_step() override;
  void post_run() override;
  double compute_vector(int n) override;
  double compute_array(int i, int j) override;

 private:
  void move_boundaries() override;
  void set_up_done() override;
  footfall::Start describe_script();
  void number_output_rows();
  void overlap_or_wait(bool report);
  void gather(const std::vector<double>& row);
  std::vector<double> sum_over_ranks(const std::vector<double>& row);
  double over_ranks(double share);
  void write_checkpoint(const std::string& folder);
  void continue_as_after_restart();
  void order_as_after_restart(TriMesh* mesh) const;

  footfall::DemLink& link_;
  const footfall::CoupleMbdArguments arguments_;
  std::vector<std::unique_ptr<CoupledMesh>> meshes_;
  const GrainTorque torque_before_ = std::make_shared<Eigen::Vector3d>(Eigen::Vector3d::Zero());
  WallCrossings crossings_;
  FastGrains fast_grains_;
  GrainChangeWatch grain_changes_;
  bool overlaps_ = false;           // pair forces overlap with the mechanism's step
  bool compares_gravity_ = false;   // gravity varies, and the first step has not begun
  std::vector<int> output_rows_;    // body of each row of f_ID: bodies of meshes_, then the others
  std::vector<double> row_, rows_;  // of this rank, of all ranks
};

}  // namespace LAMMPS_NS
