#pragma once
// Listeners between the forces of a DEM step. LIGGGHTS sums up the forces on the grains source by source: first the forces
// of grains on each other (the pair style), then the forces of each fix. The four functions of Modify that do so are replaced
// and call these listeners. Without a listener they are LIGGGHTS' own.

#include <map>

namespace LAMMPS_NS {
class Fix;
class LAMMPS;
}  // namespace LAMMPS_NS

namespace footfall {

// Observes the forces on the grains, source by source.
class ForceListener {
 public:
  virtual ~ForceListener() = default;
  virtual void pair_forces_done(bool set_up) = 0;        // set_up: of a run; otherwise of a step
  virtual void fix_force_done(LAMMPS_NS::Fix& fix) = 0;  // this fix has added its forces
  virtual void all_forces_done(bool set_up) = 0;
  virtual void step_done() = 0;  // the velocities at the end of the step are known
};

// Moves boundaries after the pair forces of a step, which do not depend on them. Modify::pre_force (lists of grains at
// meshes) then waits for the boundaries as well.
class DeferredBoundaryMotion {
 public:
  virtual ~DeferredBoundaryMotion() = default;
  virtual void move_boundaries() = 0;  // to their positions at the end of the step
};

// Called at the end of the set-up of a run, after all forces have been evaluated.
class SetUpListener {
 public:
  virtual ~SetUpListener() = default;
  virtual void set_up_done() = 0;
};

// The listeners of one kind, by the LIGGGHTS that they listen to.
template <class Listener>
std::map<LAMMPS_NS::LAMMPS*, Listener*>& listeners() {
  static std::map<LAMMPS_NS::LAMMPS*, Listener*> all;
  return all;
}

// Null: the listener of this kind is removed.
template <class Listener>
void set_listener(LAMMPS_NS::LAMMPS* lmp, Listener* listener) {
  if (listener != nullptr) {
    listeners<Listener>()[lmp] = listener;
  } else {
    listeners<Listener>().erase(lmp);
  }
}

// Null without a listener.
template <class Listener>
Listener* listener_of(LAMMPS_NS::LAMMPS* lmp) {
  if (listeners<Listener>().empty()) return nullptr;
  const auto found = listeners<Listener>().find(lmp);
  return found == listeners<Listener>().end() ? nullptr : found->second;
}

}  // namespace footfall
