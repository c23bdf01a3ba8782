// LAMMPS_NS::Modify::final_integrate, in which fixes may prescribe the motion of grains: calls the fixes one by one where a
// listener observes the changes.

#include "lammps.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::Modify::final_integrate() {
  static const auto final_integrate =
      footfall::next_definition<void (*)(Modify*)>("_ZN9LAMMPS_NS6Modify15final_integrateEv");
  if (!footfall::call_watched(lmp, fix, list_final_integrate, n_final_integrate,
                              footfall::GrainChangeListener::When::kIntegration,
                              [](Fix& one) { one.final_integrate(); }))
    final_integrate(this);
}
