#pragma once
// Energy of grains that are inserted, removed or changed otherwise than by forces: lines of the energy balance. theory 7.9.
//
// The sum over the grains (access/grain_sum.h) is compared before and after everything that may create, delete, move or resize grains: fixes within a step, commands
// between two runs, and LIGGGHTS' loss of grains that leave the box. Nothing is done in a script without such fixes.

#include <optional>

#include "liggghts_fix/access/grain_sum.h"
#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "pointers.h"

namespace LAMMPS_NS {

class GrainChangeWatch final : protected Pointers, public footfall::GrainChangeListener {
 public:
  GrainChangeWatch(LAMMPS* lmp_, footfall::DemLink& link) : Pointers(lmp_), link_(link) {}
  ~GrainChangeWatch() override;

  // LIGGGHTS is initialized for a run or a restart file: commands since the end of the last run may have changed grains.
  // Listens to fixes if there are any that may. Collective.
  void initialized();
  void run_begins() { at_end_.reset(); }
  void run_ended();

  bool watches(Fix& fix, When when) override;
  void before() override;
  void after() override;

 private:
  bool any_watched() const;

  GrainSum sum() const;

  footfall::DemLink& link_;
  double ahead_ = 0.0;  // of the watched fix [s]
  GrainSum before_;
  std::optional<GrainSum> at_end_;  // of the last run, or when last initialized; none within a run
};

}  // namespace LAMMPS_NS
