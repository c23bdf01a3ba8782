// LAMMPS_NS::Modify::initial_integrate, in which fixes may prescribe the motion of grains: calls the fixes one by one where
// a listener observes the changes.

#include "lammps.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::Modify::initial_integrate(int vflag) {
  static const auto initial_integrate =
      footfall::next_definition<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify17initial_integrateEi");
  if (!footfall::call_watched(lmp, fix, list_initial_integrate, n_initial_integrate,
                              footfall::GrainChangeListener::When::kIntegration,
                              [vflag](Fix& one) { one.initial_integrate(vflag); }))
    initial_integrate(this, vflag);
}
