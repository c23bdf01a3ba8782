// LAMMPS_NS::Modify::end_of_step: tells the listener that the velocities at the end of the step are known.

#include "fix.h"
#include "lammps.h"
#include "liggghts_fix/replaced/force_listeners.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::Modify::end_of_step() {
  static const auto end_of_step = footfall::next_definition<void (*)(Modify*)>("_ZN9LAMMPS_NS6Modify11end_of_stepEv");
  if (footfall::ForceListener* const listener = footfall::listener_of<footfall::ForceListener>(lmp))
    listener->step_done();
  end_of_step(this);
}
