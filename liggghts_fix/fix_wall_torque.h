#pragma once
// What LIGGGHTS does to a grain's torque in a contact with a coupled mesh.

#include <Eigen/Dense>
#include <map>
#include <memory>
#include <string>

#include "granular_wall.h"
#include "liggghts_fix/dem_body.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixWallGran;

// The torque [N m] of a grain as it was before the contact that is computed now.
using GrainTorque = std::shared_ptr<Eigen::Vector3d>;

// Stands before the contact model of a stock fix wall/gran, which does its work behind it, bit by bit as without.
// LIGGGHTS tells the mesh of a contact its force alone, and rolling friction is a couple: it shows only as a change of
// the grain's torque.
class WallTorque final : private Pointers, public LIGGGHTS::Walls::IGranularWall {
 public:
  // From now on `before` is written at each contact of the wall. The wall owns what is put into it.
  static void watch(LAMMPS* lmp, FixWallGran& wall, GrainTorque before);

  // Behind watch(): in contacts with this mesh the grain meets the mass of the body (pair_mass.h); null: a wall again.
  static void meet(FixWallGran& wall, const FixMeshSurface* mesh, const footfall::DemBody* body);

  void settings(int nargs, char** args, LIGGGHTS::IContactHistorySetup* setup) override;
  void init_granular() override;
  bool checkSurfaceIntersect(LIGGGHTS::ContactModels::SurfacesIntersectData& contact) override;
  void compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact, bool intersect,
                     double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh, int element) override;
  int get_history_offset(std::string name) override;
  bool contact_match(std::string kind, std::string model) override;

 private:
  WallTorque(LAMMPS* lmp_, IGranularWall* model) : Pointers(lmp_), model_(model) {}

  std::unique_ptr<IGranularWall> model_;
  GrainTorque before_;
  std::map<const FixMeshSurface*, const footfall::DemBody*> bodies_;
};

}  // namespace LAMMPS_NS
