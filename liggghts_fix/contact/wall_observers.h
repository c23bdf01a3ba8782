#pragma once
// Observers of the contacts of a stock fix wall/gran. Each is put in front of the wall's contact model, which it owns and
// calls unchanged, so that the results are the same to the bit.

#include <Eigen/Dense>
#include <functional>
#include <map>
#include <memory>
#include <string>

#include "granular_wall.h"
#include "liggghts_fix/link/dem_body.h"
#include "pointers.h"

namespace LAMMPS_NS {

class FixWallGran;

// Passes every call on to the contact model behind it.
class WallObserver : protected Pointers, public LIGGGHTS::Walls::IGranularWall {
 public:
  void settings(int nargs, char** args, LIGGGHTS::IContactHistorySetup* setup) override;
  void init_granular() override;
  bool checkSurfaceIntersect(LIGGGHTS::ContactModels::SurfacesIntersectData& contact) override;
  int get_history_offset(std::string name) override;
  bool contact_match(std::string kind, std::string model) override;

 protected:
  WallObserver(LAMMPS* lmp_, IGranularWall* model) : Pointers(lmp_), model_(model) {}
  std::unique_ptr<IGranularWall> model_;
};

// The torque [N m] of a grain before the contact that is being computed.
using GrainTorque = std::shared_ptr<Eigen::Vector3d>;

// Records the torque of a grain before each contact. LIGGGHTS reports only the force of a contact to the mesh; the
// couple of rolling friction shows as the change of the grain's torque. It also applies the mass of the body to the
// damping of its contacts.
class WallTorque final : public WallObserver {
 public:
  // From now on `before` is written at each contact of the wall. The wall owns the observer.
  static void observe(LAMMPS* lmp, FixWallGran& wall, GrainTorque before);

  // After observe(): contacts with this mesh are damped with the mass of the body (ScopedPairMass); null: as with a
  // wall.
  static void set_body(FixWallGran& wall, const FixMeshSurface* mesh, const footfall::DemBody* body);

  void compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact, bool intersect,
                     double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh, int element) override;

 private:
  using WallObserver::WallObserver;

  GrainTorque before_;
  std::map<const FixMeshSurface*, const footfall::DemBody*> bodies_;
};

// Sums the effect of some of the meshes of a wall on the grains; LIGGGHTS has one sum for all meshes.
class MeshLoad final : public WallObserver {
 public:
  using Wrench = Eigen::Matrix<long double, 6, 1>;  // on the grains of this rank, about the origin [N, N m]
  using Choice = std::function<bool(FixMeshSurface*)>;

  // From now on the contacts of the chosen meshes are added to the returned sum. The wall owns the observer.
  static std::shared_ptr<Wrench> observe(LAMMPS* lmp, FixWallGran& wall, Choice chosen);

  void compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact, bool intersect,
                     double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh, int element) override;

 private:
  using WallObserver::WallObserver;
  Wrench on_grain(int grain) const;

  std::shared_ptr<Wrench> sum_;
  Choice chosen_;
};

}  // namespace LAMMPS_NS
