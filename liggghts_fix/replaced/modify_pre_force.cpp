// LAMMPS_NS::Modify::pre_force, between re-neighbouring and the pair forces of a step: left to post_force where the
// boundaries move after the pair forces.

#include "coupler/base/pulse.h"
#include "fix.h"
#include "lammps.h"
#include "liggghts_fix/replaced/force_listeners.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::Modify::pre_force(int vflag) {
  footfall::pulse();
  static const auto pre_force = footfall::next_definition<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify9pre_forceEi");
  if (footfall::listener_of<footfall::DeferredBoundaryMotion>(lmp) == nullptr) pre_force(this, vflag);
}
