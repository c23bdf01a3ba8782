// LAMMPS_NS::FixMesh::create_mesh_restart, for a mesh whose id is in the restart file. LIGGGHTS takes its triangles from
// there, and requires the mesh file to exist even after the keyword `fix`. A mesh that a fix can create is created anew
// at the bodies' positions in the scene, and the triangles of the restart file are ignored.

#include "fix_mesh.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::FixMesh::create_mesh_restart(char* file_or_fix) {
  Fix* const creator = modify->find_fix_id(file_or_fix);
  if (creator == nullptr || !creator->can_create_mesh()) {
    footfall::next_definition<void (*)(FixMesh*, char*)>("_ZN9LAMMPS_NS7FixMesh19create_mesh_restartEPc")(this,
                                                                                                          file_or_fix);
    return;
  }
  footfall::forget_restart_data(*modify, id);
  create_mesh(file_or_fix, true);
}
