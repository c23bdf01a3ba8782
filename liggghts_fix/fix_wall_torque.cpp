#include "liggghts_fix/fix_wall_torque.h"

#include <utility>

#include "atom.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/fix_wall_gran_smooth.h"
#include "liggghts_fix/liggghts_access.h"
#include "liggghts_fix/pair_mass.h"

namespace LAMMPS_NS {

void WallTorque::watch(LAMMPS* lmp, FixWallGran& wall, GrainTorque before) {
  IGranularWall*& model = footfall::wall_model(&wall);
  auto* watching = dynamic_cast<WallTorque*>(model);
  if (watching == nullptr) model = watching = new WallTorque(lmp, model);
  watching->before_ = std::move(before);
}

void WallTorque::meet(FixWallGran& wall, const FixMeshSurface* mesh, const footfall::DemBody* body) {
  auto* watching = dynamic_cast<WallTorque*>(footfall::wall_model(&wall));
  if (watching == nullptr) return;
  if (body != nullptr) {
    watching->bodies_[mesh] = body;
  } else {
    watching->bodies_.erase(mesh);
  }
}

void WallTorque::settings(int nargs, char** args, LIGGGHTS::IContactHistorySetup* setup) {
  model_->settings(nargs, args, setup);
}

void WallTorque::init_granular() { model_->init_granular(); }

bool WallTorque::checkSurfaceIntersect(LIGGGHTS::ContactModels::SurfacesIntersectData& contact) {
  return model_->checkSurfaceIntersect(contact);
}

void WallTorque::compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                               bool intersect, double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh,
                               int element) {
  // An output of contacts names the mesh by its number, and LIGGGHTS may see a part of the list alone.
  if (wall->addflag() != 0)
    if (const auto* smooth = dynamic_cast<FixWallGranSmooth*>(wall)) mesh_number = smooth->number_of(mesh_fix);
  *before_ = Eigen::Map<const Eigen::Vector3d>(atom->torque[contact.i]);
  const auto body = bodies_.find(mesh_fix);
  const footfall::PairMass mass(atom->rmass[contact.i], body != bodies_.end() ? body->second->inverse_mass() : 0.0);
  model_->compute_force(wall, contact, intersect, v_wall, mesh_fix, mesh_number, mesh, element);
}

int WallTorque::get_history_offset(std::string name) { return model_->get_history_offset(std::move(name)); }

bool WallTorque::contact_match(std::string kind, std::string model) {
  return model_->contact_match(std::move(kind), std::move(model));
}

}  // namespace LAMMPS_NS
