// LAMMPS_NS::Modify::pre_force, between re-neighbouring and the pair forces of a step: left to post_force where the
// boundaries move after the pair forces. Calls the fixes one by one where a listener observes changes of grains.

#include "lammps.h"
#include "liggghts_fix/replaced/force_listeners.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::Modify::pre_force(int vflag) {
  static const auto pre_force = footfall::next_definition<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify9pre_forceEi");
  if (footfall::listener_of<footfall::DeferredBoundaryMotion>(lmp) != nullptr) return;
  if (!footfall::call_watched(lmp, fix, list_pre_force, n_pre_force, footfall::GrainChangeListener::When::kForces,
                              [vflag](Fix& one) { one.pre_force(vflag); }))
    pre_force(this, vflag);
}
