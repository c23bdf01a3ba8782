#pragma once
// fix ID all insert/exact seed S distributiontemplate D nparticles 1 particlerate R|massrate M insert_every N [keywords of
// insert/rate/region] region REGION [from T] [until T]
// LIGGGHTS' insert/rate/region, except that the number of grains follows the rate exactly, and that a resumed run
// inserts the same grains: until time t, floor(R (min(t, until) - from)) grains are inserted. Each insertion draws its random
// numbers from seed and step alone. With a massrate the inserted mass is M (min(t, until) - from), minus less than a
// mean grain: each insertion compensates for the sizes drawn before. Grains that find no space follow at the next insertion. Times count from step 0.

#include <cstdio>

#include "fix_insert_rate_region.h"

namespace LAMMPS_NS {

class FixInsertExact : public FixInsertRateRegion {
 public:
  FixInsertExact(LAMMPS* lmp, int narg, char** arg);

  void init() override;
  void pre_exchange() override;
  void write_restart(FILE* file) override;
  void restart(char* buffer) override;

 private:
  int calc_ninsert_this() override;
  double come() const;                        // grains, or their mass over the mass of a mean grain
  long due(bigint step) const;                // grains that should have come until this step
  bigint next_insertion(bigint after) const;  // step at which more are due; 0: never
  void draw_anew();

  double from_ = 0.0, until_;  // [s]
  double rate_ = 0.0;          // [grains/s]
  int first_seed_ = 0;
  bool by_mass_ = false;  // the mass follows the rate, not the number
  bool late_ = false;     // grains found no space: reported once
};

}  // namespace LAMMPS_NS
