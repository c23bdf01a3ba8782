// LAMMPS_NS::FixContactHistoryMesh::markAllContacts, before the contacts of a step with a mesh: marks the histories of
// the grains near the mesh only (listed_grains.h). No contact is kept, or touches, until it is found.

#include "atom.h"
#include "error.h"
#include "fix_contact_history_mesh.h"
#include "liggghts_fix/replaced/listed_grains.h"
#include "tri_mesh.h"

void LAMMPS_NS::FixContactHistoryMesh::markAllContacts() {
  keeppage_[0]->reset(true);
  intersectpage_[0]->reset(false);
  footfall::for_each_listed_grain(*fix_neighlist_mesh_, mesh_->sizeLocal() + mesh_->sizeGhost(), atom->nlocal,
                                  [this](int grain) {
                                    keepflag_[grain] = keeppage_[0]->get(nneighs(grain));
                                    intersectflag_[grain] = intersectpage_[0]->get(nneighs(grain));
                                    if (keepflag_[grain] == nullptr || intersectflag_[grain] == nullptr)
                                      error->one(FLERR, "mesh contact history overflow, boost neigh_modify one");
                                  });
}
