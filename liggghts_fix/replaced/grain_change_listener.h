#pragma once
// A listener around the functions of fixes that may create, delete, move or resize grains.

#include "fix.h"
#include "liggghts_fix/replaced/force_listeners.h"

namespace footfall {

class GrainChangeListener {
 public:
  virtual ~GrainChangeListener() = default;
  // When LIGGGHTS calls the fix in a step: before the exchange of grains, before the forces, within the integration, at
  // the end.
  enum class When { kExchange, kForces, kIntegration, kEnd };
  virtual bool watches(LAMMPS_NS::Fix& fix, When when) = 0;
  virtual void before() = 0;
  virtual void after() = 0;
};

// Calls the fix, with the listener around a fix that it watches.
template <class Call>
void call_watched(GrainChangeListener& listener, LAMMPS_NS::Fix& fix, GrainChangeListener::When when, Call call) {
  if (!listener.watches(fix, when)) {
    call(fix);
    return;
  }
  listener.before();
  call(fix);
  listener.after();
}

// Calls the listed fixes, and returns true, where a listener exists.
template <class Call>
bool call_watched(LAMMPS_NS::LAMMPS* lmp, LAMMPS_NS::Fix** fixes, const int* list, int count,
                  GrainChangeListener::When when, Call call) {
  auto* const listener = listener_of<GrainChangeListener>(lmp);
  if (listener == nullptr) return false;
  for (int i = 0; i < count; ++i) call_watched(*listener, *fixes[list[i]], when, call);
  return true;
}

}  // namespace footfall
