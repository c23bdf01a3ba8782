// LAMMPS_NS::Modify::pre_exchange, in which fixes insert and delete grains: calls the fixes one by one where a listener
// observes the changes.

#include "lammps.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "liggghts_fix/replaced/next_definition.h"
#include "modify.h"

void LAMMPS_NS::Modify::pre_exchange() {
  static const auto pre_exchange = footfall::next_definition<void (*)(Modify*)>("_ZN9LAMMPS_NS6Modify12pre_exchangeEv");
  if (!footfall::call_watched(lmp, fix, list_pre_exchange, n_pre_exchange,
                              footfall::GrainChangeListener::When::kExchange, [](Fix& one) { one.pre_exchange(); }))
    pre_exchange(this);
}
