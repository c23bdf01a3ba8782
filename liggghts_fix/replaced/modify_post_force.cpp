// LAMMPS_NS::Modify::post_force, the forces of all fixes in a step: moves boundaries that waited for the pair forces, and
// calls the fixes one by one where a listener observes their forces.

#include "coupler/base/pulse.h"
#include "fix.h"
#include "lammps.h"
#include "liggghts_fix/replaced/force_listeners.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::Modify::post_force(int vflag) {
  footfall::pulse();
  static const auto pre_force = footfall::next_definition<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify9pre_forceEi");
  static const auto post_force =
      footfall::next_definition<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify10post_forceEi");
  if (auto* const boundaries = footfall::listener_of<footfall::DeferredBoundaryMotion>(lmp)) {
    boundaries->move_boundaries();
    pre_force(this, vflag);
  }
  footfall::ForceListener* const listener = footfall::listener_of<footfall::ForceListener>(lmp);
  if (listener == nullptr) {
    post_force(this, vflag);
    return;
  }
  listener->pair_forces_done(false);
  for (int i = 0; i < n_post_force; ++i) {
    Fix& one = *fix[list_post_force[i]];
    one.post_force(vflag);
    listener->fix_force_done(one);
  }
  listener->all_forces_done(false);
}
