// Forces on the grains, told source by source, and boundaries that move behind those of grains on each other: LIGGGHTS
// adds them up in members that stand here in place of the library's.

#include <mpi.h>

#include <map>

#include "fix.h"
#include "lammps.h"
#include "liggghts_fix/fix_couple_mbd_restart.h"
#include "liggghts_fix/liggghts_access.h"
#include "liggghts_fix/liggghts_access_members.h"
#include "modify.h"
#include "update.h"

namespace footfall {
namespace {

using namespace LAMMPS_NS;

// Who hears what in which LIGGGHTS.
template <class Hearer>
std::map<LAMMPS*, Hearer*>& hearers() {
  static std::map<LAMMPS*, Hearer*> one;
  return one;
}

// Null in runs that nobody listens to.
template <class Hearer>
Hearer* hearer_of(LAMMPS* lmp) {
  if (hearers<Hearer>().empty()) return nullptr;
  const auto found = hearers<Hearer>().find(lmp);
  return found == hearers<Hearer>().end() ? nullptr : found->second;
}

template <class Hearer>
void listen(LAMMPS* lmp, Hearer* hearer) {
  if (hearer != nullptr) {
    hearers<Hearer>()[lmp] = hearer;
  } else {
    hearers<Hearer>().erase(lmp);
  }
}

// Never made: it only names protected members.
class OpenModify : public Modify {
 public:
  static int* post_force_list(Modify* modify) { return modify->*&OpenModify::list_post_force; }
  static LAMMPS* owner(Modify* modify) { return modify->*&OpenModify::lmp; }
};

}  // namespace

void watch_forces(LAMMPS* lmp, ForceWatch* watch) { listen(lmp, watch); }
void move_behind_pairs(LAMMPS* lmp, LateBoundaries* boundaries) { listen(lmp, boundaries); }

}  // namespace footfall

// In a step, between re-neighbouring and the forces of grains on each other.
void LAMMPS_NS::Modify::pre_force(int vflag) {
  static const auto pre_force = footfall::original<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify9pre_forceEi");
  if (footfall::hearer_of<footfall::LateBoundaries>(footfall::OpenModify::owner(this)) == nullptr)
    pre_force(this, vflag);
}

// The forces of fixes, one after the other; and the same when a run is set up.
void LAMMPS_NS::Modify::post_force(int vflag) {
  static const auto pre_force = footfall::original<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify9pre_forceEi");
  static const auto post_force = footfall::original<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify10post_forceEi");
  if (footfall::LateBoundaries* const boundaries =
          footfall::hearer_of<footfall::LateBoundaries>(footfall::OpenModify::owner(this))) {
    boundaries->move_boundaries();
    pre_force(this, vflag);
  }
  footfall::ForceWatch* const watch = footfall::hearer_of<footfall::ForceWatch>(footfall::OpenModify::owner(this));
  if (watch == nullptr) {
    post_force(this, vflag);
    return;
  }
  watch->pairs_done(false);
  for (int i = 0; i < n_post_force; ++i) {
    Fix& one = *fix[footfall::OpenModify::post_force_list(this)[i]];
    one.post_force(vflag);
    watch->fix_done(one);
  }
  watch->forces_done(false);
}

// Beside the forces it settles what fixes know of a restart, and computes.
void LAMMPS_NS::Modify::setup(int vflag) {
  static const auto setup = footfall::original<void (*)(Modify*, int)>("_ZN9LAMMPS_NS6Modify5setupEi");
  constexpr int kRun = 1, kNothing = 0;
  footfall::ForceWatch* const watch = footfall::hearer_of<footfall::ForceWatch>(footfall::OpenModify::owner(this));
  if (watch == nullptr || update->whichflag != kRun) {
    setup(this, vflag);
  } else {
    watch->pairs_done(true);
    update->whichflag = kNothing;
    setup(this, vflag);
    update->whichflag = kRun;
    for (int i = 0; i < nfix; ++i) {
      fix[i]->setup(vflag);
      watch->fix_done(*fix[i]);
    }
    watch->forces_done(true);
  }
  return_held_forces(lmp);
}

void LAMMPS_NS::Modify::end_of_step() {
  static const auto end_of_step = footfall::original<void (*)(Modify*)>("_ZN9LAMMPS_NS6Modify11end_of_stepEv");
  if (footfall::ForceWatch* const watch = footfall::hearer_of<footfall::ForceWatch>(footfall::OpenModify::owner(this)))
    watch->step_done();
  end_of_step(this);
}
