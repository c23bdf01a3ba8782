// LAMMPS_NS::Input::jump: from here on a script may contain a loop, whose runs may go on after the end of the scene.

#include "input.h"
#include "lammps.h"
#include "liggghts_fix/access/liggghts_access.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/next_definition.h"

void LAMMPS_NS::Input::jump() {
  static const auto jump = footfall::next_definition<void (*)(Input*)>("_ZN9LAMMPS_NS5Input4jumpEv");
  footfall::DemLink* const link = footfall::find_dem_link(lmp);
  if (link != nullptr && link->started()) link->runs().script_jumps();
  jump(this);
}
