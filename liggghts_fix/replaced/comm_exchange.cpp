// LAMMPS_NS::Comm::exchange, in which grains change ranks. Grains outside of the box are lost here, and LIGGGHTS corrects
// its total at once: only the numbers before and after show how many.

#include "atom.h"
#include "comm.h"
#include "lammps.h"
#include "liggghts_fix/access/grain_sum.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "update.h"

void LAMMPS_NS::Comm::exchange() {
  static const auto exchange = footfall::next_definition<void (*)(Comm*)>("_ZN9LAMMPS_NS4Comm8exchangeEv");
  const int before = atom->nlocal;
  footfall::DemLink* const link = footfall::find_dem_link(lmp);
  if (link != nullptr && link->started() && !link->finished()) {
    const GrainSum lost = sum_of_grains(lmp, link->script_gravity(), true, 0.5 * lmp->update->dt);
    footfall::GrainChanges changes;
    changes.left = -lost.energy;
    changes.lost_mass = lost.mass;
    link->grains().changed(changes);
  }
  exchange(this);
  if (link != nullptr) link->grains().exchanged(before, atom->nlocal);
}
