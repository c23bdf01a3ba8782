// Forwards LIGGGHTS' interface of contact models, and compares grains before and after each contact.

#include "liggghts_fix/contact/wall_observers.h"

#include <utility>

#include "atom.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/contact/fix_wall_gran_smooth.h"
#include "liggghts_fix/link/scoped_values.h"

namespace LAMMPS_NS {

// --- WallObserver

void WallObserver::settings(int nargs, char** args, LIGGGHTS::IContactHistorySetup* setup) {
  model_->settings(nargs, args, setup);
}

void WallObserver::init_granular() { model_->init_granular(); }

bool WallObserver::checkSurfaceIntersect(LIGGGHTS::ContactModels::SurfacesIntersectData& contact) {
  return model_->checkSurfaceIntersect(contact);
}

int WallObserver::get_history_offset(std::string name) { return model_->get_history_offset(std::move(name)); }

bool WallObserver::contact_match(std::string kind, std::string model) {
  return model_->contact_match(std::move(kind), std::move(model));
}

// --- WallTorque

void WallTorque::observe(LAMMPS* lmp, FixWallGran& wall, GrainTorque before) {
  IGranularWall*& model = footfall::wall_model(&wall);
  auto* observer = dynamic_cast<WallTorque*>(model);
  if (observer == nullptr) model = observer = new WallTorque(lmp, model);
  observer->before_ = std::move(before);
}

void WallTorque::set_body(FixWallGran& wall, const FixMeshSurface* mesh, const footfall::DemBody* body) {
  auto* observer = dynamic_cast<WallTorque*>(footfall::wall_model(&wall));
  if (observer == nullptr) return;
  if (body != nullptr) {
    observer->bodies_[mesh] = body;
  } else {
    observer->bodies_.erase(mesh);
  }
}

void WallTorque::compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                               bool intersect, double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh,
                               int element) {
  // An output of contacts (addflag) names the mesh by its number in the whole list; LIGGGHTS may see a part of it.
  if (wall->addflag() != 0)
    if (const auto* smooth = dynamic_cast<FixWallGranSmooth*>(wall)) mesh_number = smooth->number_of(mesh_fix);
  *before_ = Eigen::Map<const Eigen::Vector3d>(atom->torque[contact.i]);
  const auto body = bodies_.find(mesh_fix);
  const footfall::ScopedPairMass mass(atom->rmass[contact.i],
                                      body != bodies_.end() ? body->second->inverse_mass() : 0.0);
  model_->compute_force(wall, contact, intersect, v_wall, mesh_fix, mesh_number, mesh, element);
}

// --- MeshLoad

std::shared_ptr<MeshLoad::Wrench> MeshLoad::observe(LAMMPS* lmp, FixWallGran& wall, Choice chosen) {
  IGranularWall*& model = footfall::wall_model(&wall);
  auto* const observer = new MeshLoad(lmp, model);
  model = observer;
  observer->sum_ = std::make_shared<Wrench>(Wrench::Zero());
  observer->chosen_ = std::move(chosen);
  return observer->sum_;
}

MeshLoad::Wrench MeshLoad::on_grain(int i) const {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const auto vector = [](const double* x) { return Vector(x[0], x[1], x[2]); };
  const Vector f = vector(atom->f[i]);
  Wrench wrench;
  wrench << f, vector(atom->x[i]).cross(f) + vector(atom->torque[i]);
  return wrench;
}

void MeshLoad::compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact, bool intersect,
                             double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh, int element) {
  const bool counts = mesh_fix != nullptr && chosen_(mesh_fix);
  const Wrench before = counts ? on_grain(contact.i) : Wrench(Wrench::Zero());
  model_->compute_force(wall, contact, intersect, v_wall, mesh_fix, mesh_number, mesh, element);
  if (counts) *sum_ += on_grain(contact.i) - before;
}

}  // namespace LAMMPS_NS
