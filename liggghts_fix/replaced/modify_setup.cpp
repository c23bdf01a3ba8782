// LAMMPS_NS::Modify::setup, the forces of all fixes in the set-up of a run: calls the fixes one by one where a listener
// observes their forces.

#include "fix.h"
#include "lammps.h"
#include "liggghts_fix/replaced/force_listeners.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"
#include "update.h"

// LIGGGHTS' own function also completes the fixes' restart data, and evaluates computes. It calls the fixes only while
// whichflag says that a run is set up.
void LAMMPS_NS::Modify::setup(int vflag) {
  static const auto setup = footfall::next_definition<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify5setupEi");
  constexpr int kRun = 1, kNothing = 0;
  footfall::ForceListener* const listener = footfall::listener_of<footfall::ForceListener>(lmp);
  if (listener == nullptr || update->whichflag != kRun) {
    setup(this, vflag);
  } else {
    listener->pair_forces_done(true);
    update->whichflag = kNothing;
    setup(this, vflag);
    update->whichflag = kRun;
    for (int i = 0; i < nfix; ++i) {
      fix[i]->setup(vflag);
      listener->fix_force_done(*fix[i]);
    }
    listener->all_forces_done(true);
  }
  if (auto* const set_up = footfall::listener_of<footfall::SetUpListener>(lmp)) set_up->set_up_done();
}
