// LAMMPS_NS::FixContactHistoryMesh::cleanUpContacts, after the contacts of a step with a mesh: deletes the histories of
// contacts that were not found, of the grains near the mesh only (listed_grains.h).

#include "atom.h"
#include "fix_contact_history_mesh.h"
#include "liggghts_fix/replaced/listed_grains.h"
#include "tri_mesh.h"

void LAMMPS_NS::FixContactHistoryMesh::cleanUpContacts() {
  footfall::for_each_listed_grain(*fix_neighlist_mesh_, mesh_->sizeLocal() + mesh_->sizeGhost(), atom->nlocal,
                                  [this](int grain) { cleanUpContacts(grain, grain + 1); });
}
