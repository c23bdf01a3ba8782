// fix ID all couple/mbd every N|auto [patience SECONDS] [mesh MESH-ID BODY ...]
// Moves stock meshes with the bodies of a multibody scene and sends the mean contact load of every N steps back. The
// bodies of fix wall/gran/beam take part without being named here. A partner that says nothing for SECONDS (600) counts
// as lost.
//
// Output: f_ID[1] windows done, [2] interface energy residual [J] (work of the grains on the boundaries minus the work
// received by the multibody side, over all windows but the last), [3] work of the grains on the boundaries [J], [4]
// largest overlap over grain radius, [5] contacts. f_ID[i][1..6]: mean force [N] and mean moment about Bo [N m], both
// in W, of the last window on the body of the i-th `mesh` pair, positive ON the body; then on the bodies that only
// beams touch, in the order of their fixes.

#ifdef FIX_CLASS
FixStyle(couple / mbd, FixCoupleMbd)
#else

#ifndef FOOTFALL_FIX_COUPLE_MBD_H
#define FOOTFALL_FIX_COUPLE_MBD_H

#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "liggghts_fix/dem_link.h"
#include "liggghts_fix/mesh_module_mbd.h"

namespace LAMMPS_NS {

// Errors leave as exceptions of footfall (the launcher catches them): the same on every rank, as every rank sees the
// same messages.
class FixCoupleMbd : public Fix {
 public:
  FixCoupleMbd(LAMMPS* lmp, int narg, char** arg);

  int setmask() override;
  void post_create() override;
  void pre_delete(bool unfixed) override;
  void init() override;
  void initial_integrate(int) override;
  void final_integrate() override;
  double compute_vector(int n) override;
  double compute_array(int i, int j) override;

 private:
  // A mesh of the script and the body it belongs to.
  struct CoupledMesh {
    FixMeshSurface* fix;
    std::string mesh_id;
    int body;  // index in the link
    std::unique_ptr<MeshModuleMbd> module;
    Eigen::Matrix3Xd x_W, v_W;  // nodes of the body's boundary
    double reach;               // no node is farther from Bo, undeformed [m]
  };

  CoupledMesh couple(const std::string& mesh_id, const std::string& body);
  std::vector<footfall::CornerNodes> match(FixMeshSurface* mesh_fix, const std::string& mesh_id,
                                           const footfall::CoupledBody& body) const;
  std::vector<WallContact> wall_contacts(int wall_type) const;
  void move(CoupledMesh& mesh);
  void translate(TriMesh* mesh, const Eigen::Vector3d& velocity) const;
  double nearest_image(double place, double before, int direction) const;
  void turn_properties(CoupledMesh& mesh, const footfall::BoundaryStep& step);
  void check_inside_box(const CoupledMesh& mesh) const;

  footfall::DemLink& link_;
  int every_ = 0;  // substeps per window; 0: the multibody side chooses
  std::vector<CoupledMesh> meshes_;
  std::vector<int> rows_of_output_;  // body of each row of f_ID: those of meshes_, then the others
  std::vector<double> sums_, rows_;
};

}  // namespace LAMMPS_NS

#endif
#endif
