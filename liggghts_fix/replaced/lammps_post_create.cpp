// LAMMPS_NS::LAMMPS::post_create, which LIGGGHTS calls after it has created its parts: at its start and in the command
// `clear`. All that the library's own function does is for packages that Debian leaves out (suffixes gpu and omp).

#include "lammps.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/dem_link.h"

void LAMMPS_NS::LAMMPS::post_create() {
  footfall::DemLink* const link = footfall::find_dem_link(this);
  if (link == nullptr) return;  // at the start
  link->uncoupled_by("clear");
  footfall::restore_fix_styles(this);
}
