// LAMMPS_NS::Modify::setup_pre_force, in which fixes may resize grains: calls the fixes one by one where a listener observes
// the changes.

#include "lammps.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"
#include "update.h"

void LAMMPS_NS::Modify::setup_pre_force(int vflag) {
  static const auto setup_pre_force =
      footfall::next_definition<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify15setup_pre_forceEi");
  constexpr int kRun = 1;
  if (update->whichflag != kRun ||
      !footfall::call_watched(lmp, fix, list_pre_force, n_pre_force, footfall::GrainChangeListener::When::kForces,
                              [vflag](Fix& one) { one.setup_pre_force(vflag); }))
    setup_pre_force(this, vflag);
}
