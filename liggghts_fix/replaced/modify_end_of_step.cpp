// LAMMPS_NS::Modify::end_of_step: notifies the listener that the velocities at the end of the step are known, and calls the
// fixes one by one where a listener observes changes of grains.

#include "lammps.h"
#include "liggghts_fix/replaced/force_listeners.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"
#include "update.h"

void LAMMPS_NS::Modify::end_of_step() {
  static const auto end_of_step = footfall::next_definition<void (*)(Modify*)>("_ZN9LAMMPS_NS6Modify11end_of_stepEv");
  if (footfall::ForceListener* const listener = footfall::listener_of<footfall::ForceListener>(lmp))
    listener->step_done();
  auto* const listener = footfall::listener_of<footfall::GrainChangeListener>(lmp);
  if (listener == nullptr) {
    end_of_step(this);
    return;
  }
  for (int i = 0; i < n_end_of_step; ++i)
    if (update->ntimestep % end_of_step_every[i] == 0)
      footfall::call_watched(*listener, *fix[list_end_of_step[i]], footfall::GrainChangeListener::When::kEnd,
                             [](Fix& one) { one.end_of_step(); });
}
