#pragma once
// Energy of grains that are inserted, removed or changed otherwise than by forces: lines of the energy balance. theory 7.9.
//
//   E = sum of 1/2 m v^2 + 1/2 I w^2 - m g . x   (over the grains; clumps as rigid bodies)
// is compared before and after everything that may create, delete, move or resize grains: fixes within a step, commands
// between two runs, and LIGGGHTS' loss of grains that leave the box. Nothing is done in a script without such fixes.

#include <optional>

#include "liggghts_fix/link/dem_link.h"
#include "liggghts_fix/replaced/grain_change_listener.h"
#include "pointers.h"

namespace LAMMPS_NS {

// Sums over the grains of this rank.
struct GrainSum {
  double energy = 0.0;  // E [J]
  double size = 0.0;    // the same without regard to sign [J]: round-off is relative to this
  double mass = 0.0;    // [kg]
  long count = 0;
};
// only_outside: grains beyond fixed sides of the box, which LIGGGHTS is about to lose. ahead: g has acted on the velocities for this
// much less time [s]; at the exchange of grains half a step, because they have been advanced to the middle of the step.
GrainSum sum_of_grains(LAMMPS* lmp, const Eigen::Vector3d& g, bool only_outside = false, double ahead = 0.0);

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
