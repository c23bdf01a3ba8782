#pragma once
// What some of the meshes of a stock fix wall/gran do to the grains: LIGGGHTS has one sum for all of them.

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <string>

#include "granular_wall.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixWallGran;

// Stands before the contact model of the wall, which does its work behind it, bit by bit as without.
class MeshShare final : private Pointers, public LIGGGHTS::Walls::IGranularWall {
 public:
  using Wrench = Eigen::Matrix<long double, 6, 1>;  // on the grains of this rank, about the origin [N, N m]
  using Choice = std::function<bool(FixMeshSurface*)>;

  // From now on the contacts of the chosen meshes are added to what is returned. The wall owns what is put into it.
  static std::shared_ptr<Wrench> watch(LAMMPS* lmp, FixWallGran& wall, Choice chosen);

  void settings(int nargs, char** args, LIGGGHTS::IContactHistorySetup* setup) override;
  void init_granular() override;
  bool checkSurfaceIntersect(LIGGGHTS::ContactModels::SurfacesIntersectData& contact) override;
  void compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact, bool intersect,
                     double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh, int element) override;
  int get_history_offset(std::string name) override;
  bool contact_match(std::string kind, std::string model) override;

 private:
  MeshShare(LAMMPS* lmp_, IGranularWall* model) : Pointers(lmp_), model_(model) {}
  Wrench on_grain(int grain) const;

  std::unique_ptr<IGranularWall> model_;
  std::shared_ptr<Wrench> sum_;
  Choice chosen_;
};

}  // namespace LAMMPS_NS
