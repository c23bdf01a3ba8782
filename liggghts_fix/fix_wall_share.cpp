#include "liggghts_fix/fix_wall_share.h"

#include <utility>

#include "atom.h"
#include "fix_wall_gran.h"
#include "liggghts_fix/liggghts_access.h"

namespace LAMMPS_NS {

std::shared_ptr<MeshShare::Wrench> MeshShare::watch(LAMMPS* lmp, FixWallGran& wall, Choice chosen) {
  IGranularWall*& model = footfall::wall_model(&wall);
  auto* const share = new MeshShare(lmp, model);
  model = share;
  share->sum_ = std::make_shared<Wrench>(Wrench::Zero());
  share->chosen_ = std::move(chosen);
  return share->sum_;
}

MeshShare::Wrench MeshShare::on_grain(int i) const {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  const auto vector = [](const double* x) { return Vector(x[0], x[1], x[2]); };
  const Vector f = vector(atom->f[i]);
  Wrench wrench;
  wrench << f, vector(atom->x[i]).cross(f) + vector(atom->torque[i]);
  return wrench;
}

void MeshShare::compute_force(FixWallGran* wall, LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                              bool intersect, double* v_wall, FixMeshSurface* mesh_fix, int mesh_number, TriMesh* mesh,
                              int element) {
  const bool counts = mesh_fix != nullptr && chosen_(mesh_fix);
  const Wrench before = counts ? on_grain(contact.i) : Wrench(Wrench::Zero());
  model_->compute_force(wall, contact, intersect, v_wall, mesh_fix, mesh_number, mesh, element);
  if (counts) *sum_ += on_grain(contact.i) - before;
}

void MeshShare::settings(int nargs, char** args, LIGGGHTS::IContactHistorySetup* setup) {
  model_->settings(nargs, args, setup);
}

void MeshShare::init_granular() { model_->init_granular(); }

bool MeshShare::checkSurfaceIntersect(LIGGGHTS::ContactModels::SurfacesIntersectData& contact) {
  return model_->checkSurfaceIntersect(contact);
}

int MeshShare::get_history_offset(std::string name) { return model_->get_history_offset(std::move(name)); }

bool MeshShare::contact_match(std::string kind, std::string model) {
  return model_->contact_match(std::move(kind), std::move(model));
}

}  // namespace LAMMPS_NS
