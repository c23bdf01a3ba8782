// LAMMPS_NS::Modify::setup_pre_exchange, in which fixes insert and delete grains: calls the fixes one by one where a
// listener observes the changes.

#include "lammps.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"
#include "update.h"

void LAMMPS_NS::Modify::setup_pre_exchange() {
  static const auto setup_pre_exchange =
      footfall::next_definition<void (*)(Modify*)>("_ZN9LAMMPS_NS6Modify18setup_pre_exchangeEv");
  constexpr int kRun = 1;
  if (update->whichflag > kRun || !footfall::call_watched(lmp, fix, list_pre_exchange, n_pre_exchange,
                                                          footfall::GrainChangeListener::When::kExchange,
                                                          [](Fix& one) { one.setup_pre_exchange(); }))
    setup_pre_exchange(this);
}
